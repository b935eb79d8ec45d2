/* Bounds rounding errors backwards; see rounding.h.
 *
 * Each operation's own error is multiplied by the derivative of the result. Errors that reach the result on several
 * paths cancel in this derivative, as they do in fact. Forward bounds serve to enclose all intermediate values.
 *
 * Named values and divisors are joints: their errors are bounded backwards from earlier joints in the same box, and
 * then count as single errors. So a long program, such as several Newton steps, does not need its derivatives by the
 * first values, which are enclosed badly. The result is also bounded without joints. */
#include "rounding.h"

#include "../program/evaluate.h"
#include "../region/affine.h"
#include "../region/enclosure.h"

#include <stdlib.h>

#define MOST_LINKED ((size_t)1 << 24) /* operations on backward paths from joints, in one box: a tenth of a second */
#define GROW (1 + 0x1p-45)            /* exceeds the roundings of the terms of a bound, all positive */

static bool is_joint(const struct rounding *e, int i)
{
    const struct known *x = e->forms->known;
    return x->joint[i] && !rounding_is_given(x, i);
}

struct rounding *rounding_new(struct forms *w, const int *target, size_t targets)
{
    struct rounding *e = new_array(1, sizeof *e);
    const struct program *p = w->known->program;
    bool *marked = new_array(p->ops, sizeof *marked);
    size_t joints = 0;
    *e = (struct rounding){.arithmetic = w->known->arithmetic, .forms = w, .targets = targets};
    e->target = arena_array(&e->arena, targets, sizeof *e->target);
    e->asked = arena_array(&e->arena, p->ops, sizeof *e->asked);
    e->needed = arena_array(&e->arena, w->needs, sizeof *e->needed);
    e->place = arena_array(&e->arena, p->ops, sizeof *e->place);
    e->constant = arena_array(&e->arena, p->ops, sizeof *e->constant);
    e->error = arena_array(&e->arena, p->ops, sizeof *e->error);
    e->relative = arena_array(&e->arena, p->ops, sizeof *e->relative);
    e->linked = arena_array(&e->arena, p->ops, sizeof *e->linked);
    e->nonnegative = arena_array(&e->arena, p->ops, sizeof *e->nonnegative);
    e->by = arena_array(&e->arena, p->ops, sizeof *e->by);
    for (size_t i = 0; i < targets; i++) {
        e->target[i] = target[i];
        e->asked[target[i]] = marked[target[i]] = true;
    }
    for (size_t i = p->ops; i-- > 0;) {
        const struct op *o = &p->op[i];
        if (!marked[i] || rounding_is_given(w->known, (int)i))
            continue;
        if (o->a >= 0)
            marked[o->a] = true;
        if (o->b >= 0)
            marked[o->b] = true;
        if (o->kind == OP_CONSTANT)
            e->constant[i] = constant_error(&e->arithmetic, p, o);
    }
    for (size_t i = 0; i < p->ops; i++)
        if (marked[i]) {
            e->place[i] = e->needs;
            e->needed[e->needs++] = (int)i;
        }
    free(marked);
    for (size_t n = 0; n < e->needs; n++)
        joints += is_joint(e, e->needed[n]);
    e->links = joints == 0 || e->needs <= MOST_LINKED / joints;
    return e;
}

void rounding_free(struct rounding *e)
{
    if (!e)
        return;
    arena_free(&e->arena);
    free(e);
}

/* ---- backwards ---- */

