/* Facts known about a program's values before a search; see known.h. */
#include "known.h"

#include "../graph/constant_text.h"
#include "../program/evaluate.h"
#include "../program/genome_program.h"
#include "../prove/prove_points.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

const struct arithmetic arithmetic_double = {0x1p-53, 0x1p-1074, DBL_MAX, 0};
const struct arithmetic arithmetic_single = {0x1p-24, 0x1p-149, FLT_MAX, 0};
const struct arithmetic arithmetic_single_scaled = {0x1p-24, 0x1p-149, FLT_MAX,
                                                    0x1.001p-23}; /* a difference, a product */

double constant_error(const struct arithmetic *a, const struct program *p, const struct op *o)
{
    double error;
    const double x = point_constant(p, o, &error);
    if (a->unit == arithmetic_double.unit || (error == 0 && (double)(float)x == x))
        return error;
    return error + a->unit * (fabs(x) * (1 + 0x1p-20)) + a->least;
}

bool result_is_exact(const struct arithmetic *a, enum op_kind kind, double x, double y)
{
    const double other = kind == OP_SUB ? -y : y, z = kind == OP_MUL ? x * y : x + other;
    return (kind == OP_MUL ? product_is_exact(x, y, z) : sum_is_exact(x, other, z)) &&
           (a->unit == arithmetic_double.unit || (double)(float)z == z);
}

/* ---- requires as a program ---- */

/* Returns first[i]: the first require that needs let i, or f->requires. The caller frees it. */
static size_t *first_needs(const struct genome_file *f)
{
    size_t *first = new_array(f->lets, sizeof *first);
    for (size_t i = 0; i < f->lets; i++)
    first[i] = f->requires;
    for (size_t k = f->lets + f->requires; k-- > 0;) {
        const struct genome_expr *e = k < f->lets ? &f->let[k] : &f->require[k - f->lets];
        const size_t need = k < f->lets ? first[k] : k - f->lets;
        for (size_t i = 0; i < e->length; i++) {
            const int let = e->gene[i] - GENE_SYMBOL - (int)f->inputs;
            if (let >= 0 && let < (int)f->lets && need < first[let])
                first[let] = need;
        }
    }
    return first;
}

static bool speaks_of_shapes(const struct genome_expr *e)
{
    for (size_t i = 0; i < e->length; i++)
        if (e->gene[i] >= GENE_LOCAL)
            return true;
    return false;
}

/* Adds the requires, each preceded by the lets that it is the first to need, so that earlier requires can narrow the
 * values used in these lets. */
static void add_requires(struct genome_program *b)
{
    const struct genome_file *f = b->file;
    struct program *p = b->program;
    size_t *first = first_needs(f);
    int *head = new_array(f->requires, sizeof *head), *next = new_array(f->lets, sizeof *next); /* lists, 1 + let */
    for (size_t i = f->lets; i-- > 0;)
        if (first[i] < f->requires) {
            next[i] = head[first[i]];
            head[first[i]] = 1 + (int)i;
        }
    for (size_t k = 0; k < f->requires; k++) {
        for (int i = head[k]; i > 0; i = next[i - 1])
            b->symbol[f->inputs + (size_t)i - 1] = genome_program_add(b, &f->let[i - 1]);
        if (b->shape || !speaks_of_shapes(&f->require[k]))
            p->output[p->outputs++] = genome_program_add(b, &f->require[k]);
    }
    free(first);
    free(head);
    free(next);
}

/* Reads inputs and requires; the requires are the outputs. */
static struct program *read_requires(const struct genome_file *f)
{
    struct genome_program b = genome_program_start(f, f->requires);
    add_requires(&b);
    return genome_program_end(&b);
}

/* Starts the region's program. Its inputs that do not vary become numbers, so that values are known to be equal that
 * are equal only for these. */
static struct genome_program start_region(const struct genome_file *region, size_t outputs)
{
    struct genome_program b = genome_program_start(region, outputs);
    fmpq_t lo, hi;
    fmpq_init(lo);
    fmpq_init(hi);
    for (size_t i = 0; i < region->inputs; i++) {
        const struct genome_range *range = &region->range[i];
        if (!range->given)
            continue;
        constant_read(lo, region->constant[range->lo].text);
        constant_read(hi, region->constant[range->hi].text);
        if (fmpq_equal(lo, hi))
            b.symbol[i] = program_add_constant(b.program, lo, false);
    }
    fmpq_clear(lo);
    fmpq_clear(hi);
    return b;
}

