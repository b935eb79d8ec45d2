/* Breeding towards the front of error against cost. Parents come from the population and from the front. Most operators
 * change little; a child seen lately is made anew. Parents and children then compete by the ratio of their error to the
 * front's error at their own cost, as the front was when the generation began. So every size is under the same
 * pressure, and growth must pay. Equal errors and equal structures are kept once, and the number of individuals of
 * equal cost is limited. A child is rejected before all samples are evaluated once its ratio is certain to exceed the
 * worst parent's. */
#include "population.h"

#include "../../codegen/base/random.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TRIES = 4 };                    /* attempts to make a child not seen lately */
static const double smallest = 1e-300; /* errors are clamped to it, so that 0 can be compared */
static const double immigrants = 0.02; /* fraction of random programs among the children */

static double ratio(const struct island *is, const struct individual *x)
{
    const size_t place = front_place(is->front, x->cost);
    if (place > is->front->limit || x->error == INFINITY)
        return INFINITY;
    return (x->error + smallest) / (is->reference[place] + smallest);
}

/* Computes the error of an individual whose cost is known. */
static void evaluate(struct island *is, struct individual *x)
{
    const size_t place = front_place(is->front, x->cost);
    struct remembered *r = population_memory(is, x->hash);
    x->error = INFINITY;
    if (place > is->front->limit)
        return;
    if (r->hash != x->hash) {
        const double bound = is->bound < INFINITY ? is->bound * is->reference[place] : INFINITY;
        *r = (struct remembered){
            x->hash, objective_error_in_tails(is->objective, &x->genes, is->goal.last, &is->goal.tails, bound)};
        is->evaluations++;
    }
    x->error = r->error;
    population_record(is, x);
}

static void fix_reference(struct island *is)
{
    memcpy(is->reference, is->front->lowest, (is->front->limit + 1) * sizeof *is->reference);
}

/* Returns true if the key is new to the table, and adds it. */
static bool meet(struct island *is, uint64_t key)
{
    const uint64_t hash = random_mix(key); /* a bijection: different keys, different hashes */
    size_t probe = 0;
    const bool fresh = index_next(&is->met, hash, &probe) < 0;
    if (fresh)
        index_add(&is->met, hash, 0);
    return fresh;
}

enum fate { LIVES, CROWDED_OUT, DOUBLE, FATES };

/* Decides whether an individual survives, given that all better individuals were decided. */
static enum fate fate_of(struct island *is, const struct individual *x)
{
    uint64_t bits;
    memcpy(&bits, &x->error, sizeof bits);
    if (x->fitness == INFINITY)
        return DOUBLE;
    const bool new_tree = meet(is, x->hash), new_error = meet(is, bits);
    if (!new_tree || !new_error)
        return DOUBLE;
    return ++is->crowd[front_place(is->front, x->cost)] > is->plan->crowd ? CROWDED_OUT : LIVES;
}

/* Selects the survivors among the first n of now[], by ratio: no duplicates, at most `crowd` of equal cost. If too few
 * remain, rejected individuals fill the population. */
static void select_survivors(struct island *is, size_t n)
{
    size_t ordered = 0;
    index_clear(&is->met);
    memset(is->crowd, 0, (is->front->limit + 1) * sizeof *is->crowd);
    for (size_t i = 0; i < n; i++)
        is->now[i].fitness = ratio(is, &is->now[i]);
    qsort(is->now, n, sizeof *is->now, population_compare);
    for (size_t i = 0; i < n; i++)
        is->fate[i] = (unsigned char)fate_of(is, &is->now[i]);
    for (int fate = LIVES; fate < FATES; fate++)
        for (size_t i = 0; i < n; i++)
            if (is->fate[i] == fate)
                is->order[ordered++] = is->now[i];
    memcpy(is->now, is->order, n * sizeof *is->now);
}

/* Ends the generation: ranks the survivors against the current front. */
static void rank_population(struct island *is)
{
    const size_t n = is->plan->population;
    fix_reference(is);
    for (size_t i = 0; i < n; i++)
        is->now[i].fitness = ratio(is, &is->now[i]);
    qsort(is->now, n, sizeof *is->now, population_compare);
    is->bound = is->now[n - 1].fitness;
}

static void fill_at_random(struct island *is, size_t first)
{
    for (size_t i = first; i < is->plan->population; i++) {
        population_draw(is, i, &is->now[i].genes);
        population_count(is, &is->now[i]);
        evaluate(is, &is->now[i]);
    }
    rank_population(is);
}

