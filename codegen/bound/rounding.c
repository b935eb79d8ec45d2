/* Bounds of rounding errors, forwards and backwards; see rounding.h.
 *
 * Forwards (running error analysis): with x the exact and x' the computed value of an operation, |x' - x| <= e and |x'
 * - x| <= r |x|: what the operands' errors make of the exact result, and one rounding, at most u |result| + h with u the
 * unit roundoff and h the smallest number above 0 (of products and quotients; a sum that underflows is exact).  A product
 * contracted into a sum is not rounded; the sum's rounding, u |sum| or h, is at most what is counted for both.  So the
 * bounds hold with and without contraction.  Absolute and relative bound narrow each other: relative ones do not care
 * by what factor a quotient's divisor varies over the box, absolute ones do not mind zeros.
 *
 * Backwards: what one operation adds to the error, times the derivative of the result.  There errors that reach the
 * result on several ways cancel, as they do in fact; the forward bounds serve to enclose all values on the way.
 *
 * Values with names and divisors are joints: their errors are bounded backwards from the joints before them, in the same
 * box, and count from there on.  So the derivatives of a long program, such as several steps of Newton's, by its first values,
 * which are enclosed badly, need not be known.  The result is tried without them, too. */
#include "rounding.h"

#include "../program/evaluate.h"
#include "affine.h"
#include "enclosure.h"

#include <stdlib.h>

#define MOST_LINKED ((size_t)1 << 24) /* operations on ways backwards from joints, in one box: a tenth of a second */
#define GROW (1 + 0x1p-45)            /* above the roundings of the terms of a bound, all positive */

/* What the program is given, exactly: its inputs, which a region block may compute of others. */
static bool is_given(const struct known *x, int op)
{
    return (size_t)op < x->first;
}

static bool is_joint(const struct rounding *e, int i)
{
    const struct known *x = e->forms->known;
    return (x->joint[i] || x->pinned[i]) && !is_given(x, i);
}

static double last_rounding(const struct rounding *e, double most)
{
    return e->arithmetic.unit * most + e->arithmetic.least;
}

/* How far a constant is off. */
static double constant_error(const struct rounding *e, const struct program *p, const struct op *o)
{
    double error;
    const double x = point_constant(p, o, &error);
    if (e->arithmetic.unit == arithmetic_double.unit || (error == 0 && (double)(float)x == x))
        return error;
    return error + last_rounding(e, fabs(x) * (1 + 0x1p-20));
}

