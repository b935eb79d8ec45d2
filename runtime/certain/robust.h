/* Finds the closest point of a bilinear segment, beginning with the header's answer; see robust.c. */
#ifndef FOOTPOINT_ROBUST_H
#define FOOTPOINT_ROBUST_H

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* The status of a header's function, and its answer if that is >= 0.  The function is footpoint_quad4_accurate_closest for a
 * four-node segment, and for other faces a search for the foot point, whose gap is the distance. */
struct robust_start {
    int status;
    double loc[2], distance;
};

/** Does the work of footpoint_robust for the nodes A, B, C, D, S. */
int footpoint_robust_from(const double *const x[5], const struct robust_start *start, double loc[2], double *dist);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
