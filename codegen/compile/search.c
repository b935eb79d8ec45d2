/* Seeded local search; see search.h. Each shape is tried with a few random preferences. The best results are improved
 * by overriding Horner's choices, one at a time, keeping changes that are not worse. Work is counted, not timed, so
 * that the result does not depend on the machine. */
#include "search.h"

#include "../graph/rewrite.h"
#include "../passes/cse.h"
#include "../passes/expand.h"
#include "../passes/horner.h"
#include "../schedule/balance.h"
#include "../schedule/distribute.h"
#include "../schedule/scales.h"
#include "../schedule/share_multiples.h"
#include "explain.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum {
    BEAM = 4,
    FORMS = 24,
    KEEPING = 6, /* the first policies, which leave quotients unchanged */
    WRITTEN = 2, /* shapes that are the genome as written; others may be far from it */
    RANDOM_TRIES = 200,
    UNIT = 1500, /* nodes and edges processed in about a millisecond */
    PAIRS = 50,  /* pairs of operands examined in the time of a node */
    FREE_PAIRS = 20000000,
    SCALES = 12,     /* work of searching a node's scale, in nodes */
    FIRST = 2000,    /* units for the starting points, whatever the effort */
    SLACK = 2,       /* multiplications that a search of scales may make up for */
    FREE_DEGREE = 64 /* common denominators may raise the degree up to this; in a segment's functions, whose scale is
                      * any length, never beyond the genome's own */
};

static const double TIE = 1e-3; /* weight of a multiplication between shapes of equal cost */
static const double HOT = 0.5;  /* multiplications by which annealing may rise at first */

struct shape {
    struct dag *dag; /* owned */
    double behind;   /* dropped if it costs this many times the first shape */
    const char *what;
};

/* A way to lower a shape. */
struct candidate {
    size_t shape;
    struct policy policy; /* owned */
    double estimate;      /* cost before scales are searched */
    double cost;
};

struct form_search {
    const struct genome_file *file;
    const struct compile_options *options;
    struct shape *shape; /* owned */
    size_t shapes, shape_room;
    struct candidate beam[BEAM + 1]; /* sorted by cost; the last place is for the current trial */
    size_t n;
    struct lowered best;     /* owned program; NULL at first */
    struct candidate winner; /* its origin */
    double least;
    double guide;                     /* least cost of the programs that steer the search */
    struct removed removing, removed; /* singularities removed by the current passes, and by the winner's */
    struct scales_memo *memo;         /* owned */
    uint64_t random;
    int degree, most_degree, least_degree; /* degree of the current graph; its upper limit; the limit that always
                                            * applies */
    double work, limit;
    bool differences; /* differences of two inputs stay whole */
    bool relative;    /* the first form uses only differences of coordinates, so the others must, too */
    bool starting;    /* processing the starting points */
    bool explaining;  /* the passes print their results */
};

struct form_search *search_new(const struct genome_file *f, const struct compile_options *o)
{
    struct form_search *s = new_array(1, sizeof *s);
    s->file = f;
    s->options = o;
    s->memo = scales_memo_new();
    s->random = o->seed;
    s->limit = (double)o->effort * UNIT;
    s->guide = HUGE_VAL;
    s->differences = f->segment && shape_differs_first(f->segment);
    s->least_degree = f->segment ? 0 : FREE_DEGREE;
    return s;
}

void search_free(struct form_search *s)
{
    for (size_t i = 0; i < s->shapes; i++)
        dag_free(s->shape[i].dag);
    for (size_t i = 0; i <= BEAM; i++)
        policy_clear(&s->beam[i].policy);
    policy_clear(&s->winner.policy);
    scales_memo_free(s->memo);
    free(s->shape);
    free(s);
}

void search_add(struct form_search *s, struct dag *g, double behind, const char *what)
{
    grow_array(&s->shape, s->shapes, &s->shape_room, sizeof *s->shape);
    if (s->shapes == 0)
        s->most_degree = dag_degree(g) > s->least_degree ? dag_degree(g) : s->least_degree;
    s->shape[s->shapes++] = (struct shape){.dag = g, .behind = behind, .what = what};
}

