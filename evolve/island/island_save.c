/* The state of an island as bytes: everything in struct island that the next generations depend on. A state is checked
 * whole before the island changes. */
#include "island.h"

#include "../common/decimal.h"
#include "population.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

struct facts {
    uint64_t generation, evaluations;
    double bound;
};

/* An individual or a member of a front, followed by max_length genes. */
struct record {
    uint64_t length; /* of a member; 0: empty place */
    double fitness, error, cost;
    uint64_t mark; /* an individual's hash, or a member's `polished` */
};

static size_t record_size(const struct island *is)
{
    return sizeof(struct record) + is->goal.max_length * sizeof(int);
}

static size_t records(const struct island *is)
{
    return is->plan->population + is->front->limit + 1;
}

size_t island_state_size(const struct island *is)
{
    return sizeof(struct facts) + records(is) * record_size(is) + (sizeof *is->cache << CACHE_BITS);
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

static void put_record(const struct island *is, unsigned char **to, const struct record *r, const int *gene)
{
    put(to, r, sizeof *r);
    memset(*to, 0, is->goal.max_length * sizeof *gene);
    memcpy(*to, gene, (size_t)r->length * sizeof *gene);
    *to += is->goal.max_length * sizeof *gene;
}

void island_save(const struct island *is, unsigned char *to)
{
    const struct facts f = {is->generation, is->evaluations, is->bound};
    put(&to, &f, sizeof f);
    for (size_t i = 0; i < is->plan->population; i++) {
        const struct individual *x = &is->now[i];
        const struct record r = {x->genes.length, x->fitness, x->error, x->cost, x->hash};
        put_record(is, &to, &r, x->genes.gene);
    }
    for (const struct member *m = is->front->member; m <= is->front->member + is->front->limit; m++) {
        const struct record empty = {0}, r = {m->genes.length, 0, m->error, m->cost, m->polished};
        put_record(is, &to, m->genes.length > 0 ? &r : &empty, m->genes.gene);
    }
    put(&to, is->cache, sizeof *is->cache << CACHE_BITS);
}

static bool known_gene(const struct gene_set *s, int gene)
{
    if (gene < GENE_OPERATORS)
        return gene >= 0 || decimal_valid(gene);
    for (size_t i = 0; i < s->operations + s->functions; i++)
        if (s->operation[i] == gene)
            return true;
    for (size_t i = 0; i < s->symbols; i++)
        if (s->symbol[i] == gene)
            return true;
    return false;
}

/* Reads the next record and its genes into gene[0..max_length-1]. Returns false if the genes are not valid. */
static bool take_record(const struct island *is, const unsigned char **from, struct record *r, int *gene)
{
    take(from, r, sizeof *r);
    take(from, gene, is->goal.max_length * sizeof *gene);
    if (r->length > is->goal.max_length || !(r->error >= 0) || !(r->cost >= 0) || !(r->fitness >= 0))
        return false;
    if (is->goal.program)
        return r->length == 0 || lines_valid(is->objective->rules, gene, (size_t)r->length);
    for (size_t i = 0; i < r->length; i++)
        if (!known_gene(is->goal.genes, gene[i]))
            return false;
    return r->length == 0 || gene_span(gene, (size_t)r->length) == r->length;
}

/* Returns true if all individuals have genes, and the front's members are in their places with falling errors. */
static bool check(const struct island *is, const unsigned char *from)
{
    const size_t n = is->plan->population;
    int *gene = new_array(is->goal.max_length, sizeof *gene);
    struct facts f;
    double last = INFINITY;
    take(&from, &f, sizeof f);
    bool good = f.bound >= 0;
    for (size_t i = 0; good && i < records(is); i++) {
        struct record r;
        good = take_record(is, &from, &r, gene);
        if (i < n) {
            good = good && r.length > 0;
            continue;
        }
        if (good && r.length > 0) {
            good = front_place(is->front, r.cost) == i - n && r.error < last && r.mark <= 1;
            last = r.error;
        }
    }
    free(gene);
    return good;
}

static void take_front(const struct island *is, const unsigned char **from, struct front *f)
{
    front_clear(f);
    for (size_t c = 0; c <= f->limit; c++) {
        struct record r;
        const struct genes t = {is->scratch.gene, 0};
        take_record(is, from, &r, t.gene);
        if (r.length > 0)
            front_offer(f, &(struct genes){t.gene, (size_t)r.length}, r.error, r.cost)->polished = r.mark == 1;
    }
}

bool island_load(struct island *is, const unsigned char *from)
{
    struct facts f;
    if (!check(is, from))
        return false;
    take(&from, &f, sizeof f);
    is->generation = f.generation;
    is->evaluations = f.evaluations;
    is->bound = f.bound;
    for (size_t i = 0; i < is->plan->population; i++) {
        struct individual *x = &is->now[i];
        struct record r;
        take_record(is, &from, &r, x->genes.gene);
        *x = (struct individual){{x->genes.gene, (size_t)r.length}, r.fitness, r.error, r.cost, r.mark};
    }
    take_front(is, &from, is->front);
    take(&from, is->cache, sizeof *is->cache << CACHE_BITS);
    population_refresh(is);
    return true;
}
