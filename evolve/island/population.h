/* The population of an island and the operations that both ways of breeding share. For the files of this room. */
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
    const struct plan *plan; /* not owned, like the goal's genes and fits, and the objective */
    struct goal goal;
    struct objective *objective;

    /* State that the next generations depend on. Random streams start anew in each generation. */
    uint64_t generation;
    uint64_t evaluations;     /* for display only */
    struct individual *now;   /* in the arena: room for 2 * population + 2; the first `population` are the living, best
                               * first */
    double bound;             /* evaluation stops above it. BREED_PAPER: an error; BREED_FRONT: a multiple of the
                               * front's error */
    struct remembered *cache; /* in the arena: 1 << CACHE_BITS */
    struct front *front;      /* owned: the best so far */

    /* Scratch, and values derived from the state; arrays are in the arena. */
    struct arena arena;          /* owned */
    gsl_rng *rng;                /* owned */
    struct counter *counter;     /* owned */
    struct frame_cost *frame;    /* owned: of the objective's program */
    struct lines_counter *lines; /* owned: for programs, whose cost includes the frame's values that they need */
    int *pool;                   /* genes of now[] and scratch */
    struct individual *order;    /* like now[] */
    unsigned char *fate;         /* like now[] */
    size_t *crowd;               /* number of individuals of each cost */
    struct index_table met;      /* hashes and errors of the survivors so far */
    double *cumulative;          /* roulette wheel of the living */
    double *reference;           /* the front's error at each cost when the generation began */
    struct genes scratch;        /* in the pool */
    struct individual best;      /* lowest plan_fitness; its tree is in the front */
};

struct remembered *population_memory(const struct island *is, uint64_t hash);
/* Computes the operations, hash and cost of an individual. */
void population_count(struct island *is, struct individual *x);
/* Offers a measured individual to the front. */
void population_record(struct island *is, const struct individual *x);
/* Compares by fitness, then error, length and genes, lowest first. */
int population_compare(const void *a, const void *b);
/* Recomputes derived values: wheel, reference and best. now[] must be sorted. */
void population_refresh(struct island *is);
const struct genes *population_choose(struct island *is);
/* Draws the k-th individual of a new population. */
void population_draw(struct island *is, size_t k, struct genes *t);
/* Makes a program of two numbers, the start when nothing better is known. */
void population_numbers(struct genes *t);
/* Returns the number of ints of an individual in a parcel. */
static inline size_t population_parcel(const struct island *is)
{
    return 1 + is->goal.max_length;
}

/* The two ways of breeding: how a population starts, makes a generation, and accepts n migrants from a parcel. */
void breed_paper_start(struct island *is, const struct genes *seed, size_t n);
void breed_paper_step(struct island *is);
void breed_paper_receive(struct island *is, size_t n, int *parcel);

void breed_front_start(struct island *is, const struct genes *seed, size_t n);
void breed_front_step(struct island *is);
void breed_front_receive(struct island *is, size_t n, int *parcel);

#endif
