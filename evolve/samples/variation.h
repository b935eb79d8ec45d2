/* Which inputs the segments of a scene vary: right angles, parallel edges, a plane, or none of these. */
#ifndef FOOTPOINT_VARIATION_H
#define FOOTPOINT_VARIATION_H

#include "../surface/sample.h"

#include <stdio.h>

/** Each kind includes those before it. */
enum variation_kind {
    VARY_RECTANGLES,     /* sizes alone */
    VARY_PARALLELOGRAMS, /* and angles */
    VARY_PLANE,          /* and taper */
    VARY_WARPED          /* and warp */
};

/** The most that segments have of each, as scenes measure it; mid-lines 2 c1 and 2 c2. */
struct variation {
    enum variation_kind kind;
    double taper;     /* c3 = (A - B + C - D)/4 is a c1 + b c2 + g n: the larger of |a| and |b| */
    double warp;      /* angle between the normals at opposite corners, rad */
    double skew;      /* angle of c1 and c2 off the right angle, rad */
    double tolerance; /* up to this is nothing: 1e-12, and what rounding makes of coordinates far from the origin */
};

/** Of bilinear segments; of any others how far rounding goes, by corners A, B and the last one, and VARY_WARPED. */
struct variation variation_measure(const struct segment_kind *kind, const struct sample_set *set);

/** "rectangles", "parallelograms", "plane", "warped". */
extern const char *const variation_name[];

/** "segments are ... (taper up to ...)", without an end of line. */
void variation_print(const struct variation *v, FILE *stream);

#endif
