/* Champions, seeds and fronts; see archive.h. A champion of the start file keeps its constants to the last digit; seeds
 * bred from it round them. */
#include "archive.h"

#include "../../codegen/base/text.h"
#include "../common/decimal.h"
#include "../eval/frame.h"
#include "../genotype/lines_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double worth = 0.99;       /* a gain of less than 1 % changes no header */
static const double worth_judged = 0.9; /* For programs the gain must be 10 %, because the worst error on other samples
                                         * is more uncertain than a small gain in the mean. If both are right to
                                         * rounding, the cost must be 10 % lower. */

const char *const origin_name[ORIGINS] = {"start file", "seed", "seeded island", "random island"};

const struct genome *archive_start_genome(const struct archive *a, size_t tier)
{
    for (size_t i = 0; a->start && i < a->start->genomes; i++)
        if (strcmp(a->start->genome[i].name, a->scene->tier[tier].name) == 0)
            return &a->start->genome[i];
    return NULL;
}

static void make_quests(struct archive *a)
{
    a->quest = new_array(2 * a->scene->tiers, sizeof *a->quest);
    for (size_t i = 0; i < a->scene->tiers; i++) {
        const struct tier *t = &a->scene->tier[i];
        for (int k = t->program ? TIER_BOTH : 0; k <= (t->program ? TIER_BOTH : 1); k++)
            a->quest[a->quests++] =
                (struct quest){t, i, k, t->last ? line_function(a->program, t->last) : -1, .front = NULL};
    }
}

/* Returns the program that a genome's outputs make, its genes owned by the caller. Length 0 if it needs other values
 * than the tier's or is too long. */
static struct genes read_program(const struct archive *a, const struct genome_file *f, const struct genome_expr *xi,
                                 const struct genome_expr *eta, size_t tier)
{
    const struct tier *t = &a->scene->tier[tier];
    const struct gene_set genes = {.symbol = archive_symbols(a, tier), .symbols = t->terminals};
    const struct genome_expr *const out[2] = {xi, eta};
    struct genes program = {new_array(tier_genes(t), sizeof *program.gene), 0};
    if (!xi || !eta || !lines_read(a->lines, f, out, &genes, t->last != NULL, tier_genes(t), &program)) {
        free(program.gene);
        program = (struct genes){NULL, 0};
    }
    free(genes.symbol);
    return program;
}

static bool check_start(const struct archive *a, size_t tier, char *const start[2], struct diag *d)
{
    enum { ANY_LENGTH = 300000 };
    const struct tier *t = &a->scene->tier[tier];
    const struct gene_set genes = {.symbol = archive_symbols(a, tier), .symbols = t->terminals};
    struct genes program = {new_array(ANY_LENGTH, sizeof *program.gene), 0};
    const bool good = lines_read_values(a->lines, start, &genes, ANY_LENGTH, &program);
    free(program.gene);
    free(genes.symbol);
    return good ||
           diag_at(d, a->scene->path, t->line, 0, "tier '%s': start '%s', '%s' must be made of the tier's terminals",
                   t->name, start[0], start[1]);
}

bool archive_check_starts(const struct archive *a, struct diag *d)
{
    bool good = true;
    for (size_t i = 0; i < a->scene->tiers; i++) {
        const struct tier *t = &a->scene->tier[i];
        for (size_t k = 0; good && k < t->starts && t->program && !t->starts_at_large; k++)
            good = check_start(a, i, t->start[k], d);
    }
    return good;
}

static const struct genome_expr *output_of(const struct genome *g, int output)
{
    for (size_t i = 0; i < g->outs; i++)
        if (strcmp(g->out[i].name, frame_output[output]) == 0)
            return &g->out[i];
    return NULL;
}

