/* What all islands of a run have in common. */
#ifndef FOOTPOINT_PLAN_H
#define FOOTPOINT_PLAN_H

#include "../eval/operation_count.h"

enum breeding {
    BREED_PAPER, /* the paper's pd-LinearGP: generations by crossover and mutation, the best one kept */
    BREED_FRONT  /* programs: parents and children compete by their distance from the front of error against cost */
};
enum selection { SELECT_ROULETTE, SELECT_TOURNAMENT };

struct plan {
    uint64_t seed;
    enum breeding breeding;
    enum selection selection;
    size_t population; /* at least 2 */
    size_t migrants;   /* emigrants of one migration, less than population */
    struct prices prices;
    struct prices times; /* of programs, as machines take time: over arrays and in dependent calls, half and half */
    double parsimony;    /* what an operation (in the cost model) costs, as a fraction of the error */
    size_t front_limit;  /* cost of the costliest trees that a front keeps, at least 1 */
    /* Of BREED_FRONT alone: */
    double front_parents; /* part of the parents that comes from the front, 0..1 */
    size_t crowd;         /* individuals of one cost in a population, at most; at least 1 */
    double tune;          /* part of the children, the best, whose numbers are fitted, 0..1 */
    size_t polish_every;  /* generations between fits of the front's inner constants; 0: never */
};

/** Front breeding with tournaments; a product and a sum cost 1, a quotient 8. */
struct plan plan_default(void);

/** What the choice of one champion minimises: the error, grown by the plan's parsimony for each operation, so that
 *  operations must earn their keep. */
double plan_fitness(const struct plan *plan, double error, double cost);

#endif
