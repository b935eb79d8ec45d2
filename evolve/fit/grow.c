/* Greedy growth; see grow.h.  Sums begin at the root and at operands of anything but sums (grow_screen.h), so that
 * Horner's form, factors, numerators, denominators and what is clamped grow alike.  The most promising additions are
 * made and fitted, the best is kept; terms that have become useless are dropped again wherever that beats what was
 * found before at the lower cost. */
#include "grow.h"

#include "../common/decimal.h"
#include "grow_screen.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { GROW_STEPS = 5, LAST_STEPS = 5, DROPS = 4 };
static const double near = 0.3; /* scale of the smoothed absolute error, of its mean */
static const double divisor_guard = 0.03, least_progress = 1e-6, least_drop = 1e-4, least_stage = 0.01;

struct grower {
    const struct grow_plan *plan;
    struct objective *objective;
    size_t target;
    struct columns thin;
    struct fitter *fitter;
    struct tree now, trial, best, spare; /* owned */
    double error, best_error;            /* mean absolute ones on the thin table, of `now` and `best` */
    double cost;                         /* of `now` */
    struct loss measure;                 /* follows the error of `now` */
    struct pareto stages;                /* by the error on the thin table */
    struct term_list list;
};

static double cost_of(const struct grower *g, const struct tree *t)
{
    return tree_price(&g->plan->prices, t);
}

/* Fit `trial`; its mean absolute error. */
static double fit_trial(struct grower *g)
{
    static const struct loss plain = {LOSS_ABSOLUTE, 1e-12, 0};
    tape_load(g->fitter->tape, &g->trial);
    fitter_descend(g->fitter, g->target, &g->measure, GROW_STEPS);
    tape_store(g->fitter->tape, &g->trial);
    tape_load(g->fitter->tape, &g->trial);
    return fitter_loss(g->fitter, g->target, &plain) / (double)g->thin.n;
}

static void adopt(struct grower *g, const struct tree *t, double error)
{
    tree_copy(t, &g->now);
    g->cost = cost_of(g, t);
    g->error = error;
    g->measure = (struct loss){LOSS_ABSOLUTE, near * error, 0};
    pareto_offer(&g->stages, t, error);
}

/* Gain for the price, in place of the gain; terms without room, or that would only repeat, are left out. */
static void price_terms(struct grower *g)
{
    size_t kept = 0;
    for (size_t i = 0; i < g->list.n; i++) {
        struct term x = g->list.term[i];
        if (term_repeats(&g->now, &x))
            continue;
        term_insert(&g->now, &x, &g->spare);
        const double extra = cost_of(g, &g->spare) - g->cost;
        if (g->spare.length > g->plan->max_length || !(g->cost + extra <= g->plan->max_cost))
            continue;
        x.gain /= fmax(extra, g->plan->prices.add);
        g->list.term[kept++] = x;
    }
    g->list.n = kept;
}

static int compare_terms(const void *a, const void *b)
{
    const struct term *p = a, *q = b;
    if (p->gain != q->gain)
        return p->gain > q->gain ? -1 : 1;
    if (p->at != q->at)
        return p->at < q->at ? -1 : 1;
    return memcmp(p->symbol, q->symbol, sizeof p->symbol);
}

/* Make the best addition; false if none helps. */
static bool add_term(struct grower *g)
{
    double best = 0, last = INFINITY;
    tape_load(g->fitter->tape, &g->now);
    screen_terms(g->fitter, g->target, g->measure.scale, g->plan->symbol, g->plan->symbols, &g->list);
    price_terms(g);
    if (g->list.n > 0)
        qsort(g->list.term, g->list.n, sizeof *g->list.term, compare_terms);
    int tries = 0;
    for (size_t i = 0; i < g->list.n && tries < g->plan->tries; i++) {
        const struct term *x = &g->list.term[i];
        if (x->gain >= last * (1 - least_progress))
            continue; /* the same column at another point */
        last = x->gain;
        tries++;
        term_insert(&g->now, x, &g->trial);
        const double error = fit_trial(g);
        const double gain = (g->error - error) / fmax(cost_of(g, &g->trial) - g->cost, g->plan->prices.add);
        if (gain > best) {
            best = gain;
            g->best_error = error;
            tree_copy(&g->trial, &g->best);
        }
    }
    if (!(best > least_progress * g->error))
        return false;
    adopt(g, &g->best, g->best_error);
    return true;
}

