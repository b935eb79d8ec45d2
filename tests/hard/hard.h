/* Draws segments and slave nodes on which searches fail, in families, from a seed; see hard.c. */
#ifndef FOOTPOINT_HARD_H
#define FOOTPOINT_HARD_H

#include "hard_case.h"

struct hard_family {
    const char *name;
    const char *what; /* a few words for the table */
    void (*draw)(uint64_t *stream, struct hard_case *h);
    void (*draw_float)(uint64_t *stream, struct hard_case *h); /* within the range of float, or NULL */
    int finite;                                                /* 1 if all coordinates are finite */
    int sized;                                                 /* 1 if they are also neither denormal nor near 1e308 */
};

extern const struct hard_family hard_families[];
extern const int hard_family_count;

/** Draws case number `index` of a family, the same on every machine. */
void hard_draw(int family, uint64_t seed, uint64_t index, struct hard_case *h);
/** Draws the same for code in float: coordinates are floats. */
void hard_draw_float(int family, uint64_t seed, uint64_t index, struct hard_case *h);

#endif
