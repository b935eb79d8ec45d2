/* The closest point of a bilinear segment, from an answer of the header's search; see robust.c. */
#ifndef FOOTPOINT_ROBUST_H
#define FOOTPOINT_ROBUST_H

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/* What a search returned and, if its status is >= 0, wrote; of a four-node segment footpoint_quad4_accurate. */
struct robust_start {
    int status;
    double loc[2], gap;
};

/** Finds what footpoint_robust returns, of the nodes A, B, C, D, S. */
int footpoint_robust_from(const double *const x[5], const struct robust_start *start, double loc[2], double *dist);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
