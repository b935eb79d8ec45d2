/* Faces and slave nodes of sixteen families, ordinary to hard: see draw_queries.c. */
#ifndef FOOTPOINT_DRAW_QUERIES_H
#define FOOTPOINT_DRAW_QUERIES_H

#include "distance_polynomial.h"

#include <stdint.h>

enum query_family {
    MILD,
    BENT,
    BESIDE,
    ON,
    NEEDLE,
    TAPER,
    COLLAPSED,
    WILD,
    CURVATURE,
    TIE,
    FAR,
    OFFSET,
    SIZE,
    BORDER,
    FOLDED,
    MIXED,
    FAMILIES
};

extern const char *const query_family_name[FAMILIES];

/** Draws a face and a slave node: x has the nodes and then the slave node, 3 each.  The same state, the same bits. */
void draw_query(enum query_kind kind, int family, uint64_t *state, double *x);

#endif
