/* The population of an island, and what both ways of breeding do with it; for the files of this room. */
#ifndef FOOTPOINT_POPULATION_H
#define FOOTPOINT_POPULATION_H

#include "../../codegen/base/index_table.h"
#include "../eval/frame_cost.h"
#include "../genotype/front.h"
#include "goal.h"

enum { CACHE_BITS = 13 };

/* An individual seen lately. */
struct remembered {
    uint64_t hash; /* 0: empty */
    double error;
};

struct island {
    const struct plan *plan; /* not owned, as are goal's genes and fits and the objective */
    struct goal goal;
    struct objective *objective;

    /* All that the next generations depend on; random streams start anew in each. */
    uint64_t generation;
    uint64_t evaluations;     /* for show alone */
    struct individual *now;   /* owned: room for 2 * population + 2; the first `population` live, best first */
    double bound;             /* BREED_PAPER: errors above it are hopeless; BREED_FRONT: multiples of the front's */
    struct remembered *cache; /* owned: 1 << CACHE_BITS */
    struct front *front;      /* owned: the best so far */

    /* Scratch, and what follows from the rest. */
    gsl_rng *rng;                /* owned */
    struct counter *counter;     /* owned */
    struct frame_cost *frame;    /* owned: of the objective's program */
    struct lines_counter *lines; /* owned: of programs, which cost what they need of the frame with the rest */
    int *pool;                   /* owned: genes of now[] and of scratch */
    struct individual *order;    /* owned: as now[] */
    unsigned char *fate;         /* owned: as now[] */
    size_t *crowd;               /* owned: how many of each cost */
    struct index_table met;      /* hashes and errors of those that live already */
    double *cumulative;          /* owned: roulette wheel of the living */
    double *reference;           /* owned: error at each cost of the front when the generation began */
    struct genes scratch;        /* in the pool */
    struct individual best;      /* lowest plan_fitness; its tree is in the front */
};

struct remembered *population_memory(const struct island *is, uint64_t hash);
/* Operations, hash and cost of an individual. */
void population_count(struct island *is, struct individual *x);
/* A measured individual enters the front. */
void population_record(struct island *is, const struct individual *x);
/* Lowest fitness first, then error, length and genes. */
int population_compare(const void *a, const void *b);
/* Make what follows from the rest: wheel, reference and best; now[] is sorted. */
void population_refresh(struct island *is);
const struct genes *population_choose(struct island *is);
/* The k-th individual of a new population. */
void population_draw(struct island *is, size_t k, struct genes *t);
/* Two numbers: programs that nothing is known of begin with them. */
void population_numbers(struct genes *t);
/* Ints of an individual in a parcel. */
static inline size_t population_parcel(const struct island *is)
{
    return 1 + is->goal.max_length;
}

#endif
