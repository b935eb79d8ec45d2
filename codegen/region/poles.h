/* Zeros of denominators: proved absent, proved present, or neither. */
#ifndef FOOTPOINT_POLES_H
#define FOOTPOINT_POLES_H

#include "region.h"

/** POLE_REQUIRED: no zero where the requires hold, since where it is 0 one of them is not > 0, but by no proved margin. */
enum pole_verdict { POLE_FREE, POLE_EXISTS, POLE_REQUIRED, POLE_UNDECIDED };

struct pole {
    enum pole_verdict verdict;
    struct interval values; /* POLE_FREE: encloses the denominator on the region; without 0, unless it has both signs */
    double least;           /* POLE_FREE: its absolute value is at least this; else 0 */
    double *witness;        /* owned, by variable: POLE_EXISTS: a zero, or a point near one; else NULL */
    long draws;             /* random points of the box that were looked at */
};

/** Looks for zeros of operation `op` of the region's program, by branch and bound in at most `boxes` boxes; never
 *  POLE_REQUIRED. */
struct pole pole_find(struct region *r, int op, long boxes);

#endif