const struct dag *search_first(const struct form_search *s)
{
    return s->shape[0].dag;
}

static void copy_candidate(struct candidate *to, const struct candidate *from)
{
    to->shape = from->shape;
    to->cost = from->cost;
    to->estimate = from->estimate;
    policy_copy(&to->policy, &from->policy);
}

static void count_work(struct form_search *s, const struct dag *g)
{
    for (size_t i = 0; i < g->nodes; i++)
        s->work += 1 + (double)g->node[i].edges;
}

/* Counts comparisons of pairs only if they take longer than the work counted otherwise. */
static void count_dear(struct form_search *s, double pairs)
{
    if (pairs > FREE_PAIRS)
        s->work += (pairs - FREE_PAIRS) / PAIRS;
}

/* Completes a pass: its result replaces the graph from which it was made. */
static void step(struct form_search *s, struct dag **g, struct dag *made, const char *pass)
{
    count_work(s, made);
    dag_free(*g);
    *g = made;
    if (s->explaining)
        explain_graph(s->options->explain, s->file, pass, s->options->explained, made);
}

static bool divides(const struct dag *g)
{
    for (size_t i = 0; i < g->outputs; i++)
        if (g->node[g->output[i].node].divides)
            return true;
    return false;
}

static bool has(const struct form_search *s, enum left_out pass)
{
    return s->options->without != (int)pass;
}

static struct dag *run_passes(struct form_search *s, const struct candidate *c, struct record *record)
{
    const struct policy *p = &c->policy;
    struct dag *g = dag_copy(s->shape[c->shape].dag);
    if (record)
        record->decisions = record->alternatives = 0;
    if (divides(g) && has(s, WITHOUT_COMBINE))
        step(s, &g, shape_combine(g, p, record), "common denominators");
    if (has(s, WITHOUT_DISSOLVE))
        step(s, &g, shape_dissolve(g, p, record), "multiplying out");
    if (p->join && divides(g) && has(s, WITHOUT_JOIN))
        step(s, &g, shape_join(g), "one division for several");
    if (p->early && has(s, WITHOUT_EARLY)) {
        count_dear(s, (double)share_pairs(g));
        step(s, &g, walk_again(g), "early sharing");
    }
    const struct policy plain = {.plain = true, .differences = p->differences};
    step(s, &g, horner_factor(g, has(s, WITHOUT_HORNER) ? p : &plain, record), "Horner");
    s->removing = dag_removed(g);
    s->degree = dag_degree(g);
    if (has(s, WITHOUT_SHARING))
        count_dear(s, (double)share_pairs(g));
    if (s->explaining)
        explain_graph(s->options->explain, s->file, "sharing", s->options->explained, g);
    if (has(s, WITHOUT_DISTRIBUTE))
        distribute_products(g, &s->options->cost);
    balance_order(g);
    return g;
}

/* Lowers a scheduled graph and keeps the program if it is the cheapest so far. Returns the cost. Programs that do not
 * steer the search leave no trace unless they win. */
static double lower_schedule(struct form_search *s, const struct schedule *schedule, const struct candidate *from,
                             bool steers)
{
    struct lowered e;
    lower(s->file, schedule, &e);
    e.out_of_range |= rational_take_overflow();
    const double cost = operations_cost(&e.ops, &s->options->cost) + (e.out_of_range ? 1e9 : 0);
    const bool tie = s->best.program && cost < s->least + 1e-9,
               exacter = from->policy.differences && !s->winner.policy.differences,
               neater =
                   e.ops.mul < s->best.ops.mul || (e.ops.mul == s->best.ops.mul && e.negations < s->best.negations);
    if (steers && cost < s->guide)
        s->guide = cost;
    if (!s->best.program || cost < s->least - 1e-9 || (tie && (exacter || (steers && neater)))) {
        program_free(s->best.program);
        s->best = e;
        s->least = cost;
        s->removed = s->removing;
        copy_candidate(&s->winner, from);
    } else
        program_free(e.program);
    return cost;
}

