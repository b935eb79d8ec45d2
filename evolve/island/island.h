/* An island: one population of expressions for one output, which evolves by itself between migrations (the paper's
 * pd-LinearGP, sections 4.1, 5.2 and 6.3, and what goes beyond it). */
#ifndef FOOTPOINT_ISLAND_H
#define FOOTPOINT_ISLAND_H

#include "../genotype/front.h"
#include "goal.h"

struct island;
/** Plan, goal's genes and fits, and the objective (of decimal numbers) must outlive the island. */
struct island *island_new(const struct plan *plan, const struct goal *goal, struct objective *objective);
void island_free(struct island *is);

/** Generation 0: n seeds (each at most max_length genes), then random trees of all shapes. */
void island_start(struct island *is, const struct genes *seed, size_t n);
/** One generation. */
void island_step(struct island *is);
/** The best so far: lowest plan_fitness.  Valid until the island changes. */
const struct individual *island_best(const struct island *is);

/** Ints of a parcel of n individuals. */
size_t island_parcel_size(const struct island *is, size_t n);
/** Copy n of its best into a parcel: for each its length and max_length genes. */
void island_pack(const struct island *is, size_t n, int *parcel);
/** Let the n individuals of a parcel compete with those that live here. */
void island_receive(struct island *is, size_t n, int *parcel);

/** For the log: median error of the population, or nearly. */
double island_median(const struct island *is);
/** For the log: individuals evaluated so far; those remembered do not count. */
uint64_t island_evaluations(const struct island *is);

/** Bytes of a saved state, fixed for an island. */
size_t island_state_size(const struct island *is);
/** Save everything that the next generations depend on: what follows is the same as without the interruption. */
void island_save(const struct island *is, unsigned char *to);
/** Go on from a saved state.  False, and the island as it was, where it is no state of such an island. */
bool island_load(struct island *is, const unsigned char *from);

/** Ints of a report of any front. */
size_t island_report_size(const struct island *is);
/** The front: how many members, then each with its error, by ascending cost. */
void island_report(const struct island *is, int *report);
/** A report's member, the first of which begins at report + 1; returns where the next begins.  *t: genes in the report. */
const int *island_reported(const int *at, struct genes *t, double *error);

#endif