/* Constants that multiply something, those first whose loss is least: estimated as c^2 / (A^-1)_cc for normal equations
 * with the matrix A. */
static size_t rank_drops(struct grower *g, size_t drop[DROPS])
{
    struct fitter *f = g->fitter;
    struct tape *t = f->tape;
    tape_load(t, &g->now);
    fitter_descend(f, g->target, &g->measure, 0);
    const size_t k = t->constants, count = f->room;
    double *column = new_array(k, sizeof *column), least[DROPS];
    size_t found = 0;
    for (size_t i = 0; i < k; i++)
        f->normal[i * count + i] = f->normal[i * count + i] > 0 ? f->normal[i * count + i] * (1 + 1e-10) : 1;
    const bool good = cholesky_factor(f->normal, k, count);
    for (size_t i = 0; good && i < t->length; i++) {
        if (t->gene[i] != GENE_MUL || (t->gene[i + 1] >= 0 && t->gene[t->operand[i]] >= 0))
            continue;
        const size_t at = t->gene[i + 1] < 0 ? i + 1 : t->operand[i];
        size_t c = 0;
        while (t->constant[c] != at)
            c++;
        memset(column, 0, k * sizeof *column);
        column[c] = 1;
        cholesky_forward(f->normal, k, count, column);
        double inverse = 0;
        for (size_t j = c; j < k; j++)
            inverse += column[j] * column[j];
        const double loss = t->number[at] * t->number[at] / inverse;
        size_t place = found < DROPS ? found : DROPS;
        while (place > 0 && loss < least[place - 1])
            place--;
        if (place == DROPS)
            continue;
        found = found < DROPS ? found + 1 : DROPS;
        for (size_t j = found - 1; j > place; j--) {
            least[j] = least[j - 1];
            drop[j] = drop[j - 1];
        }
        least[place] = loss;
        drop[place] = at;
    }
    free(column);
    return found;
}

/* Drop a term where that gives the best tree so far of the lower cost. */
static bool drop_term(struct grower *g)
{
    size_t drop[DROPS];
    const size_t n = rank_drops(g, drop);
    for (size_t i = 0; i < n; i++) {
        tree_copy(&g->now, &g->spare);
        g->spare.gene[drop[i]] = decimal_gene(0);
        terms_drop_zeros(&g->spare, &g->trial);
        const double error = fit_trial(g);
        if (error < pareto_error(&g->stages, cost_of(g, &g->trial)) * (1 - least_drop)) {
            adopt(g, &g->trial, error);
            return true;
        }
    }
    return false;
}

static void make_room(struct grower *g, size_t start)
{
    const size_t room = (start > g->plan->max_length ? start : g->plan->max_length) + TERM_GENES;
    struct tree *tree[] = {&g->now, &g->trial, &g->best, &g->spare};
    for (size_t i = 0; i < sizeof tree / sizeof *tree; i++)
        tree[i]->gene = new_array(room, sizeof *tree[i]->gene);
}

static void grower_free(struct grower *g)
{
    columns_free(&g->thin);
    fitter_free(g->fitter);
    pareto_free(&g->stages);
    free(g->now.gene);
    free(g->trial.gene);
    free(g->best.gene);
    free(g->spare.gene);
    free(g->list.term);
}

/* Fit the stages to all samples, but for those that are hardly better than the one before. */
static void finish(struct grower *g, struct pareto *front)
{
    double last = INFINITY;
    struct fitter *f = fitter_new(g->objective->table);
    f->guard = divisor_guard;
    for (size_t i = 0; i < g->stages.n; i++) {
        const struct pareto_member *x = &g->stages.member[i];
        double error;
        if (i + 1 < g->stages.n && x->error > last * (1 - least_stage))
            continue;
        last = x->error;
        fit_constants(f, g->objective, &x->tree, g->target, LAST_STEPS, &g->trial, &error);
        if (isfinite(error))
            pareto_offer(front, &g->trial, error);
    }
    fitter_free(f);
}

struct grow_plan grow_plan_new(const int *symbol, size_t symbols, double max_cost, size_t max_length)
{
    return (struct grow_plan){symbol, symbols, {.add = 0.3, .div = 1}, max_cost, max_length, 2500, 4, 3, false, 0, 0};
}

