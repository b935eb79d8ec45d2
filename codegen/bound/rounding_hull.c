/* Rounding errors on a hull; see rounding.h.
 *
 * Derivatives are limited at the exact values.  How far those at values between these and the computed ones are from them: with
 * A and A' the derivatives of all operations by their operands at either, and T = 1/(1 - A) and T' those of all values by all
 * others,
 *     T' - T = T' (A' - A) T.
 * What T' (A' - A) of the result is, as far as no joint is between (`pushed`), is summed up at joints, whose T is limited: so
 * it does not grow with every value on the way, as sums of sizes would. */
#include "rounding.h"

#define PAD 0x1p-10 /* above the rounding of sums */

void rounding_begin_on_hull(struct rounding *e)
{
    e->rest = new_array(e->forms->known->program->ops, sizeof *e->rest);
    e->source = new_array(e->hull->joints, sizeof *e->source);
    e->reach = new_array(e->hull->program->ops * e->hull->joints, sizeof *e->reach);
}

void rounding_enter(struct rounding *e, const struct hull_part *part)
{
    const struct program *p = e->hull->program;
    const size_t joints = e->hull->joints;
    e->part = part;
    e->limited = true;
    for (size_t i = 0; i < p->ops; i++) {
        const bool product = p->op[i].kind == OP_MUL || p->op[i].kind == OP_NEG;
        for (size_t k = 0; k < joints; k++) {
            const struct hull_slope *x = &part->slope[k * p->ops + i];
            e->reach[i * joints + k] = product ? x->size : x->slope;
        }
    }
}

/* Above the sum of products of numbers >= 0. */
static double sum_of_products(const double *a, const double *b, size_t n)
{
    double part[4] = {0}, all = 0;
    size_t k = 0;
    for (; k + 4 <= n; k += 4)
        for (size_t l = 0; l < 4; l++)
            part[l] += a[k + l] * b[k + l];
    for (; k < n; k++)
        part[0] += a[k] * b[k];
    const double sum = (part[0] + part[1] + (part[2] + part[3])) * (1 + PAD) + DBL_MIN;
    if (sum == sum)
        return sum;
    for (k = 0; k < n; k++)
        all = above(all + rounding_product(a[k], b[k]));
    return all;
}

/* Joints are passed from the last to the first. */
static void begin_drift(struct rounding *e, size_t joint, double size)
{
    if (e->sources == 0)
        e->first_source = joint + 1;
    while (e->first_source > joint) {
        e->source[--e->first_source] = 0;
        e->sources++;
    }
    e->source[joint] = size;
}

static void find_drift(struct rounding *e, int i, int own)
{
    const struct hull *h = e->hull;
    struct sensitivity *by = &e->by[i];
    if (e->sources > 0) {
        const size_t first = e->first_source;
        const double drift =
            own < 0 ? INFINITY
                    : sum_of_products(e->source + first, e->reach + (size_t)own * h->joints + first, e->sources);
        by->drift = above(by->drift + drift);
    }
    if (hull_is_joint(h, i) && by->pushed > 0) {
        begin_drift(e, (size_t)h->joint[own], by->pushed);
        by->pushed = 0;
    }
}

void rounding_limit_by_hull(struct rounding *e, int result, int i)
{
    const int own = e->hull->own[i];
    const struct hull_slope *most = hull_slopes(e->part, result);
    struct sensitivity *by = &e->by[i];
    find_drift(e, i, own);
    if (!most || own < 0) {
        by->more = INFINITY;
        return;
    }
    most += own;
    const double value = above(interval_most(e->forms->range[i]) + e->error[i]);
    const double slope = above(most->slope + by->drift), size = above(most->size + by->drift);
    /* (slope + drift) (value + error) */
    by->more = above(rounding_product(most->size < INFINITY ? most->size : most->slope, e->error[i]) +
                     rounding_product(by->drift, value));
    const double weight = above(most->weight + by->more);
    by->slope = interval_meet(by->slope, (struct interval){-slope, slope});
    by->weight = interval_meet(by->weight, (struct interval){-weight, weight});
    by->slope_span = interval_meet(by->slope_span, (struct interval){-size, size});
    const double size_weight = above(most->size_weight + by->more);
    by->weight_span = interval_meet(by->weight_span, (struct interval){-size_weight, size_weight});
}

double rounding_rest(struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const struct sensitivity *by = &e->by[i];
    const double size = greater(0, interval_most(kind == OP_MUL ? by->slope_span : by->slope));
    double constant;
    if (rounding_is_given(e->forms->known, i))
        return rounding_product(e->arithmetic.given, by->more);
    if (kind == OP_CONSTANT)
        return rounding_product(e->constant[i], above(by->more / interval_least(e->forms->range[i])));
    const double unit = rounding_own_share(e, i, &constant);
    return rounding_product(unit, above(by->more + 2 * rounding_product(e->error[i], size))) +
           rounding_product(constant, size);
}

/* The share is of the exact weights. */
double rounding_end_on_hull(struct rounding *e, int joint, double rest)
{
    const struct hull *h = e->hull;
    const int own = h->own[joint];
    e->rest[joint] = rest;
    if (!hull_is_joint(h, joint))
        return INFINITY;
    const double sum = e->arithmetic.unit * e->part->limit[own].sum * (1 + PAD);
    if (!h->divides[own])
        return rounding_checked(e, sum + rest, 0);
    const double share = e->arithmetic.unit * e->part->limit[own].share * (1 + PAD);
    const double relative = rounding_checked(e, share + rest / e->part->limit[own].least, 0);
    const double most = interval_most(e->forms->range[joint]);
    if (rounding_checked(e, relative * most, most) < INFINITY) /* or it may overflow */
        e->relative[joint] = lesser(e->relative[joint], relative);
    return rounding_checked(e, sum + rest, 0);
}

static double rest_of(const struct rounding *e, int op)
{
    if (op < 0 || e->error[op] == 0 || rounding_is_given(e->forms->known, op))
        return 0;
    if (e->forms->known->program->op[op].kind == OP_CONSTANT)
        return 0;
    return hull_is_joint(e->hull, op) ? e->rest[op] : INFINITY;
}

static bool is_choice(const struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    return e->hull && e->hull->own[i] >= 0 && (kind == OP_MIN || kind == OP_MAX || kind == OP_ABS);
}

bool rounding_is_decided(const struct rounding *e, int i)
{
    const struct op *op = &e->forms->known->program->op[i];
    if (!is_choice(e, i))
        return false;
    const int own = e->hull->own[i];
    const double share = e->arithmetic.unit * e->part->limit[own].tie * (1 + PAD);
    return share + (rest_of(e, op->a) + rest_of(e, op->b)) / e->part->limit[own].apart < 0.5;
}

bool rounding_is_limited(struct rounding *e, int i)
{
    e->limited = e->limited && (!is_choice(e, i) || rounding_is_decided(e, i));
    return e->limited;
}