/* Reads the file's inputs as values of its region block, and the places of the block's symbols. */
static struct program *read_places(const struct genome_file *f, int *symbol)
{
    const struct genome_file *region = f->region;
    struct genome_program b = start_region(region, f->inputs);
    for (size_t i = 0; i < region->lets; i++)
        b.symbol[region->inputs + i] = genome_program_add(&b, &region->let[i]);
    for (size_t i = 0; i < f->inputs; i++)
        b.program->output[b.program->outputs++] = b.symbol[genome_region_symbol(f, i)];
    memcpy(symbol, b.symbol, (region->inputs + region->lets) * sizeof *symbol);
    return genome_program_end(&b);
}

/* Reads the region block's inputs, its requires and the file's. */
static struct program *read_shapes(struct known *x, const struct genome_file *f, int *shape)
{
    const struct genome_file *region = f->region;
    struct genome_program a = start_region(region, region->requires + f->requires);
    struct genome_program b = genome_program_start(f, 0);
    add_requires(&a);
    const int shift = program_append(a.program, x->place, NULL);
    for (size_t i = 0; i < f->inputs; i++) {
        const int op = x->place->output[i];
        b.symbol[i] = x->placed[i] = op < (int)region->inputs ? op : op + shift;
    }
    for (size_t i = 0; i < region->inputs + region->lets; i++)
        shape[i] += shape[i] < (int)region->inputs ? 0 : shift;
    x->shapes = a.program->ops;
    program_free(b.program);
    b.program = a.program;
    b.shape = shape;
    add_requires(&b);
    free(a.symbol);
    return genome_program_end(&b);
}

/* ---- ranges ---- */

static void read_range(struct known *x, const struct genome_file *f, size_t i)
{
    const struct genome_range *range = &f->range[i];
    x->range[i] = interval_whole();
    if (!range->given)
        return;
    constant_read(&x->lo[i], f->constant[range->lo].text);
    constant_read(&x->hi[i], f->constant[range->hi].text);
    x->range[i] = (struct interval){interval_around(&x->lo[i]).lo, interval_around(&x->hi[i]).hi};
}

static void read_ranges(struct known *x, const struct genome_file *f, const bool *matters)
{
    x->lo = _fmpq_vec_init((slong)f->inputs);
    x->hi = _fmpq_vec_init((slong)f->inputs);
    x->range = arena_array(&x->arena, f->inputs, sizeof *x->range);
    x->input = arena_array(&x->arena, f->inputs, sizeof *x->input);
    x->variable = arena_array(&x->arena, f->inputs, sizeof *x->variable);
    x->complete = true;
    for (size_t i = 0; i < f->inputs; i++) {
        read_range(x, f, i);
        x->complete = x->complete && (f->range[i].given || !matters[i]);
        if (matters[i] && (!f->range[i].given || !fmpq_equal(&x->lo[i], &x->hi[i])))
            x->input[x->variables++] = i;
    }
    for (size_t i = 0; i < f->inputs; i++)
        x->variable[i] = x->variables;
    for (size_t k = 0; k < x->variables; k++)
        x->variable[x->input[k]] = k;
}

static struct interval given_range(const struct known *x, const struct op *op)
{
    return op->kind == OP_INPUT      ? x->range[op->input]
           : op->kind == OP_CONSTANT ? interval_around(&x->program->constant[op->input])
                                     : interval_whole();
}

/* ---- twins ---- */

/* Finds operations that are multiples of an earlier operation, proved up to a negligible chance (points_classes), with
 * exact ratios: of their values at a point or, if these are too long, of their residues. */
static void find_twins(struct known *x)
{
    const struct program *p = x->program;
    int divisor;
    struct points *points = points_new(p, &divisor);
    int *class = points ? points_classes(points) : NULL;
    fmpq *input = _fmpq_vec_init((slong)p->inputs), *value = _fmpq_vec_init((slong)p->ops);
    bool *defined = new_array(p->ops, sizeof *defined);
    uint64_t seed = 1;
    fmpq_t ratio;
    fmpq_init(ratio);
    for (size_t i = 0; i < p->inputs; i++)
        fmpq_set_si(&input[i], (slong)(random_next(&seed) % 61) - 30, 8);
    if (class)
        point_rational(p, p->ops, input, value, defined);
    for (size_t i = 0; class && i < p->ops; i++) {
        const int twin = class[i];
        if (twin < 0 && defined[i]) /* a number, constant everywhere */
            x->value[i] = interval_around(&value[i]);
        if (twin < 0 || (size_t)twin >= i)
            continue;
        if (defined[i] && defined[twin]) {
            if (fmpq_is_zero(&value[i]))
                continue;
            fmpq_div(ratio, &value[i], &value[twin]);
        } else if (!points_factor(points, (int)i, twin, ratio))
            continue;
        x->ratio[i] = interval_around(ratio);
        x->twin[i] = twin;
    }
    fmpq_clear(ratio);
    _fmpq_vec_clear(input, (slong)p->inputs);
    _fmpq_vec_clear(value, (slong)p->ops);
    free(defined);
    free(class);
    points_free(points);
}