/* Starts with two numbers, to which insertions can add terms. Without seeds, evolution starts from this program. */
void breed_front_start(struct island *is, const struct genes *seed, size_t n)
{
    size_t living = 1;
    fix_reference(is);
    population_numbers(&is->now[0].genes);
    population_count(is, &is->now[0]);
    evaluate(is, &is->now[0]);
    for (size_t i = 0; i < n; i++) { /* if the front has more members than the population, the rest are parents through
                                      * the front */
        struct individual *x = &is->now[living];
        genes_copy(&seed[i], &x->genes);
        population_count(is, x);
        evaluate(is, x);
        living += living + 1 < is->plan->population / 2;
    }
    fill_at_random(is, living);
}

/* Chooses a member of the front, mostly expensive, near the budget. */
static const struct genes *choose(struct island *is)
{
    const size_t n = front_count(is->front);
    if (n == 0 || gsl_rng_uniform(is->rng) >= is->plan->front_parents)
        return population_choose(is);
    const size_t one = gsl_rng_uniform_int(is->rng, n), other = gsl_rng_uniform_int(is->rng, n);
    return &front_member(is->front, one > other ? one : other)->genes;
}

static bool change(struct island *is, struct genes *child)
{
    const struct fitting *f = is->goal.fit;
    const struct genes *t = choose(is), *mate = choose(is);
    return f->change(f->fits, is->rng, is->goal.genes, t, mate, is->goal.last, is->goal.max_length, child);
}

static bool is_new(const struct island *is, const struct individual *x)
{
    return front_place(is->front, x->cost) <= is->front->limit && population_memory(is, x->hash)->hash != x->hash;
}

static void make_child(struct island *is, struct individual *x)
{
    bool done = false;
    for (int tries = 0; !done && tries < TRIES; tries++) {
        if (gsl_rng_uniform(is->rng) < immigrants || !change(is, &x->genes))
            population_draw(is, gsl_rng_uniform_int(is->rng, 1000), &x->genes);
        population_count(is, x);
        done = is_new(is, x);
    }
}

/* Fits the numbers of the best children. A fitted program replaces its child if it is better. */
static void tune_children(struct island *is)
{
    const struct fitting *f = is->goal.fit;
    const size_t n = is->plan->population;
    struct individual *child = is->now + n, *fitted = is->now + 2 * n;
    for (size_t i = 0; i < n; i++)
        child[i].fitness = ratio(is, &child[i]);
    qsort(child, n, sizeof *child, population_compare);
    for (size_t i = 0; i < (size_t)(is->plan->tune * (double)n) && child[i].fitness < INFINITY; i++) {
        if (!f->fit(f->fits, &child[i].genes, is->goal.last, false, &fitted->genes))
            continue;
        population_count(is, fitted);
        evaluate(is, fitted);
        if (ratio(is, fitted) < child[i].fitness) {
            const struct individual unfitted = child[i];
            child[i] = *fitted;
            *fitted = unfitted;
        }
    }
}

/* Fits the constants of the front's new members. */
static void polish(struct island *is)
{
    const struct fitting *f = is->goal.fit;
    struct individual *x = &is->now[2 * is->plan->population];
    for (size_t c = 0; c <= is->front->limit; c++) {
        struct member *m = &is->front->member[c];
        if (m->genes.length == 0 || m->polished)
            continue;
        m->polished = true;
        if (!f->fit(f->fits, &m->genes, is->goal.last, true, &x->genes))
            continue;
        population_count(is, x);
        evaluate(is, x);
        if (m->genes.length > 0 && m->error == x->error)
            m->polished = true;
    }
}

void breed_front_step(struct island *is)
{
    const struct plan *p = is->plan;
    for (size_t i = p->population; i < 2 * p->population; i++) {
        make_child(is, &is->now[i]);
        evaluate(is, &is->now[i]);
    }
    tune_children(is);
    select_survivors(is, 2 * p->population);
    if (p->polish_every > 0 && is->generation % p->polish_every == 0)
        polish(is);
    rank_population(is);
}

void breed_front_receive(struct island *is, size_t n, int *parcel)
{
    struct individual *migrant = is->now + is->plan->population;
    for (size_t i = 0; i < n; i++, migrant++, parcel += population_parcel(is)) {
        const struct genes t = {parcel + 1, (size_t)parcel[0]};
        genes_copy(&t, &migrant->genes);
        population_count(is, migrant);
        evaluate(is, migrant);
    }
    select_survivors(is, is->plan->population + n);
    rank_population(is);
}
