/* What an operation costs: the currency in which codegen compares forms of an expression. */
#ifndef FOOTPOINT_COST_H
#define FOOTPOINT_COST_H

#include "base.h"

/** Cost of one operation each.  `throughput`, in units of a vector addition: mul 1, add 1, div 8, sqrt 12, compare 1.
 *  `paper`: mul 1, div 1, the rest nearly nothing.  `latency`: the longest chain counts, not the sum. */
struct cost_model {
    char name[32];
    double mul, add, div, sqrt, compare;
    bool chain; /* cost of the longest chain of dependent operations, ties by the sum */
};

/** "throughput", "paper", "latency", or a file that footpoint-calibrate wrote.  False with *d filled otherwise. */
bool cost_model_find(const char *name, struct cost_model *m, struct diag *d);

#endif
