/* The inputs that the segments of a scene vary: right angles, parallel edges, a plane, or all. */
#ifndef FOOTPOINT_VARIATION_H
#define FOOTPOINT_VARIATION_H

#include "../surface/sample.h"

#include <stdio.h>

/** Each kind includes those before it. */
enum variation_kind {
    VARY_RECTANGLES,     /* only sizes */
    VARY_PARALLELOGRAMS, /* and angles */
    VARY_PLANE,          /* and taper */
    VARY_WARPED          /* and warp */
};

/** Largest variation among segments, in the units of scenes; the mid-lines are 2 c1 and 2 c2. */
struct variation {
    enum variation_kind kind;
    double taper;     /* c3 = (A - B + C - D)/4 = a c1 + b c2 + g n: the larger of |a| and |b| */
    double warp;      /* angle between the normals at opposite corners, rad */
    double skew;      /* deviation of the angle between c1 and c2 from the right angle, rad */
    double tolerance; /* variations up to this count as 0: 1e-12, and the rounding of coordinates far from the origin */
};

/** Measures bilinear segments. For others it returns the rounding tolerance, by corners A, B and the last one, and
 *  VARY_WARPED. */
struct variation variation_measure(const struct segment_kind *kind, const struct sample_set *set);

/** "rectangles", "parallelograms", "plane", "warped". */
extern const char *const variation_name[];

/** Prints "segments are ... (taper up to ...)" without an end of line. */
void variation_print(const struct variation *v, FILE *stream);

#endif
