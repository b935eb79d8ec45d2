/* Evaluation of a program at a point; see evaluate.h. */
#include "evaluate.h"

#include "../genome/gene_value.h"
#include "../graph/unary.h"

#include <math.h>
#include <mpfr.h>
#include <stdlib.h>

enum { FIRST_BITS = 128, MOST_BITS = 2048, GOOD_BITS = 64, MOST_RATIONAL_BITS = 1 << 14, MOST_EXPONENT = 20000 };

/* ---- double ---- */

/* Returns the number of `bits` bits nearest to q, rounded again if it is subnormal. */
static double nearest(const fmpq *q, int bits)
{
    mpfr_t x;
    mpfr_init2(x, bits);
    fmpq_get_mpfr(x, q, MPFR_RNDN);
    const double d = mpfr_get_d(x, MPFR_RNDN);
    mpfr_clear(x);
    return d;
}

double double_nearest(const fmpq *q)
{
    return nearest(q, 53);
}

float single_nearest(const fmpq *q)
{
    return (float)nearest(q, 24);
}

static double nearest_integer(const fmpz *z)
{
    fmpq_t q;
    fmpq_init(q);
    fmpz_set(fmpq_numref(q), z);
    const double d = double_nearest(q);
    fmpq_clear(q);
    return d;
}

void double_rational(fmpq *q, double x)
{
    arf_t y;
    arf_init(y);
    arf_set_d(y, x);
    arf_get_fmpq(q, y);
    arf_clear(y);
}

double point_constant(const struct program *p, const struct op *op, double *error)
{
    const fmpq *q = &p->constant[op->input];
    const double d =
        op->quotient ? nearest_integer(fmpq_numref(q)) / nearest_integer(fmpq_denref(q)) : double_nearest(q);
    fmpq_t rest;
    mpfr_t x;
    fmpq_init(rest);
    mpfr_init2(x, 53);
    double_rational(rest, d);
    fmpq_sub(rest, rest, q);
    fmpq_abs(rest, rest);
    fmpq_get_mpfr(x, rest, MPFR_RNDU);
    *error = mpfr_get_d(x, MPFR_RNDU);
    mpfr_clear(x);
    fmpq_clear(rest);
    return d;
}

/* Returns a + sign b; with `contract`, a product may be fused with the sum. */
static double sum(const struct program *p, const double *v, const struct op *op, double sign, uint64_t *contract)
{
    const struct op *a = &p->op[op->a], *b = &p->op[op->b];
    const uint64_t choice = contract ? random_next(contract) % 3 : 0;
    if (choice == 1 && a->kind == OP_MUL)
        return fma(v[a->a], v[a->b], sign * v[op->b]);
    if (choice == 2 && b->kind == OP_MUL)
        return fma(sign * v[b->a], v[b->b], v[op->a]);
    return v[op->a] + sign * v[op->b];
}

void point_constants(const struct program *p, double *value)
{
    double error;
    for (size_t i = 0; i < p->ops; i++)
        if (p->op[i].kind == OP_CONSTANT)
            value[i] = point_constant(p, &p->op[i], &error);
}

double point_operation(enum op_kind kind, double a, double b)
{
#define OPERATION(name, ...) [OP_##name] = GENE_##name,
    static const int gene[OP_KINDS] = {GENES_OF_TWO(OPERATION) GENES_OF_ONE(OPERATION)};
    return gene_value(gene[kind], a, b);
}

void point_double(const struct program *p, const double *input, uint64_t *contract, double *value)
{
    double *v = value;
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *op = &p->op[i];
        if (op->kind == OP_INPUT)
            v[i] = input[op->input];
        else if (op->kind == OP_ADD || op->kind == OP_SUB)
            v[i] = sum(p, v, op, op->kind == OP_ADD ? 1 : -1, contract);
        else if (op->kind != OP_CONSTANT)
            v[i] = point_operation(op->kind, v[op->a], op->b >= 0 ? v[op->b] : 0);
    }
}

/* ---- balls ---- */

/* UNDEFINED: at any precision. */
enum outcome { GOOD, BLURRED, UNDEFINED };

static enum outcome quotient(arb_t x, const arb_t a, const arb_t b, bool protected_zero, long bits)
{
    if (arb_is_zero(b)) {
        arb_one(x);
        return protected_zero ? GOOD : UNDEFINED;
    }
    arb_div(x, a, b, bits);
    return arb_contains_zero(b) ? BLURRED : GOOD;
}

static enum outcome function(unsigned k, arb_t x, const arb_t a, long bits)
{
    unary_ball(k, x, a, bits);
    return arb_is_finite(x) ? GOOD : arb_is_negative(a) && !unary_of[k].negative ? UNDEFINED : BLURRED;
}

static enum outcome evaluate(const struct program *p, const struct op *op, const double *input, arb_ptr v, arb_t x,
                             long bits)
{
    arb_srcptr a = op->a >= 0 ? v + op->a : x, b = op->b >= 0 ? v + op->b : x;
    switch (op->kind) {
    case OP_CONSTANT:
        arb_set_fmpq(x, &p->constant[op->input], bits);
        break;
    case OP_INPUT:
        arb_set_d(x, input[op->input]);
        break;
    case OP_NEG:
        arb_neg(x, a);
        break;
    case OP_ADD:
        arb_add(x, a, b, bits);
        break;
    case OP_SUB:
        arb_sub(x, a, b, bits);
        break;
    case OP_MUL:
        arb_mul(x, a, b, bits);
        break;
    case OP_DIV:
    case OP_PDIV:
        return quotient(x, a, b, op->kind == OP_PDIV, bits);
    case OP_MIN:
        arb_min(x, a, b, bits);
        break;
    case OP_MAX:
        arb_max(x, a, b, bits);
        break;
    default:
        return function(op->kind - OP_UNARY, x, a, bits);
    }
    return GOOD;
}

