/* The vectors of a straight segment out of values that a search has computed on its way to xi and eta.
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

/** What a function has: operation `op`, or none (-1), is `factor` times the coordinate. */
struct coordinate {
    int op;
    double factor;
};

struct vectors_found {
    const struct vector *vector;
    struct coordinate at[VECTORS][3];
    int square[VECTORS];                 /* operation: the square of `factor`[0] times the vector; -1 */
    double factor[2];                    /* by which the function has c1, c2, c3, and d */
    double rounding;                     /* see vectors_print */
    int twist;                           /* bits 1, 2: errors of c3's coordinates are of |c1| + |c3|, of |c2| + |c3| */
    struct coordinate product[PRODUCTS]; /* of c1, c2, c3 and d, in the order of vector_products; `factor` as the
                                          * vectors are taken, d / c1's factor */
    double product_rounding;             /* see vectors_product */
    bool *needed;                        /* owned: by operation */
    slong values;
    fmpq *value[POINTS]; /* owned: exact values of the operations at points */
    bool *known[POINTS]; /* owned: those that have one */
};

/** Whether a function has them as they are: of a bilinear segment with corners in any order, or of a flat triangle. */
bool vectors_shared(const struct unit *u, const struct function *f);

/** Finds them in f, if it has them, and marks the operations that they need. */
void vectors_find(struct vectors_found *w, const struct unit *u, const struct function *f);

/** The same of their products: w->product and w->product_rounding. */
void vectors_find_products(struct vectors_found *w, const struct function *f);

void vectors_clear(struct vectors_found *w);

/** "const double a[3] = {-t3, 0.5 * t4, t5};": a, b, c and d, each times the factor that it is taken with.  By rounding each
 *  coordinate is off by w->rounding units of rounding (2^-53 of double): of |c1| + |c2| + |c3| there, d, which has its own factor, of
 *  these and |d|. */
void vectors_print(const struct vectors_found *w, struct printer *r, FILE *out);

/** Product number k of {c1 c1, c1 c2, c2 c2, c1 c3, c2 c3, c3 c3, c1 d, c2 d, c3 d}, times the square of c1's factor; the caller
 *  frees it.  By rounding it is off by w->product_rounding units of the scalar product of what bounds the errors of its
 *  two vectors, times that factor: c1 by |c1| + |c3| + VECTORS_FOREIGN |c2|, c2 by |c2| + |c3| + VECTORS_FOREIGN |c1|, c3 by what
 *  w->twist says, d by |d| + VECTORS_SHIFT (|c1| + |c2| + |c3|). */
char *vectors_product(const struct vectors_found *w, struct printer *r, size_t k);

/** The sum of the squares of c1, c2, c3 as they are taken; the caller frees it. */
char *vectors_size(const struct vectors_found *w, struct printer *r);

#endif