static bool read_champion(struct archive *a, struct quest *q, struct diag *d)
{
    const struct genome *g = archive_start_genome(a, q->tier);
    const struct genome_expr *e = g ? output_of(g, q->output) : NULL;
    struct champion *c = &q->champion;
    bool good = true;
    if (g && quest_of_programs(q)) {
        c->genes = read_program(a, a->start, output_of(g, 0), output_of(g, 1), q->tier);
        good = c->genes.length > 0 || a->shipped ||
               diag_at(d, a->start->path, g->line, 0,
                       "genome '%s' is not a program of the tier's terminals within max_length; --from-scratch starts "
                       "without it",
                       g->name);
    } else if (e) {
        c->genes = (struct genes){new_array(e->length, sizeof *e->gene), e->length};
        good = frame_rebind(a->start, e, a->program, c->genes.gene, d);
    }
    if (!good) {
        free(c->genes.gene);
        c->genes = (struct genes){NULL, 0};
    }
    c->length_before = c->genes.length;
    return good || a->shipped;
}

/* Rounds constants of the program to decimal numbers. */
static void round_constants(const struct genome_file *program, struct genes *t)
{
    for (size_t i = 0; i < t->length; i++)
        if (t->gene[i] < 0)
            t->gene[i] = decimal_gene(program->constant[-1 - t->gene[i]].value);
}

/* Adds the champion as a seed of its own tier. */
static void seed_champion(struct archive *a, const struct quest *q)
{
    const struct genes *t = &q->champion.genes;
    if (t->length == 0)
        return;
    archive_add_seed(a, (long)q->tier, q->output, t);
    if (!quest_of_programs(q))
        round_constants(a->program, &a->seed[a->seeds - 1].genes);
}

struct archive *archive_new(const struct scene *s, struct genome_file *program, const char *start, bool shipped,
                            struct diag *d)
{
    struct archive *a = new_array(1, sizeof *a);
    *a = (struct archive){.scene = s, .program = program, .shipped = shipped};
    make_quests(a);
    a->rules = line_rules_new(program);
    a->counter = lines_counter_new(a->rules);
    a->lines = lines_new(a->rules);
    struct memory *bare = memory_open();
    genome_print(program, bare->stream);
    a->bare = memory_close(bare);
    a->start = start ? genome_read(start, d) : NULL;
    bool good = a->start || !start;
    for (size_t i = 0; good && i < a->quests; i++) {
        good = read_champion(a, &a->quest[i], d);
        if (good)
            seed_champion(a, &a->quest[i]);
    }
    if (good)
        return a;
    archive_free(a);
    return NULL;
}

void archive_free(struct archive *a)
{
    if (!a)
        return;
    for (size_t i = 0; i < a->quests; i++) {
        free(a->quest[i].champion.genes.gene);
        front_free(a->quest[i].front);
        front_free(a->quest[i].old);
    }
    for (size_t i = 0; i < a->seeds; i++)
        free(a->seed[i].genes.gene);
    free(a->seed);
    free(a->quest);
    free(a->bare);
    frame_cost_free(a->frame);
    lines_counter_free(a->counter);
    lines_free(a->lines);
    line_rules_free(a->rules);
    genome_file_free(a->start);
    genome_file_free(a->program);
    free(a);
}

void archive_add_seed(struct archive *a, long tier, int output, const struct genes *t)
{
    struct archive_seed *s = &APPEND(a->seed, a->seeds, a->seed_room);
    *s = (struct archive_seed){tier, output, {new_array(t->length, sizeof *t->gene), 0}};
    genes_copy(t, &s->genes);
}

static long tier_of_name(const struct scene *s, const char *name)
{
    for (size_t i = 0; i < s->tiers; i++)
        if (strcmp(s->tier[i].name, name) == 0)
            return (long)i;
    return -1;
}

static bool read_seed(struct archive *a, const struct genome_file *f, const struct genome *g, int output,
                      struct diag *d)
{
    const struct genome_expr *e = output_of(g, output);
    if (!e)
        return true;
    struct genes t = {new_array(e->length, sizeof *e->gene), e->length};
    const bool good = frame_rebind(f, e, a->program, t.gene, d);
    if (good) {
        round_constants(a->program, &t);
        archive_add_seed(a, tier_of_name(a->scene, g->name), output, &t);
    }
    free(t.gene);
    return good;
}

