/* Seeded local search; see search.h.  Each shape is tried with a few random likings; the best of what results is
 * improved by overruling one of Horner's choices at a time, keeping what is not worse.  Work is counted, not timed, so
 * that the result does not depend on the machine. */
#include "search.h"

#include "horner.h"
#include "shape.h"
#include "share.h"

#include <stdlib.h>
#include <string.h>

enum { BEAM = 6, FIRST_TRIES = 24, UNIT = 400 /* nodes and edges handled in about a millisecond */ };

struct shape {
    struct dag *dag; /* owned */
    const char *what;
};

/* A way to emit a shape. */
struct candidate {
    size_t shape;
    struct policy policy; /* owned */
    double cost;
};

struct search {
    const struct genome_file *file;
    const struct compile_options *options;
    struct shape *shape; /* owned */
    size_t shapes, shape_room;
    struct candidate beam[BEAM + 1]; /* sorted by cost; the last place is for the one under trial */
    size_t n;
    struct emission best; /* owned text */
    double least;
    size_t removed;
    uint64_t random;
    double work, limit;
};

struct search *search_new(const struct genome_file *f, const struct compile_options *o)
{
    struct search *s = new_array(1, sizeof *s);
    s->file = f;
    s->options = o;
    s->random = o->seed;
    s->limit = (double)o->effort * UNIT;
    return s;
}

void search_free(struct search *s)
{
    for (size_t i = 0; i < s->shapes; i++)
        dag_free(s->shape[i].dag);
    for (size_t i = 0; i <= BEAM; i++)
        policy_clear(&s->beam[i].policy);
    free(s->shape);
    free(s);
}

void search_add(struct search *s, struct dag *g, const char *what)
{
    grow_array(&s->shape, s->shapes, &s->shape_room, sizeof *s->shape);
    s->shape[s->shapes++] = (struct shape){g, what};
}

const struct dag *search_first(const struct search *s)
{
    return s->shape[0].dag;
}

static uint64_t next_random(struct search *s)
{
    uint64_t z = s->random += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static void count_work(struct search *s, const struct dag *g)
{
    for (size_t i = 0; i < g->nodes; i++)
        s->work += 1 + (double)g->node[i].edges;
}

/* One pass done: its result takes the place of the graph that it was made from. */
static void step(struct search *s, struct dag **g, struct dag *made)
{
    count_work(s, made);
    dag_free(*g);
    *g = made;
}

static bool divides(const struct dag *g)
{
    for (size_t i = 0; i < g->outputs; i++)
        if (g->node[g->output[i].node].divides)
            return true;
    return false;
}

/* Emits the candidate; the text is kept if it is the cheapest so far. */
static void evaluate(struct search *s, struct candidate *c, struct record *record)
{
    const struct policy *p = &c->policy;
    struct dag *g = dag_copy(s->shape[c->shape].dag);
    struct emission e;
    if (record)
        record->decisions = record->alternatives = 0;
    if (divides(g))
        step(s, &g, shape_combine(g, p, record));
    step(s, &g, shape_dissolve(g, p, record));
    if (p->join && divides(g))
        step(s, &g, shape_join(g));
    if (!p->plain)
        step(s, &g, horner_factor(g, p, record));
    share_pairs(g);
    struct schedule *schedule = schedule_new(g, &s->options->cost);
    emit_statements(s->file, schedule, &e);
    c->cost = operations_cost(&e.ops, &s->options->cost) + (e.out_of_range ? 1e9 : 0);
    if (!s->best.text || c->cost < s->least - 1e-9 || (c->cost < s->least + 1e-9 && e.ops.mul < s->best.ops.mul)) {
        free(s->best.text);
        s->best = e;
        s->least = c->cost;
        s->removed = g->removed;
    } else
        free(e.text);
    schedule_free(schedule);
    dag_free(g);
}

static void copy_candidate(struct candidate *to, const struct candidate *from)
{
    to->shape = from->shape;
    to->cost = from->cost;
    policy_copy(&to->policy, &from->policy);
}

/* Puts the candidate under trial in its place of the beam. */
static void enter_beam(struct search *s)
{
    const struct candidate c = s->beam[BEAM];
    size_t i = s->n < BEAM ? s->n++ : BEAM;
    if (i == BEAM && c.cost >= s->beam[BEAM - 1].cost)
        return;
    if (i == BEAM)
        i--;
    s->beam[BEAM] = s->beam[i];
    for (; i > 0 && s->beam[i - 1].cost > c.cost; i--)
        s->beam[i] = s->beam[i - 1];
    s->beam[i] = c;
}

/* The starting points: as written, multiplied out, brought to common denominators, and mixtures. */
static void try_first(struct search *s)
{
    static const double preference[] = {0.9, 3, 1000};
    for (int attempt = 0; attempt < FIRST_TRIES; attempt++)
        for (size_t i = 0; i < s->shapes; i++) {
            struct candidate *c = &s->beam[BEAM];
            struct policy *p = &c->policy;
            const int form = attempt % 8;
            if (attempt > 0 && s->work > s->limit / 2)
                return;
            c->shape = i;
            p->choices = 0;
            p->seed = next_random(s);
            p->preference = attempt < 8 ? 0 : preference[attempt % 3];
            p->dissolve = form & 1 ? 1 : 0;
            p->combine = form & 2 ? 1 : 0;
            p->join = form & 4;
            p->plain = false;
            if (form > 1 && !divides(s->shape[i].dag)) {
                p->dissolve = 0.5 * (attempt % 3);
                p->plain = attempt == 2;
            }
            evaluate(s, c, NULL);
            enter_beam(s);
        }
}

/* One choice of the candidate under trial overruled. */
static void mutate(struct search *s, struct candidate *c, const struct record *record)
{
    if (c->policy.choices > 0 && next_random(s) % 8 == 0) {
        const size_t k = next_random(s) % c->policy.choices;
        memmove(&c->policy.choice[k], &c->policy.choice[k + 1],
                (c->policy.choices-- - k - 1) * sizeof *c->policy.choice);
        return;
    }
    const struct decision *d = &record->decision[next_random(s) % record->decisions];
    const size_t k = next_random(s) % (d->alternatives + 1);
    policy_choose(&c->policy, (struct choice){d->key, k == d->alternatives ? 0 : record->alternative[d->first + k]});
}

static void climb(struct search *s, struct candidate *at, double until)
{
    struct record record = {0}, next = {0};
    struct candidate *trial = &s->beam[BEAM];
    evaluate(s, at, &record);
    while (s->work < until && record.decisions > 0) {
        copy_candidate(trial, at);
        for (uint64_t moves = 1 + next_random(s) % 3; moves > 0; moves--)
            mutate(s, trial, &record);
        evaluate(s, trial, &next);
        if (trial->cost > at->cost)
            continue;
        copy_candidate(at, trial);
        const struct record swap = record;
        record = next;
        next = swap;
    }
    record_clear(&record);
    record_clear(&next);
}

size_t search_run(struct search *s, struct emission *e)
{
    try_first(s);
    const double start = s->work, share = (s->limit - start) / (2 * (double)(s->n + 1));
    for (size_t i = 0; i < s->n && s->work < s->limit; i++)
        climb(s, &s->beam[i], s->work + share);
    size_t best = 0;
    for (size_t i = 0; i < s->n; i++)
        if (s->beam[i].cost < s->beam[best].cost)
            best = i;
    if (s->n > 0 && s->work < s->limit)
        climb(s, &s->beam[best], s->limit);
    *e = s->best;
    return s->removed;
}
