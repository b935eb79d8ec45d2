/* Rounding errors of a program, bounded over a box, forwards and backwards. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "../region/forms.h"

/** What an error added to a value does to the result: the result's derivative, and that times the value. */
struct sensitivity {
    struct interval slope, weight;
    struct interval slope_span, weight_span; /* of some of its uses, those in which a product is rounded */
};

struct rounding {
    struct arena arena; /* of all arrays */
    struct arithmetic arithmetic;
    struct forms *forms; /* not owned: the enclosures of the exact values */
    int *target;         /* owned: operations whose errors are asked for */
    size_t targets;
    bool *asked; /* owned: by operation, it is one of these */
    int *needed; /* owned: operations that it depends on, ascending */
    size_t needs;
    size_t *place;          /* owned: by operation, where it stands among these */
    bool links;             /* errors of joints are found backwards: there are not too many of them */
    double *constant;       /* owned: by operation, error of the constants */
    double *error;          /* owned: by operation, above |computed - exact|; +infinity: no bound */
    double *relative;       /* owned: by operation, above |computed - exact| / |exact| */
    bool *linked;           /* owned: by operation, a joint whose error, found backwards, is less than forwards */
    bool *nonnegative;      /* owned: by operation, the computed value is >= 0 for certain */
    struct sensitivity *by; /* owned: by operation; 0 between searches */
};

/** For the errors of operations of the program that the forms enclose. */
struct rounding *rounding_new(struct forms *w, const int *target, size_t targets);
void rounding_free(struct rounding *e);

/** Above |computed - exact| over the box that the forms were evaluated on last, whichever products are contracted to
 *  FMA, by target. */
void rounding_errors(struct rounding *e, double *error);

/* ---- what they are made of ---- */

/* What the program is given, exactly: its inputs, which a region block may compute of others. */
static inline bool rounding_is_given(const struct known *x, int op)
{
    return (size_t)op < x->first;
}

/* Of sizes: 0 times what has no bound is 0. */
static inline double rounding_product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : above(a * b);
}

static inline double rounding_of_last(const struct rounding *e, double most)
{
    return e->arithmetic.unit * most + e->arithmetic.least;
}

/* All values that an operation takes on the way from exact to computed ones. */
static inline struct interval rounding_inflated(const struct rounding *e, int i)
{
    const struct interval x = e->forms->range[i];
    return e->error[i] > 0 ? (struct interval){below(x.lo - e->error[i]), above(x.hi + e->error[i])} : x;
}

/* ---- forwards: rounding_forwards.c ---- */

/** The errors of operation i from those of its operands. */
void rounding_propagate(struct rounding *e, size_t i);

/** What rounding the operation itself adds: up to share |value| + constant. */
double rounding_own_share(const struct rounding *e, int i, double *constant);

/** 1/n of an n-th root, 0 of what is none. */
double rounding_power(const struct op *op);
/** Derivative of an n-th root of a, which is that root / (n a); of other functions nothing is known. */
struct interval rounding_function_slope(const struct op *op, struct interval a);

/** A bound of the error of a value up to `most`, padded for the roundings of the bound itself; NaN, anything below 0, and what
 *  may overflow, is none. */
double rounding_checked(const struct rounding *e, double error, double most);

#endif