/* Encloses the derivatives of operation i by its operands. */
static void find_slopes(const struct rounding *e, int i, struct interval slope[2])
{
    const struct op *op = &e->forms->known->program->op[i];
    const struct interval one = {1, 1}, a = op->a >= 0 ? rounding_inflated(e, op->a) : one,
                          b = op->b >= 0 ? rounding_inflated(e, op->b) : one;
    slope[0] = slope[1] = one;
    switch (op->kind) {
    case OP_CONSTANT:
    case OP_ADD:
        break;
    case OP_NEG:
        slope[0] = interval_point(-1);
        break;
    case OP_SUB:
        slope[1] = interval_point(-1);
        break;
    case OP_MUL:
        slope[0] = b;
        slope[1] = a;
        break;
    case OP_DIV:
    case OP_PDIV:
        slope[0] = interval_divide(one, b);
        slope[1] = interval_negative(interval_divide(rounding_inflated(e, i), b));
        break;
    case OP_SQRT:
        slope[0] = interval_divide(interval_point(0.5), rounding_inflated(e, i));
        break;
    case OP_ABS:
        slope[0] = (struct interval){a.lo >= 0 ? 1 : -1, a.hi <= 0 ? -1 : 1};
        break;
    case OP_MIN:
    case OP_MAX: {
        const bool first = op->kind == OP_MIN ? a.hi <= b.lo : a.lo >= b.hi;
        const bool second = op->kind == OP_MIN ? b.hi <= a.lo : b.lo >= a.hi;
        slope[0] = (struct interval){first ? 1 : 0, second ? 0 : 1};
        slope[1] = (struct interval){second ? 1 : 0, first ? 0 : 1};
        break;
    }
    default:
        slope[0] = rounding_function_slope(op, a);
    }
}

/* Returns slope times operand over result if it is constant: a power in a product. */
static double find_power(const struct op *op, int k)
{
    switch (op->kind) {
    case OP_NEG:
    case OP_MUL:
        return 1;
    case OP_DIV:
    case OP_PDIV:
        return k ? -1 : 1;
    default:
        return op->kind < OP_UNARY ? 0 : rounding_power(op);
    }
}

/* Narrows slope and weight of a value by each other. */
static void reconcile(struct interval *slope, struct interval *weight, struct interval value)
{
    *weight = interval_meet(*weight, interval_multiply(*slope, value));
    *slope = interval_meet(*slope, interval_divide(*weight, value));
}

/* Returns true if the sum rounds: a sum with 0 is exact, but a contracted product passes its rounding on. */
static bool is_rounded_sum(struct rounding *e, int i)
{
    double constant;
    return rounding_own_share(e, i, &constant) > 0;
}

/* Returns the slopes of single uses of a product that may be contracted: only sums contract, each separately. */
static struct interval span_of_use(struct rounding *e, int i, struct interval part)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const double most = interval_most(part);
    if (kind != OP_ADD && kind != OP_SUB)
        return part;
    return is_rounded_sum(e, i) ? (struct interval){lesser(part.lo, 0), greater(part.hi, 0)}
                                : (struct interval){-most, most};
}

/* Adds the contribution of operand k of operation i. blur: the operation's own error times its slope. */
static void charge(struct rounding *e, int i, int k, struct interval slope, double blur)
{
    const struct op *op = &e->forms->known->program->op[i];
    const int operand = k ? op->b : op->a;
    const struct sensitivity *by = &e->by[i];
    struct sensitivity *to = &e->by[operand];
    const double power = find_power(op, k);
    struct interval part = interval_multiply(by->slope, slope), weight = interval_whole();
    if (power != 0)
        weight = interval_multiply((struct interval){below(by->weight.lo - blur), above(by->weight.hi + blur)},
                                   interval_point(power));
    reconcile(&part, &weight, rounding_inflated(e, operand));
    part = affine_charge(e->forms, i, k, e->error, part);
    to->slope = interval_add(to->slope, part);
    to->weight = interval_add(to->weight, weight);
    const bool negates = op->kind == OP_NEG;
    to->slope_span =
        interval_add(to->slope_span, negates ? interval_negative(by->slope_span) : span_of_use(e, i, part));
    to->weight_span = interval_add(to->weight_span, negates ? by->weight_span : span_of_use(e, i, weight));
}

/* Returns the error of a link. If its last operation is a product, contraction may skip its rounding in some uses; its
 * factors' errors have the same effect in all. */
static double link_error(const struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const struct sensitivity *by = &e->by[i];
    const double rounding = rounding_of_last(e, interval_most(e->forms->range[i]) + e->error[i]);
    return e->error[i] * interval_most(by->slope) +
           (kind == OP_MUL || kind == OP_NEG ? 2 * rounding * above(by->slope_span.hi - by->slope_span.lo) : 0);
}

