/* The fewest additions for several sums of points, whose coefficients add up to 0 in each: the vectors of a segment,
 * for which x, y and z take the same. */
#ifndef FOOTPOINT_ADDITIONS_H
#define FOOTPOINT_ADDITIONS_H

#include <stdbool.h>

enum { ADDITIONS_POINTS = 6, ADDITIONS_VECTORS = 5, ADDITIONS_VALUES = 16 };

/** Coefficients of the points: no common divisor, the first that is not 0 positive. */
struct vector {
    long of[ADDITIONS_POINTS];
};

/** (p a + q b) / d of two points or of two earlier values. */
struct addition {
    int a, b;
    long p, q, d;
};

/** Values; the first of them are the points. */
struct additions {
    struct vector value[ADDITIONS_VALUES];
    struct addition addition[ADDITIONS_VALUES]; /* by value */
    int points, values;
    int multiplications; /* additions whose p and q differ in size */
};

/** Divides by *divisor, which all have in common.  False for zeros alone, and for numbers too large to go on with. */
bool vector_reduce(struct vector *v, long *divisor);
bool vector_equal(const struct vector *a, const struct vector *b);

/** Additions, `most` at most, that make n vectors, up to their size; of the shortest that are found those with the
 *  fewest multiplications.  False if none are found within a bounded search. */
bool additions_find(int points, const struct vector *wanted, int n, int most, struct additions *found);

#endif
