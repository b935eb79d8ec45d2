/* Costs of operations, by which codegen compares forms of an expression. */
#ifndef FOOTPOINT_COST_H
#define FOOTPOINT_COST_H

#include "../base/base.h"

/** Cost of each operation. `throughput`, in units of a vector addition: mul 1, add 1, div 8, sqrt 12, compare 1.
 *  `paper`: mul 1, div 1, the rest nearly nothing. */
struct cost_model {
    char name[32];
    double mul, add, div, sqrt, compare;
};

/** Latency in cycles, on most cores since 2015 (Sapphire Rapids: 4, 2 to 3, 14, 21, 4). Statements and operands are
 *  ordered by these, whatever the cost model. */
extern const struct cost_model cost_cycles;

/** Operations as written: every *, /, + or -, and square root in the statements. Constant quotients such as (7.0 /
 *  3.0), which a compiler folds, do not count. */
struct operations {
    long mul, div, add, sqrt;
    long compare;     /* min, max, abs and the test of a protected quotient */
    long temporaries; /* named values */
};

/** Returns the total cost of all operations. */
double operations_cost(const struct operations *ops, const struct cost_model *m);

/** Returns the cost of function k of one number; adds n of it to the operations. */
double unary_cost(const struct cost_model *m, unsigned k);
void unary_count(struct operations *ops, unsigned k, long n);

/** Finds "throughput", "operations", "paper", or a file written by footpoint-calibrate. Returns false, with *d filled,
 *  on failure. */
bool cost_model_find(const char *name, struct cost_model *m, struct diag *d);

#endif
