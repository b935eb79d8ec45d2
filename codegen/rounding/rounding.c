/* Bounds of rounding errors, backwards; see rounding.h.
 *
 * Backwards: what one operation adds to the error, times the derivative of the result.  There errors that reach the
 * result on several ways cancel, as they do in fact; the forward bounds serve to enclose all values on the way.
 *
 * Values with names and divisors are joints: their errors are bounded backwards from the joints before them, in the same
 * box, and count from there on.  So the derivatives of a long program, such as several steps of Newton's, by its first values,
 * which are enclosed badly, need not be known.  The result is tried without them, too. */
#include "rounding.h"

#include "../program/evaluate.h"
#include "../region/affine.h"
#include "../region/enclosure.h"

#include <stdlib.h>

#define MOST_LINKED ((size_t)1 << 24) /* operations on ways backwards from joints, in one box: a tenth of a second */
#define GROW (1 + 0x1p-45)            /* above the roundings of the terms of a bound, all positive */

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

/* Derivatives of operation i by its operands. */
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

/* Slope times operand over result, where that is a number: a power of a product. */
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

/* Slope and weight of a value narrow each other. */
static void reconcile(struct interval *slope, struct interval *weight, struct interval value)
{
    *weight = interval_meet(*weight, interval_multiply(*slope, value));
    *slope = interval_meet(*slope, interval_divide(*weight, value));
}

/* A sum with 0 is exact, and of a product contracted what the product's rounding was. */
static bool is_rounded_sum(struct rounding *e, int i)
{
    double constant;
    return rounding_own_share(e, i, &constant) > 0;
}

/* What a use is to a product that may be contracted: only sums do that, each of them by itself. */
static struct interval span_of_use(struct rounding *e, int i, struct interval part)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const double most = interval_most(part);
    if (kind != OP_ADD && kind != OP_SUB)
        return part;
    return is_rounded_sum(e, i) ? (struct interval){lesser(part.lo, 0), greater(part.hi, 0)}
                                : (struct interval){-most, most};
}

/* What the result owes to operand k of operation i.  `blur`: the operation's own error times its slope. */
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

/* The part of a link.  Where its last operation is a product, that may be rounded in some of its uses and not in others, when
 * contracted; what its factors' errors make of it is the same in all. */
static double link_error(const struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const struct sensitivity *by = &e->by[i];
    const double rounding = rounding_of_last(e, interval_most(e->forms->range[i]) + e->error[i]);
    return e->error[i] * interval_most(by->slope) +
           (kind == OP_MUL || kind == OP_NEG ? 2 * rounding * above(by->slope_span.hi - by->slope_span.lo) : 0);
}

/* The part of operation i: what it adds by itself, or, of a link, its error.  Infinite: there is no bound. */
static double part_error(struct rounding *e, int i, bool link)
{
    const struct op *op = &e->forms->known->program->op[i];
    const bool product = op->kind == OP_MUL;
    const struct sensitivity *by = &e->by[i];
    double constant;
    if (link)
        return link_error(e, i);
    const double share = rounding_own_share(e, i, &constant);
    /* the rounded value and the one that the weight is of are both within the error from the exact one */
    const double size = interval_most(product ? by->slope_span : by->slope);
    const double weight = interval_most(product ? by->weight_span : by->weight);
    return (share > 0 ? share * (weight + 2 * e->error[i] * size) : 0) + (constant > 0 ? constant * size : 0);
}

/* By the mean value theorem, the error of the result is the sum over all operations of what each adds, times the
 * derivative of the result by that at some point between exact and computed values.  A product may be contracted in some of
 * its uses and rounded in the others, so that its error is charged for the worst of these; so through a sign.
 * Joints, as far as the way goes by them, count by their errors in this box. */
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
    return rounding_checked(e, error * (1 + 0x1p-30), 0); /* its terms are many */
}

/* A joint's error, found backwards from those before it. */
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
