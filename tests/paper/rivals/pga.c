/* Runs the genetic algorithm; see pga.h.  The best individual always survives, as the paper reports the best of a run. */
#include "pga.h"

#include "../../../evolve/common/stream.h"

#include <gsl/gsl_randist.h>
#include <gsl/gsl_statistics_double.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct individual {
    gene_bit *chosen; /* not owned: in the population's bits */
    double error, fitness;
    bool fresh; /* to be evaluated */
};

struct population {
    gene_bit *bits;           /* owned */
    struct individual *being; /* owned */
};

struct pga {
    const struct pga_plan *plan;
    const struct polynomials *polynomials;
    const struct pga_evaluator *evaluator;
    struct population now, next;
    size_t best;
    size_t generation, evaluations, singular;
    gsl_rng *rng;
    gene_bit *batch; /* owned: individuals to be evaluated */
    double *number;  /* owned: a number for each individual */
};

struct pga_plan pga_plan_default(void)
{
    return (struct pga_plan){.seed = 1, .population = 100, .crossover = 0.7, .mutation = 0.3};
}

double pga_fitness(double error, size_t terms, size_t limit)
{
    const double fitness = error < INFINITY ? 1 / error : 0;
    return terms > limit ? fitness / (100 * (double)(terms - limit)) : fitness;
}

static struct population population_new(size_t individuals, size_t genes)
{
    struct population p = {new_array(individuals * genes, sizeof(gene_bit)), new_array(individuals, sizeof *p.being)};
    for (size_t i = 0; i < individuals; i++)
        p.being[i].chosen = p.bits + i * genes;
    return p;
}

static void population_free(struct population *p)
{
    free(p->bits);
    free(p->being);
}

/* Evaluates all new individuals at once, so that the work can be shared. */
static void evaluate(struct pga *g, struct population *p)
{
    const size_t genes = g->polynomials->count, n = g->plan->population;
    size_t fresh = 0;
    for (size_t i = 0; i < n; i++)
        if (p->being[i].fresh)
            memcpy(g->batch + genes * fresh++, p->being[i].chosen, genes * sizeof *g->batch);
    g->evaluator->errors(g->evaluator->context, g->batch, fresh, g->number);
    g->evaluations += fresh;
    fresh = 0;
    for (size_t i = 0; i < n; i++) {
        struct individual *x = &p->being[i];
        if (!x->fresh)
            continue;
        x->fresh = false;
        x->error = g->number[fresh++];
        x->fitness = pga_fitness(x->error, polynomials_terms(g->polynomials, x->chosen, NULL), g->plan->terms);
        g->singular += x->error < INFINITY ? 0 : 1;
    }
}

/* Improves the best individual by exchanges of terms, if it is new. */
static void exchange(struct pga *g, struct individual *x)
{
    const size_t genes = g->polynomials->count, terms = polynomials_terms(g->polynomials, x->chosen, NULL);
    const size_t limit = g->plan->terms < genes ? g->plan->terms : terms;
    memcpy(g->batch, x->chosen, genes * sizeof *x->chosen);
    if (!polynomials_exchange(g->polynomials, g->batch, limit))
        return;
    double error;
    polynomials_errors(g->polynomials, g->batch, 1, &error);
    g->evaluations++;
    const double fitness = pga_fitness(error, polynomials_terms(g->polynomials, g->batch, NULL), g->plan->terms);
    if (fitness > x->fitness) {
        memcpy(x->chosen, g->batch, genes * sizeof *x->chosen);
        x->error = error;
        x->fitness = fitness;
    }
}

/* Finds the first of the best individuals of the present population. */
static void find_best(struct pga *g, double before)
{
    const struct individual *x = g->now.being;
    g->best = 0;
    for (size_t i = 1; i < g->plan->population; i++)
        if (x[i].fitness > x[g->best].fitness)
            g->best = i;
    if (g->plan->exchange && x[g->best].fitness > before)
        exchange(g, &g->now.being[g->best]);
}

/* Draws half of all terms, or half to all of N. */
static void create(struct pga *g, struct individual *x)
{
    const size_t genes = g->polynomials->count, limit = g->plan->terms;
    if (limit >= genes) {
        for (size_t i = 0; i < genes; i++)
            x->chosen[i] = gsl_rng_uniform_int(g->rng, 2) ? 1 : 0;
        return;
    }
    const size_t least = (limit + 1) / 2, n = least + gsl_rng_uniform_int(g->rng, limit - least + 1);
    size_t *all = new_array(genes, sizeof *all), *some = new_array(n, sizeof *some);
    for (size_t i = 0; i < genes; i++)
        all[i] = i;
    gsl_ran_choose(g->rng, some, n, all, genes, sizeof *all);
    for (size_t i = 0; i < n; i++)
        x->chosen[some[i]] = 1;
    free(all);
    free(some);
}

