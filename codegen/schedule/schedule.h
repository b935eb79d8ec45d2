/* The order of statements, and the scale of each computed value. */
#ifndef FOOTPOINT_SCHEDULE_H
#define FOOTPOINT_SCHEDULE_H

#include "../graph/cost.h"
#include "../graph/dag.h"

/** A term size * node, and the number of sums that contain it with its own coefficient. Size ZERO marks an empty
 *  entry. */
struct shared_term {
    rational size;
    int node, times;
};

struct schedule {
    struct arena arena;             /* of all owned arrays */
    double work;                    /* of the search for scales, in pairs of terms */
    const struct dag *dag;          /* not owned */
    const struct cost_model *model; /* not owned */
    int *order;                     /* owned: used nodes, operands first */
    size_t n;
    int *stage;               /* owned: by node; even for arithmetic, odd for choices; at least each operand's */
    int *uses;                /* owned: by node; number of operands and outputs that name it */
    int *alone;               /* owned: by node; number of these that are not factors of a product */
    rational *scale;          /* owned: by node; the emitted value is scale * the node's value */
    struct shared_term *term; /* owned: hash table with a power of 2 of places */
    size_t terms;
};

/** Returns a schedule with the outputs' nodes in order and in stages, and all scales ONE. Scales may change until
 *  schedule_finish(). */
struct schedule *schedule_new(const struct dag *g, const struct cost_model *model);
void schedule_free(struct schedule *s);

/** Fixes the order of statements and the terms that sums share. */
void schedule_finish(struct schedule *s);

/** Returns the coefficient of edge i in the emitted value of node n, with respect to the operand's emitted value. */
rational schedule_coefficient(const struct schedule *s, int n, size_t i);

/** Returns true if node n is an inverse that is computed once for several users, so that it may have any numerator. */
bool schedule_has_numerator(const struct schedule *s, int n);

/** A term of a sum: coef times the emitted value of an edge's node. Terms with equal `like` have the same |coef|; like
 *  0 marks terms that share nothing: constants, and terms of size ONE. */
struct addend {
    rational coef, size; /* size: |coef| */
    rational like;
    size_t edge;
};

/** Sorts the terms of sum n, one per edge, by `like`, then by edge. */
void schedule_sort_addends(const struct schedule *s, int n, struct addend *sorted);

/** Returns true if several sums have the term size * emitted value of `node`, so that it is computed once. */
bool schedule_shares_term(const struct schedule *s, rational size, int node);

/** Returns the place of a term in a table: its own, or the empty place for it. */
struct shared_term *schedule_term(struct shared_term *table, size_t room, rational size, int node);

/** Returns how many times a value is doubled, x + x, instead of multiplied by +-c; 0: it is multiplied. At equal cost,
 *  a multiplication is preferred, because it can fuse with an addition. */
int schedule_doublings(const struct schedule *s, rational c);

#endif
