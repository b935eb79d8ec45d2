/* p-GA, the paper's genetic algorithm on polynomials (sections 3.2 and 5.2): a bit for each term; parents by
 * roulette, a range of genes exchanged between two, a gene changed in some; coefficients by least squares. */
#ifndef FOOTPOINT_PGA_H
#define FOOTPOINT_PGA_H

#include "polynomials.h"

#include <stdint.h>

struct pga_plan {
    uint64_t seed, stream; /* stream: separates searches of the same seed */
    size_t population;     /* at least 2 */
    size_t terms;          /* N of equation (40); at the number of monomials, unrestricted */
    double crossover;      /* part of the pairs that exchange a range, 0..1 */
    double mutation;       /* part of the individuals in which a gene is changed, 0..1 */
    bool exchange;         /* beyond the paper: improve each new best by exchanges of terms */
};
/** Returns a plan: population 100, crossover 0.7, mutation 0.3. */
struct pga_plan pga_plan_default(void);

/** Computes the mean errors of n choices, stored in sequence: the server's helpers. */
struct pga_evaluator {
    void *context;
    void (*errors)(void *context, const gene_bit *chosen, size_t n, double *error);
};

struct pga;
/** Returns a population of random polynomials of at most the plan's terms, evaluated.  Plan, polynomials and evaluator are not
 *  owned. */
struct pga *pga_new(const struct pga_plan *plan, const struct polynomials *p, const struct pga_evaluator *evaluator);
void pga_free(struct pga *g);
/** Breeds a generation. */
void pga_step(struct pga *g);

struct pga_state {
    size_t generation, evaluations; /* evaluations: individuals that were new */
    size_t singular;                /* among them, individuals with dependent terms */
    const gene_bit *best;           /* not owned */
    size_t terms;                   /* of the best, like: */
    double error;                   /* mean |error| */
    double median;                  /* median fitness of all */
};
struct pga_state pga_look(const struct pga *g);

/** Returns the fitness by equations (32), with the mean instead of the sum, and (40). */
double pga_fitness(double error, size_t terms, size_t limit);

#endif