/* Returns the error of operation i: its own rounding or, for a link, its total. Infinite: no bound. */
static double part_error(struct rounding *e, int i, bool link)
{
    const struct op *op = &e->forms->known->program->op[i];
    const bool product = op->kind == OP_MUL;
    const struct sensitivity *by = &e->by[i];
    double constant;
    if (link)
        return link_error(e, i);
    const double share = rounding_own_share(e, i, &constant);
    /* the rounded value, and the value with the weight, are both within the error of the exact value */
    const double size = interval_most(product ? by->slope_span : by->slope);
    const double weight = interval_most(product ? by->weight_span : by->weight);
    return (share > 0 ? share * (weight + 2 * e->error[i] * size) : 0) + (constant > 0 ? constant * size : 0);
}

/* Bounds the error of the result. By the mean value theorem it is the sum over all operations of their own errors,
 * times the derivative of the result at some point between exact and computed values. A product may be contracted in
 * some uses and rounded in others, so its error is charged for the worst set of uses, also through a sign. Joints on
 * the paths count by their errors in this box. */
static double backward_error(struct rounding *e, int result, bool by_joints)
{
    static const struct sensitivity none;
    double error = 0;
    const struct interval value = rounding_inflated(e, result);
    e->by[result] = (struct sensitivity){{1, 1}, value, {1, 1}, value};
    affine_result(e->forms, result);
    size_t n = e->place[result];
    for (n++; n-- > 0;) {
        const int i = e->needed[n];
        struct sensitivity *by = &e->by[i];
        const bool given = rounding_is_given(e->forms->known, i);
        const bool used = !interval_is_zero(by->slope_span);
        if (used && i != result && e->error[i] == INFINITY) /* it may overflow */
            error = INFINITY;
        if (given && used && e->error[i] > 0)
            error += e->error[i] * interval_most(interval_meet(by->slope, affine_slope(e->forms, i)));
        if (!used || given || error == INFINITY) {
            *by = none;
            affine_discharge(e->forms, i);
            continue;
        }
        by->slope = interval_meet(by->slope, affine_slope(e->forms, i));
        const bool link = by_joints && i != result && e->linked[i];
        reconcile(&by->slope, &by->weight, rounding_inflated(e, i));
        const double own = part_error(e, i, link);
        error += own;
        if (!(own >= 0 && error <= DBL_MAX))
            error = INFINITY;
        else if (!link) {
            struct interval slope[2];
            const struct op *op = &e->forms->known->program->op[i];
            find_slopes(e, i, slope);
            for (int k = 0; k < 2; k++)
                if ((k ? op->b : op->a) >= 0)
                    charge(e, i, k, slope[k], own * GROW);
        }
        *by = none;
        affine_discharge(e->forms, i);
    }
    return rounding_checked(e, error * (1 + 0x1p-30), 0); /* it has many terms */
}

/* Bounds a joint's error backwards from earlier joints. */
static void bound_joint(struct rounding *e, int i)
{
    const double most = interval_most(e->forms->range[i]), least = interval_least(e->forms->range[i]);
    const double error = rounding_checked(e, backward_error(e, i, true), most);
    if (!(error < e->error[i]))
        return;
    e->error[i] = error;
    e->relative[i] = lesser(e->relative[i], rounding_checked(e, error / least, 0));
    e->linked[i] = true;
}

static void find_errors(struct rounding *e)
{
    for (size_t n = 0; n < e->needs; n++) {
        const int i = e->needed[n];
        rounding_propagate(e, (size_t)i);
        e->linked[i] = false;
        if (e->error[i] > 0 && (e->asked[i] || (e->links && is_joint(e, i))))
            bound_joint(e, i);
    }
}

void rounding_errors(struct rounding *e, double *error)
{
    find_errors(e);
    for (size_t i = 0; i < e->targets; i++) {
        const int op = e->target[i];
        error[i] = e->error[op];
        if (error[i] > 0 && error[i] < INFINITY)
            error[i] = lesser(error[i], backward_error(e, op, false));
    }
}
