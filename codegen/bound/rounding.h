/* Rounding errors of a program, bounded over a box; and what bounds forwards, backwards and on a hull are made of. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "forms.h"
#include "hull.h"

/** What an error added to a value does to the result: the result's derivative, and that times the value. */
struct sensitivity {
    struct interval slope, weight;
    struct interval slope_span, weight_span; /* of some of its uses, those in which a product is rounded */
    double drift;                            /* how far the derivative is from that at the exact values, at most */
    double pushed;                           /* of that, what does not come by way of joints on a hull */
    double more;                             /* on a hull: by how much errors raise weights */
};

struct rounding {
    struct arithmetic arithmetic;
    struct forms *forms;          /* not owned: the enclosures of the exact values */
    const struct hull *hull;      /* not owned: where the values lie; NULL: anywhere in the region */
    const struct hull_part *part; /* not owned: and in which part */
    int *target;                  /* owned: operations whose errors are asked for */
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
    /* on a hull */
    double *rest;  /* owned: by operation, of a joint: its error less units times the weights that it is made of */
    double *reach; /* owned: by operation of the program and joint, what an error added to it does to that, at most */
    bool limited;  /* errors do not change what operations so far choose */
    /* owned: by joint, on a way backwards, what errors do to the derivatives that it hands on, not by way of others; as far as
     * that way came */
    double *source;
    size_t first_source, sources;
};

/** For the errors of operations of the program, which the forms are of; `hull` where these are the outputs of its program, or
 *  NULL. */
struct rounding *rounding_new(struct forms *w, const struct hull *hull, const int *target, size_t targets);
void rounding_free(struct rounding *e);

/** Above |computed - exact| over the box that the forms were evaluated on last, whichever products are contracted to
 *  FMA, by target. */
void rounding_errors(struct rounding *e, double *error);
/** The same on a part of the hull, of all operations that the targets are made of: e->error.  Needs e->links. */
void rounding_errors_on_part(struct rounding *e, const struct hull_part *part);

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

/* The magnitude of a value is at least that. */
static inline double rounding_least(const struct rounding *e, int i)
{
    const double least = interval_least(e->forms->range[i]);
    const int own = e->hull ? e->hull->own[i] : -1;
    return own >= 0 && e->hull->divides[own] ? greater(least, e->part->limit[own].least) : least;
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

/* ---- on a hull: rounding_hull.c ---- */

/** Room for what it takes. */
void rounding_begin_on_hull(struct rounding *e);
/** From now on within the limits of a part. */
void rounding_enter(struct rounding *e, const struct hull_part *part);

/** How far errors move the result's derivative by operation i, on a way backwards from joint `result`, and within which limits
 *  that leaves it. */
void rounding_limit_by_hull(struct rounding *e, int result, int i);

/** What operation i, or an input's error, adds to the error of the result beyond units times its weight. */
double rounding_rest(struct rounding *e, int i);

/** After a way backwards from a joint, of that rest or, where it is infinite, without a bound: its error by the sum of the
 *  weights, as far as the part limits that. */
double rounding_end_on_hull(struct rounding *e, int joint, double rest);

/** The part limits derivatives of operation i: errors do not change what it and those before it choose.  Asked in their order. */
bool rounding_is_limited(struct rounding *e, int i);
/** Errors do not change what operation i chooses. */
bool rounding_is_decided(const struct rounding *e, int i);

#endif
