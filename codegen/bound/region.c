/* The region of a program's inputs; see region.h. */
#include "region.h"

#include "box_queue.h"
#include "enclosure.h"
#include "../program/evaluate.h"
#include "../prove/prove_points.h"

#include <stdlib.h>

/* ---- requires as a program ---- */

struct builder {
    const struct genome_file *file;
    struct program *program;
    int *symbol; /* owned: by symbol, its operation */
    int *stack;  /* owned */
    size_t depth, room;
};

static const enum op_kind kind_of[GENE_OPERATORS] = {
    [GENE_ADD] = OP_ADD, [GENE_SUB] = OP_SUB, [GENE_MUL] = OP_MUL, [GENE_DIV] = OP_DIV,   [GENE_PDIV] = OP_PDIV,
    [GENE_MIN] = OP_MIN, [GENE_MAX] = OP_MAX, [GENE_NEG] = OP_NEG, [GENE_SQRT] = OP_SQRT, [GENE_ABS] = OP_ABS,
};

static int add_op(struct program *p, struct op op)
{
    grow_array(&p->op, p->ops, &p->op_room, sizeof *p->op);
    p->op[p->ops] = op;
    return (int)p->ops++;
}

static void decimal_value(fmpq *q, const char *text)
{
    decimal_read(q, text + (*text == '-' || *text == '+'));
    if (*text == '-')
        fmpq_neg(q, q);
}

static int add_constant(struct builder *b, size_t k)
{
    struct program *p = b->program;
    grow_array(&p->constant, p->constants, &p->constant_room, sizeof *p->constant);
    fmpq_init(&p->constant[p->constants]);
    decimal_value(&p->constant[p->constants], b->file->constant[k].text);
    return add_op(p, (struct op){.kind = OP_CONSTANT, .a = -1, .b = -1, .input = (int)p->constants++});
}

static int add_expression(struct builder *b, const struct genome_expr *e)
{
    b->depth = 0;
    for (size_t i = e->length; i-- > 0;) {
        const int gene = e->gene[i], arity = gene_arity(gene);
        int op;
        if (gene < 0)
            op = add_constant(b, (size_t)(-1 - gene));
        else if (gene >= GENE_SYMBOL)
            op = b->symbol[gene - GENE_SYMBOL];
        else {
            struct op o = {.kind = kind_of[gene], .a = b->stack[--b->depth], .b = -1, .input = -1};
            if (arity == 2)
                o.b = b->stack[--b->depth];
            o.squared = o.kind == OP_MUL && o.a == o.b;
            op = add_op(b->program, o);
        }
        grow_array(&b->stack, b->depth, &b->room, sizeof *b->stack);
        b->stack[b->depth++] = op;
    }
    return b->stack[0];
}

/* first[i]: the first require that needs let i, or f->requires. */
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
            if (let >= 0 && need < first[let])
                first[let] = need;
        }
    }
    return first;
}

/* The lets that each require is the first to need stand in front of it, so that what earlier requires tell of the
 * values that these are made of comes first. */
static void add_requires(struct builder *b)
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
            b->symbol[f->inputs + (size_t)i - 1] = add_expression(b, &f->let[i - 1]);
        p->output[p->outputs++] = add_expression(b, &f->require[k]);
    }
    free(first);
    free(head);
    free(next);
}

/* Inputs and requires, which are the outputs. */
static struct program *read_requires(const struct genome_file *f)
{
    struct builder b = {.file = f, .program = new_array(1, sizeof *b.program)};
    struct program *p = b.program;
    b.symbol = new_array(f->inputs + f->lets, sizeof *b.symbol);
    p->inputs = f->inputs;
    p->output = new_array(f->requires, sizeof *p->output);
    for (size_t i = 0; i < f->inputs; i++)
        b.symbol[i] = add_op(p, (struct op){.kind = OP_INPUT, .a = -1, .b = -1, .input = (int)i});
    add_requires(&b);
    free(b.symbol);
    free(b.stack);
    return p;
}

/* Appends the operations of q behind p's; inputs are shared. */
static void append(struct program *p, const struct program *q)
{
    const int shift = (int)(p->ops - p->inputs);
    for (size_t i = q->inputs; i < q->ops; i++) {
        struct op op = q->op[i];
        op.a += op.a >= (int)p->inputs ? shift : 0;
        op.b += op.b >= (int)p->inputs ? shift : 0;
        if (op.kind == OP_CONSTANT) {
            grow_array(&p->constant, p->constants, &p->constant_room, sizeof *p->constant);
            fmpq_init(&p->constant[p->constants]);
            fmpq_set(&p->constant[p->constants], &q->constant[op.input]);
            op.input = (int)p->constants++;
        }
        add_op(p, op);
    }
}

/* ---- ranges ---- */

