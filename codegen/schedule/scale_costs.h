/* The state of a search for scales, and the costs of nodes in them: scale_costs.c. */
#ifndef FOOTPOINT_SCALE_COSTS_H
#define FOOTPOINT_SCALE_COSTS_H

#include "schedule.h"

#include <stdint.h>

enum { SCALING_MOST_TERMS = 24, SCALING_MOST_FACTORS = 32 };

#define NEGATION 0.25 /* a leading minus: at most an operation, at best free */

/* The cost of a node: its own, and the terms that are separate in it, which several sums may share. */
struct weight {
    int node;
    double own;
    struct shared_term **term;
    size_t terms;
};

/* Factors that were tried in vain on a circle of sums since the last accepted move. */
struct tried {
    long kept; /* number of accepted moves then */
    size_t n;
    rational factor[SCALING_MOST_FACTORS];
    double work[SCALING_MOST_FACTORS];
};

/* State of the search: the schedule's scales belong to the current move, `best` contains the best so far. Outputs count
 * as nodes after the graph's. Sets are bit sets, indexed by place in the order. */
struct scaling {
    struct arena arena; /* of all owned arrays */
    struct schedule *s;
    rational *best;          /* owned: by node */
    rational *ratio;         /* owned: by node; the schedule's scale over the best scale */
    size_t *first_edge;      /* owned: by node; first index of its operands in `coef` and `own` */
    rational *coef;          /* owned: coefficients of operands in the best scales */
    bool *plain;             /* owned: by node; all its coefficients are 1 or -1 */
    size_t *place;           /* owned: by node; its place in the order */
    int *twin;               /* owned: by node; the next similar sum, in a circle */
    int *circle;             /* owned: by node; the first of its circle */
    struct tried *tried;     /* owned: by first of a circle; factors tried on the whole circle */
    size_t *first_user;      /* owned: node n's users are user[first_user[n]] to user[first_user[n + 1] - 1] */
    int *user;               /* owned */
    bool *moves;             /* owned: by node; the move starts with its scale; false between moves */
    uint64_t *dirty;         /* owned: set of nodes that move or whose operands' scales changed */
    size_t words;            /* of a set */
    int *changed, *affected; /* owned: nodes whose scale the move changed; these and their users */
    size_t changes, affects, charges, weighed;
    bool *listed;             /* owned: by node; is in `affected` */
    struct weight *weight;    /* owned: by node, in the best scales */
    struct weight *trial;     /* owned: weights in the move's scales of the `charges` nodes whose costs may change, of
                            * which `weighed` are computed */
    struct shared_term **own; /* owned: the terms of `weight` and of `trial` */
    struct shared_term *term; /* owned: the separate terms, in the best scales */
    size_t terms, used;
    rational factor[SCALING_MOST_FACTORS]; /* to try on the current sum */
    size_t factors;
    long kept;    /* number of accepted moves */
    long *failed; /* owned: by place; `kept` when no trial of the node improved anything */
    bool improved;
    double work; /* pairs of terms compared */
};

/** Returns the coefficient of operand i of node n in the best scales. scaling_set_coefficients must have computed
 *  it. */
static inline rational scaling_best_coefficient(const struct scaling *x, int n, size_t i)
{
    return x->coef[x->first_edge[n] + i];
}
void scaling_set_coefficients(struct scaling *x, int n);

/** Returns the cost of a sum in the scales of the current move, as if no other sum had its separate terms. */
double scaling_sum_cost(const struct scaling *x, int n);

/** Computes two costs of a sum without coefficients, some of whose terms changed by one ratio: if it keeps its scale,
 *  and if it follows them. */
void scaling_plain_costs(const struct scaling *x, int n, rational ratio, double *stays, double *follows);

/** Returns the work of comparing a sum's coefficients. */
double scaling_pairs_of(const struct scaling *x, int n);

/** Returns the change of the total if a weight is added (+1) or removed (-1). Of equal separate terms, only the first
 *  costs. */
double scaling_charge(const struct scaling *x, const struct weight *w, int sign);

/** Charges the current move, that is the nodes of x->affected, as long as the total may still fall. Returns whether it
 *  falls. */
bool scaling_charge_move(struct scaling *x);

/** Fills the table of terms from the best scales. */
void scaling_fill_terms(struct scaling *x);

#endif
