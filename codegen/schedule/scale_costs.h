/* The state of a search for scales, and what nodes cost in them: scale_costs.c. */
#ifndef FOOTPOINT_SCALE_COSTS_H
#define FOOTPOINT_SCALE_COSTS_H

#include "schedule.h"

#include <stdint.h>

enum { SCALING_MOST_TERMS = 24, SCALING_MOST_FACTORS = 32 };

#define NEGATION 0.25 /* a leading minus: at most an operation, at best none */

/* What a node costs: by itself, and the terms that stand alone in it, which several sums may share. */
struct weight {
    int node;
    double own;
    struct shared_term **term;
    size_t terms;
};

/* Factors that a circle of sums was multiplied by, in vain, since the last move that stands. */
struct tried {
    long kept; /* moves that stood then */
    size_t n;
    rational factor[SCALING_MOST_FACTORS];
    double work[SCALING_MOST_FACTORS];
};

/* State of the search: the schedule's scales are those of the move under way, `best` the best so far.  An output counts
 * as a node beyond the graph's.  Sets are bits, indexed by place in the order. */
struct scaling {
    struct arena arena; /* of all that is owned */
    struct schedule *s;
    rational *best;          /* owned: by node */
    rational *ratio;         /* owned: by node, of the schedule's scale to the best */
    size_t *first_edge;      /* owned: by node, where its operands begin in `coef` and `own` */
    rational *coef;          /* owned: coefficients of operands in the best scales */
    bool *plain;             /* owned: by node, all of these are 1 or -1 */
    size_t *place;           /* owned: by node, its place in the order */
    int *twin;               /* owned: by node, the next of the sums like it, in a circle */
    int *circle;             /* owned: by node, the first of these */
    struct tried *tried;     /* owned: by first of a circle, what was tried on all of it */
    size_t *first_user;      /* owned: user[first_user[n]] to user[first_user[n + 1] - 1] are those of node n */
    int *user;               /* owned */
    bool *moves;             /* owned: by node, the move begins with its scale; false between moves */
    uint64_t *dirty;         /* owned: set of nodes that move or whose operands' scales have changed */
    size_t words;            /* of a set */
    int *changed, *affected; /* owned: nodes whose scale the move changed; these and their users */
    size_t changes, affects, charges, weighed;
    bool *listed;          /* owned: by node, is in `affected` */
    struct weight *weight; /* owned: by node, in the best scales */
    struct weight *trial;  /* owned: of the nodes whose costs the move may change, in its scales; `charges` of them, of
                               which `weighed` are */
    struct shared_term **own; /* owned: the terms of `weight` and of `trial` */
    struct shared_term *term; /* owned: the terms that stand alone, with the best scales */
    size_t terms, used;
    rational factor[SCALING_MOST_FACTORS]; /* to try on the sum at hand */
    size_t factors;
    long kept;    /* moves that stand */
    long *failed; /* owned: by place, `kept` when no trial of the node improved anything */
    bool improved;
    double work; /* pairs of terms compared */
};

/** The coefficient of operand i of node n in the best scales; scaling_set_coefficients finds those of a node. */
static inline rational scaling_best_coefficient(const struct scaling *x, int n, size_t i)
{
    return x->coef[x->first_edge[n] + i];
}
void scaling_set_coefficients(struct scaling *x, int n);

/** The cost of a sum in the scales of the move under way, as if nobody else had the terms that stand alone. */
double scaling_sum_cost(const struct scaling *x, int n);

/** The same of a sum without coefficients, some of whose terms have changed by one ratio: if it stays as it is, and if it
 *  follows them. */
void scaling_plain_costs(const struct scaling *x, int n, rational ratio, double *stays, double *follows);

/** The work of comparing a sum's coefficients. */
double scaling_pairs_of(const struct scaling *x, int n);

/** Change of the total when a weight comes (+1) or goes (-1): of terms that stand alone only the first of a kind costs. */
double scaling_charge(const struct scaling *x, const struct weight *w, int sign);

/** Charges the move under way, that is the nodes of x->affected, as far as the total may still fall.  Returns whether it
 *  does. */
bool scaling_charge_move(struct scaling *x);

/** Makes the table of terms from the best scales. */
void scaling_fill_terms(struct scaling *x);

#endif
