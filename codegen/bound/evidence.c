/* What is found out about a program and how it is said; see evidence.h.  The finding is done by poles.c, rounding_bound.c and
 * evaluate.c. */
#include "evidence.h"

#include "../genome/text.h"
#include "../program/dialects.h"
#include "../program/evaluate.h"
#include "rounding_bound.h"

#include <mpfr.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NAME = 60, MOST_LISTED = 12, POINTS = 8, POINT_BITS = 6, TRIES_A_SAMPLE = 20, LINE_WIDTH = 118 };
enum { BOXES_FOR_EMPTY = 200 };

/* Limits of work, in operations on coefficients (about a nanosecond) and in Arb's operations. */
#define MOST_WORK 1.5e9
#define DRAW 16.0 /* a random coordinate */
#define MOST_BALLS 4e6

/* ---- finding out ---- */

struct search {
    struct region *region;
    long boxes;  /* for each search */
    double work; /* left */
};

/* Boxes that the work left allows for one of `searches` more searches. */
static long boxes_for(struct search *s, size_t searches)
{
    const double variables = (double)s->region->known->variables, ops = (double)s->region->known->program->ops;
    const double cost = ops * (variables + 4) * (variables + 8), most = s->work / (double)searches / cost;
    const long boxes = most < (double)s->boxes ? (long)most : s->boxes;
    s->work -= (double)boxes * cost + 10 * ops;
    return boxes;
}

static void find_pole(struct search *s, struct denominator *d, size_t searches)
{
    struct region *r = s->region;
    const int op = region_op(r, d->op);
    d->verdict = POLE_UNDECIDED;
    if (s->work <= 0)
        return;
    const long boxes = boxes_for(s, searches);
    const struct pole pole = pole_find(r, op, boxes);
    s->work -= (double)pole.draws * (DRAW + (double)r->known->shift) * (double)r->known->variables;
    d->verdict = pole.verdict;
    d->least = pole.least;
    if (pole.verdict == POLE_EXISTS) {
        d->witness = new_array(r->known->inputs, sizeof *d->witness);
        region_inputs(r, pole.witness, d->witness);
    }
    if (pole.verdict == POLE_FREE)
        r->known->value[op] = interval_meet(r->known->value[op], pole.values);
    const double bound = r->known->complete ? bound_error(r, op, boxes / 10) : INFINITY;
    d->threshold = bound < INFINITY ? bound : 0;
    free(pole.witness);
}

static void skip_statement(void *to, const char *name, long output, const char *text)
{
    (void)to;
    (void)name;
    (void)output;
    (void)text;
}

/* As the text has it; of a long expression, the statement that divides by it. */
static char *denominator_name(struct printer *r, int op, const struct statement *s)
{
    if (r->name[op] || r->width[op] <= MOST_NAME)
        return printer_text(r, op, LEVEL_SUM);
    return new_format("divisor of %s", s->name);
}

static void find_denominators(struct evidence *e, const struct genome_file *f, const struct genome *genome,
                              const struct program *p)
{
    struct printer *r = printer_new(f, genome, p, &c_double);
    const struct statement *s = p->statement;
    bool *seen = new_array(p->ops, sizeof *seen);
    size_t room = 0;
    printer_run(r, skip_statement, NULL);
    for (size_t i = 0; i < p->ops; i++) {
        const int b = p->op[i].b;
        if (p->op[i].kind != OP_DIV || p->op[b].kind == OP_CONSTANT || seen[b])
            continue;
        while (s->op < (int)i)
            s++;
        seen[b] = true;
        grow_array(&e->denominator, e->denominators, &room, sizeof *e->denominator);
        e->denominator[e->denominators++] = (struct denominator){.op = b, .name = denominator_name(r, b, s)};
    }
    printer_free(r);
    free(seen);
}

/* Worst |computed - exact| of each output at random points, with and without contraction.  A bound above the outputs
 * themselves is none. */
