/* Evaluates a program at two random points modulo a random prime, with the chance that they mislead. */
#ifndef FOOTPOINT_PROVE_POINTS_H
#define FOOTPOINT_PROVE_POINTS_H

#include "../program/program.h"

struct points {
    fmpz *value[2]; /* owned: by operation, at each point */
    fmpz_t prime;
    size_t ops;
    unsigned long bits;  /* of the prime */
    double log2_failure; /* log2 of the chance that two different operations look equal */
    bool functions;      /* the program has functions; the prime then identifies larger rationals */
};

/** Evaluates p. Functions are new variables, one for each kind and arguments, subject to these rules: functions of
 *  constants fold; |c a| = |c| |a|; min and max commute, and min(a, a) = a; a protected quotient depends on its
 *  quotient and the zeros of its divisor. Returns NULL if a divisor is 0 (*divisor: its operation) or if degrees are
 *  too high for any prime (*divisor: -1). */
struct points *points_new(const struct program *p, int *divisor);
void points_free(struct points *x);

/** Returns true if two operations have the same value. */
bool points_equal(const struct points *x, int a, int b);

/** Finds the ratio a / b if it is a constant whose numerator and denominator are short enough to be identified. */
bool points_factor(const struct points *x, int a, int b, fmpq *factor);

/** Returns, for each operation, the first operation of which it is a constant multiple; -1 for constants. The caller
 *  frees it. */
int *points_classes(const struct points *x);

#endif