static void mark_inputs(const struct program *p, bool *matters)
{
    for (size_t i = 0; i < p->ops; i++)
        for (int k = 0; k < 2; k++) {
            const int operand = k ? p->op[i].b : p->op[i].a;
            if (operand >= 0 && p->op[operand].kind == OP_INPUT)
                matters[p->op[operand].input] = true;
        }
    for (size_t i = 0; i < p->outputs; i++)
        if (p->op[p->output[i]].kind == OP_INPUT)
            matters[p->op[p->output[i]].input] = true;
}

static void read_range(struct region *r, const struct genome_file *f, size_t i)
{
    const struct genome_range *range = &f->range[i];
    fmpq_init(&r->lo[i]);
    fmpq_init(&r->hi[i]);
    r->range[i] = r->doubles[i] = interval_whole();
    if (!range->given)
        return;
    decimal_value(&r->lo[i], f->constant[range->lo].text);
    decimal_value(&r->hi[i], f->constant[range->hi].text);
    r->range[i] = (struct interval){interval_around(&r->lo[i]).lo, interval_around(&r->hi[i]).hi};
    r->doubles[i] = (struct interval){double_nearest(&r->lo[i]), double_nearest(&r->hi[i])};
}

static void read_ranges(struct region *r, const struct genome_file *f, const bool *matters)
{
    r->lo = new_array(f->inputs, sizeof *r->lo);
    r->hi = new_array(f->inputs, sizeof *r->hi);
    r->range = new_array(f->inputs, sizeof *r->range);
    r->doubles = new_array(f->inputs, sizeof *r->doubles);
    r->input = new_array(f->inputs, sizeof *r->input);
    r->variable = new_array(f->inputs, sizeof *r->variable);
    r->complete = true;
    for (size_t i = 0; i < f->inputs; i++) {
        read_range(r, f, i);
        r->complete = r->complete && (f->range[i].given || !matters[i]);
        if (matters[i] && (!f->range[i].given || !fmpq_equal(&r->lo[i], &r->hi[i])))
            r->input[r->variables++] = i;
    }
    for (size_t i = 0; i < f->inputs; i++)
        r->variable[i] = r->variables;
    for (size_t k = 0; k < r->variables; k++)
        r->variable[r->input[k]] = k;
}

static struct interval known_range(const struct region *r, const struct op *op)
{
    return op->kind == OP_INPUT      ? r->range[op->input]
           : op->kind == OP_CONSTANT ? interval_around(&r->program->constant[op->input])
                                     : interval_whole();
}

/* ---- twins ---- */

/* Operations that are multiples of an earlier one, at least as far as is proved with all but certainty
 * (points_classes), with their exact ratios: those of their values at any point; or where these are too long, of their
 * residues. */
static void find_twins(struct region *r)
{
    const struct program *p = r->program;
    int divisor;
    struct points *points = points_new(p, &divisor);
    int *class = points ? points_classes(points) : NULL;
    fmpq *input = new_array(p->inputs, sizeof *input), *value = new_array(p->ops, sizeof *value);
    bool *defined = new_array(p->ops, sizeof *defined);
    uint64_t seed = 1;
    fmpq_t ratio;
    fmpq_init(ratio);
    for (size_t i = 0; i < p->inputs; i++) {
        fmpq_init(&input[i]);
        fmpq_set_si(&input[i], (slong)(random_next(&seed) % 61) - 30, 8);
    }
    for (size_t i = 0; i < p->ops; i++)
        fmpq_init(&value[i]);
    if (class)
        point_rational(p, p->ops, input, value, defined);
    for (size_t i = 0; class && i < p->ops; i++) {
        const int twin = class[i];
        if (twin < 0 || (size_t)twin >= i)
            continue;
        if (defined[i] && defined[twin]) {
            if (fmpq_is_zero(&value[i]))
                continue;
            fmpq_div(ratio, &value[i], &value[twin]);
        } else if (!points_factor(points, (int)i, twin, ratio))
            continue;
        r->ratio[i] = interval_around(ratio);
        r->twin[i] = twin;
    }
    fmpq_clear(ratio);
    for (size_t i = 0; i < p->inputs; i++)
        fmpq_clear(&input[i]);
    for (size_t i = 0; i < p->ops; i++)
        fmpq_clear(&value[i]);
    free(input);
    free(value);
    free(defined);
    free(class);
    points_free(points);
}

struct region *region_new(const struct genome_file *f, const struct program *p)
{
    struct region *r = new_array(1, sizeof *r);
    struct program *all = read_requires(f);
    bool *matters = new_array(f->inputs, sizeof *matters);
    *r = (struct region){.inputs = f->inputs, .program = all, .shift = all->ops - all->inputs};
    mark_inputs(p, matters);
    mark_inputs(all, matters);
    read_ranges(r, f, matters);
    append(all, p);
    r->known = new_array(all->ops, sizeof *r->known);
    r->twin = new_array(all->ops, sizeof *r->twin);
    r->ratio = new_array(all->ops, sizeof *r->ratio);
    for (size_t i = 0; i < all->ops; i++) {
        r->known[i] = known_range(r, &all->op[i]);
        r->twin[i] = -1;
    }
    r->length = new_array(all->ops, sizeof *r->length);
    for (size_t i = 0; i < all->inputs + r->shift; i++) {
        const struct op *op = &all->op[i];
        const size_t length = 1 + (op->a >= 0 ? r->length[op->a] : 0) + (op->b >= 0 ? r->length[op->b] : 0);
        r->length[i] = length < all->ops ? length : all->ops;
    }
    if (f->requires > 0)
        find_twins(r);
    r->required = forms_new(r, -1);
    free(matters);
    return r;
}