static int value_of(const struct known *x, int op)
{
    return op >= 0 && x->twin[op] >= 0 ? x->twin[op] : op;
}

int known_op(const struct known *x, int op)
{
    return op < (int)x->places ? x->placed[op] : op + (int)x->first - (int)x->places;
}

struct known *known_new(const struct genome_file *f, const struct program *p, bool shapes)
{
    struct known *x = new_array(1, sizeof *x);
    const struct genome_file *varies = shapes && f->region ? f->region : f;
    *x = (struct known){.arithmetic = arithmetic_double, .inputs = varies->inputs, .places = f->inputs};
    x->placed = arena_array(&x->arena, f->inputs, sizeof *x->placed);
    for (size_t i = 0; i < f->inputs; i++)
        x->placed[i] = (int)i;
    int *shape = varies != f ? new_array(varies->inputs + varies->lets, sizeof *shape) : NULL;
    if (shape)
        x->place = read_places(f, shape);
    struct program *all = shape ? read_shapes(x, f, shape) : read_requires(f);
    free(shape);
    bool *matters = program_reads(all), *reads = program_reads(p);
    x->program = all;
    for (size_t i = 0; i < p->inputs; i++) /* also inputs that are inputs of the region's block */
        if (reads[i] && x->placed[i] < (int)varies->inputs)
            matters[x->placed[i]] = true;
    free(reads);
    read_ranges(x, varies, matters);
    x->first = all->ops;
    program_append(all, p, x->placed);
    x->value = arena_array(&x->arena, all->ops, sizeof *x->value);
    x->twin = arena_array(&x->arena, all->ops, sizeof *x->twin);
    x->ratio = arena_array(&x->arena, all->ops, sizeof *x->ratio);
    for (size_t i = 0; i < all->ops; i++) {
        x->value[i] = given_range(x, &all->op[i]);
        x->twin[i] = -1;
    }
    x->joint = arena_array(&x->arena, all->ops, sizeof *x->joint);
    for (size_t i = 0; i < p->statements; i++)
        x->joint[known_op(x, p->statement[i].op)] = true;
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_DIV || p->op[i].kind == OP_PDIV)
            x->joint[known_op(x, p->op[i].b)] = true;
    x->length = arena_array(&x->arena, all->ops, sizeof *x->length);
    for (size_t i = 0; i < x->first; i++) {
        const struct op *op = &all->op[i];
        const size_t length = 1 + (op->a >= 0 ? x->length[op->a] : 0) + (op->b >= 0 ? x->length[op->b] : 0);
        x->length[i] = length < all->ops ? length : all->ops;
    }
    if (all->outputs > 0 || x->place)
        find_twins(x);
    free(matters);
    return x;
}

bool known_requires(const struct known *x, int op)
{
    const struct program *p = x->program;
    bool required = false, *made = new_array(p->ops, sizeof *made); /* a require depends on it */
    for (size_t i = 0; i < p->outputs; i++) {
        made[p->output[i]] = true;
        required = required || value_of(x, p->output[i]) == value_of(x, op);
    }
    for (int i = (int)x->first - 1; i >= 0 && !required; i--) {
        const struct op *o = &p->op[i];
        required = made[i] && o->kind == OP_DIV && value_of(x, o->b) == value_of(x, op);
        for (int k = 0; made[i] && k < 2; k++)
            if ((k ? o->b : o->a) >= 0)
                made[k ? o->b : o->a] = true;
    }
    free(made);
    return required;
}

void known_free(struct known *x)
{
    if (!x)
        return;
    _fmpq_vec_clear(x->lo, (slong)x->inputs);
    _fmpq_vec_clear(x->hi, (slong)x->inputs);
    program_free(x->program);
    program_free(x->place);
    arena_free(&x->arena);
    free(x);
}
