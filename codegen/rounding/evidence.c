/* Collects evidence about a program; see evidence.h. poles.c, rounding_bound.c and sampled_errors.c supply it. */
#include "evidence.h"

#include "../base/text.h"
#include "../program/dialects.h"
#include "../program/evaluate.h"
#include "../region/enclosure.h"
#include "rounding_bound.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NAME = 60, POINTS = 8, POINT_BITS = 6, BOXES_FOR_EMPTY = 200 };

/* Limits of work, in operations on coefficients (about a nanosecond each) if at least BOXES_FOR_MOST boxes are allowed,
 * and in Arb's operations. */
#define MOST_WORK 1.5e9
#define BOXES_FOR_MOST 2000.0
#define DRAW 16.0 /* cost of a random coordinate */
#define MOST_BALLS 4e6
#define USEFUL 100.0  /* a bound more than this many times the worst sample is useless */
#define HARMLESS 1e-3 /* of a divisor's least value: a smaller error has no effect */

/* ---- finding out ---- */

struct evidence_search {
    struct region *region;
    long boxes;  /* for each search */
    double work; /* remaining */
};

/* Returns the boxes that the remaining work allows for one of `searches` more searches. If a range is missing, few
 * boxes suffice to show whether D is 0 anywhere. */
static long boxes_for(struct evidence_search *s, size_t searches)
{
    const double variables = (double)s->region->known->variables, ops = (double)s->region->known->program->ops;
    const double cost = ops * (variables + 4) * (variables + 8), most = s->work / (double)searches / cost;
    const long wanted = s->region->known->complete ? s->boxes : s->boxes / 16;
    const long boxes = most < (double)wanted ? (long)most : wanted;
    s->work -= (double)boxes * cost + 10 * ops;
    return boxes;
}

/* Bounds the error of an operation with a part of the remaining work. */
static double find_error(struct evidence_search *s, int op, struct bound_goal goal, size_t searches)
{
    const double part = s->work / (double)searches;
    double left = part;
    const double bound = bound_error(s->region, op, goal, s->boxes, &left);
    s->work -= part - left;
    return bound;
}

/* Finds where an operation is 0; for a product that is too hard as a whole, where a factor is. */
static struct pole find_zero(struct evidence_search *s, int op, long boxes)
{
    struct region *r = s->region;
    const struct op *x = &r->known->program->op[op];
    const struct interval known = r->known->value[op];
    if (known.lo > 0 || known.hi < 0)
        return (struct pole){.verdict = POLE_FREE, .least = fmin(fabs(known.lo), fabs(known.hi)), .values = known};
    struct pole pole = pole_find(r, op, boxes);
    s->work -= (double)pole.draws * (DRAW + (double)r->known->first) * (double)r->known->variables;
    if (pole.verdict == POLE_UNDECIDED && x->kind == OP_MUL) {
        const struct pole a = find_zero(s, x->a, boxes);
        pole = x->squared || a.verdict != POLE_FREE ? a : find_zero(s, x->b, boxes);
        if (pole.verdict == POLE_FREE) {
            pole.least = interval_multiply(interval_point(a.least), interval_point(pole.least)).lo;
            pole.values = interval_multiply(r->known->value[x->a], r->known->value[x->b]);
        }
    }
    if (pole.verdict == POLE_FREE)
        r->known->value[op] = interval_meet(known, pole.values);
    return pole;
}

/* Encloses the computed values of all denominators, without a bound of their errors. */
static void enclose_computed(struct region *r, struct evidence *e)
{
    struct interval *box = new_array(r->known->variables, sizeof *box);
    region_box(r, box);
    struct interval *range = computed_ranges(r->known, box, r->known->program->ops);
    for (size_t i = 0; i < e->denominators; i++)
        e->denominator[i].apart = !interval_has(range[region_op(r, e->denominator[i].op)], 0);
    free(range);
    free(box);
}

static void find_pole(struct evidence_search *s, struct denominator *d, size_t searches)
{
    struct region *r = s->region;
    const int op = region_op(r, d->op);
    d->verdict = POLE_UNDECIDED;
    if (s->work <= 0)
        return;
    const long boxes = boxes_for(s, searches);
    const struct pole pole = find_zero(s, op, boxes);
    d->verdict = pole.verdict;
    d->least = pole.least;
    if (pole.verdict == POLE_FREE)
        d->sign = pole.values.lo > 0 ? 1 : pole.values.hi < 0 ? -1 : 0;
    if (pole.verdict == POLE_UNDECIDED && known_requires(r->known, op))
        d->verdict = POLE_REQUIRED;
    if (pole.verdict == POLE_EXISTS) {
        d->witness = new_array(r->known->places, sizeof *d->witness);
        region_inputs(r, pole.witness, d->witness);
    }
    free(pole.witness);
}

