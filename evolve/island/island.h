/* An island: a population of expressions for an output, which evolves independently between migrations (the paper's
 * pd-LinearGP, sections 4.1, 5.2 and 6.3, with extensions). */
#ifndef FOOTPOINT_ISLAND_H
#define FOOTPOINT_ISLAND_H

#include "../genotype/front.h"
#include "goal.h"

struct island;
/** Returns an island. The plan, the goal's genes and fits, and the objective (of decimal numbers) must outlive it. */
struct island *island_new(const struct plan *plan, const struct goal *goal, struct objective *objective);
void island_free(struct island *is);

/** Makes generation 0: n seeds, each of at most max_length genes, then random trees of all shapes. */
void island_start(struct island *is, const struct genes *seed, size_t n);
/** Breeds a generation. */
void island_step(struct island *is);
/** Returns the individual with the lowest plan_fitness so far. Valid until the island changes. */
const struct individual *island_best(const struct island *is);

/** Returns the number of ints in a parcel of n individuals. */
size_t island_parcel_size(const struct island *is, size_t n);
/** Copies the n best individuals into a parcel, each as its length and max_length genes. */
void island_pack(const struct island *is, size_t n, int *parcel);
/** Lets the n individuals of a parcel compete with the island's own. */
void island_receive(struct island *is, size_t n, int *parcel);

/** Returns the median error of the population, approximately, for the log. */
double island_median(const struct island *is);
/** Returns the number of individuals evaluated so far, for the log. Remembered individuals do not count. */
uint64_t island_evaluations(const struct island *is);

/** Returns the size of a saved state in bytes, fixed for an island. */
size_t island_state_size(const struct island *is);
/** Saves everything that the next generations depend on. A restored island continues exactly as an uninterrupted one.
 *  */
void island_save(const struct island *is, unsigned char *to);
/** Restores a saved state. Returns false, and leaves the island unchanged, if the state does not belong to such an
 *  island. */
bool island_load(struct island *is, const unsigned char *from);

/** Returns the number of ints in the largest possible report. */
size_t island_report_size(const struct island *is);
/** Reports the front: the number of members, then each with its error, by ascending cost. */
void island_report(const struct island *is, int *report);
/** Reads a member of a report, the first at report + 1, and returns the position of the next. *t: genes inside the
 *  report. */
const int *island_reported(const int *at, struct genes *t, double *error);

#endif
