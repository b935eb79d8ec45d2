/* A sample: one segment, one slave node and its certain foot point.  Sets of them are what scenes are made of. */
#ifndef FOOTPOINT_SAMPLE_H
#define FOOTPOINT_SAMPLE_H

#include "../../codegen/genome/segment_kind.h"

#include <stddef.h>

struct sample {
    /* Nodes and normals in the order of the segment's kind, of quad4 the corners A, B, C, D at (xi,eta) = (-1,-1),
     * (1,-1), (1,1), (-1,1); any length unit.  0 beyond what the kind has. */
    double x[SEGMENT_VECTORS][3];
    double xs[3];   /* slave node; same unit */
    double xi, eta; /* foot point, dimensionless */
    double gap;     /* (xs - r(xi,eta)) . n, n the unit normal there, right-handed in xi, eta; same unit as x */
};

struct sample_set {
    struct sample *s; /* owned */
    size_t n, room;
};

void sample_set_add(struct sample_set *set, const struct sample *s);
void sample_set_free(struct sample_set *set);

#endif