/* Lowers again with multiples of values shared, if that may be the cheapest. */
static void lower_multiples(struct form_search *s, const struct schedule *schedule, const struct candidate *from,
                            double cost)
{
    size_t saved;
    struct dag *g = multiples_taken(schedule, &saved);
    if (g && cost - (double)saved * s->options->cost.mul < s->least - 1e-9) {
        struct schedule *again = scaled_schedule(g, &s->options->cost, SCALES_SINGLE, s->memo);
        lower_schedule(s, again, from, false);
        schedule_free(again);
    }
    dag_free(g);
}

/* Lowers a graph, in its own scales or in scales from a search; returns the cost. */
static double lower_graph(struct form_search *s, const struct dag *g, const struct candidate *from,
                          enum scale_search scales)
{
    struct schedule *schedule =
        scaled_schedule(g, &s->options->cost, has(s, WITHOUT_SCALES) ? scales : SCALES_KEPT, s->memo);
    const bool steers = scales != SCALES_GROUPS;
    const double cost = lower_schedule(s, schedule, from, steers);
    if (steers) {
        s->work += (scales ? SCALES : 2) * (double)schedule->n;
        count_dear(s, schedule->work);
    }
    if (scales != SCALES_KEPT && has(s, WITHOUT_MULTIPLES))
        lower_multiples(s, schedule, from, cost);
    schedule_free(schedule);
    return cost;
}

/* Lowers the candidate and keeps the program if it is the cheapest so far. A candidate with an estimate beyond `limit`
 * is skipped. */
static void evaluate(struct form_search *s, struct candidate *c, struct record *record, double limit)
{
    rational_take_overflow();
    struct dag *g = run_passes(s, c, record);
    c->cost = c->estimate = HUGE_VAL;
    const bool relative = s->file->segment && shape_is_relative(g, s->file->segment);
    if (!s->best.program)
        s->relative = relative;
    if (rational_take_overflow() || s->degree > s->most_degree || (s->relative && !relative)) {
        dag_free(g);
        return;
    }
    for (int multiples = 0; multiples < (has(s, WITHOUT_MULTIPLES) ? 2 : 1); multiples++) {
        if (multiples > 0)
            share_multiples(g);
        if (multiples == 0)
            c->estimate = lower_graph(s, g, c, SCALES_KEPT);
        if (g->nodes > SEARCH_MOST_NODES) {
            c->cost = c->estimate;
            break;
        }
        if (c->estimate <= limit) {
            const double cost = lower_graph(s, g, c, SCALES_SINGLE);
            c->cost = cost < c->cost ? cost : c->cost;
            if (has(s, WITHOUT_GROUPS) && s->starting && c->cost <= s->least + SLACK * s->options->cost.mul)
                lower_graph(s, g, c, SCALES_GROUPS);
        }
        if (c->estimate > limit || c->cost > s->guide + SLACK * s->options->cost.mul)
            break;
    }
    dag_free(g);
}

/* Inserts the current trial into the beam. */
static void enter_beam(struct form_search *s)
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

static struct policy starting_policy(const struct form_search *s, int form)
{
    return (struct policy){.plain = form % 3 == 1,
                           .early = form % 3 == 2,
                           .dissolve = form / 3 & 1,
                           .combine = form / 6 & 1,
                           .join = form / 12 & 1,
                           .differences = s->differences};
}

/* Forgets everything found so far. */
static void start_again(struct form_search *s, double work)
{
    program_free(s->best.program);
    s->best = (struct lowered){0};
    s->guide = HUGE_VAL;
    s->work = work;
}

/* Returns the least cost of a shape without choices; ties are broken by multiplications. */
static double first_cost(struct form_search *s, size_t shape)
{
    const double work = s->work;
    struct candidate c = {.shape = shape, .policy = {.plain = true, .differences = s->differences}};
    evaluate(s, &c, NULL, HUGE_VAL);
    const double cost = s->best.program ? s->least + TIE * (double)s->best.ops.mul : HUGE_VAL;
    start_again(s, work);
    return cost;
}