/* Reads a genome's outputs as seeds, and also as programs for tiers of programs. */
static bool read_seeds(struct archive *a, const struct genome_file *f, const struct genome *g, struct diag *d)
{
    const long own = tier_of_name(a->scene, g->name);
    bool programs = false;
    for (size_t i = 0; i < a->scene->tiers; i++) {
        if (!a->scene->tier[i].program || (own >= 0 && own != (long)i))
            continue;
        const struct genes t = read_program(a, f, output_of(g, 0), output_of(g, 1), i);
        if (t.length > 0)
            archive_add_seed(a, (long)i, TIER_BOTH, &t);
        programs = programs || t.length > 0;
        free(t.gene);
    }
    if (programs || (own >= 0 && a->scene->tier[own].program))
        return true;
    return read_seed(a, f, g, 0, d) && read_seed(a, f, g, 1, d);
}

bool archive_read_seeds(struct archive *a, const char *path, struct diag *d)
{
    struct genome_file *f = genome_read(path, d);
    const size_t before = a->seeds;
    bool good = f != NULL;
    for (size_t i = 0; good && i < f->genomes; i++)
        good = read_seeds(a, f, &f->genome[i], d);
    if (good && a->seeds == before)
        good = diag_at(d, path, 0, 0, "no genome with an output xi or eta");
    genome_file_free(f);
    return good;
}

/* Returns true if islands of the quest can breed from the seed. */
static bool fits_quest(const struct archive *a, const struct quest *q, const struct archive_seed *s)
{
    const struct tier *t = q->own;
    bool known =
        (s->tier < 0 || s->tier == (long)q->tier) && s->output == q->output && s->genes.length <= tier_genes(t);
    if (quest_of_programs(q))
        return known;
    for (size_t i = 0; known && i < s->genes.length; i++) {
        known = s->genes.gene[i] < GENE_OPERATORS;
        for (size_t k = 0; !known && k < t->terminals; k++)
            known = genome_find_symbol(a->program, t->terminal[k]) == s->genes.gene[i] - GENE_SYMBOL;
    }
    return known;
}

size_t archive_seeds(const struct archive *a, const struct quest *q, struct genes **seed)
{
    size_t n = 0;
    *seed = new_array(a->seeds + 1, sizeof **seed);
    for (size_t i = 0; i < a->seeds; i++)
        if (fits_quest(a, q, &a->seed[i]))
            (*seed)[n++] = a->seed[i].genes;
    return n;
}

struct operation_count archive_operations(const struct archive *a, const struct quest *q, const struct genes *t,
                                          const struct genome_constant *constant)
{
    if (quest_of_programs(q))
        return count_lines(a->counter, t, q->last);
    struct counter *c = counter_new();
    const struct operation_count o = count_operations(c, t, constant);
    counter_free(c);
    return o;
}

static double cost_of(const struct archive *a, const struct plan *plan, const struct quest *q, const struct genes *t,
                      const struct genome_constant *constant)
{
    const struct operation_count o = archive_operations(a, q, t, constant);
    return quest_of_programs(q) ? operations_price(&o, &plan->times)
                                : operations_price(&o, &plan->prices) + frame_cost_of(a->frame, t);
}

double archive_bare_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t)
{
    return quest_of_programs(q) ? objective_error(o, t, q->last, INFINITY)
                                : objective_tree_error(o, t, frame_target(a->program, q->output), INFINITY);
}

double archive_error(const struct archive *a, struct objective *o, const struct quest *q, const struct genes *t)
{
    return quest_of_programs(q) ? objective_error_in_tails(o, t, q->last, &q->tails, INFINITY)
                                : archive_bare_error(a, o, q, t);
}

