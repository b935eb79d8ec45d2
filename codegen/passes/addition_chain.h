/* The fewest additions for several sums of points, whose coefficients add up to 0 in each: the vectors of a segment,
 * for which x, y and z take the same. */
#ifndef FOOTPOINT_ADDITION_CHAIN_H
#define FOOTPOINT_ADDITION_CHAIN_H

#include <stdbool.h>
#include <stdint.h>

enum { ADDITIONS_POINTS = 10, ADDITIONS_VECTORS = 12, ADDITIONS_VALUES = 64 };

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

/** Carries out an addition, all but its divisor, which it finds; *v is reduced.  False as of vector_reduce. */
bool addition_value(const struct additions *x, struct addition *s, struct vector *v);

/** Few enough for additions_find. */
bool additions_few(int points, int vectors);

/** Additions, `most` at most, that make n vectors, up to their size; of the shortest that are found those with the
 *  fewest multiplications.  False if none are found within a bounded search.  For few points and vectors. */
bool additions_find(int points, const struct vector *wanted, int n, int most, struct additions *found);

/** The same for any, not always the fewest: sums of differences along a tree of the points (addition_tree.c), maybe
 *  others for another seed.  False if there are too many values. */
bool additions_along_tree(int points, const struct vector *wanted, int n, uint64_t seed, struct additions *found);

#endif
