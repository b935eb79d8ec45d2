/* The closest point of a bilinear segment, from the answer of the header; see robust.c. */
#ifndef FOOTPOINT_ROBUST_H
#define FOOTPOINT_ROBUST_H

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* The status of a header's function, and its answer if that is >= 0: of a four-node segment those of footpoint_quad4_accurate_closest,
 * of other faces those of a search for the foot point, whose gap is the distance. */
struct robust_start {
    int status;
    double loc[2], distance;
};

/** Finds what footpoint_robust returns, of the nodes A, B, C, D, S. */
int footpoint_robust_from(const double *const x[5], const struct robust_start *start, double loc[2], double *dist);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
