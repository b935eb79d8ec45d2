/* Bounds rounding errors forwards; see rounding.h.
 *
 * Running error analysis: with x the exact and x' the computed value of an operation, |x' - x| <= e and |x' - x| <= r
 * |x|. e is the effect of the operands' errors on the exact result, plus one rounding of at most u |result| + h, with u
 * the unit roundoff and h the smallest number above 0 (for products and quotients; a sum that underflows is exact). A
 * product contracted into a sum is not rounded; the sum's rounding, u |sum| or h, is at most what is counted for both.
 * So the bounds hold with and without contraction. Absolute and relative bounds narrow each other: relative bounds do
 * not depend on how much a quotient's divisor varies over the box, absolute bounds tolerate zeros. */
#include "rounding.h"

#include "../region/enclosure.h"

#define GROW (1 + 0x1p-45) /* exceeds the roundings of the terms of a bound, all positive */

double rounding_power(const struct op *op)
{
    const int root = op_unary(op->kind)->root;
    return root ? 1.0 / root : 0;
}

struct interval rounding_function_slope(const struct op *op, struct interval a)
{
    const struct interval power = interval_point(rounding_power(op));
    return power.lo > 0 ? interval_divide(interval_multiply(function_range(op->kind, a), power), a) : interval_whole();
}

static bool is_exact_zero(const struct rounding *e, int op)
{
    const struct interval x = e->forms->range[op];
    return x.lo == 0 && x.hi == 0 && e->error[op] == 0;
}

/* Returns true for a number without error, such as a constant or a clamped value; not for a result that an enclosure
 * happens to fix. */
static bool is_number(const struct rounding *e, int op)
{
    return e->error[op] == 0 && e->forms->range[op].lo == e->forms->range[op].hi;
}

/* Returns true if the sum or product of two numbers is exact. */
static bool is_exact_result(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    return is_number(e, op->a) && is_number(e, op->b) &&
           result_is_exact(&e->arithmetic, op->kind, e->forms->range[op->a].lo, e->forms->range[op->b].lo);
}

/* Returns true if a sum doubles a number, which is exact unless the number is a contracted product: fma(x, y, x *
 * y). */
static bool is_exact_sum(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const enum op_kind kind = e->forms->known->program->op[op->a].kind;
    return is_exact_zero(e, op->a) || is_exact_zero(e, op->b) || is_exact_result(e, i) ||
           (op->kind == OP_ADD && op->a == op->b && kind != OP_MUL && kind != OP_NEG);
}

/* Returns true if a product is exactly 0: 0 times a value that may overflow is not. */
static bool is_exact_product(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    return (is_exact_zero(e, op->a) && e->error[op->b] < INFINITY) ||
           (is_exact_zero(e, op->b) && e->error[op->a] < INFINITY) || is_exact_result(e, i);
}

static bool is_power_of_two(const struct rounding *e, int op)
{
    const struct interval x = e->forms->range[op];
    int exponent;
    return e->error[op] == 0 && x.lo == x.hi && fabs(frexp(x.lo, &exponent)) == 0.5;
}

static double product_error(const struct rounding *e, size_t i, double most)
{
    const struct op *op = &e->forms->known->program->op[i];
    const struct interval *x = e->forms->range;
    const double ea = e->error[op->a], eb = e->error[op->b];
    const double error =
        (ea > 0 ? ea * (interval_most(x[op->b]) + eb) : 0) + (eb > 0 ? eb * interval_most(x[op->a]) : 0);
    if (is_exact_product(e, i))
        return 0;
    return error + (is_power_of_two(e, op->a) || is_power_of_two(e, op->b) ? e->arithmetic.least
                                                                           : rounding_of_last(e, most + error));
}

/* Uses a'/b' - a/b = (da - (a/b) db) / b'. */
static double quotient_error(const struct rounding *e, const struct op *op, double most)
{
    const double divisor = interval_least(e->forms->range[op->b]) * (1 - lesser(e->relative[op->b], 1)) * (1 - 0x1p-50);
    if (!(divisor > 0))
        return INFINITY;
    const double eb = e->error[op->b], error = (e->error[op->a] + (eb > 0 ? most * eb : 0)) / divisor;
    return error + (is_power_of_two(e, op->b) ? e->arithmetic.least : rounding_of_last(e, most + error));
}

/* Uses sqrt(a') - sqrt(a) = da / (sqrt(a') + sqrt(a)), at most sqrt(|da|). */
static double root_error(const struct rounding *e, const struct op *op, double most)
{
    const double ea = e->error[op->a], lo = e->forms->range[op->a].lo, computed = lo - ea * (1 + 0x1p-50);
    if (!(lo >= 0 && ea <= DBL_MAX) || (computed < 0 && !e->nonnegative[op->a]))
        return INFINITY;
    const double divisor = sqrt(lo) + sqrt(greater(0, computed)), error = ea > 0 ? lesser(sqrt(ea), ea / divisor) : 0;
    return error * (1 + 0x1p-48) + e->arithmetic.unit * (most + error);
}

/* Uses the mean value theorem. */
static double function_error(const struct rounding *e, const struct op *op, double most)
{
    const double ea = e->error[op->a];
    const double error = ea > 0 ? ea * interval_most(rounding_function_slope(op, rounding_inflated(e, op->a))) : 0;
    return error + op_unary(op->kind)->error * e->arithmetic.unit * (most + error) + e->arithmetic.least;
}

/* Returns the error of the chosen operand if the other certainly lies beyond it. */
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
        return is_exact_sum(e, i) ? error : error + e->arithmetic.unit * (most + error);
    }
    case OP_MUL:
        return product_error(e, i, most);
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

/* Returns the relative bound of a product, quotient or root; infinite for other operations. */
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

/* Returns true if the computed value is >= 0, since rounding is monotonic: exact results >= 0 of operands >= 0 stay
 * so. */
static bool is_nonnegative(const struct rounding *e, size_t i)
{
    const struct op *op = &e->forms->known->program->op[i];
    const bool a = op->a >= 0 && e->nonnegative[op->a], b = op->b >= 0 && e->nonnegative[op->b];
    if (rounding_is_given(e->forms->known, (int)i) || op->kind == OP_CONSTANT)
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

/* Returns infinity for NaN, negative numbers, and values that may overflow. */
double rounding_checked(const struct rounding *e, double error, double most)
{
    const double padded = error > 0 ? error * GROW + e->arithmetic.least : error;
    return padded >= 0 && padded + most <= e->arithmetic.most ? padded : INFINITY;
}

void rounding_propagate(struct rounding *e, size_t i)
{
    const struct interval range = e->forms->range[i];
    const double most = interval_most(range), least = interval_least(e->forms->range[i]);
    e->nonnegative[i] = is_nonnegative(e, i);
    if (rounding_is_given(e->forms->known, (int)i)) {
        e->relative[i] = e->arithmetic.given;
        e->error[i] = e->relative[i] > 0 ? rounding_checked(e, e->relative[i] * most, most) : 0;
        return;
    }
    const double error = rounding_checked(e, error_of(e, i), most),
                 relative = rounding_checked(e, relative_error_of(e, i), most);
    e->error[i] = error > 0 ? lesser(error, rounding_checked(e, relative * most, most)) : error;
    e->relative[i] = e->error[i] > 0 ? lesser(relative, rounding_checked(e, e->error[i] / least, 0)) : 0;
}

double rounding_own_share(const struct rounding *e, int i, double *constant)
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
        return is_exact_sum(e, (size_t)i) ? 0 : e->arithmetic.unit;
    case OP_MUL:
        if (is_exact_product(e, (size_t)i))
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