struct rounding *rounding_new(struct forms *w, int op)
{
    struct rounding *e = new_array(1, sizeof *e);
    const struct program *p = w->known->program;
    bool *marked = new_array(p->ops, sizeof *marked);
    size_t joints = 0;
    *e = (struct rounding){.arithmetic = w->known->arithmetic, .forms = w, .op = op};
    e->needed = new_array(w->needs, sizeof *e->needed);
    e->place = new_array(p->ops, sizeof *e->place);
    e->constant = new_array(p->ops, sizeof *e->constant);
    e->error = new_array(p->ops, sizeof *e->error);
    e->relative = new_array(p->ops, sizeof *e->relative);
    e->linked = new_array(p->ops, sizeof *e->linked);
    e->nonnegative = new_array(p->ops, sizeof *e->nonnegative);
    e->by = new_array(p->ops, sizeof *e->by);
    marked[op] = true;
    for (int i = op; i >= 0; i--) {
        const struct op *o = &p->op[i];
        if (!marked[i] || is_given(w->known, i))
            continue;
        if (o->a >= 0)
            marked[o->a] = true;
        if (o->b >= 0)
            marked[o->b] = true;
        if (o->kind == OP_CONSTANT)
            e->constant[i] = constant_error(e, p, o);
    }
    for (int i = 0; i <= op; i++)
        if (marked[i]) {
            e->place[i] = e->needs;
            e->needed[e->needs++] = i;
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
    free(e->needed);
    free(e->constant);
    free(e->error);
    free(e->relative);
    free(e->linked);
    free(e->nonnegative);
    free(e->by);
    free(e->place);
    free(e);
}

/* All values that an operation takes on the way from exact to computed ones. */
static struct interval inflated(const struct rounding *e, int i)
{
    const struct interval x = e->forms->range[i];
    return e->error[i] > 0 ? (struct interval){below(x.lo - e->error[i]), above(x.hi + e->error[i])} : x;
}

/* 1/n of an n-th root, 0 of what is none. */
static double function_power(const struct op *op)
{
    const int root = op_unary(op->kind)->root;
    return root ? 1.0 / root : 0;
}

/* Derivative of an n-th root of a, which is that root / (n a); of other functions nothing is known. */
static struct interval function_slope(const struct op *op, struct interval a)
{
    const struct interval power = interval_point(function_power(op));
    return power.lo > 0 ? interval_divide(interval_multiply(function_range(op->kind, a), power), a) : interval_whole();
}

/* ---- forwards ---- */

static bool is_exact_zero(const struct rounding *e, int op)
{
    const struct interval x = e->forms->range[op];
    return x.lo == 0 && x.hi == 0 && e->error[op] == 0;
}

/* Twice the same number is exact, but for one that is a product when contracted: fma(x, y, x * y). */
static bool is_exact_sum(const struct rounding *e, const struct op *op)
{
    const enum op_kind kind = e->forms->known->program->op[op->a].kind;
    return is_exact_zero(e, op->a) || is_exact_zero(e, op->b) ||
           (op->kind == OP_ADD && op->a == op->b && kind != OP_MUL && kind != OP_NEG);
}

static bool is_power_of_two(const struct rounding *e, int op)
{
    const struct interval x = e->forms->range[op];
    int exponent;
    return e->error[op] == 0 && x.lo == x.hi && fabs(frexp(x.lo, &exponent)) == 0.5;
}

static double product_error(const struct rounding *e, const struct op *op, double most)
{
    const struct interval *x = e->forms->range;
    const double ea = e->error[op->a], eb = e->error[op->b];
    const double error =
        (ea > 0 ? ea * (interval_most(x[op->b]) + eb) : 0) + (eb > 0 ? eb * interval_most(x[op->a]) : 0);
    if (is_exact_zero(e, op->a) || is_exact_zero(e, op->b))
        return 0;
    return error + (is_power_of_two(e, op->a) || is_power_of_two(e, op->b) ? e->arithmetic.least
                                                                           : last_rounding(e, most + error));
}

/* a'/b' - a/b = (da - (a/b) db) / b'. */
static double quotient_error(const struct rounding *e, const struct op *op, double most)
{
    const double divisor = interval_least(e->forms->range[op->b]) * (1 - lesser(e->relative[op->b], 1)) * (1 - 0x1p-50);
    if (!(divisor > 0))
        return INFINITY;
    const double eb = e->error[op->b], error = (e->error[op->a] + (eb > 0 ? most * eb : 0)) / divisor;
    return error + (is_power_of_two(e, op->b) ? e->arithmetic.least : last_rounding(e, most + error));
}

/* sqrt(a') - sqrt(a) = da / (sqrt(a') + sqrt(a)), and at most sqrt(|da|). */
static double root_error(const struct rounding *e, const struct op *op, double most)
{
    const double ea = e->error[op->a], lo = e->forms->range[op->a].lo, computed = lo - ea * (1 + 0x1p-50);
    if (!(lo >= 0 && ea <= DBL_MAX) || (computed < 0 && !e->nonnegative[op->a]))
        return INFINITY;
    const double divisor = sqrt(lo) + sqrt(greater(0, computed)), error = ea > 0 ? lesser(sqrt(ea), ea / divisor) : 0;
    return error * (1 + 0x1p-48) + e->arithmetic.unit * (most + error);
}

/* By the mean value theorem. */
static double function_error(const struct rounding *e, const struct op *op, double most)
{
    const double ea = e->error[op->a];
    const double error = ea > 0 ? ea * interval_most(function_slope(op, inflated(e, op->a))) : 0;
    return error + op_unary(op->kind)->error * e->arithmetic.unit * (most + error) + e->arithmetic.least;
}

/* The operand that is chosen, where the other one lies certainly beyond. */
static double choice_error(const struct rounding *e, const struct op *op, double sign)
{
    const struct interval *x = e->forms->range;
    const double ea = e->error[op->a], eb = e->error[op->b], both = (ea + eb) * (1 + 0x1p-50);
    const double a_over_b = sign > 0 ? x[op->a].lo - x[op->b].hi : x[op->b].lo - x[op->a].hi;
    const double b_over_a = sign > 0 ? x[op->b].lo - x[op->a].hi : x[op->a].lo - x[op->b].hi;
    return below(a_over_b) > both ? ea : below(b_over_a) > both ? eb : greater(ea, eb);
}

static double error_of(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const double most = interval_most(e->forms->range[i]);
    switch (op->kind) {
    case OP_CONSTANT:
        return e->constant[i];
    case OP_NEG:
    case OP_ABS:
        return e->error[op->a];
    case OP_ADD:
    case OP_SUB: {
        const double error = e->error[op->a] + e->error[op->b];
        return is_exact_sum(e, op) ? error : error + e->arithmetic.unit * (most + error);
    }
    case OP_MUL:
        return product_error(e, op, most);
    case OP_DIV:
    case OP_PDIV:
        return quotient_error(e, op, most);
    case OP_SQRT:
        return root_error(e, op, most);
    case OP_MIN:
        return choice_error(e, op, -1);
    case OP_MAX:
        return choice_error(e, op, 1);
    default:
        return function_error(e, op, most);
    }
}

/* Relative bound of a product, quotient or root, infinite for others. */
static double relative_error_of(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const double ra = op->a >= 0 ? e->relative[op->a] : 0, rb = op->b >= 0 ? e->relative[op->b] : 0;
    const double tiny = e->arithmetic.least / interval_least(e->forms->range[i]);
    double error = INFINITY;
    if (op->kind == OP_NEG || op->kind == OP_ABS)
        return ra;
    if (op->kind == OP_MIN || op->kind == OP_MAX)
        return ra < 1 && rb < 1 ? greater(ra, rb) : INFINITY;
    if (op->kind == OP_MUL)
        error = ra + rb + ra * rb;
    else if ((op->kind == OP_DIV || op->kind == OP_PDIV) && rb < 1)
        error = (ra + rb) / (1 - rb) * (1 + 0x1p-50);
    else if (op->kind == OP_SQRT && ra < 1)
        error = ra / (1 + sqrt(1 - ra)) * (1 + 0x1p-50);
    return error + e->arithmetic.unit * (1 + error) + tiny;
}

/* Rounding is monotonic: what is >= 0 exactly from operands >= 0 is computed so. */
static bool is_nonnegative(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const bool a = op->a >= 0 && e->nonnegative[op->a], b = op->b >= 0 && e->nonnegative[op->b];
    if (is_given(e->forms->known, (int)i) || op->kind == OP_CONSTANT)
        return e->forms->range[i].lo >= 0;
    switch (op->kind) {
    case OP_SQRT:
    case OP_ABS:
        return true;
    case OP_MUL:
        return op->squared || (a && b);
    case OP_ADD:
    case OP_DIV:
    case OP_PDIV:
    case OP_MIN:
        return a && b;
    case OP_MAX:
        return a || b;
    default:
        return false;
    }
}

/* NaN, anything below 0, and what may overflow, is no bound. */
static double checked(const struct rounding *e, double error, double most)
{
    const double padded = error > 0 ? error * GROW + e->arithmetic.least : error;
    return padded >= 0 && padded + most <= e->arithmetic.most ? padded : INFINITY;
}

static void propagate(struct rounding *e, size_t i)
{
    const struct interval range = e->forms->range[i];
    const double most = interval_most(range), least = interval_least(range);
    e->nonnegative[i] = is_nonnegative(e, i);
    if (is_given(e->forms->known, (int)i)) {
        e->relative[i] = e->arithmetic.given;
        e->error[i] = e->relative[i] > 0 ? checked(e, e->relative[i] * most, most) : 0;
        return;
    }
    const double error = checked(e, error_of(e, i), most), relative = checked(e, relative_error_of(e, i), most);
    e->error[i] = error > 0 ? lesser(error, checked(e, relative * most, most)) : error;
    e->relative[i] = e->error[i] > 0 ? lesser(relative, checked(e, e->error[i] / least, 0)) : 0;
}

/* ---- backwards ---- */

/* What rounding the operation itself adds: up to share |value| + constant. */
static double own_share(const struct rounding *e, int i, double *constant)
{
    const struct op *op = &e->forms->known->program->op[i];
    bool exact = false;
    *constant = 0;
    switch (op->kind) {
    case OP_CONSTANT:
        *constant = e->constant[i];
        return 0;
    case OP_ADD:
    case OP_SUB:
        return is_exact_sum(e, op) ? 0 : e->arithmetic.unit;
    case OP_MUL:
        if (is_exact_zero(e, op->a) || is_exact_zero(e, op->b))
            return 0;
        exact = is_power_of_two(e, op->a) || is_power_of_two(e, op->b);
        break;
    case OP_DIV:
    case OP_PDIV:
        exact = is_power_of_two(e, op->b);
        break;
    case OP_NEG:
    case OP_MIN:
    case OP_MAX:
        return 0;
    default:
        *constant = op_unary(op->kind)->error > 0 ? e->arithmetic.least : 0;
        return op_unary(op->kind)->error * e->arithmetic.unit;
    }
    *constant = e->arithmetic.least;
    return exact ? 0 : e->arithmetic.unit;
}

/* Derivatives of operation i by its operands. */
static void find_slopes(const struct rounding *e, int i, struct interval slope[2])
{
    const struct op *op = &e->forms->known->program->op[i];
    const struct interval one = {1, 1}, a = op->a >= 0 ? inflated(e, op->a) : one,
                          b = op->b >= 0 ? inflated(e, op->b) : one;
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
        slope[1] = interval_negative(interval_divide(inflated(e, i), b));
        break;
    case OP_SQRT:
        slope[0] = interval_divide(interval_point(0.5), inflated(e, i));
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
        slope[0] = function_slope(op, a);
    }
}

