/* The Pareto front of error against cost: the best genes found at each cost. */
#ifndef FOOTPOINT_FRONT_H
#define FOOTPOINT_FRONT_H

#include "genotype.h"

struct member {
    struct genes genes; /* not owned: in the front's pool; length 0: empty */
    double error, cost;
    int origin;    /* the owner's code for where the member comes from */
    bool polished; /* its constants were fitted */
};

/** Members indexed by cost, rounded to an integer. Each has a lower error than every cheaper member. */
struct front {
    size_t limit, max_length;
    struct member *member; /* owned: member[0..limit]; read only */
    double *lowest;        /* owned: lowest[c] is the lowest error at costs 0..c; INFINITY if that range is empty */
    int *pool;             /* owned */
};
/** Returns an empty front for costs 0..limit and genomes of at most max_length genes. */
struct front *front_new(size_t limit, size_t max_length);
void front_free(struct front *f);
void front_clear(struct front *f);
void front_copy(const struct front *from, struct front *to);

/** Returns the rounded cost, or limit + 1 if it exceeds the limit. */
size_t front_place(const struct front *f, double cost);
/** Returns the lowest error among members that cost no more, or INFINITY if there is no such member. A cost beyond the
 *  limit is compared with the whole front. */
double front_error(const struct front *f, double cost);
/** Adds genes if no member that costs no more has a lower or equal error, and removes the members that they dominate.
 *  Returns the new member, or NULL. */
struct member *front_offer(struct front *f, const struct genes *t, double error, double cost);
size_t front_count(const struct front *f);
/** Returns the k-th member by ascending cost; k must be less than front_count(). */
struct member *front_member(const struct front *f, size_t k);

#endif
