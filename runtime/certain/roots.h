/* Isolates the real roots in [0,1] of a quintic, with proof; only for the files of this folder.  The polynomial is in Bernstein's
 * basis,
 *     p(t) = sum over k of binomial(5,k) t^k (1-t)^(5-k) c[k],
 * with coefficients of twice the precision and a bound on the error of each. */
#ifndef FOOTPOINT_ROOTS_H
#define FOOTPOINT_ROOTS_H

#include "twofold.h"

enum { ROOTS_DEGREE = 5, ROOTS_MOST = 12 };

struct roots_polynomial {
    struct twofold c[ROOTS_DEGREE + 1];
    double error[ROOTS_DEGREE + 1];
};

/* All roots of [0,1] lie in such intervals.  A single interval contains exactly one root, which is simple, and no root at its ends.
 * Other intervals are undecided: every coefficient is 0 within its error, or the interval cannot be halved. */
struct roots_interval {
    struct twofold low; /* the interval is [low, low + width] */
    double width;
    double most; /* bound on |p| over the interval */
    int single;
    struct roots_polynomial local; /* in a single interval: the polynomial over it, from 0 to 1 */
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Isolates all roots.
 *  @return the number of intervals, from left to right */
int footpoint_roots_isolate(const struct roots_polynomial *p, struct roots_interval interval[ROOTS_MOST]);

/** Cuts a single interval until it is at most `width` wide, or the sign at the cut is undecided; below the units of double if
 *  necessary. */
void footpoint_roots_narrow(struct roots_interval *interval, double width);

/** Returns the root of a single interval, as accurately as bounds on errors permit. */
struct twofold footpoint_roots_middle(const struct roots_interval *interval);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