/* Sets the largest permitted 99 % and maximum errors of programs: taken from the first champion or, if there is no
 * champion, from the best seed within the budget. */
static void find_tails(const struct archive *a, const struct plan *plan, struct objective *o, struct quest *q)
{
    const struct champion *c = &q->champion;
    const double budget = q->own->budget;
    struct genes *seed;
    const size_t n = archive_seeds(a, q, &seed);
    const struct genes *best = c->genes.length > 0 ? &c->genes : NULL;
    double least = INFINITY;
    for (size_t i = 0; i < n && c->genes.length == 0; i++) {
        const double cost = cost_of(a, plan, q, &seed[i], NULL);
        const double error = objective_error(o, &seed[i], q->last, least);
        if (error < least && (budget == 0 || cost <= budget)) {
            least = error;
            best = &seed[i];
        }
    }
    if (best)
        q->tails = objective_tails(o, best, q->last);
    free(seed);
}

static void measure_champion(const struct archive *a, const struct plan *plan, struct objective *exact, struct quest *q)
{
    struct champion *c = &q->champion;
    if (c->genes.length > 0) {
        c->error = archive_error(a, exact, q, &c->genes);
        c->cost = cost_of(a, plan, q, &c->genes, a->program->constant);
    }
    c->error_before = c->error;
    c->cost_before = c->cost;
}

/* Replaces the champion by a value of the frame that is right to rounding. */
static void take_exact(const struct archive *a, struct objective *exact, struct quest *q)
{
    struct champion *c = &q->champion;
    const struct genes value = {&c->exact, 1};
    if (c->exact == 0 || genes_equal(&c->genes, &value))
        return;
    free(c->genes.gene);
    c->genes.gene = new_array(1, sizeof *c->genes.gene);
    genes_copy(&value, &c->genes);
    c->error = archive_error(a, exact, q, &c->genes);
    c->cost = frame_cost_of(a->frame, &c->genes);
    c->bred = true;
}

/* Starts each front. If a quest has a champion, that is its first seed. */
static void start_fronts(const struct archive *a, const struct plan *plan, struct objective *o, struct quest *q)
{
    const size_t longest = tier_genes(q->own);
    struct genes *seed;
    q->front = front_new(plan->front_limit, longest);
    q->old = front_new(plan->front_limit, longest);
    const size_t n = archive_seeds(a, q, &seed);
    for (size_t i = 0; i < n; i++) {
        const double error = archive_error(a, o, q, &seed[i]);
        const bool start = i == 0 && q->champion.length_before > 0;
        archive_offer(a, plan, q, &seed[i], error, start ? ORIGIN_START : ORIGIN_SEED);
    }
    front_copy(q->front, q->old);
    free(seed);
}

void archive_measure(struct archive *a, const struct plan *plan, struct objective *o)
{
    struct objective *exact = objective_new(a->program, o->table, o->norm);
    if (!a->frame)
        a->frame = frame_cost_new(a->program, &plan->prices);
    for (struct quest *q = a->quest; q < a->quest + a->quests; q++) {
        if (quest_of_programs(q))
            find_tails(a, plan, o, q);
        measure_champion(a, plan, exact, q);
        take_exact(a, exact, q);
        start_fronts(a, plan, o, q);
    }
    objective_free(exact);
}

void archive_offer(const struct archive *a, const struct plan *plan, struct quest *q, const struct genes *t,
                   double error, enum origin origin)
{
    struct member *m = front_offer(q->front, t, error, cost_of(a, plan, q, t, NULL));
    if (m)
        m->origin = (int)origin;
}

void archive_replace_champion(const struct archive *a, struct objective *o, struct quest *q, const struct member *m)
{
    struct champion *c = &q->champion;
    free(c->genes.gene);
    c->genes.gene = new_array(m->genes.length, sizeof *m->genes.gene);
    if (quest_of_programs(q))
        genes_copy(&m->genes, &c->genes);
    else
        genes_bind(a->program, &m->genes, &c->genes);
    c->error = archive_bare_error(a, o, q, &m->genes);
    c->cost = m->cost;
    c->bred = true;
    c->seed = m->origin == ORIGIN_SEED || m->origin == ORIGIN_START;
}

