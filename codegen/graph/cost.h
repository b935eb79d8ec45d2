/* What an operation costs: the currency in which codegen compares forms of an expression. */
#ifndef FOOTPOINT_COST_H
#define FOOTPOINT_COST_H

#include "../base/base.h"

/** Cost of one operation each.  `throughput`, in units of a vector addition: mul 1, add 1, div 8, sqrt 12, compare 1.
 *  `paper`: mul 1, div 1, the rest nearly nothing. */
struct cost_model {
    char name[32];
    double mul, add, div, sqrt, compare;
};

/** Cycles until a result can be used, on most cores since 2015 (Sapphire Rapids: 4, 2 to 3, 14, 21, 4): statements and
 *  operands are put in order by these, whatever operations cost. */
extern const struct cost_model cost_cycles;

/** Operations as written: every *, /, + or -, and square root that the statements hold; constant quotients such as
 *  (7.0 / 3.0), which a compiler folds, are none. */
struct operations {
    long mul, div, add, sqrt;
    long compare;     /* min, max, abs and the test of a protected quotient */
    long temporaries; /* named values */
};

/** Sum of the costs of all operations. */
double operations_cost(const struct operations *ops, const struct cost_model *m);

/** Cost of function k of one number, and what n of it add to the operations. */
double unary_cost(const struct cost_model *m, unsigned k);
void unary_count(struct operations *ops, unsigned k, long n);

/** "throughput", "operations", "paper", or a file that footpoint-calibrate wrote.  False with *d filled otherwise. */
bool cost_model_find(const char *name, struct cost_model *m, struct diag *d);

#endif
