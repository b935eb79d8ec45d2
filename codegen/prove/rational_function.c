/* Products of powers of polynomials; see rational_function.h. */
#include "rational_function.h"

#include "../base/base.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_BASES = 4096, MOST_BITS = 1 << 13 };

static const slong most_exponent = WORD_MAX / 4;
static const double most_work =
    2e7; /* words of all products before like terms are collected: some tenths of a second */

void ring_init(struct ring *g, slong variables)
{
    *g = (struct ring){.variables = variables};
    fmpq_mpoly_ctx_init(g->context, variables, ORD_LEX);
    for (slong v = 0; v < variables; v++) {
        grow_array(&g->base, g->bases, &g->base_room, sizeof *g->base);
        fmpz_mpoly_init(&g->base[g->bases], g->context->zctx);
        fmpz_mpoly_gen(&g->base[g->bases++], v, g->context->zctx);
    }
}

void ring_clear(struct ring *g)
{
    for (size_t i = 0; i < g->bases; i++)
        fmpz_mpoly_clear(&g->base[i], g->context->zctx);
    free(g->base);
    fmpq_mpoly_ctx_clear(g->context);
}

void ratio_init(struct ratio *r)
{
    *r = (struct ratio){0};
    fmpq_init(r->content);
}

void ratio_clear(struct ratio *r)
{
    fmpq_clear(r->content);
    free(r->power);
}

static void push(struct ratio *r, size_t base, slong exponent)
{
    if (exponent == 0)
        return;
    APPEND(r->power, r->n, r->room) = (struct power){base, exponent};
}

void ratio_set(struct ratio *r, const struct ratio *a)
{
    fmpq_set(r->content, a->content);
    r->n = 0;
    for (size_t i = 0; i < a->n; i++)
        push(r, a->power[i].base, a->power[i].exponent);
}

void ratio_set_rational(struct ratio *r, const fmpq *q)
{
    fmpq_set(r->content, q);
    r->n = 0;
}

void ratio_set_variable(struct ratio *r, slong variable)
{
    fmpq_one(r->content);
    r->n = 0;
    push(r, (size_t)variable, 1);
}

slong ratio_set_new_variable(struct ring *g, struct ratio *r)
{
    if (g->used == g->variables) {
        g->stopped = true;
        return 0;
    }
    ratio_set_variable(r, g->used);
    return g->used++;
}

/* ---- products ---- */

static void spend(struct ring *g, double work)
{
    g->work += work;
    g->stopped |= g->work > most_work;
}

static void spend_rational(struct ring *g, const fmpq *q)
{
    spend(g, (double)fmpq_height_bits(q));
    g->stopped |= fmpq_height_bits(q) > MOST_BITS;
}

/* Iterates over the exponents of both by base; returns false at the end. */
struct merge {
    const struct ratio *a, *b;
    size_t i, j;
    size_t base;
    slong first, second;
};

static bool next_base(struct merge *m)
{
    const size_t x = m->i < m->a->n ? m->a->power[m->i].base : SIZE_MAX;
    const size_t y = m->j < m->b->n ? m->b->power[m->j].base : SIZE_MAX;
    m->base = x < y ? x : y;
    m->first = x == m->base && x != SIZE_MAX ? m->a->power[m->i++].exponent : 0;
    m->second = y == m->base && y != SIZE_MAX ? m->b->power[m->j++].exponent : 0;
    return m->base != SIZE_MAX;
}

void ratio_multiply(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool divide)
{
    r->n = 0;
    if (divide && ratio_is_zero(b)) {
        g->stopped = true;
        return;
    }
    if (divide)
        fmpq_div(r->content, a->content, b->content);
    else
        fmpq_mul(r->content, a->content, b->content);
    spend_rational(g, r->content);
    spend(g, (double)(a->n + b->n));
    for (struct merge m = {.a = a, .b = b}; !fmpq_is_zero(r->content) && next_base(&m);) {
        const slong exponent = divide ? m.first - m.second : m.first + m.second;
        push(r, m.base, exponent);
        g->stopped |= labs(exponent) > most_exponent;
    }
}

/* ---- polynomials ---- */

/* Computes a *= b if the work limit allows. */
static void multiply_out(struct ring *g, fmpz_mpoly_struct *a, const fmpz_mpoly_struct *b)
{
    const slong bits = labs(fmpz_mpoly_max_bits(a)) + labs(fmpz_mpoly_max_bits(b));
    const slong exponent = (slong)(a->bits > b->bits ? a->bits : b->bits);
    spend(g, (double)a->length * (double)b->length * (1 + (double)(bits + exponent * g->variables) / FLINT_BITS));
    g->stopped |= bits > MOST_BITS;
    if (!g->stopped)
        fmpz_mpoly_mul(a, a, b, g->context->zctx);
}

static void multiply_power(struct ring *g, fmpz_mpoly_struct *a, size_t base, slong exponent)
{
    const fmpz_mpoly_struct *b = &g->base[base];
    fmpz_mpoly_t power;
    if (b->length == 1 && exponent > 1) {
        fmpz_mpoly_init(power, g->context->zctx);
        fmpz_mpoly_pow_ui(power, b, (ulong)exponent, g->context->zctx);
        multiply_out(g, a, power);
        fmpz_mpoly_clear(power, g->context->zctx);
    } else
        for (slong k = 0; k < exponent && !g->stopped; k++)
            multiply_out(g, a, b);
}

