/* Finds the vectors of a straight segment among values that a search has computed on its way to xi and eta.
 *
 * With r = c0 + xi c1 + eta c2 + xi eta c3 and d = xS - c0: every search has most coordinates of c1, c2, c3 and d, each times a
 * power of 2 of its own, and the squares of c1, c2, c3.  They are found by exact values at two points. */
#ifndef FOOTPOINT_HEADER_VECTORS_H
#define FOOTPOINT_HEADER_VECTORS_H

#include "../../compile/compiled_file.h"
#include "../../program/dialect.h"

#include <flint/fmpq.h>

enum { VECTORS = 4, PRODUCTS = 9, POINTS = 2 };
#define VECTORS_FOREIGN 0.08 /* see vectors_product */
#define VECTORS_SHIFT 0.5

/** A value of a function: operation `op`, or -1, is `factor` times the coordinate. */
struct coordinate {
    int op;
    double factor;
};

struct vectors_found {
    const struct vector *vector;
    struct coordinate at[VECTORS][3];
    int square[VECTORS]; /* operation: the square of `factor`[0] times the vector; -1 */
    double factor[2];    /* factors of the function's c1, c2, c3, and of d */
    double rounding;     /* see vectors_print */
    int twist;           /* bits 1, 2: errors of c3's coordinates are bounded by |c1| + |c3|, by |c2| + |c3| */
    struct coordinate product[PRODUCTS]; /* of c1, c2, c3 and d, in the order of vector_products; `factor` as the
                                          * vectors are taken, d / c1's factor */
    double product_rounding;             /* see vectors_product */
    bool *needed;                        /* owned: by operation */
    slong values;
    fmpq *value[POINTS]; /* owned: exact values of the operations at points */
    bool *known[POINTS]; /* owned: true for operations with an exact value */
};

/** Returns true if a function has them unchanged: on a bilinear segment with corners in any order, or on a flat triangle. */
bool vectors_shared(const struct unit *u, const struct function *f);

/** Finds them in f, if it has them, and marks the operations that they need. */
void vectors_find(struct vectors_found *w, const struct unit *u, const struct function *f);

/** Finds their products: w->product and w->product_rounding. */
void vectors_find_products(struct vectors_found *w, const struct function *f);

void vectors_clear(struct vectors_found *w);

/** Prints "const double a[3] = {-t3, 0.5 * t4, t5};": a, b, c and d, each times its factor.  Rounding errors of each
 *  coordinate are at most w->rounding units of rounding (2^-53 in double) of |c1| + |c2| + |c3| there, and for d, which has its own
 *  factor, of these and |d|. */
void vectors_print(const struct vectors_found *w, struct printer *r, FILE *out);

/** Returns product number k of {c1 c1, c1 c2, c2 c2, c1 c3, c2 c3, c3 c3, c1 d, c2 d, c3 d}, times the square of c1's factor; the caller
 *  frees it.  Its rounding error is at most w->product_rounding units of the scalar product of the error bounds of its
 *  two vectors, times that factor: for c1 |c1| + |c3| + VECTORS_FOREIGN |c2|, for c2 |c2| + |c3| + VECTORS_FOREIGN |c1|, for c3 as
 *  w->twist determines, for d |d| + VECTORS_SHIFT (|c1| + |c2| + |c3|). */
char *vectors_product(const struct vectors_found *w, struct printer *r, size_t k);

/** Returns the sum of the squares of c1, c2, c3, with their factors; the caller frees it. */
char *vectors_size(const struct vectors_found *w, struct printer *r);

#endif
