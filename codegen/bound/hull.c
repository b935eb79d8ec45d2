/* The hull of a program's values at points of a region; see hull.h. */
#include "hull.h"

#include "../program/evaluate.h"

#include <stdlib.h>
#include <string.h>

#define WIDER 2.0
#define CLOSER 0x1p20 /* of what chooses: points left out are one in a million */
#define PAD 1e-9      /* of what cancels: above the rounding of hulls */

static bool chooses(const struct op *op)
{
    return op->kind == OP_MIN || op->kind == OP_MAX || op->kind == OP_ABS;
}

bool hull_is_joint(const struct hull *h, int op)
{
    return h->own[op] >= 0 && h->joint[h->own[op]] >= 0;
}

const struct hull_slope *hull_slopes(const struct hull_part *part, int joint)
{
    const struct hull *h = part->hull;
    return hull_is_joint(h, joint) ? &part->slope[(size_t)h->joint[h->own[joint]] * h->program->ops] : NULL;
}

/* Inputs that are the same operation of a region block have none. */
static void find_own(struct hull *h)
{
    const size_t ops = h->region->known->program->ops;
    bool *twice = new_array(ops, sizeof *twice);
    h->own = new_array(ops, sizeof *h->own);
    for (size_t i = 0; i < ops; i++)
        h->own[i] = -1;
    for (size_t i = 0; i < h->program->ops; i++) {
        const int op = region_op(h->region, (int)i);
        twice[op] = twice[op] || h->own[op] >= 0;
        h->own[op] = twice[op] ? -1 : (int)i;
    }
    free(twice);
}

static void find_joints(struct hull *h)
{
    const struct program *p = h->program;
    bool *marked = new_array(p->ops, sizeof *marked);
    h->joint = new_array(p->ops, sizeof *h->joint);
    h->op = new_array(p->ops, sizeof *h->op);
    h->divides = new_array(p->ops, sizeof *h->divides);
    for (size_t i = p->inputs; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        marked[i] = marked[i] || h->region->known->joint[region_op(h->region, (int)i)] || chooses(op);
        if (op->kind == OP_DIV || op->kind == OP_PDIV)
            marked[op->b] = h->divides[op->b] = true;
        if (chooses(op))
            marked[op->a] = true;
        if (chooses(op) && op->b >= 0)
            marked[op->b] = true;
    }
    for (size_t i = 0; i < p->outputs; i++)
        marked[p->output[i]] = true;
    for (size_t i = 0; i < p->ops; i++) {
        const bool joint = marked[i] && i >= p->inputs && p->op[i].kind != OP_CONSTANT;
        h->joint[i] = joint ? (int)h->joints : -1;
        h->divides[i] = h->divides[i] && joint;
        if (joint)
            h->op[h->joints++] = (int)i;
    }
    free(marked);
}

/* ---- at a point ---- */

/* Derivatives of operation i, whose value is known, by its operands; false: it has none. */
static bool slopes_at(const struct program *p, const double *v, size_t i, double slope[2])
{
    const struct op *op = &p->op[i];
    const double a = op->a >= 0 ? v[op->a] : 0, b = op->b >= 0 ? v[op->b] : 0;
    slope[0] = slope[1] = 1;
    switch (op->kind) {
    case OP_CONSTANT:
    case OP_INPUT:
    case OP_ADD:
        return true;
    case OP_NEG:
        slope[0] = -1;
        return true;
    case OP_SUB:
        slope[1] = -1;
        return true;
    case OP_MUL:
        slope[0] = b;
        slope[1] = a;
        return true;
    case OP_DIV:
    case OP_PDIV:
        slope[0] = 1 / b;
        slope[1] = -v[i] / b;
        return b != 0;
    case OP_ABS:
        slope[0] = a < 0 ? -1 : 1;
        return true;
    case OP_MIN:
    case OP_MAX:
        slope[0] = (op->kind == OP_MIN) == (a < b);
        slope[1] = 1 - slope[0];
        return true;
    default: {
        const int root = op_unary(op->kind)->root;
        slope[0] = root ? v[i] / (root * a) : 0;
        return root != 0 && a != 0;
    }
    }
}

/* Backwards from operation `top` at the point whose values are h->at: derivatives h->by, sizes h->use. */
static bool sweep(struct hull *h, size_t top)
{
    const struct program *p = h->program;
    bool good = true;
    memset(h->by, 0, (top + 1) * sizeof *h->by);
    memset(h->use, 0, (top + 1) * sizeof *h->use);
    h->by[top] = h->use[top] = 1;
    for (size_t i = top + 1; i-- > 0;) {
        const struct op *op = &p->op[i];
        double slope[2];
        if (h->use[i] == 0)
            continue;
        good = good && slopes_at(p, h->at, i, slope);
        for (int k = 0; k < 2; k++) {
            const int operand = k ? op->b : op->a;
            if (operand < 0)
                continue;
            const double part = slope[k] * h->by[i];
            h->by[operand] += part;
            h->use[operand] += fabs(op->kind == OP_NEG ? h->use[i] : part);
        }
    }
    return good;
}

