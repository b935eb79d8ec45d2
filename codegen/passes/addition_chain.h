/* The fewest additions for several sums of points with coefficients that add up to 0: the vectors of a segment. x, y
 * and z use the same additions. */
#ifndef FOOTPOINT_ADDITION_CHAIN_H
#define FOOTPOINT_ADDITION_CHAIN_H

#include <stdbool.h>
#include <stdint.h>

enum { ADDITIONS_POINTS = 10, ADDITIONS_VECTORS = 12, ADDITIONS_VALUES = 64 };

/** Coefficients of the points, without common divisor, the first nonzero coefficient positive. */
struct vector {
    long of[ADDITIONS_POINTS];
};

/** (p a + q b) / d of two points or of two earlier values. */
struct addition {
    int a, b;
    long p, q, d;
};

/** Values; the points come first. */
struct additions {
    struct vector value[ADDITIONS_VALUES];
    struct addition addition[ADDITIONS_VALUES]; /* indexed by value */
    int points, values;
    int multiplications; /* additions with p and q of different size */
};

/** Divides by the common divisor, which becomes *divisor. Returns false for zero vectors and for numbers that are too
 *  large. */
bool vector_reduce(struct vector *v, long *divisor);
bool vector_equal(const struct vector *a, const struct vector *b);

/** Applies an addition and finds its divisor; *v is reduced. Returns false as vector_reduce does. */
bool addition_value(const struct additions *x, struct addition *s, struct vector *v);

/** Returns true if the numbers are small enough for additions_find. */
bool additions_few(int points, int vectors);

/** Finds at most `most` additions that make n vectors, up to their size; among the shortest found, those with the
 *  fewest multiplications. Returns false if a bounded search fails. For few points and vectors. */
bool additions_find(int points, const struct vector *wanted, int n, int most, struct additions *found);

/** Finds additions for any number of points, not always the fewest: sums of differences along a tree of the points
 *  (addition_tree.c). Another seed may give another solution. Returns false if there are too many values. */
bool additions_along_tree(int points, const struct vector *wanted, int n, uint64_t seed, struct additions *found);

#endif
