/* Decides statements about a whole bilinear segment by subdividing (xi,eta) into boxes; shares nothing with runtime/. */
#ifndef FOOTPOINT_SUBDIVISION_H
#define FOOTPOINT_SUBDIVISION_H

enum { BOXES_ROOTS = 64, BOXES_LEAVES = 256 };

/** xS - r = d0 - c1 xi - c2 eta - c3 xi eta, lengths of about 1; xS may be far away. */
struct boxes_segment {
    long double c1[3], c2[3], c3[3], d0[3];
};

struct boxes_list {
    int roots, leaves;
    long double root[BOXES_ROOTS][2];  /* stationary points, each the only point of its box, to rounding */
    long double leaf[BOXES_LEAVES][2]; /* nearest points, to 1e-13, of undecided boxes */
    int complete;                      /* 0 if the lists, or the number of boxes, ran out */
};

#define BOXES_LEAF 0x1p-22L   /* half-width of undecided boxes */
#define BOXES_BEYOND 0x1p-30L /* margin outside of [-1,1] in which points are searched */

/** Finds all stationary points of the distance from xS, and undecided boxes. */
void boxes_find(const struct boxes_segment *f, struct boxes_list *list);

/** Returns the determinant of the Hessian of half the squared distance, over the sizes of its terms. */
double boxes_regularity(const struct boxes_segment *f, const long double z[2]);

/** Returns |xS - r| - |d0|, without the rounding of a distance from afar. */
long double boxes_height(const struct boxes_segment *f, long double xi, long double eta);

/** Lowers *height to within `enough` of the least height of the segment, and moves z to a point of that height.  This costs little
 *  if z is the closest point already.
 *  @return 1, or 0 if it took too many boxes */
int boxes_lower(const struct boxes_segment *f, long double enough, long double z[2], long double *height);

#endif