/* Of sizes: 0 times what has no bound is 0. */
static double size_product(double a, double b)
{
    return a == 0 || b == 0 ? 0 : above(a * b);
}

/* 1/b' - 1/b, at most. */
static double reciprocal_drift(const struct rounding *e, int b)
{
    const double least = interval_least(e->forms->range[b]), rest = below(least - e->error[b]);
    return e->error[b] == 0 ? 0 : rest > 0 ? above(e->error[b] / below(least * rest)) : INFINITY;
}

/* How far the derivative of operation i by operand k, which lies in `slope`, may be from that at the exact values. */
static double slope_drift(const struct rounding *e, int i, int k, struct interval slope)
{
    const struct op *op = &e->forms->known->program->op[i];
    const double most = above(slope.hi - slope.lo);
    switch (op->kind) {
    case OP_MUL:
        return lesser(most, e->error[k ? op->a : op->b]);
    case OP_DIV:
    case OP_PDIV: {
        const double drift = reciprocal_drift(e, op->b), divisor = interval_least(e->forms->range[op->b]);
        const double value = interval_most(e->forms->range[i]), error = e->error[i];
        /* (q + error) (1/b + drift) - q/b */
        return lesser(
            most, k == 0 ? drift
                         : above(size_product(above(value + error), drift) + (error > 0 ? above(error / divisor) : 0)));
    }
    case OP_SQRT:
        return lesser(most, 0.5 * reciprocal_drift(e, i));
    default:
        return most; /* 0 of sums */
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
        return op->kind < OP_UNARY ? 0 : function_power(op);
    }
}