/* Returns the index of a primitive polynomial among the bases, adding it if new. */
static size_t find_base(struct ring *g, const fmpz_mpoly_struct *a)
{
    spend(g, (double)g->bases / 8);
    for (size_t i = 0; i < g->bases; i++)
        if (g->base[i].length == a->length && fmpz_mpoly_equal(&g->base[i], a, g->context->zctx))
            return i;
    g->stopped |= g->bases == MOST_BASES;
    grow_array(&g->base, g->bases, &g->base_room, sizeof *g->base);
    fmpz_mpoly_init(&g->base[g->bases], g->context->zctx);
    fmpz_mpoly_set(&g->base[g->bases], a, g->context->zctx);
    return g->bases++;
}

/* Sets r to a polynomial. The variables that divide all its terms, and the rest, become bases. */
static void set_polynomial(struct ring *g, struct ratio *r, fmpq_mpoly_struct *a)
{
    const fmpz_mpoly_ctx_struct *zctx = g->context->zctx;
    fmpz_mpoly_t monomial;
    r->n = 0;
    fmpq_set(r->content, a->content);
    spend_rational(g, r->content);
    g->stopped |= !fmpz_mpoly_degrees_fit_si(a->zpoly, zctx);
    if (g->stopped || fmpq_is_zero(r->content))
        return;
    fmpz_mpoly_init(monomial, zctx);
    fmpz_mpoly_term_content(monomial, a->zpoly, zctx);
    fmpz_mpoly_divides(a->zpoly, a->zpoly, monomial, zctx);
    for (slong v = 0; v < g->variables; v++)
        push(r, (size_t)v, fmpz_mpoly_degree_si(monomial, v, zctx));
    if (!fmpz_mpoly_is_one(a->zpoly, zctx))
        push(r, find_base(g, a->zpoly), 1);
    fmpz_mpoly_clear(monomial, zctx);
}

/* Splits the polynomials of a and b: common factors go to `common`, the rest, multiplied out, to `first` and
 * `second`. */
static void split(struct ring *g, const struct ratio *a, const struct ratio *b, struct ratio *common,
                  fmpq_mpoly_struct *first, fmpq_mpoly_struct *second)
{
    fmpq_one(common->content);
    fmpq_mpoly_one(first, g->context);
    fmpq_mpoly_one(second, g->context);
    for (struct merge m = {.a = a, .b = b}; !g->stopped && next_base(&m);) {
        const slong least = m.first < m.second ? m.first : m.second;
        push(common, m.base, least);
        multiply_power(g, first->zpoly, m.base, m.first - least);
        multiply_power(g, second->zpoly, m.base, m.second - least);
    }
}

void ratio_add(struct ring *g, struct ratio *r, const struct ratio *a, const struct ratio *b, bool subtract)
{
    struct ratio common, sum;
    fmpq_mpoly_t first, second;
    if (ratio_is_zero(a) || ratio_is_zero(b)) {
        ratio_set(r, ratio_is_zero(a) ? b : a);
        if (subtract && ratio_is_zero(a))
            fmpq_neg(r->content, r->content);
        return;
    }
    fmpq_mpoly_init(first, g->context);
    fmpq_mpoly_init(second, g->context);
    ratio_init(&common);
    ratio_init(&sum);
    split(g, a, b, &common, first, second);
    spend(g, (double)(first->zpoly->length + second->zpoly->length) * (double)(1 + g->variables / 8));
    if (!g->stopped) {
        fmpq_set(first->content, a->content);
        fmpq_set(second->content, b->content);
        if (subtract)
            fmpq_mpoly_sub(first, first, second, g->context);
        else
            fmpq_mpoly_add(first, first, second, g->context);
        set_polynomial(g, &sum, first);
        ratio_multiply(g, r, &common, &sum, false);
    }
    ratio_clear(&common);
    ratio_clear(&sum);
    fmpq_mpoly_clear(first, g->context);
    fmpq_mpoly_clear(second, g->context);
}

bool ratio_is_zero(const struct ratio *r)
{
    return fmpq_is_zero(r->content);
}

bool ratio_proportional(struct ring *g, const struct ratio *a, const struct ratio *b)
{
    struct ratio common;
    fmpq_mpoly_t first, second;
    if (a->n == b->n && (a->n == 0 || memcmp(a->power, b->power, a->n * sizeof *a->power) == 0))
        return true;
    fmpq_mpoly_init(first, g->context);
    fmpq_mpoly_init(second, g->context);
    ratio_init(&common);
    split(g, a, b, &common, first, second);
    const bool good = !g->stopped && fmpz_mpoly_equal(first->zpoly, second->zpoly, g->context->zctx);
    ratio_clear(&common);
    fmpq_mpoly_clear(first, g->context);
    fmpq_mpoly_clear(second, g->context);
    return good;
}

/* Returns true if a = b. Contents decide between proportional values, because products of primitive polynomials with
 * positive leading coefficients are also primitive. */
bool ratio_equal(struct ring *g, const struct ratio *a, const struct ratio *b)
{
    return fmpq_equal(a->content, b->content) && (ratio_is_zero(a) || ratio_proportional(g, a, b));
}

bool ratio_get_rational(struct ring *g, fmpq *q, const struct ratio *r)
{
    const struct ratio none = {0};
    if (!ratio_is_zero(r) && !ratio_proportional(g, r, &none))
        return false;
    fmpq_set(q, r->content);
    return true;
}

slong ratio_length(const struct ring *g, const struct ratio *r)
{
    slong longest = 1;
    for (size_t i = 0; i < r->n; i++)
        if (g->base[r->power[i].base].length > longest)
            longest = g->base[r->power[i].base].length;
    return longest;
}
