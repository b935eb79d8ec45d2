/* Affine arithmetic; see affine.h. Coefficients are rounded to nearest; the radius absorbs the rounding errors: ROUND
 * times the `size` of an operation exceeds their sum. */
#include "affine.h"

#include <stdlib.h>
#include <string.h>

#define GROW (1 + 0x1p-30) /* exceeds all relative errors of a sum of positive numbers */
#define ROUND 0x1p-50      /* exceeds the errors of a coefficient: a few roundings */
#define TINY 1e-300        /* exceeds everything that underflows */

static double *slopes(const struct forms *w, size_t i)
{
    return w->slope + i * w->known->variables;
}

/* Marks an operation as having no form until the range makes a form. */
static void forget(struct forms *w, size_t i)
{
    w->radius[i] = INFINITY;
}

static void set_radius(struct forms *w, size_t i, double radius, double size)
{
    double mass = 0;
    const double *s = slopes(w, i);
    for (size_t k = 0; k < w->known->variables; k++)
        mass += fabs(s[k]);
    w->mass[i] = mass * GROW;
    w->radius[i] = (radius + size * ROUND) * GROW + TINY;
    if (!(w->radius[i] + w->mass[i] <= DBL_MAX))
        forget(w, i);
}

/* Sets out = p a + q b + shift, with additional radius. */
static void combine(struct forms *w, size_t out, double p, size_t a, double q, size_t b, double shift, double radius)
{
    if (!(w->radius[a] + w->radius[b] + radius + fabs(p) + fabs(q) < INFINITY)) {
        forget(w, out);
        return;
    }
    double *s = slopes(w, out);
    const double *sa = slopes(w, a), *sb = slopes(w, b);
    for (size_t k = 0; k < w->known->variables; k++)
        s[k] = p * sa[k] + q * sb[k];
    w->centre[out] = p * w->centre[a] + q * w->centre[b] + shift;
    set_radius(w, out, fabs(p) * w->radius[a] + fabs(q) * w->radius[b] + radius,
               fabs(p) * (fabs(w->centre[a]) + w->mass[a]) + fabs(q) * (fabs(w->centre[b]) + w->mass[b]) + fabs(shift));
}

/* Multiplies two forms. The product of the linear parts is sum_k s_k t_k e_k^2, half of which goes to the centre as
 * e_k^2 is in [0,1], and the mixed terms. */
static void multiply(struct forms *w, size_t out, size_t a, size_t b)
{
    if (!(w->radius[a] + w->radius[b] < INFINITY)) {
        forget(w, out);
        return;
    }
    double *s = slopes(w, out), sum = 0, absolute = 0;
    const double *sa = slopes(w, a), *sb = slopes(w, b), ca = w->centre[a], cb = w->centre[b];
    for (size_t k = 0; k < w->known->variables; k++) {
        const double square = sa[k] * sb[k];
        sum += square;
        absolute += fabs(square);
        s[k] = ca * sb[k] + cb * sa[k];
    }
    w->centre[out] = ca * cb + 0.5 * sum;
    const double ma = w->mass[a], mb = w->mass[b], ra = w->radius[a], rb = w->radius[b];
    set_radius(w, out,
               fabs(ca) * rb + fabs(cb) * ra + greater(0, ma * mb - 0.5 * absolute / GROW) + ma * rb + ra * mb +
                   ra * rb,
               (fabs(ca) + ma) * (fabs(cb) + mb));
}

/* Sets the form of a function of x that lies in slope x + [lo,hi]. */
static void linearise(struct forms *w, size_t out, size_t x, double slope, double lo, double hi)
{
    const double middle = 0.5 * (lo + hi);
    combine(w, out, slope, x, 0, x, middle, above(greater(hi - middle, middle - lo)));
}