struct pga *pga_new(const struct pga_plan *plan, const struct polynomials *p, const struct pga_evaluator *evaluator)
{
    struct pga *g = new_array(1, sizeof *g);
    *g = (struct pga){.plan = plan, .polynomials = p, .evaluator = evaluator, .rng = stream_new()};
    g->now = population_new(plan->population, p->count);
    g->next = population_new(plan->population, p->count);
    g->batch = new_array(plan->population * p->count, sizeof *g->batch);
    g->number = new_array(plan->population, sizeof *g->number);
    for (size_t i = 0; i < plan->population; i++) {
        stream_key(g->rng, plan->seed, plan->stream, 0, i);
        create(g, &g->now.being[i]);
        g->now.being[i].fresh = true;
    }
    evaluate(g, &g->now);
    find_best(g, 0);
    return g;
}

void pga_free(struct pga *g)
{
    if (!g)
        return;
    population_free(&g->now);
    population_free(&g->next);
    free(g->batch);
    free(g->number);
    gsl_rng_free(g->rng);
    free(g);
}

/* Draws a parent: the wheel's sectors are proportional to the fitness. */
static const struct individual *draw(const struct pga *g, double total)
{
    double at = gsl_rng_uniform(g->rng) * total;
    size_t i = 0;
    while (i + 1 < g->plan->population && at >= g->now.being[i].fitness)
        at -= g->now.being[i++].fitness;
    return &g->now.being[i];
}

static void copy(const struct pga *g, const struct individual *from, struct individual *to)
{
    memcpy(to->chosen, from->chosen, g->polynomials->count * sizeof *to->chosen);
    to->error = from->error;
    to->fitness = from->fitness;
    to->fresh = false;
}

/* Exchanges a range of genes. */
static void cross(struct pga *g, struct individual *a, struct individual *b)
{
    const size_t genes = g->polynomials->count;
    const size_t i = gsl_rng_uniform_int(g->rng, genes), j = gsl_rng_uniform_int(g->rng, genes);
    const size_t first = i < j ? i : j, last = i < j ? j : i;
    for (size_t k = first; k <= last; k++)
        if (a->chosen[k] != b->chosen[k]) {
            a->chosen[k] ^= 1;
            b->chosen[k] ^= 1;
            a->fresh = b->fresh = true;
        }
}

static void mutate(struct pga *g, struct individual *x)
{
    x->chosen[gsl_rng_uniform_int(g->rng, g->polynomials->count)] ^= 1;
    x->fresh = true;
}

void pga_step(struct pga *g)
{
    const struct pga_plan *plan = g->plan;
    const double before = g->now.being[g->best].fitness;
    double total = 0;
    g->generation++;
    for (size_t i = 0; i < plan->population; i++)
        total += g->now.being[i].fitness;
    copy(g, &g->now.being[g->best], &g->next.being[0]);
    for (size_t i = 1; i < plan->population; i += 2) {
        const bool pair = i + 1 < plan->population;
        struct individual *a = &g->next.being[i], spare = {.chosen = g->batch}, *b = pair ? a + 1 : &spare;
        stream_key(g->rng, plan->seed, plan->stream, g->generation, i);
        copy(g, draw(g, total), a);
        copy(g, draw(g, total), b);
        if (gsl_rng_uniform(g->rng) < plan->crossover)
            cross(g, a, b);
        if (gsl_rng_uniform(g->rng) < plan->mutation)
            mutate(g, a);
        if (gsl_rng_uniform(g->rng) < plan->mutation)
            mutate(g, b);
    }
    const struct population before_step = g->now;
    g->now = g->next;
    g->next = before_step;
    evaluate(g, &g->now);
    find_best(g, before);
}

struct pga_state pga_look(const struct pga *g)
{
    const struct individual *best = &g->now.being[g->best];
    for (size_t i = 0; i < g->plan->population; i++)
        g->number[i] = g->now.being[i].fitness;
    return (struct pga_state){.generation = g->generation,
                              .evaluations = g->evaluations,
                              .singular = g->singular,
                              .best = best->chosen,
                              .terms = polynomials_terms(g->polynomials, best->chosen, NULL),
                              .error = best->error,
                              .median = gsl_stats_median(g->number, 1, g->plan->population)};
}