/* Returns the largest error bound that still separates a denominator from 0: at least half the digits of its largest
 * values must be right. */
static double most_threshold(const struct evidence_search *s, const struct denominator *d)
{
    return sqrt(s->region->known->arithmetic.unit) * d->most;
}

/* Bounds the errors of divisors, with a part of the work. */
static void bound_denominators(struct evidence_search *s, struct evidence *e)
{
    for (size_t i = 0; i < e->denominators && s->work > 0; i++) {
        struct denominator *d = &e->denominator[i];
        const struct bound_goal goal = {d->least, fmax(d->least, most_threshold(s, d)), HARMLESS * d->least};
        d->error = find_error(s, region_op(s->region, d->op), goal, 2 * (e->denominators + e->outputs));
    }
}

/* Bounds the errors of outputs with the remaining work, if bounds may come near the worst samples. */
static void bound_outputs(struct evidence_search *s, struct evidence *e, const struct program *p)
{
    for (size_t i = 0; i < p->outputs && s->work > 0; i++) {
        const double useful = e->error[i].sampled >= 0 ? USEFUL * e->error[i].sampled : INFINITY;
        const struct bound_goal goal = {useful, useful, 0};
        e->error[i].bound = find_error(s, region_op(s->region, p->output[i]), goal, p->outputs - i);
    }
}

/* Returns the denominator as the text writes it; for a long expression, the statement that divides by it. */
static char *denominator_name(struct printer *r, int op, const struct statement *s)
{
    if (r->name[op] || r->width[op] <= MOST_NAME)
        return printer_text(r, op, LEVEL_SUM);
    return new_format("divisor of %s", s->name);
}

static void find_denominators(struct evidence *e, const struct genome_file *f, const struct genome *genome,
                              const struct program *p)
{
    struct printer *r = c_statements(f, genome, p, &c_double, NULL);
    const struct statement *s = p->statement;
    bool *seen[2] = {new_array(p->ops, sizeof **seen), new_array(p->ops, sizeof **seen)}; /* of protected quotients */
    size_t room = 0, protected_room = 0;
    for (size_t i = 0; i < p->ops; i++) {
        const int b = p->op[i].b;
        const bool protects = p->op[i].kind == OP_PDIV;
        if (!(protects || p->op[i].kind == OP_DIV) || p->op[b].kind == OP_CONSTANT || seen[protects][b])
            continue;
        while (s->op < (int)i)
            s++;
        seen[protects][b] = true;
        char *name = denominator_name(r, b, s);
        if (protects)
            APPEND(e->protected_name, e->protecteds, protected_room) = name;
        else
            APPEND(e->denominator, e->denominators, room) =
                (struct denominator){.op = b, .name = name, .error = INFINITY};
    }
    printer_free(r);
    free(seen[0]);
    free(seen[1]);
}

/* Returns true if a bound applies to the program's coordinates. Coordinates relative to the first node equal the
 * region's only if the region has that node at the origin. */
static bool can_bound(const struct known *x)
{
    bool origin = true;
    for (int i = 0; x->arithmetic.given > 0 && i < 3; i++)
        origin = origin && interval_is_zero(x->value[known_op(x, i)]);
    return x->complete && origin;
}

static void choose_thresholds(const struct evidence_search *s, struct evidence *e)
{
    for (size_t i = 0; i < e->denominators; i++) {
        struct denominator *d = &e->denominator[i];
        d->threshold = d->error < most_threshold(s, d) ? d->error : 0;
    }
}

static void take_samples(struct evidence *e, const struct sampled_errors *s)
{
    e->samples = s->points;
    for (size_t i = 0; i < e->outputs && s->points > 0; i++)
        e->error[i].sampled = s->worst[i];
    for (size_t i = 0; i < e->denominators; i++)
        e->denominator[i].most = s->most[e->denominator[i].op];
}