static void sample_errors(struct evidence *e, const struct program *p, struct region *r,
                          const struct evidence_options *o)
{
    const long most =
        o->samples < (long)(MOST_BALLS / (double)p->ops) ? o->samples : (long)(MOST_BALLS / (double)p->ops);
    long tries = most * TRIES_A_SAMPLE;
    uint64_t seed = o->seed;
    double *input = new_array(p->inputs, sizeof *input), *value = new_array(p->ops, sizeof *value);
    double *largest = new_array(p->outputs, sizeof *largest);
    arb_ptr exact = _arb_vec_init((slong)p->outputs);
    arb_t error;
    arb_init(error);
    point_constants(p, value);
    while (e->samples < most && region_draw(r, &seed, 0, &tries, input)) {
        if (!point_exact(p, input, exact))
            continue;
        e->samples++;
        for (int contract = 0; contract < 2; contract++) {
            point_double(p, input, contract ? &seed : NULL, value);
            for (size_t i = 0; i < p->outputs; i++) {
                const double computed = value[p->output[i]];
                arb_set_d(error, computed);
                arb_sub(error, error, exact + i, 64);
                const double far = isfinite(computed) ? fabs(arf_get_d(arb_midref(error), ARF_RND_NEAR)) : INFINITY;
                e->error[i].sampled = fmax(e->error[i].sampled, far);
                largest[i] = fmax(largest[i], fabs(computed));
            }
        }
    }
    for (size_t i = 0; i < p->outputs; i++)
        if (largest[i] > 0 && e->error[i].bound > largest[i])
            e->error[i].bound = INFINITY;
    arb_clear(error);
    _arb_vec_clear(exact, (slong)p->outputs);
    free(input);
    free(value);
    free(largest);
}

