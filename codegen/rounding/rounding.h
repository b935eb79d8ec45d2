/* Rounding errors of a program, bounded over a box, forwards and backwards. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "../region/forms.h"

/** The effect on the result of an error added to a value: the result's derivative, and the derivative times the
 *  value. */
struct sensitivity {
    struct interval slope, weight;
    struct interval slope_span, weight_span; /* over subsets of its uses: those in which a product is rounded */
};

struct rounding {
    struct arena arena; /* of all arrays */
    struct arithmetic arithmetic;
    struct forms *forms; /* not owned: enclosures of the exact values */
    int *target;         /* owned: operations whose errors are wanted */
    size_t targets;
    bool *asked; /* owned: by operation; it is a target */
    int *needed; /* owned: operations on which the targets depend, ascending */
    size_t needs;
    size_t *place;          /* owned: by operation; its index in `needed` */
    bool links;             /* joints' errors are bounded backwards: there are few enough */
    double *constant;       /* owned: by operation; error of the constants */
    double *error;          /* owned: by operation; bounds |computed - exact|; +infinity: no bound */
    double *relative;       /* owned: by operation; bounds |computed - exact| / |exact| */
    bool *linked;           /* owned: by operation; a joint whose backward error bound is below the forward bound */
    bool *nonnegative;      /* owned: by operation; the computed value is certainly >= 0 */
    struct sensitivity *by; /* owned: by operation; 0 between searches */
};

/** Returns a workspace for the errors of operations that the forms enclose. */
struct rounding *rounding_new(struct forms *w, const int *target, size_t targets);
void rounding_free(struct rounding *e);

/** Bounds |computed - exact| over the box of the forms' last evaluation, whichever products are contracted to FMA;
 *  indexed by target. */
void rounding_errors(struct rounding *e, double *error);

/* ---- what they are made of ---- */

/* Returns true for exact values that the program receives: its inputs, which a region block may compute. */
static inline bool rounding_is_given(const struct known *x, int op)
{
    return (size_t)op < x->first;
}

/* Multiplies sizes: 0 times infinity is 0. */
static inline double rounding_product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : above(a * b);
}

static inline double rounding_of_last(const struct rounding *e, double most)
{
    return e->arithmetic.unit * most + e->arithmetic.least;
}

/* Encloses all values of an operation between exact and computed. */
static inline struct interval rounding_inflated(const struct rounding *e, int i)
{
    const struct interval x = e->forms->range[i];
    return e->error[i] > 0 ? (struct interval){below(x.lo - e->error[i]), above(x.hi + e->error[i])} : x;
}

/* ---- forwards: rounding_forwards.c ---- */

/** Computes the errors of operation i from its operands' errors. */
void rounding_propagate(struct rounding *e, size_t i);

/** Returns the rounding error of the operation itself: at most share |value| + constant. */
double rounding_own_share(const struct rounding *e, int i, double *constant);

/** Returns 1/n for an n-th root, otherwise 0. */
double rounding_power(const struct op *op);
/** Encloses the derivative of an n-th root of a, root / (n a); the whole line for other functions. */
struct interval rounding_function_slope(const struct op *op, struct interval a);

/** Returns a bound of the error of a value up to `most`, padded for the roundings of the bound itself. Returns infinity
 *  for NaN, negative numbers, and values that may overflow. */
double rounding_checked(const struct rounding *e, double error, double most);

#endif