void grow(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *start,
          struct pareto *front)
{
    struct grower g = {.plan = plan, .objective = objective, .target = target};
    const size_t n = objective->table->n;
    g.thin = columns_thin(objective->table, plan->rows < n ? n / plan->rows : 1);
    g.fitter = fitter_new(&g.thin);
    g.fitter->guard = divisor_guard;
    g.measure = (struct loss){LOSS_SQUARES, 1, 0};
    g.stages.prices = plan->prices;
    make_room(&g, start->length);
    tree_copy(start, &g.trial);
    adopt(&g, &g.trial, fit_trial(&g));
    while (isfinite(g.error) && g.measure.scale > 0 && add_term(&g)) {
        while (drop_term(&g))
            ;
    }
    finish(&g, front);
    grower_free(&g);
}

/* Mean of the target less that of a tree, or of nothing: where its constant begins. */
static double mean_above(const struct columns *table, size_t target, const struct tree *base)
{
    const double *goal = columns_at(table, target);
    struct tape *t = tape_new(table);
    double sum = 0;
    if (base)
        tape_load(t, base);
    for (size_t row = 0; row < table->n; row++) {
        if (base && row % TAPE_BLOCK == 0)
            tape_values(t, row);
        sum += goal[row] - (base ? t->value[0][row % TAPE_BLOCK] : 0);
    }
    tape_free(t);
    return sum / (double)table->n;
}

enum { START_GENES = 16 }; /* beside those of a base */

static void append(struct tree *t, const int *gene, size_t n)
{
    memcpy(t->gene + t->length, gene, n * sizeof *gene);
    t->length += n;
}

/* constant [+ base] [+ 0.2 / (constant + symbol), with a divisor that is positive on all samples], clamped if the plan
 * says so.  symbol 0: no quotient. */
static void write_start(const struct grow_plan *plan, const struct columns *table, double constant,
                        const struct tree *base, int symbol, struct tree *t)
{
    const int clamp[] = {GENE_MAX, decimal_gene(plan->low), GENE_MIN, decimal_gene(plan->high)};
    const int first = decimal_gene(constant), add = GENE_ADD;
    t->length = 0;
    if (plan->clamped)
        append(t, clamp, sizeof clamp / sizeof *clamp);
    if (base) {
        append(t, &add, 1);
        append(t, base->gene, base->length);
    }
    if (symbol != 0) {
        const double *x = columns_at(table, (size_t)(symbol - GENE_SYMBOL));
        double size = 0;
        for (size_t i = 0; i < table->n; i++)
            size = fmax(size, fabs(x[i]));
        const int quotient[] = {GENE_ADD, GENE_DIV, decimal_gene(0.2), GENE_ADD, decimal_gene(1.5 * size + 0.5),
                                symbol};
        append(t, quotient, sizeof quotient / sizeof *quotient);
    }
    append(t, &first, 1);
}

void grow_polynomials(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *base,
                      struct pareto *front)
{
    struct tree start = {new_array((base ? base->length : 0) + START_GENES, sizeof *start.gene), 0};
    write_start(plan, objective->table, mean_above(objective->table, target, base), base, 0, &start);
    grow(plan, objective, target, &start, front);
    free(start.gene);
}

/* Index of the least number; it is made infinite. */
static size_t take_least(double *number, size_t n)
{
    size_t least = 0;
    for (size_t i = 1; i < n; i++)
        if (number[i] < number[least])
            least = i;
    number[least] = INFINITY;
    return least;
}

void grow_quotients(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *base,
                    struct pareto *front)
{
    static const double first_cost = 8;
    struct grow_plan first = *plan;
    struct tree start = {new_array((base ? base->length : 0) + START_GENES, sizeof *start.gene), 0};
    double *error = new_array(plan->symbols, sizeof *error);
    const double constant = mean_above(objective->table, target, base);
    first.max_cost = fmin(plan->max_cost, (base ? tree_price(&plan->prices, base) : 0) + plan->prices.div + first_cost);
    for (size_t i = 0; i < plan->symbols; i++) {
        struct pareto found = {.prices = plan->prices};
        write_start(plan, objective->table, constant, base, plan->symbol[i], &start);
        grow(&first, objective, target, &start, &found);
        error[i] = pareto_error(&found, first.max_cost);
        pareto_free(&found);
    }
    for (size_t i = 0; i < plan->starts && i < plan->symbols; i++) {
        write_start(plan, objective->table, constant, base, plan->symbol[take_least(error, plan->symbols)], &start);
        grow(plan, objective, target, &start, front);
    }
    free(error);
    free(start.gene);
}