static bool is_product(const struct op *op)
{
    return op->kind == OP_MUL || op->kind == OP_NEG;
}

/* In units of rounding, what operation i adds at most, its value being 1, or what an input is off. */
static double own_units(const struct hull *h, size_t i)
{
    const struct arithmetic *a = &h->region->known->arithmetic;
    const enum op_kind kind = h->program->op[i].kind;
    return kind == OP_INPUT                                ? a->given / a->unit
           : kind >= OP_UNARY && kind < OP_UNARY + UNARIES ? op_unary(kind)->error
                                                           : 1;
}

/* The sum of the weights that operation `top` is made of, after its sweep. */
static double sum_weights(const struct hull *h, size_t top)
{
    double sum = 0;
    for (size_t i = 0; i <= top; i++)
        if (h->use[i] > 0)
            sum += own_units(h, i) * fabs(h->at[i]) * (is_product(&h->program->op[i]) ? h->use[i] : fabs(h->by[i]));
    return sum;
}

void hull_go(struct hull *h, const double *at)
{
    const struct program *p = h->program;
    double *input = new_array(p->inputs, sizeof *input);
    region_inputs(h->region, at, input);
    point_double(p, input, NULL, h->at);
    free(input);
}

/* ---- limits ---- */

/* Whether a number is within a limit, which it may raise. */
static bool within(double x, double *most, bool raise)
{
    if (raise && x > *most)
        *most = x;
    return x <= *most;
}

static bool values_within(const struct hull *h, struct hull_limit *limit, bool raise)
{
    bool good = true;
    for (size_t i = 0; i < h->program->ops && good; i++) {
        struct interval *value = &limit[i].value;
        const double x = h->at[i];
        if (raise)
            *value = (struct interval){lesser(value->lo, x), greater(value->hi, x)};
        good = interval_has(*value, x);
    }
    return good;
}

static bool slopes_within(struct hull *h, struct hull_slope *most, size_t top, bool raise)
{
    bool good = sweep(h, top);
    for (size_t i = 0; i < top && good; i++) {
        const double x = fabs(h->at[i]), slope = fabs(h->by[i]), size = h->use[i];
        good =
            size == 0 || (within(slope, &most[i].slope, raise) && within(size, &most[i].size, raise) &&
                          within(slope * x, &most[i].weight, raise) && within(size * x, &most[i].size_weight, raise));
    }
    h->sum[top] = good ? sum_weights(h, top) : INFINITY;
    return good;
}

static bool share_within(double sum, double size, double *least, double *share, bool raise)
{
    if (raise && size < *least)
        *least = size;
    return size >= *least && size > 0 && within(sum / size, share, raise);
}

/* After the sweeps of operation i and what it chooses from. */
static bool shares_within(const struct hull *h, struct hull_limit *limit, size_t i, bool raise)
{
    const struct op *op = &h->program->op[i];
    bool good = !h->divides[i] || share_within(h->sum[i], fabs(h->at[i]), &limit->least, &limit->share, raise);
    if (good && chooses(op)) {
        const double b = op->b >= 0 ? h->at[op->b] : 0, sum = h->sum[op->a] + (op->b >= 0 ? h->sum[op->b] : 0);
        good = share_within(sum, fabs(h->at[op->a] - b), &limit->apart, &limit->tie, raise);
    }
    return good;
}

static bool visit(struct hull *h, const struct hull_part *part, bool raise)
{
    bool good = values_within(h, part->limit, raise);
    for (size_t i = 0; i < h->program->ops; i++)
        h->sum[i] = own_units(h, i) * fabs(h->at[i]); /* of joints below */
    for (size_t k = 0; k < h->joints && good; k++) {
        const size_t top = (size_t)h->op[k];
        good = slopes_within(h, &part->slope[k * h->program->ops], top, raise) &&
               shares_within(h, &part->limit[top], top, raise);
    }
    return good;
}

bool hull_part_holds(struct hull *h, const struct hull_part *part)
{
    return visit(h, part, false);
}

bool hull_part_raise(struct hull *h, struct hull_part *part)
{
    return visit(h, part, true);
}

