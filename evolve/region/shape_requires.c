/* Extremes of a genome file's values on samples in the position of its region block; see shape_region.h. */
#include "shape_region.h"

#include "../eval/frame.h"
#include "../eval/lines_run.h"
#include "region_values.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_MARKS = 32 };

#define LEAST_NEARNESS 1e-6 /* of the largest modulus: closer bounds gain nothing */

/* An intermediate value, or an output. */
struct value {
    const int *gene; /* not owned */
    size_t length;
    int own; /* the gene, if the value is a let */
    double lo, hi;
    double factor[MOST_MARKS], far[MOST_MARKS]; /* largest distance from factor[k] times mark k */
    size_t near; /* index of the nearest mark; s->marks if no mark bounds the value better than its size does */
};

struct shape_survey {
    struct genome_file *file; /* not owned */
    struct shape *shape;      /* owned */
    struct value *value;      /* owned */
    size_t values, value_room;
    size_t mark[MOST_MARKS]; /* symbols of the region block that values may be near to */
    size_t marks;
    double least[SHAPE_NUMBERS], most[SHAPE_NUMBERS];
    bool begun; /* samples have been added */
};

/* ---- values ---- */

/* Adds an expression; `own` is its gene if it is a let, 0 if it is an output. */
static void add_value(struct shape_survey *s, const struct genome_expr *made, int own)
{
    APPEND(s->value, s->values, s->value_room) = (struct value){
        .gene = made->gene, .length = own ? 1 : made->length, .own = own, .lo = INFINITY, .hi = -INFINITY};
}

static void find_values(struct shape_survey *s)
{
    const struct genome_file *f = s->file;
    bool *used = used_lets(f), *named = named_quotients(f, used);
    for (size_t i = 0; i < f->lets; i++)
        if (named[i])
            add_value(s, &f->let[i], GENE_SYMBOL + (int)(f->inputs + i));
    for (size_t g = 0; g < f->genomes; g++)
        for (size_t k = 0; k < f->genome[g].outs; k++)
            if (output_is_quotient(f, &f->genome[g].out[k]))
                add_value(s, &f->genome[g].out[k], 0);
    for (size_t i = 0; i < s->values; i++)
        if (s->value[i].own)
            s->value[i].gene = &s->value[i].own;
    free(used);
    free(named);
}

static void find_marks(struct shape_survey *s)
{
    const struct genome_file *r = s->file->region;
    for (size_t i = 0; i < r->inputs + r->lets && s->marks < MOST_MARKS; i++) {
        const char *name = genome_symbol_name(r, i);
        if (strcmp(name, "xi") == 0 || strcmp(name, "eta") == 0 || strncmp(name, "foot_", 5) == 0)
            s->mark[s->marks++] = i;
    }
}

/* ---- samples ---- */

/* Evaluates the region block on the shape numbers of n samples. */
static struct columns block_columns(const struct shape_survey *s, double (*number)[SHAPE_NUMBERS], size_t n)
{
    const struct genome_file *r = s->file->region;
    const size_t numbers = shape_numbers(s->shape), fixed = r->inputs - numbers;
    struct columns c = columns_new(n, r->inputs + r->lets);
    for (size_t j = 0; j < r->inputs; j++)
        for (size_t i = 0; i < n; i++)
            columns_at(&c, j)[i] = j < fixed ? r->constant[r->range[j].lo].value : number[i][j - fixed];
    for (size_t j = 0; j < r->lets; j++) {
        table_values(&c, r->constant, r->let[j].gene, r->let[j].length, columns_at(&c, r->inputs + j));
    }
    return c;
}

/* Returns the factor, a power of 2 times a power of 3, that brings the mark nearest to the value. */
static double find_factor(const double *x, const double *mark, size_t n)
{
    double xm = 0, mm = 0, best = 1, least = INFINITY;
    for (size_t i = 0; i < n; i++) {
        xm += x[i] * mark[i];
        mm += mark[i] * mark[i];
    }
    static const double powers[] = {1, 3, 9, 81, 1.0 / 9, 1.0 / 81};
    for (size_t k = 0; k < sizeof powers / sizeof *powers && xm / mm != 0 && isfinite(xm / mm); k++) {
        const double threes = powers[k], twos = log2(fabs(xm / mm) / threes), off = fabs(twos - round(twos));
        if (off < 0.5 * least) { /* prefers few threes */
            best = copysign(threes * exp2(round(twos)), xm);
            least = off;
        }
    }
    return best;
}

static void take_in(struct shape_survey *s, struct value *v, const double *x, const struct columns *block)
{
    extend_range(x, block->n, &v->lo, &v->hi);
    for (size_t k = 0; k < s->marks; k++) {
        const double *mark = columns_at(block, s->mark[k]);
        if (!s->begun)
            v->factor[k] = find_factor(x, mark, block->n);
        v->far[k] = farthest(x, mark, v->factor[k], block->n, v->far[k]);
    }
}

