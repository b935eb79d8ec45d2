/* The hull of the values that a program has at points of a region: where each lies within twice its range there, and so do
 * the derivatives of the joints (named values, divisors, what minima and maxima choose from) by those before them, and these
 * times the values.  That says where bounds of rounding errors are no larger than they need be: it leaves out corners of
 * the region where values cancel as they do nowhere else.
 *
 * Derivatives are along what minima and maxima choose; they are not where two values to choose from are nearly the same. */
#ifndef FOOTPOINT_HULL_H
#define FOOTPOINT_HULL_H

#include "region.h"

/** Sizes of what an error added to a value does to a joint. */
struct hull_slope {
    double slope;  /* |derivative| */
    double weight; /* |derivative * value| */
    double size; /* of products: the sum of the sizes of the derivative's parts, one for each use; infinite of others */
    double size_weight;
};

struct hull {
    const struct region *region;   /* not owned */
    const struct program *program; /* not owned */
    long points;                   /* that were found */
    size_t joints;
    int *own;                 /* owned: by operation of the region's program, that of the program; -1: none */
    int *joint;               /* owned: by operation of the program, which joint it is; -1: none */
    int *op;                  /* owned: by joint, its operation of the program */
    struct hull_slope *slope; /* owned: by joint and operation of the program */
    /* owned, by operation of the program: */
    struct interval *value;
    bool *divides; /* others divide by it */
    /* of what divides: its magnitude is at least, and over that the sum of the weights that it is made of, in units of rounding,
     * at most; of what chooses, the same of the distance of its operands */
    double *least, *share, *apart, *tie;
    double *at, *by, *use, *sum; /* values, derivatives, their sizes and sums of weights at one point */
};

/** Of program p at `points` points of the region, fewer of long programs and where points are hard to find. */
struct hull *hull_new(struct region *r, const struct program *p, long points, unsigned long seed);
void hull_free(struct hull *h);

/** Whether a point of the region, by variable, belongs to it, as far as rounded values tell. */
bool hull_holds(struct hull *h, const double *at);

/** Operation `op` of the region's program is a joint. */
bool hull_is_joint(const struct hull *h, int op);
/** What the hull says of joint `to` and operation `from`, of the region's program; NULL: nothing. */
const struct hull_slope *hull_slope(const struct hull *h, int to, int from);

#endif