/* Encloses 1/x - slope x with slope = -1/(lo hi), for positive x: equal at both ends, least at their geometric mean. */
static void reciprocal(struct forms *w, size_t out, size_t x)
{
    const struct interval r = interval_absolute(w->range[x]);
    const double slope = -1 / (r.lo * r.hi), least = below(2 * sqrt(-slope));
    const double most =
        greater(above(above(1 / r.lo) + above(-slope * r.lo)), above(above(1 / r.hi) + above(-slope * r.hi)));
    if (!(slope < 0 && most <= DBL_MAX))
        forget(w, out);
    else if (w->range[x].lo > 0)
        linearise(w, out, x, slope, least, most);
    else
        linearise(w, out, x, slope, -most, -least);
}

/* Divides by a/b = q + (a - q b) / b with q = centre / centre: common parts of a and b cancel in the bracket. */
static void divide(struct forms *w, size_t out, size_t a, size_t b)
{
    const size_t inverse = w->known->program->ops, rest = inverse + 1;
    if (interval_has(w->range[b], 0) || !(w->radius[a] + w->radius[b] < INFINITY)) {
        forget(w, out);
        return;
    }
    const double ratio = w->centre[a] / w->centre[b], q = fabs(ratio) <= DBL_MAX ? ratio : 0;
    reciprocal(w, inverse, b);
    combine(w, rest, 1, a, -q, b, 0, 0);
    multiply(w, out, rest, inverse);
    w->centre[out] += q;
    w->radius[out] += fabs(w->centre[out]) * ROUND;
}

static void root(struct forms *w, size_t out, size_t x)
{
    const struct interval r = w->range[x];
    const double slope = 1 / (sqrt(r.lo) + sqrt(r.hi));
    if (!(r.lo >= 0 && slope > 0 && slope <= DBL_MAX)) {
        forget(w, out);
        return;
    }
    const double least =
        lesser(below(below(sqrt(r.lo)) - above(slope * r.lo)), below(below(sqrt(r.hi)) - above(slope * r.hi)));
    linearise(w, out, x, slope, least, above(1 / (4 * slope)));
}

/* Returns the slope of |x| from end to end. *most: the largest distance of |x| above it, so that |x| is in slope x +
 * [0,most]. */
static double chord(struct interval r, double *most)
{
    const double slope = greater(-1, lesser(1, (r.hi + r.lo) / (r.hi - r.lo)));
    *most = greater(above(r.hi * above(1 - slope)), above(-r.lo * above(1 + slope)));
    return slope;
}

static void absolute(struct forms *w, size_t out, size_t x)
{
    const struct interval r = w->range[x];
    double most;
    if (r.lo >= 0 || r.hi <= 0)
        combine(w, out, r.lo >= 0 ? 1 : -1, x, 0, x, 0, 0);
    else if (!interval_finite(r))
        forget(w, out);
    else {
        const double slope = chord(r, &most);
        linearise(w, out, x, slope, 0, most);
    }
}

static struct interval form_range(const struct forms *w, size_t i)
{
    const double reach = above(w->mass[i] + w->radius[i]);
    return (struct interval){below(w->centre[i] - reach), above(w->centre[i] + reach)};
}

/* Uses min(a,b) = (a + b - |a - b|) / 2, max with +. */
static void choose(struct forms *w, size_t out, size_t a, size_t b, int sign)
{
    const size_t t = w->known->program->ops;
    double most;
    combine(w, t, 1, a, -1, b, 0, 0);
    if (w->radius[t] == INFINITY) {
        forget(w, out);
        return;
    }
    const struct interval r = interval_meet(interval_subtract(w->range[a], w->range[b]), form_range(w, t));
    if (r.lo >= 0 || r.hi <= 0) {
        combine(w, out, 1, (r.lo >= 0) == (sign > 0) ? a : b, 0, a, 0, 0);
        return;
    }
    const double slope = chord(r, &most);
    combine(w, out, 0.5 * (1 + sign * slope), a, 0.5 * (1 - sign * slope), b, sign * 0.25 * most, above(0.25 * most));
}

static void set_form(struct forms *w, size_t i, double centre, double radius)
{
    w->centre[i] = centre;
    memset(slopes(w, i), 0, w->known->variables * sizeof *w->slope);
    w->mass[i] = 0;
    w->radius[i] = radius;
}

