/* The hull of a program's values at points of a region; see hull.h. */
#include "hull.h"

#include "../program/evaluate.h"

#include <stdlib.h>
#include <string.h>

#define WIDER 2.0
#define CLOSER 0x1p8 /* of what chooses: points left out are one in a million */
#define DECIDED 0.25 /* but errors are less than that of the distance, if they are at the points */
#define PAD 1e-9     /* of what cancels: above the rounding of hulls */

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

/* Derivatives by the uses of an operand of operation i, where those of i are by[i] and in span[i].  A product is contracted by sums
 * alone, in any of them; so it is through a sign. */
static struct interval span_of_use(const struct hull *h, size_t i, double part)
{
    const enum op_kind kind = h->program->op[i].kind;
    if (kind == OP_NEG)
        return interval_negative(h->span[i]);
    if (kind == OP_ADD || kind == OP_SUB)
        return (struct interval){lesser(part, 0), greater(part, 0)};
    return interval_point(part);
}

/* What has no error at the point moves nothing. */
static bool moves(const struct hull *h, size_t i)
{
    return !h->exact[i] && !interval_is_zero(h->span[i]);
}

/* Backwards from operation `top` at the point whose values are h->at. */
static bool sweep(struct hull *h, size_t top)
{
    const struct program *p = h->program;
    bool good = true;
    memset(h->by, 0, (top + 1) * sizeof *h->by);
    memset(h->span, 0, (top + 1) * sizeof *h->span);
    h->by[top] = 1;
    h->span[top] = interval_point(1);
    for (size_t i = top + 1; i-- > 0;) {
        const struct op *op = &p->op[i];
        double slope[2];
        if (!moves(h, i))
            continue;
        good = good && slopes_at(p, h->at, i, slope);
        for (int k = 0; k < 2; k++) {
            const int operand = k ? op->b : op->a;
            if (operand < 0)
                continue;
            const double part = slope[k] * h->by[i];
            const struct interval span = span_of_use(h, i, part);
            h->by[operand] += part;
            h->span[operand].lo += span.lo;
            h->span[operand].hi += span.hi;
        }
    }
    return good;
}

static bool is_product(const struct op *op)
{
    return op->kind == OP_MUL || op->kind == OP_NEG;
}

static bool is_power_of_two(double x)
{
    int exponent;
    return fabs(frexp(x, &exponent)) == 0.5;
}

/* What operation i adds at the point, in units of rounding, its value being 1. */
static double units_at(const struct hull *h, size_t i)
{
    const struct op *op = &h->program->op[i];
    const bool twice = op->kind == OP_MUL && ((h->exact[op->a] && is_power_of_two(h->at[op->a])) ||
                                              (h->exact[op->b] && is_power_of_two(h->at[op->b])));
    return h->exact[i] || twice ? 0 : h->units[i];
}

/* Derivative of operation `top` by a constant i, and, where it is the first one, by all that are the same and are off by the
 * same, which are passed before it. */
static double pool(struct hull *h, size_t i)
{
    const size_t first = (size_t)h->same[i];
    const double by = h->by[i] + h->pooled[i];
    if (first == i) {
        h->pooled[i] = 0;
        return by;
    }
    h->pooled[first] += h->at[first] == h->at[i] ? h->by[i] : -h->by[i];
    return 0;
}

/* The sum of the weights that operation `top` is made of, after its sweep. */
static double sum_weights(struct hull *h, size_t top)
{
    double sum = 0;
    for (size_t i = top + 1; i-- > 0;) {
        const struct op *op = &h->program->op[i];
        if (op->kind == OP_CONSTANT && h->units[i] > 0)
            sum += h->units[i] * fabs(h->at[i] * pool(h, i));
        else if (moves(h, i))
            sum += units_at(h, i) * fabs(h->at[i]) * (is_product(op) ? interval_most(h->span[i]) : fabs(h->by[i]));
    }
    return sum;
}

/* Constants, and what is made of them where they are chosen. */
static bool is_exact(const struct hull *h, size_t i)
{
    const struct op *op = &h->program->op[i];
    const struct arithmetic *a = &h->region->known->arithmetic;
    const bool *x = h->exact;
    const double *v = h->at;
    switch (op->kind) {
    case OP_CONSTANT:
        return h->units[i] == 0;
    case OP_NEG:
    case OP_ABS:
        return x[op->a];
    case OP_MIN:
        return v[op->a] < v[op->b] ? x[op->a] : x[op->b];
    case OP_MAX:
        return v[op->a] > v[op->b] ? x[op->a] : x[op->b];
    case OP_ADD:
    case OP_SUB:
        return x[op->a] && x[op->b] && result_is_exact(a, op->kind, v[op->a], v[op->b]);
    case OP_MUL:
        return (x[op->a] && v[op->a] == 0) || (x[op->b] && v[op->b] == 0) ||
               (x[op->a] && x[op->b] && result_is_exact(a, op->kind, v[op->a], v[op->b]));
    default:
        return false;
    }
}

