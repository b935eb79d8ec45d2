/* Values of a program at two random points modulo a random prime, with the chance that they mislead. */
#ifndef FOOTPOINT_PROVE_POINTS_H
#define FOOTPOINT_PROVE_POINTS_H

#include "../program/program.h"

struct points {
    fmpz *value[2]; /* owned: by operation, at either point */
    fmpz_t prime;
    size_t ops;
    unsigned long bits;  /* of the prime */
    double log2_failure; /* log2 of the chance that two operations of different value look equal */
    bool functions;      /* the program has any; the prime then tells larger rationals */
};

/** Evaluates p.  Functions stand for new variables, one for each kind and arguments, but for what holds of them: those
 * of constants fold, |c a| = |c| |a|, min and max commute and min(a, a) = a, and a protected quotient knows its
 * quotient and where its divisor is 0.  NULL if a divisor is 0, *divisor its operation; or if the degrees defy every
 * prime, *divisor then -1. */
struct points *points_new(const struct program *p, int *divisor);
void points_free(struct points *x);

/** Whether two operations have the same value. */
bool points_equal(const struct points *x, int a, int b);

/** The ratio a / b, a constant, unless its numerator or denominator has more bits than can be told. */
bool points_factor(const struct points *x, int a, int b, fmpq *factor);

/** For each operation the first one that it is a constant multiple of, or -1 for constants.  Caller frees. */
int *points_classes(const struct points *x);

#endif
