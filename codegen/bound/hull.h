/* The hull of the values that a program has at points of a region: where each lies within twice its range there, and so do
 * the derivatives of the joints (named values, divisors, what minima and maxima choose from) by those before them, and these
 * times the values.  That says where bounds of rounding errors are no larger than they need be: it leaves out corners of
 * the region where values cancel as they do nowhere else.  It has parts, each the hull of some of the points, as what is large
 * at some of them need not be so at others.
 *
 * Derivatives are along what minima and maxima choose; they are not where two values to choose from are nearly the same.  Where
 * a number is chosen, and what is made of such numbers alone is one, that has no error: what it would move is not limited. */
#ifndef FOOTPOINT_HULL_H
#define FOOTPOINT_HULL_H

#include "region.h"

/** Sizes of what an error added to a value does to a joint. */
struct hull_slope {
    double slope;  /* |derivative| */
    double weight; /* |derivative * value| */
    double size;   /* of products: of the derivative by those uses in which it is rounded; infinite of others */
    double size_weight;
};

/** What an operation is limited to. */
struct hull_limit {
    struct interval value;
    /* of what divides: its magnitude is at least, and over that the sum of the weights that it is made of, in units of rounding,
     * at most; of what chooses, the same of the distance of its operands */
    double least, share, apart, tie;
    double sum; /* of a joint: of the weights that it is made of, in units of rounding, at most */
};

struct hull_part {
    const struct hull *hull;  /* not owned */
    struct hull_limit *limit; /* owned: by operation of the program */
    struct hull_slope *slope; /* owned: by joint and operation of the program */
};

struct hull {
    const struct region *region;   /* not owned */
    const struct program *program; /* not owned */
    size_t joints;
    int *own;        /* owned: by operation of the region's program, that of the program; -1: none */
    int *joint;      /* owned: by operation of the program, which joint it is; -1: none */
    int *op;         /* owned: by joint, its operation of the program */
    bool *divides;   /* owned: by operation of the program, others divide by it */
    double *units;   /* owned: by operation of the program, what it adds at most, its value being 1 */
    int *same;       /* owned: by operation of the program, of constants, the first that is the same but for its sign */
    double *pooled;  /* owned: by operation, of such a first constant, derivatives by the others; 0 between sweeps */
    double *at, *by; /* owned: values at one point, derivatives */
    struct interval *span; /* owned: of the derivatives by some uses, those by others being contracted */
    bool *exact; /* owned: the value at the point is a number that what is chosen says, computed without an error */
    double *sum; /* owned: by input, constant and joint, of the weights that it is made of, in units of rounding */
    long points; /* that its parts were made of */
    size_t parts;
    struct hull_part *part; /* owned */
};

/** Of program p at `points` points of the region, fewer of long programs and where points are hard to find: hull_cover.c. */
struct hull *hull_new(struct region *r, const struct program *p, long points, unsigned long seed);
void hull_free(struct hull *h);

/** Whether a point of the region, by variable, belongs to one of its parts, as far as rounded values tell. */
bool hull_holds(struct hull *h, const double *at);

/** Operation `op` of the region's program is a joint. */
bool hull_is_joint(const struct hull *h, int op);
/** What a part says of a joint, an operation of the region's program, and those of the program; NULL: nothing. */
const struct hull_slope *hull_slopes(const struct hull_part *part, int joint);

/* ---- what it is made of ---- */

/** Without parts. */
struct hull *hull_of_program(const struct region *r, const struct program *p);

/** Goes to a point of the region, by variable. */
void hull_go(struct hull *h, const double *at);
/** Whether the part holds the point where the hull is. */
bool hull_part_holds(struct hull *h, const struct hull_part *part);
/** Makes it hold the point, and finds the sums of weights there; false: some derivatives are none, and limits half raised. */
bool hull_part_raise(struct hull *h, struct hull_part *part);

struct hull_part hull_part_new(const struct hull *h);
struct hull_part hull_part_copy(const struct hull_part *part);
/** Its limits as far as a hull has them, beyond those of its points. */
void hull_part_widen(struct hull_part *part);
void hull_part_free(struct hull_part *part);

#endif
