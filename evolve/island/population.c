/* Functions shared by both ways of breeding; see population.h. */
#include "population.h"

#include "../common/decimal.h"
#include "../genotype/tree.h"

#include <math.h>
#include <string.h>

enum {
    TOURNAMENT = 4,
    SHALLOWEST = 2, /* depths of the first trees, ramped */
    DEEPEST = 6
};

struct remembered *population_memory(const struct island *is, uint64_t hash)
{
    return &is->cache[hash >> (64 - CACHE_BITS)];
}

void population_count(struct island *is, struct individual *x)
{
    const bool both = is->goal.program;
    const struct operation_count o =
        both ? count_lines(is->lines, &x->genes, is->goal.last) : count_operations(is->counter, &x->genes, NULL);
    x->cost = both ? operations_price(&o, &is->plan->times)
                   : operations_price(&o, &is->plan->prices) + frame_cost_of(is->frame, &x->genes);
    x->hash = o.hash;
}

void population_record(struct island *is, const struct individual *x)
{
    front_offer(is->front, &x->genes, x->error, x->cost);
}

int population_compare(const void *a, const void *b)
{
    const struct individual *p = a, *q = b;
    if (p->fitness != q->fitness)
        return p->fitness < q->fitness ? -1 : 1;
    if (p->error != q->error)
        return p->error < q->error ? -1 : 1;
    if (p->genes.length != q->genes.length)
        return p->genes.length < q->genes.length ? -1 : 1;
    return memcmp(p->genes.gene, q->genes.gene, p->genes.length * sizeof *p->genes.gene);
}

const struct genes *population_choose(struct island *is)
{
    const size_t n = is->plan->population;
    size_t chosen = n;
    if (is->plan->selection == SELECT_TOURNAMENT) { /* now[] is sorted, so the lowest index wins */
        for (int i = 0; i < TOURNAMENT; i++) {
            const size_t k = gsl_rng_uniform_int(is->rng, n);
            chosen = k < chosen ? k : chosen;
        }
        return &is->now[chosen].genes;
    }
    const double at = gsl_rng_uniform(is->rng) * is->cumulative[n - 1];
    size_t low = 0, high = n - 1;
    while (low < high) {
        const size_t middle = (low + high) / 2;
        if (is->cumulative[middle] > at)
            high = middle;
        else
            low = middle + 1;
    }
    return &is->now[low].genes;
}

void population_numbers(struct genes *t)
{
    const struct genes numbers = {(int[2]){decimal_gene(-0.1), decimal_gene(0.1)}, 2};
    genes_copy(&numbers, t);
}

/* Makes a random program: a member of the front with a few changes, or two numbers until some program has a finite
 * error. */
static void random_program(struct island *is, struct genes *t)
{
    const struct fitting *f = is->goal.fit;
    enum { CHANGES = 3 };
    const size_t members = front_count(is->front);
    if (members == 0) {
        population_numbers(t);
        return;
    }
    genes_copy(&front_member(is->front, gsl_rng_uniform_int(is->rng, members))->genes, t);
    for (int i = 0; i < CHANGES; i++) {
        const struct genes *mate = &front_member(is->front, gsl_rng_uniform_int(is->rng, members))->genes;
        if (f->change(f->fits, is->rng, is->goal.genes, t, mate, is->goal.last, is->goal.max_length, &is->scratch))
            genes_copy(&is->scratch, t);
    }
}

void population_draw(struct island *is, size_t k, struct genes *t)
{
    if (is->goal.program) {
        random_program(is, t);
        return;
    }
    const int depth = SHALLOWEST + (int)(k / 2) % (DEEPEST - SHALLOWEST + 1);
    tree_random(is->rng, is->goal.genes, depth, k % 2 == 0, is->goal.max_length, t);
}

/* Finds the best individual; with front breeding, a member of the front. */
static void find_best(struct island *is)
{
    is->best = is->now[0];
    if (is->plan->breeding == BREED_PAPER)
        return;
    is->best.fitness = INFINITY;
    for (size_t c = 0; c <= is->front->limit; c++) {
        const struct member *m = &is->front->member[c];
        const double fitness = plan_fitness(is->plan, m->error, m->cost);
        if (m->genes.length > 0 && fitness < is->best.fitness)
            is->best = (struct individual){m->genes, fitness, m->error, m->cost, 0};
    }
}

void population_refresh(struct island *is)
{
    double sum = 0;
    for (size_t i = 0; i < is->plan->population; i++)
        is->cumulative[i] = sum += 1 / fmin(fmax(is->now[i].fitness, 1e-100), 1e100);
    memcpy(is->reference, is->front->lowest, (is->front->limit + 1) * sizeof *is->reference);
    find_best(is);
}
