/* Rounding errors on a hull; see rounding_parts.h.
 *
 * Derivatives are limited at the exact values.  How far those at values between these and the computed ones are from them: with
 * A and A' the derivatives of all operations by their operands at either, and T = 1/(1 - A) and T' those of all values by all
 * others,
 *     T' - T = T' (A' - A) T.
 * What T' (A' - A) of the result is, as far as no joint is between (`pushed`), is summed up at joints, whose T is limited: so
 * it does not grow with every value on the way, as sums of sizes would. */
#include "rounding_parts.h"

#define PAD 0x1p-10 /* above the rounding of sums */

static void find_drift(struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    struct sensitivity *by = &e->by[i];
    for (size_t k = 0; k < e->sources; k++) {
        const struct hull_slope *most = hull_slope(e->hull, e->source[k].joint, i);
        const double slope = !most ? INFINITY : kind == OP_MUL || kind == OP_NEG ? most->size : most->slope;
        by->drift = above(by->drift + rounding_product(e->source[k].size, slope));
    }
    if (hull_is_joint(e->hull, i) && by->pushed > 0) {
        e->source[e->sources++] = (struct source){i, by->pushed};
        by->pushed = 0;
    }
}

void rounding_limit_by_hull(struct rounding *e, int result, int i)
{
    const struct hull_slope *most = hull_slope(e->hull, result, i);
    struct sensitivity *by = &e->by[i];
    find_drift(e, i);
    if (!most) {
        by->more = INFINITY;
        return;
    }
    const double value = above(interval_most(e->forms->range[i]) + e->error[i]);
    const double slope = above(most->slope + by->drift), size = above(most->size + by->drift);
    /* (slope + drift) (value + error) */
    by->more = above(rounding_product(most->size < INFINITY ? most->size : most->slope, e->error[i]) +
                     rounding_product(by->drift, value));
    const double weight = above(most->weight + by->more);
    by->slope = interval_meet(by->slope, (struct interval){-slope, slope});
    by->weight = interval_meet(by->weight, (struct interval){-weight, weight});
    by->slope_size = lesser(by->slope_size, size);
    by->weight_size = lesser(by->weight_size, above(most->size_weight + by->more));
}

/* How much more than a unit of its value a constant is off. */
static double excess(const struct rounding *e, int i)
{
    return greater(0, above(e->constant[i] - below(e->arithmetic.unit * interval_least(e->forms->range[i]))));
}

double rounding_rest(struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const struct sensitivity *by = &e->by[i];
    const double size = kind == OP_MUL ? by->slope_size : interval_most(by->slope);
    double constant;
    if (rounding_is_given(e->forms->known, i))
        return rounding_product(e->arithmetic.given, by->more);
    const double unit = rounding_own_share(e, i, &constant);
    if (kind == OP_CONSTANT) /* mostly, but not always, off by less than a unit */
        return rounding_product(e->arithmetic.unit, by->more) + rounding_product(excess(e, i), size);
    return rounding_product(unit, above(by->more + 2 * rounding_product(e->error[i], size))) +
           rounding_product(constant, size);
}

/* The share is of the exact weights. */
void rounding_end_on_hull(struct rounding *e, int joint, double rest)
{
    const struct hull *h = e->hull;
    const int own = h->own[joint];
    e->rest[joint] = rest;
    if (!hull_is_joint(h, joint) || !h->divides[own])
        return;
    const double share = e->arithmetic.unit * h->share[own] * (1 + PAD);
    e->relative[joint] = lesser(e->relative[joint], rounding_checked(e, share + rest / h->least[own], 0));
}

static double rest_of(const struct rounding *e, int op)
{
    if (op < 0 || e->error[op] == 0 || rounding_is_given(e->forms->known, op))
        return 0;
    if (e->forms->known->program->op[op].kind == OP_CONSTANT)
        return excess(e, op);
    return hull_is_joint(e->hull, op) ? e->rest[op] : INFINITY;
}

bool rounding_is_decided(const struct rounding *e, int i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const int own = e->hull ? e->hull->own[i] : -1;
    if (own < 0 || (op->kind != OP_MIN && op->kind != OP_MAX && op->kind != OP_ABS))
        return false;
    const double share = e->arithmetic.unit * e->hull->tie[own] * (1 + PAD);
    return share + (rest_of(e, op->a) + rest_of(e, op->b)) / e->hull->apart[own] < 0.5;
}