/* ---- operations ---- */

static void set_input(struct forms *w, size_t i, size_t variable)
{
    forget(w, i);
    if (variable == w->known->variables || !interval_finite(w->range[i]))
        return;
    const double middle = interval_middle(w->range[i]), half = interval_half(w->range[i], middle);
    set_form(w, i, middle, 0);
    slopes(w, i)[variable] = w->mass[i] = half;
    w->middle[variable] = middle;
    w->half[variable] = half;
}

static void set_operation(struct forms *w, size_t i)
{
    const struct op *op = &w->known->program->op[i];
    const size_t a = (size_t)op->a, b = (size_t)op->b;
    switch (op->kind) {
    case OP_CONSTANT:
        forget(w, i);
        break;
    case OP_INPUT:
        set_input(w, i, w->known->variable[op->input]);
        break;
    case OP_NEG:
        combine(w, i, -1, a, 0, a, 0, 0);
        break;
    case OP_ADD:
        combine(w, i, 1, a, 1, b, 0, 0);
        break;
    case OP_SUB:
        combine(w, i, 1, a, -1, b, 0, 0);
        break;
    case OP_MUL:
        multiply(w, i, a, b);
        break;
    case OP_DIV:
    case OP_PDIV:
        divide(w, i, a, b);
        break;
    case OP_SQRT:
        root(w, i, a);
        break;
    case OP_ABS:
        absolute(w, i, a);
        break;
    case OP_MIN:
    case OP_MAX:
        choose(w, i, a, b, op->kind == OP_MAX ? 1 : -1);
        break;
    default:
        forget(w, i);
    }
}

/* Replaces a form whose radius is as wide as the range. */
static void settle(struct forms *w, size_t i)
{
    if (w->radius[i] < INFINITY)
        w->range[i] = interval_meet(w->range[i], form_range(w, i));
    const double middle = interval_middle(w->range[i]), half = interval_half(w->range[i], middle);
    if (half <= w->radius[i])
        set_form(w, i, middle, half);
}

void affine_set(struct forms *w, size_t i)
{
    set_operation(w, i);
    settle(w, i);
}

/* Exchanges the form of operation i for the form at hand, if that is closer. */
static void take_closer(struct forms *w, size_t i, size_t hand)
{
    if (!(w->radius[hand] < w->radius[i]))
        return;
    w->centre[i] = w->centre[hand];
    w->radius[i] = w->radius[hand];
    w->mass[i] = w->mass[hand];
    memcpy(slopes(w, i), slopes(w, hand), w->known->variables * sizeof *w->slope);
    settle(w, i);
}

void affine_adopt(struct forms *w, size_t i, size_t other, struct interval ratio)
{
    const size_t hand = w->known->program->ops;
    const double middle = interval_middle(ratio), most = interval_most(w->range[other]);
    if (!w->affine || !interval_finite(ratio))
        return;
    combine(w, hand, middle, other, 0, other, 0, ratio.lo < ratio.hi ? above(interval_half(ratio, middle) * most) : 0);
    take_closer(w, i, hand);
}

void affine_shift(struct forms *w, size_t i, size_t other, struct interval difference)
{
    const size_t hand = w->known->program->ops;
    if (!w->affine || !interval_finite(difference))
        return;
    const double middle = interval_middle(difference);
    combine(w, hand, 1, other, 0, other, middle, interval_half(difference, middle));
    take_closer(w, i, hand);
}

/* ---- derivatives ---- */

static size_t slope_row(const struct forms *w, int i)
{
    return w->known->program->ops + FORMS_HANDS + (size_t)i;
}

/* Adds the effect of errors in row `other`, up to `error`, on a product with values up to `most`. */
static void blur(struct forms *w, size_t row, double most, double error)
{
    if (error > 0)
        w->radius[row] = above(w->radius[row] + above(most * error));
}

void affine_result(struct forms *w, int result)
{
    if (w->affine) {
        set_form(w, slope_row(w, result), 1, 0);
        w->range[slope_row(w, result)] = interval_point(1);
    }
}

