/* Rounding errors of a program in double, bounded over a box. */
#ifndef FOOTPOINT_ROUNDING_H
#define FOOTPOINT_ROUNDING_H

#include "form.h"

struct rounding {
    struct forms *forms; /* not owned: the enclosures of the exact values */
    double *constant;    /* owned: by operation, error of the constants */
    double *error;       /* owned: by operation, above |computed - exact|; +infinity: no bound */
    double *relative;    /* owned: by operation, above |computed - exact| / |exact| */
    bool *nonnegative;   /* owned: by operation, the computed value is >= 0 for certain */
};

struct rounding *rounding_new(struct forms *w);
void rounding_free(struct rounding *e);

/** Above |computed - exact| of operation `op`, which the forms are of, over the box that they were evaluated on last.
 *  Holds whichever products are contracted to FMA. */
double rounding_error(struct rounding *e, int op);

#endif