/* Slope and weight of a value narrow each other. */
static void reconcile(struct interval *slope, struct interval *weight, struct interval value)
{
    *weight = interval_meet(*weight, interval_multiply(*slope, value));
    *slope = interval_meet(*slope, interval_divide(*weight, value));
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
    reconcile(&part, &weight, inflated(e, operand));
    part = affine_charge(e->forms, i, k, e->error, part);
    to->drift = above(to->drift + above(size_product(by->drift, interval_most(slope)) +
                                        size_product(interval_most(by->slope), slope_drift(e, i, k, slope))));
    to->slope = interval_add(to->slope, part);
    to->weight = interval_add(to->weight, weight);
    to->slope_size += op->kind == OP_NEG ? by->slope_size : interval_most(part);
    to->weight_size += op->kind == OP_NEG ? by->weight_size : interval_most(weight);
}

/* Where a way backwards ends: at all joints whose errors were found backwards to be less than forwards; at local coordinates
 * alone, so that what a step of Newton's is made of cancels as far as it does; or nowhere. */
enum way { BY_JOINTS, BY_PINNED, BY_NONE };

static bool is_link(const struct rounding *e, int i, enum way way)
{
    return way == BY_JOINTS ? e->linked[i] : way == BY_PINNED && e->forms->known->pinned[i];
}

