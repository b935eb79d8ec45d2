/* Rounding errors of a program, bounded over a box. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "forms.h"

/** What an error added to a value does to the result: the result's derivative, and that times the value. */
struct sensitivity {
    struct interval slope, weight;
    double slope_size, weight_size; /* sums of the sizes of their parts, one for each use of the value */
    double drift;                   /* how far the derivative is from that at the exact values, at most */
};

struct rounding {
    struct arithmetic arithmetic;
    struct forms *forms; /* not owned: the enclosures of the exact values */
    int op;              /* whose error is asked for */
    int *needed;         /* owned: operations that it depends on, ascending */
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

/** For the error of operation `op`, which the forms are of. */
struct rounding *rounding_new(struct forms *w, int op);
void rounding_free(struct rounding *e);

/** Above |computed - exact| over the box that the forms were evaluated on last, whichever products are contracted to
 *  FMA. */
double rounding_error(struct rounding *e);

#endif
