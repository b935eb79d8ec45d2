/* Parameters shared by all islands of a run. */
#ifndef FOOTPOINT_PLAN_H
#define FOOTPOINT_PLAN_H

#include "../eval/operation_count.h"

enum breeding {
    BREED_PAPER, /* the paper's pd-LinearGP: generations by crossover and mutation; the best individual is kept */
    BREED_FRONT  /* programs: parents and children compete by their distance from the front of error against cost */
};
enum selection { SELECT_ROULETTE, SELECT_TOURNAMENT };

struct plan {
    uint64_t seed;
    enum breeding breeding;
    enum selection selection;
    size_t population; /* at least 2 */
    size_t migrants;   /* emigrants per migration, less than population */
    struct prices prices;
    struct prices times; /* for programs, modelled on machine time: over arrays and in dependent calls, half each */
    double parsimony;    /* price of an operation (in the cost model), as a fraction of the error */
    size_t front_limit;  /* largest cost of a front's members, at least 1 */
    /* For BREED_FRONT only: */
    double front_parents; /* fraction of parents taken from the front, 0..1 */
    size_t crowd;         /* most individuals of equal cost in a population; at least 1 */
    double tune;          /* fraction of children, the best, whose numbers are fitted, 0..1 */
    size_t polish_every;  /* generations between fits of the front's numbers; 0: never */
};

/** Returns a plan with front breeding and tournaments. A product or sum costs 1, a quotient 8. */
struct plan plan_default(void);

/** Returns the fitness by which a champion is chosen: the error, raised by the plan's parsimony for each operation, so
 *  that each operation must pay for itself. */
double plan_fitness(const struct plan *plan, double error, double cost);

#endif
