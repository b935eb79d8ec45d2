/* Genetic programming on one island.  A generation keeps the best individual and fills up with children: parents are
 * chosen by roulette on fitness 1/error (the paper) or by tournament, then crossed or mutated.  Genomes seen lately are
 * remembered: a child that repeats one is changed once more.  A child whose error is sure to exceed a multiple of its
 * parents' median is not evaluated to the end and counts as hopeless, at the same block on every machine.  All
 * randomness comes from the stream of (seed, ring, place in the ring, generation). */
#include "island.h"

#include "stream.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    TOURNAMENT = 4,
    SHALLOWEST = 2, /* depths of the first trees, ramped */
    DEEPEST = 6,
    CACHE_BITS = 13
};
static const double crossover_rate = 0.8, gene_mutation_rate = 0.2, hopeless = 4;

struct remembered {
    uint64_t hash; /* 0: empty */
    double error;
};

struct island {
    const struct plan *plan; /* not owned, as are goal's genes and the judge */
    struct goal goal;
    struct judge *judge;
    gsl_rng *rng; /* owned */
    uint64_t generation, evaluations;
    struct individual *now, *next; /* owned; now[] is ascending: best first */
    int *pool;                     /* owned: their genes */
    double *cumulative;            /* owned: roulette wheel of now[] */
    double bound;                  /* errors above it are hopeless */
    struct remembered *cache;      /* owned */
};

double plan_demerit(const struct plan *plan, double error, size_t length)
{
    return error * (1 + plan->parsimony * (double)length);
}

struct island *island_new(const struct plan *plan, const struct goal *goal, struct judge *judge)
{
    struct island *is = new_array(1, sizeof *is);
    *is = (struct island){.plan = plan, .goal = *goal, .judge = judge, .rng = stream_new(), .bound = INFINITY};
    const size_t n = plan->population;
    const size_t room = n + 1; /* the last child of a generation may come with a twin too many */
    is->now = new_array(room, sizeof *is->now);
    is->next = new_array(room, sizeof *is->next);
    is->pool = new_array(2 * room * goal->max_length, sizeof *is->pool);
    is->cumulative = new_array(n, sizeof *is->cumulative);
    is->cache = new_array((size_t)1 << CACHE_BITS, sizeof *is->cache);
    for (size_t i = 0; i < room; i++) {
        is->now[i].tree.gene = is->pool + i * goal->max_length;
        is->next[i].tree.gene = is->pool + (room + i) * goal->max_length;
    }
    return is;
}

void island_free(struct island *is)
{
    if (!is)
        return;
    gsl_rng_free(is->rng);
    free(is->now);
    free(is->next);
    free(is->pool);
    free(is->cumulative);
    free(is->cache);
    free(is);
}

static struct remembered *memory_of(const struct island *is, uint64_t hash)
{
    return &is->cache[hash >> (64 - CACHE_BITS)];
}

static void evaluate(struct island *is, struct individual *x)
{
    const uint64_t hash = tree_hash(&x->tree);
    struct remembered *r = memory_of(is, hash);
    if (r->hash != hash || hash == 0) {
        *r = (struct remembered){hash, judge_error(is->judge, &x->tree, is->goal.target, is->bound)};
        is->evaluations++;
    }
    x->error = r->error;
    x->demerit = plan_demerit(is->plan, x->error, x->tree.length);
}

/* Change genes of a tree that was seen lately, so that hardly a child is bred for nothing. */
static void renew(struct island *is, struct tree *t)
{
    for (int tries = 2; tries > 0; tries--) {
        const uint64_t hash = tree_hash(t);
        if (memory_of(is, hash)->hash != hash)
            break;
        tree_mutate_gene(is->rng, is->goal.genes, t);
    }
}

static int compare_individuals(const void *a, const void *b)
{
    const struct individual *p = a, *q = b;
    if (p->demerit != q->demerit)
        return p->demerit < q->demerit ? -1 : 1;
    if (p->error != q->error)
        return p->error < q->error ? -1 : 1;
    if (p->tree.length != q->tree.length)
        return p->tree.length < q->tree.length ? -1 : 1;
    return memcmp(p->tree.gene, q->tree.gene, p->tree.length * sizeof *p->tree.gene);
}