/* Twice as wide about its middle, but what has a sign keeps it. */
static struct interval widened(struct interval x, double pad)
{
    const double middle = 0.5 * x.lo + 0.5 * x.hi, half = WIDER * (0.5 * x.hi - 0.5 * x.lo) + pad;
    struct interval y = {middle - half, middle + half};
    if (x.lo > pad)
        y.lo = greater(y.lo, x.lo / WIDER);
    if (x.hi < -pad)
        y.hi = lesser(y.hi, x.hi / WIDER);
    return y;
}

/* Of the value of operation i, more than it is off by. */
static double value_pad(const struct hull_part *part, size_t i)
{
    const struct op *op = &part->hull->program->op[i];
    double size = interval_most(part->limit[i].value);
    if (op->kind == OP_ADD || op->kind == OP_SUB)
        size += interval_most(part->limit[op->a].value) + interval_most(part->limit[op->b].value);
    return PAD * size;
}

/* The mean of the weights of the values that a joint is made of. */
static double mean_weight(const struct hull_slope *slope, int ops)
{
    double sum = 0, n = 0;
    for (int i = 0; i < ops; i++)
        if (slope[i].size > 0) {
            sum += slope[i].weight;
            n++;
        }
    return n > 0 ? sum / n : 0;
}

/* Twice as much, or as the mean where that is more: what adds little does not tell a point from others. */
static double raised(double x, double cancels, double mean)
{
    return greater(WIDER * x + PAD * cancels, mean);
}

/* Sizes matter of what may be contracted in some uses and not in others. */
static void widen_slopes(struct hull_part *part, size_t joint)
{
    const struct program *p = part->hull->program;
    struct hull_slope *slope = &part->slope[joint * p->ops];
    const int ops = part->hull->op[joint];
    const double mean = mean_weight(slope, ops);
    for (int i = 0; i < ops; i++) {
        struct hull_slope *x = &slope[i];
        const double most = interval_most(part->limit[i].value);
        const bool product = is_product(&p->op[i]);
        x->slope = raised(x->slope, x->size, most > 0 ? mean / most : 0);
        x->weight = raised(x->weight, x->size_weight, mean);
        x->size = product ? raised(x->size, 0, x->slope) : INFINITY;
        x->size_weight = product ? raised(x->size_weight, 0, x->weight) : INFINITY;
    }
}

void hull_part_widen(struct hull_part *part)
{
    for (size_t k = 0; k < part->hull->joints; k++)
        widen_slopes(part, k);
    for (size_t i = 0; i < part->hull->program->ops; i++) {
        struct hull_limit *x = &part->limit[i];
        x->value = widened(x->value, value_pad(part, i));
        x->least /= WIDER;
        x->share *= WIDER;
        x->apart /= CLOSER;
        x->tie *= CLOSER;
    }
}

/* ---- room ---- */

struct hull_part hull_part_new(const struct hull *h)
{
    const size_t ops = h->program->ops;
    struct hull_part part = {.hull = h};
    part.limit = new_array(ops, sizeof *part.limit);
    part.slope = new_array(h->joints * ops, sizeof *part.slope);
    for (size_t i = 0; i < ops; i++)
        part.limit[i] = (struct hull_limit){.value = {INFINITY, -INFINITY}, .least = INFINITY, .apart = INFINITY};
    return part;
}

struct hull_part hull_part_copy(const struct hull_part *part)
{
    const struct hull *h = part->hull;
    const size_t ops = h->program->ops;
    struct hull_part copy = hull_part_new(h);
    memcpy(copy.limit, part->limit, ops * sizeof *copy.limit);
    memcpy(copy.slope, part->slope, h->joints * ops * sizeof *copy.slope);
    return copy;
}

void hull_part_free(struct hull_part *part)
{
    free(part->limit);
    free(part->slope);
}

struct hull *hull_of_program(const struct region *r, const struct program *p)
{
    struct hull *h = new_array(1, sizeof *h);
    *h = (struct hull){.region = r, .program = p};
    find_own(h);
    find_joints(h);
    h->at = new_array(p->ops, sizeof *h->at);
    h->by = new_array(p->ops, sizeof *h->by);
    h->use = new_array(p->ops, sizeof *h->use);
    h->sum = new_array(p->ops, sizeof *h->sum);
    point_constants(p, h->at);
    return h;
}

void hull_free(struct hull *h)
{
    if (!h)
        return;
    for (size_t k = 0; k < h->parts; k++)
        hull_part_free(&h->part[k]);
    free(h->part);
    free(h->own);
    free(h->joint);
    free(h->op);
    free(h->divides);
    free(h->at);
    free(h->by);
    free(h->use);
    free(h->sum);
    free(h);
}
