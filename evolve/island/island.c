/* Islands; see island.h. All random numbers come from the stream of (seed, ring, place in the ring, generation). An
 * island's results depend only on itself and on its migrants and their order. */
#include "island.h"

#include "../common/stream.h"
#include "population.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { REPORTED = 1 + sizeof(double) / sizeof(int) }; /* ints before the genes: length, error */

struct island *island_new(const struct plan *plan, const struct goal *goal, struct objective *objective)
{
    struct island *is = new_array(1, sizeof *is);
    *is = (struct island){.plan = plan, .goal = *goal, .objective = objective, .bound = INFINITY};
    const size_t n = plan->population, room = 2 * n + 2;
    is->rng = stream_new();
    is->counter = counter_new();
    is->frame = frame_cost_new(objective->program, &plan->prices);
    is->lines = lines_counter_new(objective->rules);
    is->now = arena_array(&is->arena, room, sizeof *is->now);
    is->order = arena_array(&is->arena, room, sizeof *is->order);
    is->fate = arena_array(&is->arena, room, sizeof *is->fate);
    is->crowd = arena_array(&is->arena, plan->front_limit + 1, sizeof *is->crowd);
    is->pool = arena_array(&is->arena, (room + 1) * goal->max_length, sizeof *is->pool);
    is->cumulative = arena_array(&is->arena, n, sizeof *is->cumulative);
    is->reference = arena_array(&is->arena, plan->front_limit + 1, sizeof *is->reference);
    is->cache = arena_array(&is->arena, (size_t)1 << CACHE_BITS, sizeof *is->cache);
    is->front = front_new(goal->limit ? goal->limit : plan->front_limit, goal->max_length);
    for (size_t i = 0; i < room; i++)
        is->now[i].genes.gene = is->pool + i * goal->max_length;
    is->scratch.gene = is->pool + room * goal->max_length;
    return is;
}

void island_free(struct island *is)
{
    if (!is)
        return;
    gsl_rng_free(is->rng);
    counter_free(is->counter);
    frame_cost_free(is->frame);
    lines_counter_free(is->lines);
    front_free(is->front);
    index_free(&is->met);
    arena_free(&is->arena);
    free(is);
}

void island_start(struct island *is, const struct genes *seed, size_t n)
{
    stream_key(is->rng, is->plan->seed, is->goal.ring, is->goal.place, is->generation);
    if (is->plan->breeding == BREED_PAPER)
        breed_paper_start(is, seed, n);
    else
        breed_front_start(is, seed, n);
    population_refresh(is);
}

void island_step(struct island *is)
{
    stream_key(is->rng, is->plan->seed, is->goal.ring, is->goal.place, ++is->generation);
    if (is->plan->breeding == BREED_PAPER)
        breed_paper_step(is);
    else
        breed_front_step(is);
    population_refresh(is);
}

const struct individual *island_best(const struct island *is)
{
    return &is->best;
}

size_t island_parcel_size(const struct island *is, size_t n)
{
    return n * population_parcel(is);
}

static void pack(const struct genes *t, int *parcel)
{
    struct genes packed = {parcel + 1, 0};
    genes_copy(t, &packed);
    parcel[0] = (int)packed.length;
}

/* With front breeding, packs members of the front, evenly spaced if there are more than n, then individuals of the
 * population. */
void island_pack(const struct island *is, size_t n, int *parcel)
{
    const size_t members = is->plan->breeding == BREED_FRONT ? front_count(is->front) : 0;
    const size_t from_front = members < n ? members : n;
    for (size_t i = 0; i < n; i++, parcel += island_parcel_size(is, 1))
        if (i < from_front)
            pack(&front_member(is->front, (i * members + is->generation % members) / from_front % members)->genes,
                 parcel);
        else
            pack(&is->now[i - from_front].genes, parcel);
}

void island_receive(struct island *is, size_t n, int *parcel)
{
    if (is->plan->breeding == BREED_PAPER)
        breed_paper_receive(is, n, parcel);
    else
        breed_front_receive(is, n, parcel);
    population_refresh(is);
}

double island_median(const struct island *is)
{
    return is->now[is->plan->population / 2].error;
}

uint64_t island_evaluations(const struct island *is)
{
    return is->evaluations;
}

size_t island_report_size(const struct island *is)
{
    size_t size = 1;
    for (size_t c = 0; c <= is->front->limit; c++)
        if (is->front->member[c].genes.length > 0)
            size += REPORTED + is->front->member[c].genes.length;
    return size;
}

void island_report(const struct island *is, int *report)
{
    *report++ = (int)front_count(is->front);
    for (size_t c = 0; c <= is->front->limit; c++) {
        const struct member *m = &is->front->member[c];
        if (m->genes.length == 0)
            continue;
        memcpy(report + 1, &m->error, sizeof m->error);
        struct genes genes = {report + REPORTED, 0};
        genes_copy(&m->genes, &genes);
        *report = (int)genes.length;
        report += REPORTED + genes.length;
    }
}

const int *island_reported(const int *at, struct genes *t, double *error)
{
    memcpy(error, at + 1, sizeof *error);
    *t = (struct genes){(int *)at + REPORTED, (size_t)at[0]};
    return at + REPORTED + t->length;
}