int region_op(const struct region *r, int op)
{
    return op < (int)r->inputs ? op : op + (int)r->shift;
}

void region_free(struct region *r)
{
    if (!r)
        return;
    for (size_t i = 0; i < r->inputs; i++) {
        fmpq_clear(&r->lo[i]);
        fmpq_clear(&r->hi[i]);
    }
    free(r->lo);
    free(r->hi);
    free(r->range);
    free(r->doubles);
    free(r->input);
    free(r->variable);
    free(r->known);
    free(r->twin);
    free(r->ratio);
    free(r->length);
    forms_free(r->required);
    program_free(r->program);
    free(r);
}

void region_box(const struct region *r, struct interval *box)
{
    for (size_t k = 0; k < r->variables; k++)
        box[k] = r->range[r->input[k]];
}

bool region_holds(struct region *r, const struct interval *box)
{
    return r->program->outputs == 0 || (forms_evaluate(r->required, box) && r->required->inside);
}

double region_width(const struct region *r, size_t variable, struct interval side)
{
    const struct interval range = r->range[r->input[variable]];
    const double width = 0.5 * side.hi - 0.5 * side.lo, whole = 0.5 * range.hi - 0.5 * range.lo;
    const double part = interval_finite(range) ? width / whole : width;
    return part > 0x1p-40 ? part : 0;
}

static size_t widest_side(const struct region *r, const struct interval *box)
{
    size_t widest = 0;
    for (size_t k = 1; k < r->variables; k++)
        if (region_width(r, k, box[k]) > region_width(r, widest, box[widest]))
            widest = k;
    return widest;
}

bool region_is_empty(struct region *r, long boxes)
{
    struct boxes waiting = {.variables = r->variables};
    struct interval *box = new_array(r->variables, sizeof *box), *part = new_array(r->variables, sizeof *part);
    region_box(r, part);
    bool empty = r->program->outputs > 0;
    if (empty && forms_evaluate_narrowed(r->required, part))
        boxes_push(&waiting, 0, part);
    for (long i = 0; empty && waiting.n > 0; i++) {
        boxes_pop(&waiting, box);
        for (size_t k = 0; k < r->variables; k++)
            part[k] = interval_point(interval_middle(box[k]));
        const size_t side = widest_side(r, box);
        empty = i < boxes && r->variables > 0 && region_width(r, side, box[side]) > 0 && !region_holds(r, part);
        for (int half = 0; half < 2 && empty; half++) {
            box_half(box, r->variables, side, half, part);
            if (forms_evaluate_narrowed(r->required, part))
                boxes_push(&waiting, 0, part);
        }
    }
    boxes_free(&waiting);
    free(box);
    free(part);
    return empty;
}

/* ---- points ---- */

void region_inputs(const struct region *r, const double *at, double *input)
{
    for (size_t i = 0; i < r->inputs; i++) {
        const struct interval range = r->doubles[i];
        const double fixed = interval_finite(range) ? range.lo : 0;
        input[i] = r->variable[i] < r->variables ? fmin(fmax(at[r->variable[i]], range.lo), range.hi) : fixed;
    }
}

/* Uniform in 0..1. */
static double draw_fraction(uint64_t *seed)
{
    return (double)(random_next(seed) >> 11) * 0x1p-53;
}

/* Uniform in the range, and random to the last bit also where that is near 0. */
static double draw_coordinate(struct interval range, uint64_t *seed, int bits)
{
    if (!interval_finite(range))
        range = (struct interval){-1, 1};
    const double half = 0.5 * range.hi - 0.5 * range.lo;
    double x = range.lo + half * (2 * draw_fraction(seed));
    x += half * (draw_fraction(seed) * 0x1p-51);
    if (bits > 0 && half > 0) {
        const double step = ldexp(1, ilogb(half) - bits);
        x = step > 0 ? nearbyint(x / step) * step : x;
    }
    return fmin(fmax(x, range.lo), range.hi);
}

bool region_draw(struct region *r, uint64_t *seed, int bits, long *tries, double *input)
{
    double *at = new_array(r->variables, sizeof *at);
    struct interval *box = new_array(r->variables, sizeof *box);
    bool found = false;
    while (!found && (*tries)-- > 0) {
        for (size_t k = 0; k < r->variables; k++) {
            at[k] = draw_coordinate(r->doubles[r->input[k]], seed, bits);
            box[k] = interval_point(at[k]);
        }
        found = region_holds(r, box);
    }
    region_inputs(r, at, input);
    free(at);
    free(box);
    return found;
}