/* Evaluates the file's values on n samples in the position of the region block, and the block's own values. */
static struct columns place(struct shape_survey *s, const struct sample *sample, size_t n, struct columns *block)
{
    struct sample *placed = new_array(n, sizeof *placed);
    double(*number)[SHAPE_NUMBERS] = new_array(n, sizeof *number);
    for (size_t i = 0; i < n; i++) {
        shape_measure(s->shape, &sample[i], number[i], &placed[i]);
        for (size_t k = 0; k < shape_numbers(s->shape); k++) {
            s->least[k] = fmin(s->least[k], number[i][k]);
            s->most[k] = fmax(s->most[k], number[i][k]);
        }
    }
    *block = block_columns(s, number, n);
    struct columns table = frame_columns(s->file, placed, n);
    free(placed);
    free(number);
    return table;
}

void shape_survey_take(struct shape_survey *s, const struct sample *sample, size_t n)
{
    struct columns block, table = place(s, sample, n, &block);
    double *x = new_array(n, sizeof *x);
    for (size_t i = 0; i < s->values; i++) {
        struct value *v = &s->value[i];
        table_values(&table, s->file->constant, v->gene, v->length, x);
        take_in(s, v, x, &block);
    }
    s->begun = true;
    columns_free(&table);
    columns_free(&block);
    free(x);
}

static void find_nearest(struct shape_survey *s)
{
    for (size_t i = 0; i < s->values; i++) {
        struct value *v = &s->value[i];
        v->near = 0;
        for (size_t k = 1; k < s->marks; k++)
            v->near = v->far[k] < v->far[v->near] ? k : v->near;
        if (!(v->far[v->near] < 0.5 * fmax(-v->lo, v->hi)))
            v->near = s->marks;
    }
}

/* ---- ranges and requires ---- */

/* Adds the ranges of the shape numbers; numbers that vary only by rounding are 0. */
static void add_ranges(const struct shape_survey *s)
{
    struct genome_file *r = s->file->region;
    const size_t numbers = shape_numbers(s->shape);
    for (size_t k = 0; k < numbers; k++) {
        const bool none = fmax(-s->least[k], s->most[k]) < 1e-9;
        if (s->least[k] <= s->most[k])
            add_range(r, r->inputs - numbers + k, none ? 0 : s->least[k], none ? 0 : s->most[k]);
    }
}

/* Requires |value - factor mark| < most. */
static void require_near(struct genome_file *f, const struct value *v, double factor, size_t mark, double most)
{
    int *gene = new_array(v->length + 4, sizeof *gene);
    size_t n = 0;
    gene[n++] = GENE_SUB;
    memcpy(gene + n, v->gene, v->length * sizeof *gene);
    n += v->length;
    if (factor != 1) {
        char text[40];
        snprintf(text, sizeof text, "%.17g", factor);
        gene[n++] = GENE_MUL;
        gene[n++] = -1 - (int)genome_add_constant(f, text);
    }
    gene[n++] = GENE_LOCAL + (int)mark;
    require_magnitude(f, gene, n, most);
    free(gene);
}

static void require_value(const struct shape_survey *s, const struct value *v)
{
    const double most = fmax(-v->lo, v->hi);
    if (!(most > 0 && isfinite(most)))
        return;
    if (v->near < s->marks)
        require_near(s->file, v, v->factor[v->near], s->mark[v->near],
                     2 * fmax(v->far[v->near], LEAST_NEARNESS * most));
    else
        require_magnitude(s->file, v->gene, v->length, 2 * most);
    if (v->lo > 0 || v->hi < 0)
        require_sign(s->file, v->gene, v->length, 0.5 * (v->lo > 0 ? v->lo : v->hi));
}

struct shape_survey *shape_survey_new(struct genome_file *f)
{
    struct shape *shape = shape_new(f->segment);
    if (!shape)
        return NULL;
    struct shape_survey *s = new_array(1, sizeof *s);
    *s = (struct shape_survey){.file = f, .shape = shape};
    f->region = shape_region(s->shape);
    find_marks(s);
    find_values(s);
    for (size_t k = 0; k < SHAPE_NUMBERS; k++)
        s->most[k] = -(s->least[k] = INFINITY);
    return s;
}

void shape_survey_add(struct shape_survey *s)
{
    find_nearest(s);
    add_ranges(s);
    for (size_t i = 0; i < s->values; i++)
        require_value(s, &s->value[i]);
    free(s->shape);
    free(s->value);
    free(s);
}