void hull_go(struct hull *h, const double *at)
{
    const struct program *p = h->program;
    double *input = new_array(p->inputs, sizeof *input);
    region_inputs(h->region, at, input);
    point_double(p, input, NULL, h->at);
    for (size_t i = 0; i < p->ops; i++)
        h->exact[i] = is_exact(h, i);
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

static struct hull_slope slope_at(const struct hull *h, size_t i)
{
    const double x = fabs(h->at[i]), slope = fabs(h->by[i]), size = interval_most(h->span[i]);
    return (struct hull_slope){slope, slope * x, size, size * x};
}

static bool slopes_within(struct hull *h, struct hull_slope *most, size_t top, bool raise)
{
    bool good = sweep(h, top);
    for (size_t i = 0; i < top && good; i++) {
        if (!moves(h, i))
            continue;
        const struct hull_slope x = slope_at(h, i);
        if (raise)
            most[i] = (struct hull_slope){greater(x.slope, most[i].slope), greater(x.weight, most[i].weight),
                                          greater(x.size, most[i].size), greater(x.size_weight, most[i].size_weight)};
        good = x.slope <= most[i].slope && x.weight <= most[i].weight && x.size <= most[i].size &&
               x.size_weight <= most[i].size_weight;
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
        h->sum[i] = units_at(h, i) * fabs(h->at[i]); /* of joints below */
    for (size_t k = 0; k < h->joints && good; k++) {
        const size_t top = (size_t)h->op[k];
        good = slopes_within(h, &part->slope[k * h->program->ops], top, raise) &&
               within(h->sum[top], &part->limit[top].sum, raise) && shares_within(h, &part->limit[top], top, raise);
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
    return PAD * size + part->hull->region->known->arithmetic.least;
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
    const double unit = part->hull->region->known->arithmetic.unit;
    for (size_t k = 0; k < part->hull->joints; k++)
        widen_slopes(part, k);
    for (size_t i = 0; i < part->hull->program->ops; i++) {
        struct hull_limit *x = &part->limit[i];
        x->value = widened(x->value, value_pad(part, i));
        x->least /= WIDER;
        x->share *= WIDER;
        x->sum *= WIDER;
        x->apart /= CLOSER;
        x->tie = greater(WIDER * x->tie, lesser(CLOSER * x->tie, DECIDED / unit));
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

/* In units of rounding, what an operation adds at most, its value being 1, or what an input or constant is off. */
static double own_units(const struct hull *h, const struct op *op)
{
    const struct arithmetic *a = &h->region->known->arithmetic;
    switch (op->kind) {
    case OP_CONSTANT: {
        const double error = constant_error(a, h->program, op);
        return error > 0 ? error / (a->unit * fabs(fmpq_get_d(h->program->constant + op->input))) : 0;
    }
    case OP_INPUT:
        return a->given / a->unit;
    case OP_NEG:
    case OP_MIN:
    case OP_MAX:
        return 0;
    default:
        return op->kind >= OP_UNARY ? op_unary(op->kind)->error : 1;
    }
}

static bool is_same(const struct program *p, const struct op *a, const struct op *b)
{
    const fmpq *x = p->constant + a->input, *y = p->constant + b->input;
    return b->kind == OP_CONSTANT && a->quotient == b->quotient && fmpz_cmpabs(fmpq_numref(x), fmpq_numref(y)) == 0 &&
           fmpz_equal(fmpq_denref(x), fmpq_denref(y));
}

static void find_same(struct hull *h)
{
    const struct program *p = h->program;
    h->same = new_array(p->ops, sizeof *h->same);
    h->pooled = new_array(p->ops, sizeof *h->pooled);
    for (size_t i = 0; i < p->ops; i++) {
        size_t k = p->op[i].kind == OP_CONSTANT ? 0 : i;
        while (k < i && !is_same(p, &p->op[i], &p->op[k]))
            k++;
        h->same[i] = (int)k;
    }
}

struct hull *hull_of_program(const struct region *r, const struct program *p)
{
    struct hull *h = new_array(1, sizeof *h);
    *h = (struct hull){.region = r, .program = p};
    find_own(h);
    find_joints(h);
    h->at = new_array(p->ops, sizeof *h->at);
    h->by = new_array(p->ops, sizeof *h->by);
    h->sum = new_array(p->ops, sizeof *h->sum);
    h->span = new_array(p->ops, sizeof *h->span);
    h->exact = new_array(p->ops, sizeof *h->exact);
    h->units = new_array(p->ops, sizeof *h->units);
    for (size_t i = 0; i < p->ops; i++)
        h->units[i] = own_units(h, &p->op[i]);
    find_same(h);
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
    free(h->sum);
    free(h->span);
    free(h->exact);
    free(h->units);
    free(h->same);
    free(h->pooled);
    free(h);
}
