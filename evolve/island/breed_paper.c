/* The paper's pd-LinearGP on one island. A generation keeps the best individual and adds children. Parents are chosen
 * by roulette with fitness 1/error (the paper) or by tournament, then crossed or mutated. A child that repeats a genome
 * seen lately is mutated once more. Evaluation of a child stops once its error is certain to exceed a multiple of the
 * parents' median, at the same block on every machine. */
#include "population.h"

#include "../genotype/tree.h"

#include <math.h>
#include <stdlib.h>

static const double crossover_rate = 0.8, gene_mutation_rate = 0.2, hopeless = 4;

static void evaluate(struct island *is, struct individual *x)
{
    const uint64_t hash = genes_hash(&x->genes);
    struct remembered *r = population_memory(is, hash);
    if (r->hash != hash || hash == 0) {
        *r = (struct remembered){hash, objective_tree_error(is->objective, &x->genes, is->goal.column, is->bound)};
        is->evaluations++;
    }
    population_count(is, x);
    x->error = r->error;
    x->fitness = plan_fitness(is->plan, x->error, x->cost);
    population_record(is, x);
}

/* Mutates a tree that was seen lately, so that few evaluations are wasted. */
static void renew(struct island *is, struct genes *t)
{
    for (int tries = 2; tries > 0; tries--) {
        const uint64_t hash = genes_hash(t);
        if (population_memory(is, hash)->hash != hash)
            break;
        tree_mutate_gene(is->rng, is->goal.genes, t);
    }
}

/* Sorts the population and sets the bound for the children. */
static void rank_population(struct island *is)
{
    const size_t n = is->plan->population;
    qsort(is->now, n, sizeof *is->now, population_compare);
    is->bound = hopeless * is->now[n / 2].error;
}

void breed_paper_start(struct island *is, const struct genes *seed, size_t n)
{
    for (size_t i = 0; i < is->plan->population; i++) {
        if (i < n)
            genes_copy(&seed[i], &is->now[i].genes);
        else
            population_draw(is, i, &is->now[i].genes);
        evaluate(is, &is->now[i]);
    }
    rank_population(is);
}

static void make_children(struct island *is, struct genes *child_a, struct genes *child_b)
{
    struct genes *child[2] = {child_a, child_b};
    const size_t max = is->goal.max_length;
    const struct genes *a = population_choose(is), *b = population_choose(is);
    if (gsl_rng_uniform(is->rng) < crossover_rate) {
        tree_cross(is->rng, a, b, max, child[0], child[1]);
    } else {
        tree_mutate_branch(is->rng, is->goal.genes, a, max, child[0]);
        tree_mutate_branch(is->rng, is->goal.genes, b, max, child[1]);
    }
    for (int k = 0; k < 2; k++)
        if (gsl_rng_uniform(is->rng) < gene_mutation_rate)
            tree_mutate_gene(is->rng, is->goal.genes, child[k]);
}

/* Children follow their parents in the array. The last crossover may make a surplus child. */
void breed_paper_step(struct island *is)
{
    const size_t n = is->plan->population;
    struct individual *next = is->now + n;
    for (size_t i = 1; i < n; i += 2)
        make_children(is, &next[i].genes, &next[i + 1].genes);
    for (size_t i = 1; i < n; i++) {
        renew(is, &next[i].genes);
        evaluate(is, &next[i]);
        const struct individual parent = is->now[i];
        is->now[i] = next[i];
        next[i] = parent;
    }
    rank_population(is);
}

static bool lives_here(const struct island *is, const struct genes *t)
{
    for (size_t i = 0; i < is->plan->population; i++)
        if (genes_equal(&is->now[i].genes, t))
            return true;
    return false;
}

void breed_paper_receive(struct island *is, size_t n, int *parcel)
{
    size_t place = is->plan->population;
    for (size_t i = 0; i < n; i++, parcel += population_parcel(is)) {
        const struct genes migrant = {parcel + 1, (size_t)parcel[0]};
        if (lives_here(is, &migrant))
            continue;
        genes_copy(&migrant, &is->now[--place].genes);
        evaluate(is, &is->now[place]);
    }
    rank_population(is);
}