void search_select(struct form_search *s, size_t n)
{
    double *cost = new_array(s->shapes, sizeof *cost);
    for (size_t i = 0; s->shapes > n && i < s->shapes; i++)
        cost[i] = first_cost(s, i);
    while (s->shapes > n) {
        size_t worst = 0;
        for (size_t i = 1; i < s->shapes; i++)
            worst = cost[i] >= cost[worst] ? i : worst;
        dag_free(s->shape[worst].dag);
        s->shapes--;
        memmove(&s->shape[worst], &s->shape[worst + 1], (s->shapes - worst) * sizeof *s->shape);
        memmove(&cost[worst], &cost[worst + 1], (s->shapes - worst) * sizeof *cost);
    }
    free(cost);
}

/* Drops shapes that start far behind the first, unless trying them is expensive. This does not count as work, so that
 * they leave no trace. */
static void drop_shapes(struct form_search *s)
{
    const double work = s->work;
    struct candidate first = {.policy.differences = s->differences};
    size_t kept = 1;
    if (s->shapes <= WRITTEN)
        return;
    evaluate(s, &first, NULL, 0);
    for (size_t i = 1; i < s->shapes; i++) {
        struct candidate c = {.shape = i, .policy.differences = s->differences};
        if (s->work - work < s->limit / 20)
            evaluate(s, &c, NULL, 0);
        if (c.estimate < s->shape[i].behind * first.estimate)
            s->shape[kept++] = s->shape[i];
        else
            dag_free(s->shape[i].dag);
    }
    start_again(s, work);
    s->shapes = kept;
}

/* Evaluates a shape under a policy without choices, for the beam. */
static void try_policy(struct form_search *s, size_t shape, const struct policy *p)
{
    struct candidate *c = &s->beam[BEAM];
    c->shape = shape;
    policy_copy(&c->policy, p);
    evaluate(s, c, NULL, HUGE_VAL);
    enter_beam(s);
}

/* Tries the starting points: as written, multiplied out, with common denominators, one division for several, factored
 * or not, in all combinations; then with random preferences. If multiplying out is expensive for a shape, it is tried
 * once. */
static void try_first(struct form_search *s)
{
    static const double preference[] = {0.9, 3, 1000};
    const double first = s->limit > FIRST * (double)UNIT ? s->limit : FIRST * (double)UNIT;
    for (size_t i = 0; i < s->shapes; i++) {
        const bool quotients = divides(s->shape[i].dag);
        bool dear = false;
        for (int form = 0; form < FORMS; form++) {
            const struct policy p = starting_policy(s, form);
            const double before = s->work;
            if ((form >= KEEPING && !quotients) || (p.dissolve > 0 && dear) || (s->n > 0 && s->work > first))
                continue;
            s->starting = true;
            try_policy(s, i, &p);
            s->starting = false;
            dear |= s->work - before > s->limit / 20;
        }
        for (int attempt = 0; attempt < RANDOM_TRIES && s->work < s->limit / 2 * (double)(i + 1) / (double)s->shapes;
             attempt++) {
            const struct policy p = {.seed = random_next(&s->random),
                                     .preference = preference[attempt % 3],
                                     .plain = attempt % 4 == 3,
                                     .early = attempt % 5 == 1,
                                     .dissolve = dear ? 0 : 0.5 * (attempt % 3),
                                     .combine = quotients ? attempt / 2 % 2 : 0,
                                     .join = quotients && attempt & 4,
                                     .differences = s->differences};
            try_policy(s, i, &p);
        }
    }
}

/* Overrides a choice of the current trial. */
static void mutate(struct form_search *s, struct candidate *c, const struct record *record)
{
    if (c->policy.choices > 0 && random_next(&s->random) % 8 == 0) {
        const size_t k = random_next(&s->random) % c->policy.choices;
        memmove(&c->policy.choice[k], &c->policy.choice[k + 1],
                (c->policy.choices-- - k - 1) * sizeof *c->policy.choice);
        return;
    }
    const struct decision *d = &record->decision[random_next(&s->random) % record->decisions];
    const size_t k = random_next(&s->random) % (d->alternatives + 1);
    policy_choose(&c->policy, (struct choice){d->key, k == d->alternatives ? 0 : record->alternative[d->first + k]});
}