void affine_discharge(struct forms *w, int i)
{
    if (w->affine) {
        set_form(w, slope_row(w, i), 0, 0);
        w->range[slope_row(w, i)] = interval_point(0);
    }
}

struct interval affine_slope(const struct forms *w, int i)
{
    return w->affine && w->radius[slope_row(w, i)] < INFINITY ? form_range(w, slope_row(w, i)) : interval_whole();
}

/* Computes derivative / value; the value's error must leave its sign certain. */
static void slope_quotient(struct forms *w, size_t out, size_t slope, int value, double error)
{
    const double least = interval_least(w->range[value]), rest = below(least - error);
    divide(w, out, slope, (size_t)value);
    if (rest > 0)
        blur(w, out, interval_most(w->range[slope]), above(error / below(least * rest)));
    else
        forget(w, out);
}

/* Computes, at hand, the form of the result's derivative through operand k; returns false if there is no form. */
static bool charge_form(struct forms *w, size_t hand, int i, int k, const double *error)
{
    const struct op *op = &w->known->program->op[i];
    const size_t slope = slope_row(w, i), quotient = hand + 1;
    const int other = k ? op->a : op->b;
    switch (op->kind) {
    case OP_ADD:
    case OP_SUB:
    case OP_NEG:
        combine(w, hand, op->kind == OP_NEG || (op->kind == OP_SUB && k) ? -1 : 1, slope, 0, slope, 0, 0);
        return true;
    case OP_MUL:
        multiply(w, hand, slope, (size_t)other);
        blur(w, hand, interval_most(w->range[slope]), error[other]);
        return true;
    case OP_DIV:
    case OP_PDIV:
        slope_quotient(w, k ? quotient : hand, slope, op->b, error[op->b]);
        if (k) {
            w->range[quotient] = form_range(w, quotient);
            multiply(w, hand, quotient, (size_t)i);
            blur(w, hand, interval_most(w->range[quotient]), error[i]);
            combine(w, hand, -1, hand, 0, hand, 0, 0);
        }
        return true;
    case OP_SQRT:
        slope_quotient(w, hand, slope, i, error[i]);
        combine(w, hand, 0.5, hand, 0, hand, 0, 0);
        return true;
    default:
        return false;
    }
}

struct interval affine_charge(struct forms *w, int i, int k, const double *error, struct interval part)
{
    const struct op *op = &w->known->program->op[i];
    const size_t hand = w->known->program->ops + 2, to = slope_row(w, k ? op->b : op->a);
    if (!w->affine)
        return part;
    if (!charge_form(w, hand, i, k, error))
        forget(w, hand);
    w->range[hand] = part;
    settle(w, hand);
    combine(w, to, 1, to, 1, hand, 0, 0);
    w->range[to] = interval_add(w->range[to], w->range[hand]);
    return w->range[hand];
}

bool affine_narrow(const struct forms *w, int op, int sign, double bound, struct interval *box)
{
    const size_t i = (size_t)op;
    bool cut = false;
    if (!w->affine || !(w->radius[i] < INFINITY))
        return false;
    /* |slope[k]| (1 + sign sign(slope[k]) e_k) >= need, whatever the other e are */
    const double *s = slopes(w, i), size = fabs(bound) + fabs(w->centre[i]) + w->mass[i] + w->radius[i];
    const double need = sign * (bound - w->centre[i]) - w->mass[i] - w->radius[i] - size * ROUND - TINY;
    for (size_t k = 0; k < w->known->variables; k++) {
        const double steep = fabs(s[k]), least = (need + steep) / steep - 1e-9;
        if (!(steep > 1e-200 && least > -1))
            continue;
        /* of the box that was evaluated, ignoring later cuts, and as far as the variable is known to lie in it */
        const double reduced = below(w->half[k] * (least - 1e-9));
        if (sign * s[k] > 0)
            box[k].lo = greater(box[k].lo, below(w->middle[k] + reduced));
        else
            box[k].hi = lesser(box[k].hi, above(w->middle[k] - reduced));
        cut = true;
    }
    return cut;
}
