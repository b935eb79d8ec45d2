/* The Pareto front of error against cost: the best genes known for each cost. */
#ifndef FOOTPOINT_FRONT_H
#define FOOTPOINT_FRONT_H

#include "genotype.h"

struct member {
    struct genes genes; /* genes not owned: in the front's pool; length 0: none */
    double error, cost;
    int origin;    /* whatever its owner says of it */
    bool polished; /* its constants have been fitted */
};

/** Members by cost, rounded to whole operations.  Each has a lower error than all that cost no more. */
struct front {
    size_t limit, max_length;
    struct member *member; /* owned: member[0..limit]; read only */
    double *lowest;        /* owned: lowest[c]: lowest error of the costs 0..c; INFINITY: none */
    int *pool;             /* owned */
};
/** For costs 0..limit and at most max_length genes. */
struct front *front_new(size_t limit, size_t max_length);
void front_free(struct front *f);
void front_clear(struct front *f);
void front_copy(const struct front *from, struct front *to);

/** Index of a cost, rounded; beyond the limit: limit + 1. */
size_t front_place(const struct front *f, double cost);
/** Lowest error of those that cost no more; the costliest are compared with for costs beyond the limit.  INFINITY:
 * there is none. */
double front_error(const struct front *f, double cost);
/** Take genes in if their error is lower than that of all that cost no more; those that it outdoes leave.  Returns the
 *  new member, or NULL. */
struct member *front_offer(struct front *f, const struct genes *t, double error, double cost);
size_t front_count(const struct front *f);
/** The k-th member, k < front_count, by ascending cost. */
struct member *front_member(const struct front *f, size_t k);

#endif
