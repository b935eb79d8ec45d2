/* Zeros of denominators: proved absent, proved present, or undecided. */
#ifndef FOOTPOINT_POLES_H
#define FOOTPOINT_POLES_H

#include "region.h"

/** POLE_REQUIRED: no zero where the requires hold, because a require is not > 0 where it is 0, but without a proved
 *  margin. */
enum pole_verdict { POLE_FREE, POLE_EXISTS, POLE_REQUIRED, POLE_UNDECIDED };

struct pole {
    enum pole_verdict verdict;
    struct interval values; /* POLE_FREE: encloses the denominator on the region; excludes 0 unless it has both signs */
    double least;           /* POLE_FREE: lower bound of its absolute value; otherwise 0 */
    double *witness;        /* owned, by variable: POLE_EXISTS: a zero, or a point near a zero; otherwise NULL */
    long draws;             /* random points of the box examined */
};

/** Searches for zeros of operation `op` of the region's program, by branch and bound in at most `boxes` boxes; never
 *  returns POLE_REQUIRED. */
struct pole pole_find(struct region *r, int op, long boxes);

#endif
