/* What holds all over a bilinear segment, by subdivision of (xi,eta) into boxes; nothing of it shared with runtime/. */
#ifndef FOOTPOINT_SUBDIVISION_H
#define FOOTPOINT_SUBDIVISION_H

enum { BOXES_ROOTS = 64, BOXES_LEAVES = 256 };

/** xS - r = d0 - c1 xi - c2 eta - c3 xi eta, lengths of about 1; xS may be far away. */
struct boxes_segment {
    long double c1[3], c2[3], c3[3], d0[3];
};

struct boxes_list {
    int roots, leaves;
    long double root[BOXES_ROOTS][2];  /* stationary points, each the only one of its box, to rounding */
    long double leaf[BOXES_LEAVES][2]; /* nearest points, to 1e-13, of boxes of which nothing is known */
    int complete;                      /* 0 if the lists, or the number of boxes, were at their end */
};

#define BOXES_LEAF 0x1p-22L   /* half-width of those */
#define BOXES_BEYOND 0x1p-30L /* how far outside of [-1,1] points are looked for */

/** All stationary points of the distance from xS, and what may be some. */
void boxes_find(const struct boxes_segment *f, struct boxes_list *list);

/** The determinant of the Hessian of half the square of the distance, over the sizes of its terms. */
double boxes_regularity(const struct boxes_segment *f, const long double z[2]);

/** |xS - r| - |d0|, without the rounding of a distance from afar. */
long double boxes_height(const struct boxes_segment *f, long double xi, long double eta);

/** Lowers *height to within `enough` of the least height of the segment, and z to a point that has it.  It costs little
 *  if they are that of the closest point already.
 *  @return 1, or 0 if it took too many boxes */
int boxes_lower(const struct boxes_segment *f, long double enough, long double z[2], long double *height);

#endif