/* What is said of the result's derivative by operation i, as far as the errors move that. */
static struct interval step_slope(const struct rounding *e, int result, int i)
{
    const double most = step_limits_most(&e->forms->known->steps, result, i), moved = above(most + e->by[i].drift);
    return most < INFINITY ? (struct interval){-moved, moved} : interval_whole();
}

/* The part of a link.  Where its last operation is a product, that may be rounded in some of its uses and not in others, when
 * contracted; what its factors' errors make of it is the same in all. */
static double link_error(const struct rounding *e, int i)
{
    const enum op_kind kind = e->forms->known->program->op[i].kind;
    const struct sensitivity *by = &e->by[i];
    const double rounding = last_rounding(e, interval_most(e->forms->range[i]) + e->error[i]);
    return e->error[i] * interval_most(by->slope) +
           (kind == OP_MUL || kind == OP_NEG ? 2 * rounding * by->slope_size : 0);
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
    const double share = own_share(e, i, &constant);
    /* the rounded value and the one that the weight is of are both within the error from the exact one */
    const double size = product ? by->slope_size : interval_most(by->slope);
    const double weight = product ? by->weight_size : interval_most(by->weight);
    return (share > 0 ? share * (weight + 2 * e->error[i] * size) : 0) + (constant > 0 ? constant * size : 0);
}

/* By the mean value theorem, the error of the result is the sum over all operations of what each adds, times the
 * derivative of the result by that at some point between exact and computed values.  A product may be contracted in one
 * of its uses and rounded in another, so that its error is charged for each of them by itself; so through a sign.
 * Joints, as far as the way goes by them, count by their errors in this box. */
static double backward_error(struct rounding *e, int result, enum way way)
{
    static const struct sensitivity none;
    double error = 0;
    const struct interval value = inflated(e, result);
    e->by[result] = (struct sensitivity){{1, 1}, value, 1, interval_most(value), 0};
    affine_result(e->forms, result);
    size_t n = e->place[result];
    for (n++; n-- > 0;) {
        const int i = e->needed[n];
        struct sensitivity *by = &e->by[i];
        const bool given = is_given(e->forms->known, i);
        if (given && by->slope_size > 0 && e->error[i] > 0)
            error += e->error[i] * interval_most(interval_meet(by->slope, affine_slope(e->forms, i)));
        if (by->slope_size == 0 || given || error == INFINITY) {
            *by = none;
            affine_discharge(e->forms, i);
            continue;
        }
        by->slope = interval_meet(by->slope, affine_slope(e->forms, i));
        const bool link = i != result && is_link(e, i, way);
        if (link && way == BY_PINNED)
            by->slope = interval_meet(by->slope, step_slope(e, result, i));
        reconcile(&by->slope, &by->weight, inflated(e, i));
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
    return checked(e, error * (1 + 0x1p-30), 0); /* its terms are many */
}

/* A joint's error, found backwards from those before it. */
static void bound_joint(struct rounding *e, int i)
{
    const double most = interval_most(e->forms->range[i]), least = interval_least(e->forms->range[i]);
    const bool pinned = e->forms->known->pinned[i] || i == e->op;
    const double by_joints = backward_error(e, i, BY_JOINTS);
    const double by_pinned = pinned ? backward_error(e, i, BY_PINNED) : INFINITY;
    const double error = checked(e, lesser(by_joints, by_pinned), most);
    if (!(error < e->error[i]))
        return;
    e->error[i] = error;
    e->relative[i] = lesser(e->relative[i], checked(e, error / least, 0));
    e->linked[i] = true;
}

double rounding_error(struct rounding *e)
{
    for (size_t n = 0; n < e->needs; n++) {
        const int i = e->needed[n];
        propagate(e, (size_t)i);
        e->linked[i] = false;
        if (e->error[i] > 0 && (i == e->op || (e->links && is_joint(e, i))))
            bound_joint(e, i);
    }
    return e->error[e->op] < INFINITY ? lesser(e->error[e->op], backward_error(e, e->op, BY_NONE)) : INFINITY;
}
