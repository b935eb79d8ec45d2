/* The real roots in [0,1] of a quintic, told apart with proof; for the files of this folder alone.  The polynomial is
 * in Bernstein's basis,
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

/* All roots of [0,1] lie in such intervals.  In a single one lies one root, a simple one, and none at its ends; in
 * another what lies there cannot be told: every coefficient is 0 within its error, or the interval cannot be halved. */
struct roots_interval {
    struct twofold low; /* the interval is [low, low + width] */
    double width;
    double most; /* |p| is no more, over the interval */
    int single;
    struct roots_polynomial local; /* of a single one: the polynomial over it, from 0 to 1 */
};

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** @return how many, from left to right */
int footpoint_roots_isolate(const struct roots_polynomial *p, struct roots_interval interval[ROOTS_MOST]);

/** Cuts a single interval until it is at most `width` wide, or the sign where it is to be cut cannot be told: below the
 *  units of double if need be. */
void footpoint_roots_narrow(struct roots_interval *interval, double width);

/** Where in a single interval the root is, as well as can be told: bounds on errors are amply above them. */
struct twofold footpoint_roots_middle(const struct roots_interval *interval);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
