/* Chooses the functions of a scene without tiers of its own at the knees of its fronts; see archive.h.  All fronts are merged into
 * one, of the judge's errors.  A function with fewer digits than a shipped function of its price, in any figure, stays out.  Then the
 * member whose absence costs least area between the front's steps, log error over log cost, goes, until few are left. */
#include "archive.h"

#include <math.h>
#include <stdlib.h>

enum { KNEES = 6 };
static const double same_price = 1.05; /* factor on costs, which are estimates */
static const double finest = 1e-12;    /* the least promise of a header */
static const double chance = 10;       /* factor on a single largest error; promises of names are further apart */
static const double worth = 0.99;      /* a smaller gain replaces no function that the run began with */

/* A shipped function on the judge's samples. */
struct rival {
    double error, cost, max;
    struct outputs outputs;
};

struct choice {
    struct objective *judge; /* not owned */
    struct rival *rival;     /* owned; indexed by tier */
    size_t rivals;
    double rounding;     /* smaller errors are no better */
    double worst;        /* a larger error deserves no name */
    struct front *front; /* owned: judged members */
};

static void judge_rivals(struct choice *c, const struct archive *shipped)
{
    c->rivals = shipped->quests;
    c->rival = new_array(c->rivals, sizeof *c->rival);
    for (size_t i = 0; i < c->rivals; i++) {
        const struct quest *q = &shipped->quest[i];
        struct rival *r = &c->rival[i];
        *r = (struct rival){.error = INFINITY, .cost = INFINITY};
        if (q->champion.genes.length == 0)
            continue;
        r->cost = q->champion.cost;
        r->error = fmax(c->rounding, objective_error(c->judge, &q->champion.genes, q->last, INFINITY));
        r->max = fmax(finest, chance * objective_tails(c->judge, &q->champion.genes, q->last).max);
        r->outputs = objective_outputs(c->judge, &q->champion.genes, q->last);
        c->worst = fmax(c->worst, r->error);
    }
}

/* Returns the most accurate shipped function of a price, or NULL. */
static const struct rival *rival_of(const struct choice *c, double cost)
{
    const struct rival *best = NULL;
    for (const struct rival *r = c->rival; r < c->rival + c->rivals; r++)
        if (r->cost <= same_price * cost && (!best || r->error < best->error))
            best = r;
    return best;
}

static void offer(struct choice *c, const struct quest *q, const struct member *m, double part)
{
    const struct tails none = {.max = 0};
    const double bound = fmin(part * front_error(c->front, m->cost), nextafter(c->worst, INFINITY));
    const double error = fmax(c->rounding, objective_error_in_tails(c->judge, &m->genes, q->last, &none, bound));
    const struct rival *r = rival_of(c, m->cost);
    if (!(error < bound) || (r && !objective_no_worse(c->judge, &m->genes, q->last, &r->outputs)))
        return;
    struct member *kept = front_offer(c->front, &m->genes, error, m->cost);
    if (kept)
        kept->origin = m->origin;
}

/* Offers all champions first. */
static void offer_all(struct choice *c, const struct archive *a)
{
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        if (q->champion.genes.length > 0)
            offer(c, q, &(struct member){.genes = q->champion.genes, .cost = q->champion.cost}, 1);
    for (const struct quest *q = a->quest; q < a->quest + a->quests; q++)
        for (size_t k = 0; k <= q->front->limit; k++)
            if (q->front->member[k].genes.length > 0)
                offer(c, q, &q->front->member[k], worth);
}

/* Returns the area between the steps that a member adds: its drop of error, up to the cost of the next member. */
static double area_of(const struct member *const *m, size_t n, size_t i)
{
    const double before = i > 0 ? m[i - 1]->error : 1, next = i + 1 < n ? m[i + 1]->cost : 2 * m[i]->cost;
    return log(before / m[i]->error) * log(next / m[i]->cost);
}

static size_t keep_knees(const struct member **m, size_t n)
{
    while (n > KNEES) {
        size_t least = 0;
        for (size_t i = 1; i < n; i++)
            if (area_of(m, n, i) < area_of(m, n, least))
                least = i;
        n--;
        for (size_t i = least; i < n; i++)
            m[i] = m[i + 1];
    }
    return n;
}

/* Gives each tier that a member is named after its champion, and takes the others'.  A member's mean error is no larger than that of
 * the shipped function of its name, nor its largest error but for chance; of two that could have a name, the less accurate takes the next one down. */
static void name_knees(struct archive *a, struct objective *o, const struct choice *c, const struct member **m,
                       size_t n)
{
    for (size_t t = a->quests; t-- > 0;) {
        const struct rival *r = &c->rival[t];
        const bool named = n > 0 && m[n - 1]->error <= r->error && r->error < INFINITY &&
                           objective_tails(c->judge, &m[n - 1]->genes, a->quest[t].last).max <= r->max;
        const struct member *own = named ? m[--n] : NULL;
        struct champion *champion = &a->quest[t].champion;
        if (own && genes_equal(&own->genes, &champion->genes))
            continue;
        if (own)
            archive_replace_champion(a, o, &a->quest[t], own);
        else
            champion->genes.length = 0;
    }
}

void archive_choose_knees(struct archive *a, const struct archive *shipped, struct objective *o,
                          struct objective *judge)
{
    struct choice c = {.judge = judge, .rounding = objective_rounding(a->scene->norm)};
    const struct front *any = a->quest[0].front;
    judge_rivals(&c, shipped);
    c.front = front_new(any->limit, any->max_length);
    offer_all(&c, a);
    const struct member **m = new_array(any->limit + 1, sizeof *m);
    const size_t n = front_count(c.front);
    for (size_t i = 0; i < n; i++)
        m[i] = front_member(c.front, i);
    name_knees(a, o, &c, m, keep_knees(m, n));
    free(m);
    front_free(c.front);
    free(c.rival);
}
