/* The order of statements, and the scale in which each value is computed. */
#ifndef FOOTPOINT_SCHEDULE_H
#define FOOTPOINT_SCHEDULE_H

#include "cost.h"
#include "dag.h"

/** A term size * node of sums, and how many of them have it. */
struct met_term {
    rational size;
    int node, times;
    long count; /* the count that met it */
};

struct schedule {
    const struct dag *dag;          /* not owned */
    const struct cost_model *model; /* not owned */
    int *order;                     /* owned: used nodes, operands first */
    size_t n;
    int *uses;   /* owned: by node, how many operands and outputs name it */
    rational *scale; /* owned: by node; the emitted value is scale * the node's value */
    struct met_term *met; /* owned: hash table of the terms met in the last count */
    size_t mets;
    long count;
};

/** A schedule with every value in its own scale; schedule_improve looks for scales that cost fewer multiplications by
 *  constants. */
struct schedule *schedule_new(const struct dag *g, const struct cost_model *model);
void schedule_improve(struct schedule *s);
void schedule_free(struct schedule *s);

/** Coefficient with which edge i of node n multiplies the emitted value of its operand, in the emitted value of n. */
rational schedule_coefficient(const struct schedule *s, int n, size_t i);

/** True if several sums have the term size * emitted value of `node`, so that it is computed once. */
bool schedule_shares_term(const struct schedule *s, rational size, int node);

#endif
