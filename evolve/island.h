/* An island: one population of expressions for one output, which evolves by itself between migrations (the paper's
 * pd-LinearGP, sections 4.1, 5.2 and 6.3). */
#ifndef FOOTPOINT_ISLAND_H
#define FOOTPOINT_ISLAND_H

#include "judge.h"
#include "tree.h"

enum selection { SELECT_ROULETTE, SELECT_TOURNAMENT };

/** What all islands of a run have in common. */
struct plan {
    uint64_t seed;
    size_t population; /* at least 2 */
    enum selection selection;
    double parsimony; /* what a gene costs, as a fraction of the error */
    size_t migrants;  /* emigrants of one migration, less than population */
};

/** What selection minimises: the error, grown by the plan's parsimony for each gene, so that genes must earn their
 * keep. */
double plan_demerit(const struct plan *plan, double error, size_t length);

/** What one island is to find. */
struct goal {
    size_t target;                /* table column */
    size_t max_length;            /* genes */
    const struct gene_set *genes; /* not owned */
    uint64_t ring, place;         /* key of its random streams: which ring, where in it */
};

struct individual {
    struct tree tree; /* genes not owned: in the island's pool */
    double demerit;   /* plan_demerit */
    double error;     /* INFINITY when not finite, or so bad that it was not evaluated to the end */
};

struct island;
/** Plan, goal and judge must outlive the island. */
struct island *island_new(const struct plan *plan, const struct goal *goal, struct judge *judge);
void island_free(struct island *is);

/** Generation 0: the seed (NULL: none; at most max_length genes), then random trees of all shapes. */
void island_start(struct island *is, const struct tree *seed);
/** One generation. */
void island_step(struct island *is);
/** The best individual so far: lowest demerit, then lowest error. */
const struct individual *island_best(const struct island *is);

/** Ints of a parcel of n individuals. */
size_t island_parcel_size(const struct island *is, size_t n);
/** Copy the n best individuals into a parcel: for each its length and max_length genes. */
void island_pack(const struct island *is, size_t n, int *parcel);
/** Let the n individuals of a parcel take the places of the worst, but for those that live here already. */
void island_receive(struct island *is, size_t n, int *parcel);

/** For the log: median error of the population. */
double island_median(const struct island *is);
/** For the log: individuals evaluated so far; those remembered do not count. */
uint64_t island_evaluations(const struct island *is);

/** Bytes of a saved state, fixed for an island. */
size_t island_state_size(const struct island *is);
/** Save everything that the next generations depend on: what follows is the same as without the interruption. */
void island_save(const struct island *is, unsigned char *to);
/** Go on from a saved state.  False, and the island as it was, where it is no state of such an island. */
bool island_load(struct island *is, const unsigned char *from);

/** Ints of a report; may differ among islands and over time. */
size_t island_report_size(const struct island *is);
/** What the island has found: how many trees, and for each its length and genes. */
void island_report(const struct island *is, int *report);

#endif