struct evidence *evidence_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                              const struct evidence_options *options)
{
    struct evidence *e = new_array(1, sizeof *e);
    struct region *r = region_new(f, p);
    struct search s = {.region = r, .boxes = options->boxes, .work = MOST_WORK};
    find_denominators(e, f, genome, p);
    e->region = r->known->complete;
    e->empty = region_is_empty(r, BOXES_FOR_EMPTY);
    e->outputs = p->outputs;
    e->error = new_array(p->outputs, sizeof *e->error);
    for (size_t i = 0; i < e->denominators; i++)
        find_pole(&s, &e->denominator[i], e->denominators + p->outputs - i);
    const bool bounded = e->region && evidence_pole_free(e);
    for (size_t i = 0; i < p->outputs; i++) {
        e->error[i] = (struct output_error){INFINITY, -1};
        if (bounded && s.work > 0)
            e->error[i].bound = bound_error(r, region_op(r, p->output[i]), boxes_for(&s, p->outputs - i));
    }
    if (e->region)
        sample_errors(e, p, r, options);
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

/* ---- saying ---- */

/* Three digits, rounded away from 0 (sign 1) or towards it (-1). */
static const char *rounded(double x, int sign, char text[32])
{
    mpfr_t y;
    mpfr_init2(y, 53);
    mpfr_set_d(y, x, MPFR_RNDN);
    if (sign > 0)
        mpfr_snprintf(text, 32, "%.2RUg", y);
    else
        mpfr_snprintf(text, 32, "%.2RZg", y);
    mpfr_clear(y);
    return text;
}

/* A line of the banner that goes on below where it gets long. */
struct line {
    FILE *out;
    int column;
};

static void begin_line(struct line *l, FILE *out, const char *text)
{
    l->out = out;
    l->column = fprintf(out, " *   %s", text);
}

static void add_word(struct line *l, const char *word)
{
    if (l->column + 1 + (int)strlen(word) > LINE_WIDTH)
        l->column = fprintf(l->out, "\n *    ") - 1;
    l->column += fprintf(l->out, " %s", word);
}

static void print_region(const struct genome_file *f, FILE *out)
{
    struct line l;
    char word[300];
    size_t left = 0;
    for (size_t i = 0; i < f->inputs; i++)
        left += f->range[i].given;
    begin_line(&l, out, "region:");
    for (size_t i = 0; i < f->inputs; i++) {
        if (!f->range[i].given)
            continue;
        const char *lo = f->constant[f->range[i].lo].text, *hi = f->constant[f->range[i].hi].text;
        const char *end = --left > 0 ? "," : f->requires ? "; all requires > 0" : "";
        if (strcmp(lo, hi) == 0)
            snprintf(word, sizeof word, "%s = %s%s", f->input[i], lo, end);
        else
            snprintf(word, sizeof word, "%s in [%s, %s]%s", f->input[i], lo, hi, end);
        add_word(&l, word);
    }
    fputc('\n', out);
}

/* The inputs that operation `op` depends on. */
static bool *find_inputs(const struct program *p, int op)
{
    bool *needed = new_array(p->ops, sizeof *needed);
    needed[op] = true;
    for (int i = op; i >= (int)p->inputs; i--)
        for (int k = 0; needed[i] && k < 2; k++)
            if ((k ? p->op[i].b : p->op[i].a) >= 0)
                needed[k ? p->op[i].b : p->op[i].a] = true;
    return needed;
}

static void print_witness(const struct genome_file *f, const struct program *p, const struct denominator *d,
                          struct line *l)
{
    char word[120];
    bool first = true, *needed = find_inputs(p, d->op);
    add_word(l, "a zero exists near");
    for (size_t i = 0; i < f->inputs; i++) {
        if (!needed[i] || strcmp(f->constant[f->range[i].lo].text, f->constant[f->range[i].hi].text) == 0)
            continue;
        snprintf(word, sizeof word, "%s = %.6g", f->input[i], d->witness[i]);
        if (!first)
            fputc(',', l->out);
        first = false;
        add_word(l, word);
    }
    free(needed);
}

static bool is_word(const char *text)
{
    return text[strcspn(text, " (")] == '\0';
}

static void print_denominator(const struct genome_file *f, const struct program *p, const struct denominator *d,
                              FILE *out)
{
    char word[200], number[32];
    struct line l;
    snprintf(word, sizeof word, "poles: %s:", d->name);
    begin_line(&l, out, word);
    if (d->verdict == POLE_EXISTS)
        print_witness(f, p, d, &l);
    else if (d->verdict == POLE_UNDECIDED)
        add_word(&l, "undecided");
    else {
        snprintf(word, sizeof word, "proved free of zeros, |%s| >= %s", is_word(d->name) ? d->name : "...",
                 rounded(d->least, -1, number));
        add_word(&l, word);
        if (d->threshold > 0) {
            snprintf(word, sizeof word, "(rounding error <= %s)", rounded(d->threshold, 1, number));
            add_word(&l, word);
        }
    }
    fputc('\n', out);
}

static void print_error(const struct evidence *e, size_t i, const char *name, FILE *out)
{
    char number[32];
    fprintf(out, " *   rounding error of %s: ", name);
    if (e->error[i].bound < INFINITY)
        fprintf(out, "<= %s proved (with or without FMA)", rounded(e->error[i].bound, 1, number));
    else
        fprintf(out, "no bound found");
    if (e->error[i].sampled >= 0)
        fprintf(out, ", %s worst of %ld points", rounded(e->error[i].sampled, 1, number), e->samples);
    fputc('\n', out);
}

void evidence_print(const struct evidence *e, const struct genome_file *f, const struct genome *genome,
                    const struct program *p, FILE *out)
{
    size_t proved = 0;
    if (e->region)
        print_region(f, out);
    for (size_t i = 0; i < e->denominators; i++) {
        if (i < MOST_LISTED)
            print_denominator(f, p, &e->denominator[i], out);
        else
            proved += e->denominator[i].verdict == POLE_FREE;
    }
    if (e->denominators == 0)
        fprintf(out, " *   poles: none, nothing is divided by\n");
    if (e->denominators > MOST_LISTED)
        fprintf(out, " *   poles: of %zu more denominators, %zu are proved free of zeros\n",
                e->denominators - MOST_LISTED, proved);
    if (!e->region)
        fprintf(out, " *   rounding error: no bound, as no ranges are given\n");
    for (size_t i = 0; e->region && i < e->outputs; i++)
        print_error(e, i, genome->out[i].name, out);
}

/* ---- test points ---- */

/* One row, unless an output is undefined or without a bound at the point. */
static bool print_point(const struct program *p, struct region *r, const double *input, arb_ptr exact, FILE *out)
{
    double *row = new_array(2 * p->outputs, sizeof *row);
    bool good = point_exact(p, input, exact);
    for (size_t i = 0; good && i < p->outputs; i++) {
        good = ball_nearest(exact + i, &row[i]);
        /* with the rounding of the exact result */
        row[p->outputs + i] =
            above(bound_error_at(r, region_op(r, p->output[i]), input) + above(fabs(row[i]) * 0x1p-53));
        good = good && row[p->outputs + i] < INFINITY;
    }
    if (good) {
        fputs("    {", out);
        for (size_t i = 0; i < p->inputs; i++)
            fprintf(out, "%.17g, ", input[i]);
        for (size_t i = 0; i < 2 * p->outputs; i++)
            fprintf(out, "%.17g%s", row[i], i + 1 < 2 * p->outputs ? ", " : "},\n");
    }
    free(row);
    return good;
}

int evidence_print_points(const struct genome_file *f, const struct genome *genome, const struct program *p,
                          const struct evidence *e, FILE *out)
{
    (void)genome;
    (void)e;
    struct region *r = region_new(f, p);
    double *input = new_array(p->inputs, sizeof *input);
    arb_ptr exact = _arb_vec_init((slong)p->outputs);
    long tries = (long)(MOST_BALLS / (double)r->known->program->ops);
    uint64_t seed = 1;
    int rows = 0;
    for (int i = 0; i < 4 * POINTS && rows < POINTS && region_draw(r, &seed, POINT_BITS, &tries, input); i++)
        rows += print_point(p, r, input, exact, out);
    _arb_vec_clear(exact, (slong)p->outputs);
    free(input);
    region_free(r);
    return rows;
}