/* Sort, spin up the roulette wheel, and set the bound for the children. */
static void rank_population(struct island *is)
{
    const size_t n = is->plan->population;
    double sum = 0;
    qsort(is->now, n, sizeof *is->now, compare_individuals);
    for (size_t i = 0; i < n; i++)
        is->cumulative[i] = sum += 1 / fmin(fmax(is->now[i].demerit, 1e-100), 1e100);
    is->bound = hopeless * is->now[n / 2].error;
}

void island_start(struct island *is, const struct tree *seed)
{
    const size_t n = is->plan->population;
    stream_key(is->rng, is->plan->seed, is->goal.ring, is->goal.place, is->generation);
    for (size_t i = 0; i < n; i++) {
        const int depth = SHALLOWEST + (int)(i / 2) % (DEEPEST - SHALLOWEST + 1);
        if (i == 0 && seed)
            tree_copy(seed, &is->now[i].tree);
        else
            tree_random(is->rng, is->goal.genes, depth, i % 2 == 0, is->goal.max_length, &is->now[i].tree);
        evaluate(is, &is->now[i]);
    }
    rank_population(is);
}

static const struct tree *choose_parent(struct island *is)
{
    const size_t n = is->plan->population;
    size_t chosen = n;
    if (is->plan->selection == SELECT_TOURNAMENT) { /* now[] is sorted: the lowest index wins */
        for (int i = 0; i < TOURNAMENT; i++) {
            const size_t k = gsl_rng_uniform_int(is->rng, n);
            chosen = k < chosen ? k : chosen;
        }
        return &is->now[chosen].tree;
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
    return &is->now[low].tree;
}

void island_step(struct island *is)
{
    const size_t n = is->plan->population, max = is->goal.max_length;
    stream_key(is->rng, is->plan->seed, is->goal.ring, is->goal.place, ++is->generation);
    tree_copy(&is->now[0].tree, &is->next[0].tree);
    for (size_t i = 1; i < n; i += 2) {
        struct tree *child[2] = {&is->next[i].tree, &is->next[i + 1].tree};
        const struct tree *a = choose_parent(is), *b = choose_parent(is);
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
    is->next[0].error = is->now[0].error;
    is->next[0].demerit = is->now[0].demerit;
    for (size_t i = 1; i < n; i++) {
        renew(is, &is->next[i].tree);
        evaluate(is, &is->next[i]);
    }
    struct individual *parents = is->now;
    is->now = is->next;
    is->next = parents;
    rank_population(is);
}

const struct individual *island_best(const struct island *is)
{
    return &is->now[0];
}

size_t island_parcel_size(const struct island *is, size_t n)
{
    return n * (1 + is->goal.max_length);
}

void island_pack(const struct island *is, size_t n, int *parcel)
{
    for (size_t i = 0; i < n; i++, parcel += island_parcel_size(is, 1)) {
        struct tree packed = {parcel + 1, 0};
        tree_copy(&is->now[i].tree, &packed);
        parcel[0] = (int)packed.length;
    }
}

static bool lives_here(const struct island *is, const struct tree *t)
{
    for (size_t i = 0; i < is->plan->population; i++)
        if (tree_equal(&is->now[i].tree, t))
            return true;
    return false;
}

void island_receive(struct island *is, size_t n, int *parcel)
{
    size_t place = is->plan->population;
    for (size_t i = 0; i < n; i++, parcel += island_parcel_size(is, 1)) {
        const struct tree guest = {parcel + 1, (size_t)parcel[0]};
        if (lives_here(is, &guest))
            continue;
        tree_copy(&guest, &is->now[--place].tree);
        evaluate(is, &is->now[place]);
    }
    rank_population(is);
}

double island_median(const struct island *is)
{
    return is->now[is->plan->population / 2].error; /* ranked by demerit: nearly */
}

uint64_t island_evaluations(const struct island *is)
{
    return is->evaluations;
}

/* A state: generation, evaluations, the individuals (length, error, genes), and what is remembered. */
size_t island_state_size(const struct island *is)
{
    const size_t individual = sizeof(uint64_t) + sizeof(double) + is->goal.max_length * sizeof(int);
    return 2 * sizeof(uint64_t) + is->plan->population * individual +
           ((size_t)1 << CACHE_BITS) * (sizeof(uint64_t) + sizeof(double));
}

static void put(unsigned char **to, const void *data, size_t bytes)
{
    memcpy(*to, data, bytes);
    *to += bytes;
}

static void take(const unsigned char **from, void *data, size_t bytes)
{
    memcpy(data, *from, bytes);
    *from += bytes;
}

void island_save(const struct island *is, unsigned char *to)
{
    put(&to, &is->generation, sizeof is->generation);
    put(&to, &is->evaluations, sizeof is->evaluations);
    for (size_t i = 0; i < is->plan->population; i++) {
        const struct individual *x = &is->now[i];
        const uint64_t length = x->tree.length;
        put(&to, &length, sizeof length);
        put(&to, &x->error, sizeof x->error);
        memset(to, 0, is->goal.max_length * sizeof *x->tree.gene);
        memcpy(to, x->tree.gene, x->tree.length * sizeof *x->tree.gene);
        to += is->goal.max_length * sizeof *x->tree.gene;
    }
    for (size_t i = 0; i < (size_t)1 << CACHE_BITS; i++) {
        put(&to, &is->cache[i].hash, sizeof is->cache[i].hash);
        put(&to, &is->cache[i].error, sizeof is->cache[i].error);
    }
}

static bool known_gene(const struct gene_set *s, int gene)
{
    const int *of = gene < 0 ? s->constant : s->symbol;
    const size_t n = gene < 0 ? s->constants : s->symbols;
    bool known = gene >= 0 && gene < GENE_OPERATORS;
    for (size_t i = 0; !known && i < n; i++)
        known = of[i] == gene;
    return known;
}

/* The next individual of a state, into *x (NULL: only to check it). */
static bool take_individual(const struct island *is, const unsigned char **from, int *gene, struct individual *x)
{
    uint64_t length;
    double error;
    take(from, &length, sizeof length);
    take(from, &error, sizeof error);
    take(from, gene, is->goal.max_length * sizeof *gene);
    bool good = length >= 1 && length <= is->goal.max_length && error >= 0;
    for (size_t i = 0; good && i < length; i++)
        good = known_gene(is->goal.genes, gene[i]);
    if (!good || gene_span(gene, (size_t)length) != length)
        return false;
    if (x) {
        const struct tree t = {gene, (size_t)length};
        tree_copy(&t, &x->tree);
        x->error = error;
        x->demerit = plan_demerit(is->plan, error, x->tree.length);
    }
    return true;
}

bool island_load(struct island *is, const unsigned char *from)
{
    const size_t n = is->plan->population;
    int *gene = new_array(is->goal.max_length, sizeof *gene);
    uint64_t count[2]; /* generation, evaluations */
    take(&from, count, sizeof count);
    const unsigned char *at = from;
    bool good = true;
    for (size_t i = 0; good && i < n; i++)
        good = take_individual(is, &at, gene, NULL);
    for (size_t i = 0; good && i < n; i++)
        take_individual(is, &from, gene, &is->now[i]);
    free(gene);
    if (!good)
        return false;
    is->generation = count[0];
    is->evaluations = count[1];
    for (size_t i = 0; i < (size_t)1 << CACHE_BITS; i++) {
        take(&from, &is->cache[i].hash, sizeof is->cache[i].hash);
        take(&from, &is->cache[i].error, sizeof is->cache[i].error);
    }
    rank_population(is);
    return true;
}

size_t island_report_size(const struct island *is)
{
    return 2 + is->now[0].tree.length;
}

void island_report(const struct island *is, int *report)
{
    report[0] = 1;
    report[1] = (int)is->now[0].tree.length;
    memcpy(report + 2, is->now[0].tree.gene, is->now[0].tree.length * sizeof *report);
}