struct evidence *evidence_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                              const struct evidence_options *options)
{
    struct evidence *e = new_array(1, sizeof *e);
    struct region *r = region_new(f, p, true);
    if (options->arithmetic)
        r->known->arithmetic = *options->arithmetic;
    struct evidence_search s = {
        .region = r, .boxes = options->boxes, .work = MOST_WORK * fmin(1, (double)options->boxes / BOXES_FOR_MOST)};
    find_denominators(e, f, genome, p);
    e->region = r->known->complete;
    e->empty = region_is_empty(r, BOXES_FOR_EMPTY);
    e->outputs = p->outputs;
    e->error = new_array(p->outputs, sizeof *e->error);
    enclose_computed(r, e);
    for (size_t i = 0; i < e->denominators; i++)
        find_pole(&s, &e->denominator[i], e->denominators + p->outputs - i);
    for (size_t i = 0; i < p->outputs; i++)
        e->error[i] = (struct output_error){INFINITY, -1};
    if (e->region && options->sampled)
        take_samples(e, options->sampled);
    if (can_bound(r->known))
        bound_denominators(&s, e);
    if (can_bound(r->known) && !options->poles && evidence_pole_free(e))
        bound_outputs(&s, e, p);
    choose_thresholds(&s, e);
    region_free(r);
    return e;
}

void evidence_free(struct evidence *e)
{
    if (!e)
        return;
    for (size_t i = 0; i < e->denominators; i++) {
        free(e->denominator[i].name);
        free(e->denominator[i].witness);
    }
    for (size_t i = 0; i < e->protecteds; i++)
        free(e->protected_name[i]);
    free(e->protected_name);
    free(e->denominator);
    free(e->error);
    free(e);
}

bool evidence_pole_free(const struct evidence *e)
{
    for (size_t i = 0; i < e->denominators; i++)
        if (e->denominator[i].verdict != POLE_FREE)
            return false;
    return true;
}

bool output_error_is_bounded(const struct output_error *e)
{
    return e->bound < INFINITY && (e->sampled < 0 || e->bound <= USEFUL * e->sampled);
}

bool denominator_is_safe(const struct denominator *d)
{
    return d->verdict == POLE_FREE && (d->error < d->least || d->apart);
}

/* ---- test points ---- */

/* Prints a row, unless an output is undefined or without a bound at the point. */
static bool print_point(const struct program *p, struct region *r, const double *input, arb_ptr exact, FILE *out)
{
    double *at = new_array(r->known->variables, sizeof *at);
    for (size_t k = 0; k < r->known->variables; k++)
        at[k] = input[r->known->input[k]];
    double *row = new_array(2 * p->outputs, sizeof *row);
    struct point_bound *bound = point_bound_new(r, p);
    point_bound_at(bound, at, row + p->outputs);
    bool good = point_exact(p, input, exact);
    for (size_t i = 0; good && i < p->outputs; i++) {
        double *error = &row[p->outputs + i];
        good = ball_nearest(exact + i, &row[i]);
        *error = above(*error + above(fabs(row[i]) * 0x1p-53)); /* plus the rounding of the exact result */
        good = good && *error < INFINITY;
    }
    point_bound_free(bound);
    if (good) {
        fputs("    {", out);
        for (size_t i = 0; i < p->inputs; i++)
            fprintf(out, "%.17g, ", input[i]);
        for (size_t i = 0; i < 2 * p->outputs; i++)
            fprintf(out, "%.17g%s", row[i], i + 1 < 2 * p->outputs ? ", " : "},\n");
    }
    free(row);
    free(at);
    return good;
}

int evidence_print_points(const struct genome_file *f, const struct program *p, FILE *out)
{
    struct region *r = region_new(f, p, true), *inputs = region_new(f, p, false);
    double *input = new_array(p->inputs, sizeof *input), *at = new_array(r->known->variables, sizeof *at);
    arb_ptr exact = _arb_vec_init((slong)p->outputs);
    long tries = (long)(MOST_BALLS / (double)r->known->program->ops);
    uint64_t seed = 1;
    int rows = 0;
    for (int i = 0; i < 4 * POINTS && rows < POINTS && region_draw(r, &seed, POINT_BITS, &tries, at); i++) {
        region_inputs(r, at, input);
        rows += print_point(p, inputs, input, exact, out);
    }
    _arb_vec_clear(exact, (slong)p->outputs);
    free(input);
    free(at);
    region_free(r);
    region_free(inputs);
    return rows;
}