/* Returns the figure that the choice among a tier's expressions minimises, or INFINITY for an expression out of the
 * budget. Among expressions within the budget and right to rounding, the cheapest wins. */
static double merit(const struct archive *a, const struct plan *plan, const struct quest *q, double error, double cost)
{
    const double budget = q->own->budget, least = objective_rounding(a->scene->norm);
    if (budget == 0)
        return plan_fitness(plan, error, cost);
    return cost > budget ? INFINITY : error > least ? error : least * cost / budget;
}

/* Judges the expressions of a quest, by the islands' errors or on validation samples. */
struct court {
    struct objective *judge; /* not owned; NULL: uses the islands' errors */
    int last;
    const struct genes *champion; /* not owned; NULL: no champion within the budget */
    struct outputs outputs;       /* of the champion */
    struct tails tails;
};

/* Returns the error, or INFINITY if any error figure is worse than the champion's. */
static double verdict(const struct court *court, const struct genes *t, double error)
{
    if (!court->judge || !(error < INFINITY))
        return error;
    if (court->champion && t != court->champion && !objective_no_worse(court->judge, t, court->last, &court->outputs))
        return INFINITY;
    return objective_error_in_tails(court->judge, t, court->last, &court->tails, INFINITY);
}

static void choose_champion(const struct archive *a, const struct plan *plan, struct objective *o,
                            struct objective *judge, struct quest *q)
{
    const struct front *f = q->front;
    const struct champion *c = &q->champion;
    const double budget = q->own->budget;
    struct court court = {.judge = quest_of_programs(q) ? judge : NULL, .last = q->last};
    const bool fits = c->genes.length > 0 && merit(a, plan, q, c->error, c->cost) < INFINITY;
    if (court.judge && c->genes.length > 0)
        court.tails = objective_tails(judge, &c->genes, court.last);
    if (court.judge && fits) {
        court.champion = &c->genes;
        court.outputs = objective_outputs(judge, &c->genes, court.last);
    }
    const double error = c->genes.length > 0 ? verdict(&court, &c->genes, c->error) : INFINITY;
    const double most = fmax(c->error, objective_rounding(a->scene->norm));
    double least = (court.judge ? worth_judged : worth) * merit(a, plan, q, error, c->cost);
    const struct member *best = NULL;
    for (size_t k = 0; k <= f->limit; k++) {
        const struct member *m = &f->member[k];
        if (m->genes.length == 0 || m->origin == ORIGIN_START || merit(a, plan, q, m->error, m->cost) == INFINITY)
            continue;
        if (budget > 0 && fits && m->error > most) /* the champion may have a pole among the validation samples */
            continue;
        const double own = verdict(&court, &m->genes, m->error);
        if ((budget > 0 || own <= error) && merit(a, plan, q, own, m->cost) < least) {
            best = m;
            least = merit(a, plan, q, own, m->cost);
        }
    }
    if (!best && c->genes.length == 0 && front_count(f) > 0)
        best = front_member(f, 0); /* the cheapest member if the budget excludes all */
    if (best)
        archive_replace_champion(a, o, q, best);
}

bool archive_has(const struct archive *a, size_t tier)
{
    size_t n;
    const struct quest *q = archive_quests(a, tier, &n);
    return q[0].champion.genes.length > 0 && q[n - 1].champion.genes.length > 0;
}

void archive_choose_champions(struct archive *a, const struct plan *plan, struct objective *o, struct objective *judge)
{
    for (struct quest *q = a->quest; q < a->quest + a->quests; q++)
        if (q->champion.exact == 0)
            choose_champion(a, plan, o, judge, q);
}