/* Returns true for numbers far outside the range of double, which grow at every squaring and are given up. */
static bool is_extreme(const arb_t x)
{
    arf_srcptr m = arb_midref(x);
    return !arb_is_finite(x) ||
           (!arf_is_zero(m) && (arf_cmpabs_2exp_si(m, MOST_EXPONENT) > 0 || arf_cmpabs_2exp_si(m, -MOST_EXPONENT) < 0));
}

static enum outcome evaluate_all(const struct program *p, const double *input, arb_ptr v, long bits)
{
    for (size_t i = 0; i < p->ops; i++) {
        const enum outcome outcome = evaluate(p, &p->op[i], input, v, v + i, bits);
        if (outcome != GOOD)
            return outcome;
        if (is_extreme(v + i))
            return UNDEFINED;
    }
    return GOOD;
}

/* ---- rationals ---- */

static bool evaluate_rational(const struct program *p, const struct op *op, const fmpq *input, const fmpq *v, fmpq *x)
{
    const fmpq *a = op->a >= 0 ? &v[op->a] : x, *b = op->b >= 0 ? &v[op->b] : x;
    switch (op->kind) {
    case OP_CONSTANT:
        fmpq_set(x, &p->constant[op->input]);
        break;
    case OP_INPUT:
        fmpq_set(x, &input[op->input]);
        break;
    case OP_NEG:
        fmpq_neg(x, a);
        break;
    case OP_ADD:
        fmpq_add(x, a, b);
        break;
    case OP_SUB:
        fmpq_sub(x, a, b);
        break;
    case OP_MUL:
        fmpq_mul(x, a, b);
        break;
    case OP_DIV:
    case OP_PDIV:
        if (!fmpq_is_zero(b))
            fmpq_div(x, a, b);
        else if (op->kind == OP_DIV)
            return false;
        else
            fmpq_one(x);
        break;
    case OP_MIN:
        fmpq_set(x, fmpq_cmp(a, b) < 0 ? a : b);
        break;
    case OP_MAX:
        fmpq_set(x, fmpq_cmp(a, b) > 0 ? a : b);
        break;
    default:
        if (!unary_exact(op->kind - OP_UNARY, x, a))
            return false;
    }
    return fmpq_height_bits(x) <= MOST_RATIONAL_BITS;
}

void point_rational(const struct program *p, size_t ops, const fmpq *input, fmpq *value, bool *defined)
{
    for (size_t i = 0; i < ops; i++) {
        const struct op *op = &p->op[i];
        defined[i] = (op->a < 0 || defined[op->a]) && (op->b < 0 || defined[op->b]) &&
                     evaluate_rational(p, op, input, value, &value[i]);
    }
}

/* ---- exact values ---- */

/* Evaluates in exact rationals, for values that no precision separates from 0. */
static bool rational_outputs(const struct program *p, const double *input, arb_ptr output)
{
    fmpq *point = _fmpq_vec_init((slong)p->inputs), *value = _fmpq_vec_init((slong)p->ops);
    bool good = true, *defined = new_array(p->ops, sizeof *defined);
    for (size_t i = 0; i < p->inputs; i++)
        double_rational(&point[i], input[i]);
    point_rational(p, p->ops, point, value, defined);
    for (size_t i = 0; i < p->outputs; i++) {
        good = good && defined[p->output[i]];
        arb_set_fmpq(output + i, &value[p->output[i]], FIRST_BITS);
    }
    _fmpq_vec_clear(point, (slong)p->inputs);
    _fmpq_vec_clear(value, (slong)p->ops);
    free(defined);
    return good;
}

bool point_exact(const struct program *p, const double *input, arb_ptr output)
{
    arb_ptr v = _arb_vec_init((slong)p->ops);
    enum outcome outcome = BLURRED;
    for (long bits = FIRST_BITS; outcome == BLURRED && bits <= MOST_BITS; bits *= 2) {
        outcome = evaluate_all(p, input, v, bits);
        for (size_t i = 0; outcome == GOOD && i < p->outputs; i++) {
            arb_set(output + i, v + p->output[i]);
            if (!arb_is_exact(output + i) && arb_rel_accuracy_bits(output + i) < GOOD_BITS)
                outcome = BLURRED;
        }
    }
    _arb_vec_clear(v, (slong)p->ops);
    return outcome == GOOD || (outcome == BLURRED && rational_outputs(p, input, output));
}

bool ball_nearest(const arb_t x, double *nearest)
{
    arf_t end;
    arf_init(end);
    arb_get_lbound_arf(end, x, FIRST_BITS);
    *nearest = arf_get_d(end, ARF_RND_NEAR);
    arb_get_ubound_arf(end, x, FIRST_BITS);
    const bool certain = arf_get_d(end, ARF_RND_NEAR) == *nearest;
    arf_clear(end);
    return certain;
}