/* Anneals a candidate until this much work is done; the candidate becomes the best found. */
static void anneal(struct form_search *s, struct candidate *best, double hot, double until)
{
    struct record record = {0}, next = {0};
    struct candidate at = {0}, *trial = &s->beam[BEAM];
    const double start = s->work;
    copy_candidate(&at, best);
    evaluate(s, &at, &record, HUGE_VAL);
    while (s->work < until && record.decisions > 0) {
        const double heat = hot * (1 - (s->work - start) / (until - start)) * s->options->cost.mul;
        copy_candidate(trial, &at);
        for (uint64_t moves = 1 + random_next(&s->random) % 3; moves > 0; moves--)
            mutate(s, trial, &record);
        evaluate(s, trial, &next, at.estimate + SLACK * s->options->cost.mul);
        if (trial->cost > at.cost - heat * log(1 - random_fraction(random_next(&s->random))))
            continue;
        copy_candidate(&at, trial);
        const struct record swap = record;
        record = next;
        next = swap;
        if (at.cost < best->cost)
            copy_candidate(best, &at);
    }
    policy_clear(&at.policy);
    record_clear(&record);
    record_clear(&next);
}

/* Tries the last shape from all starting points that keep quotients. */
static void try_keeping(struct form_search *s)
{
    const double before = s->work;
    s->starting = true;
    for (int form = 0; form < KEEPING && s->work - before < s->limit / 20; form++) {
        struct candidate c = {.shape = s->shapes - 1, .policy = starting_policy(s, form)};
        evaluate(s, &c, NULL, HUGE_VAL);
    }
    s->starting = false;
}

/* Tries, at the end, the winner's shape with the vectors of a segment by the fewest differences, also under its own
 * choices. */
static void try_differences(struct form_search *s)
{
    struct candidate c = {0};
    if (!s->file->segment || s->differences || !s->best.program)
        return;
    struct dag *g = shape_differences(s->shape[s->winner.shape].dag, s->file->segment, 0);
    if (!g)
        return;
    search_add(s, g, 1, "fewest differences");
    copy_candidate(&c, &s->winner);
    c.shape = s->shapes - 1;
    c.policy.differences = s->differences = true;
    evaluate(s, &c, NULL, HUGE_VAL);
    policy_clear(&c.policy);
    try_keeping(s);
}

/* Explains the result by repeating the winner's passes. */
static void explain(struct form_search *s)
{
    FILE *out = s->options->explain;
    fprintf(out, "  %zu shapes, %.0f units of work; the cheapest is \"%s\" with %zu choices overruled\n", s->shapes,
            s->work / UNIT, s->shape[s->winner.shape].what, s->winner.policy.choices);
    s->explaining = true;
    explain_graph(out, s->file, "simplified", s->options->explained, s->shape[s->winner.shape].dag);
    dag_free(run_passes(s, &s->winner, NULL));
    s->explaining = false;
    fprintf(out, "  %-26s %5ld mul %4ld div %5ld add %4ld sqrt %4ld compare; cost %g (%s)\n", "emitted",
            s->best.ops.mul, s->best.ops.div, s->best.ops.add, s->best.ops.sqrt, s->best.ops.compare, s->least,
            s->options->cost.name);
}

struct removed search_run(struct form_search *s, struct lowered *l)
{
    drop_shapes(s);
    try_first(s);
    const double start = s->work, share = (s->limit - start) / (2 * (double)(s->n + 1));
    for (size_t i = 0; i < s->n && s->work < s->limit; i++)
        anneal(s, &s->beam[i], HOT, s->work + share);
    size_t best = 0;
    for (size_t i = 0; i < s->n; i++)
        if (s->beam[i].cost < s->beam[best].cost)
            best = i;
    if (s->n > 0 && s->work < s->limit)
        anneal(s, &s->beam[best], HOT, s->limit);
    if (has(s, WITHOUT_DIFFERENCES))
        try_differences(s);
    if (s->options->explain && s->best.program)
        explain(s);
    *l = s->best;
    l->out_of_range |= !l->program; /* on the way there, in every form */
    return s->removed;
}
