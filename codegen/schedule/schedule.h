/* The order of statements, and the scale in which each value is computed. */
#ifndef FOOTPOINT_SCHEDULE_H
#define FOOTPOINT_SCHEDULE_H

#include "../graph/cost.h"
#include "../graph/dag.h"

/** A term size * node, and how many sums have it with a coefficient of its own.  An entry of size ZERO is empty. */
struct shared_term {
    rational size;
    int node, times;
};

struct schedule {
    struct arena arena;             /* of all that is owned */
    double work;                    /* of the search for scales, in pairs of terms */
    const struct dag *dag;          /* not owned */
    const struct cost_model *model; /* not owned */
    int *order;                     /* owned: used nodes, operands first */
    size_t n;
    int *stage;               /* owned: by node; even for arithmetic, odd for choices, no operand's is higher */
    int *uses;                /* owned: by node, how many operands and outputs name it */
    int *alone;               /* owned: by node, how many of these are no factor of a product */
    rational *scale;          /* owned: by node; the emitted value is scale * the node's value */
    struct shared_term *term; /* owned: hash table, a power of 2 of places */
    size_t terms;
};

/** The outputs' nodes in order and in stages, every value as the graph has it: scales may change now, and only now. */
struct schedule *schedule_new(const struct dag *g, const struct cost_model *model);
void schedule_free(struct schedule *s);

/** The order of statements, and the terms that sums share. */
void schedule_finish(struct schedule *s);

/** Coefficient with which edge i of node n multiplies the emitted value of its operand, in the emitted value of n. */
rational schedule_coefficient(const struct schedule *s, int n, size_t i);

/** True if node n is an inverse that is computed once for several users: it may have any numerator. */
bool schedule_has_numerator(const struct schedule *s, int n);

/** A term of a sum: coef times the emitted value of an edge's node.  Terms with equal `like` have the same |coef|;
 * those of like 0 have nothing to share: constants, and terms of size ONE. */
struct addend {
    rational coef, size; /* size: |coef| */
    rational like;
    size_t edge;
};

/** The terms of sum n, as many as it has edges: by `like`, equal ones by edge. */
void schedule_sort_addends(const struct schedule *s, int n, struct addend *sorted);

/** True if several sums have the term size * emitted value of `node`, so that it is computed once. */
bool schedule_shares_term(const struct schedule *s, rational size, int node);

/** Place of a term in such a table: its own, or the empty one where it belongs. */
struct shared_term *schedule_term(struct shared_term *table, size_t room, rational size, int node);

/** How many times a value is doubled, x + x, instead of multiplied by +-c: 0 if multiplied.  Where both cost the same,
 *  a multiplication has the advantage that it can fuse with an addition. */
int schedule_doublings(const struct schedule *s, rational c);

#endif
