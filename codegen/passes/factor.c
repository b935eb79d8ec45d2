/* Factoring over the rationals, with FLINT. Equal factors of a numerator and its denominator become equal nodes and
 * cancel, so this also reduces quotients to lowest terms. An irreducible sum may still have parts without a common
 * variable that factor, or that factor up to a constant: (a + b)^2 + (c - d + 1)^2 - 3. See expand.h. */
#include "expand.h"

#include "../graph/rewrite.h"

#include <flint/fmpq_mpoly_factor.h>
#include <stdlib.h>

/* Larger polynomials are not tried, because FLINT's time would be unbounded. */
enum {
    MOST_TERMS = 400,
    MOST_VARIABLES = 24,
    MOST_DENSE = 200000,
    MOST_TRIED = 10000 /* terms in all */
};

struct factoring {
    struct walk walk;
    size_t tried; /* terms of the polynomials tried */
};

struct polynomial {
    fmpq_mpoly_ctx_t ring;
    fmpq_mpoly_t p;
    int variable[MOST_VARIABLES]; /* its nodes */
    unsigned long power[MOST_VARIABLES], degree[MOST_VARIABLES];
    slong variables;
};

static slong variable_of(struct polynomial *a, int node)
{
    slong i = 0;
    while (i < a->variables && a->variable[i] != node)
        i++;
    if (i == a->variables && i < MOST_VARIABLES) {
        a->variable[i] = node;
        a->degree[i] = 0;
        a->variables++;
    }
    return i;
}

/* Computes the exponents of a term; returns false if there are too many variables. */
static bool term_powers(struct polynomial *a, const struct dag *g, int node)
{
    const struct node *n = &g->node[node];
    const struct edge self = {ONE, node, 1};
    const bool product = n->kind == NODE_PRODUCT;
    const struct edge *e = product ? n->edge : &self;
    for (slong i = 0; i < MOST_VARIABLES; i++)
        a->power[i] = 0;
    for (size_t k = 0; node != 0 && k < (product ? n->edges : 1); k++) {
        const slong i = variable_of(a, e[k].node);
        if (i == MOST_VARIABLES)
            return false;
        a->power[i] = (unsigned long)e[k].power;
        if (a->degree[i] < a->power[i])
            a->degree[i] = a->power[i];
    }
    return true;
}

static bool worth_trying(struct factoring *f, struct polynomial *a, const struct edges *sum)
{
    double dense = 1;
    a->variables = 0;
    f->tried += sum->n;
    if (sum->n > MOST_TERMS || f->tried > MOST_TRIED)
        return false;
    for (size_t i = 0; i < sum->n; i++)
        if (!term_powers(a, f->walk.to, sum->edge[i].node))
            return false;
    for (slong i = 0; i < a->variables; i++)
        dense *= (double)a->degree[i] + 1;
    return a->variables > 0 && dense <= MOST_DENSE;
}

static bool split_sum(struct factoring *f, const struct edges *sum, struct value *v);

static struct value polynomial_value(struct factoring *f, struct polynomial *a, const fmpq_mpoly_t p)
{
    struct edges terms = {0};
    fmpq_t c;
    fmpq_init(c);
    for (slong i = 0; i < fmpq_mpoly_length(p, a->ring); i++) {
        struct edges factors = {0};
        fmpq_mpoly_get_term_coeff_fmpq(c, p, i, a->ring);
        fmpq_mpoly_get_term_exp_ui(a->power, p, i, a->ring);
        for (slong k = 0; k < a->variables; k++)
            if (a->power[k] > 0)
                edges_add(&factors, ONE, a->variable[k], (int)a->power[k]);
        const struct value v = dag_product(f->walk.to, rational_intern(c), &factors);
        edges_add(&terms, v.coef, v.node, 1);
    }
    fmpq_clear(c);
    struct value sum;
    if (!split_sum(f, &terms, &sum))
        return dag_sum(f->walk.to, &terms);
    edges_clear(&terms);
    return sum;
}

/* Returns the product of the factors found. */
static struct value product_value(struct factoring *f, struct polynomial *a, const fmpq_mpoly_factor_t found)
{
    struct edges factors = {0};
    fmpq_mpoly_t base;
    fmpq_t c;
    fmpq_init(c);
    fmpq_mpoly_init(base, a->ring);
    fmpq_mpoly_factor_get_constant_fmpq(c, found, a->ring);
    rational coef = rational_intern(c);
    for (slong i = 0; i < fmpq_mpoly_factor_length(found, a->ring); i++) {
        const int power = (int)fmpq_mpoly_factor_get_exp_si((fmpq_mpoly_factor_struct *)found, i, a->ring);
        fmpq_mpoly_factor_get_base(base, found, i, a->ring);
        const struct value v = polynomial_value(f, a, base);
        coef = rational_mul(coef, rational_pow(v.coef, power));
        edges_add(&factors, ONE, v.node, power);
    }
    fmpq_mpoly_clear(base, a->ring);
    fmpq_clear(c);
    return dag_product(f->walk.to, coef, &factors);
}

/* Creates a polynomial, with its variables known; close_polynomial frees it. */
static void open_polynomial(struct polynomial *a, const struct dag *g, const struct edges *sum)
{
    fmpq_mpoly_ctx_init(a->ring, a->variables, ORD_LEX);
    fmpq_mpoly_init(a->p, a->ring);
    for (size_t i = 0; i < sum->n; i++) {
        term_powers(a, g, sum->edge[i].node);
        fmpq_mpoly_push_term_fmpq_ui(a->p, rational_value(sum->edge[i].coef), a->power, a->ring);
    }
    fmpq_mpoly_sort_terms(a->p, a->ring);
    fmpq_mpoly_combine_like_terms(a->p, a->ring);
}

static void close_polynomial(struct polynomial *a)
{
    fmpq_mpoly_clear(a->p, a->ring);
    fmpq_mpoly_ctx_clear(a->ring);
}

/* Factors the polynomial; returns false if it is irreducible. */
static bool factor_polynomial(struct factoring *f, struct polynomial *a, struct value *v)
{
    fmpq_mpoly_factor_t found;
    fmpq_mpoly_factor_init(found, a->ring);
    bool several = !fmpq_mpoly_is_zero(a->p, a->ring) && fmpq_mpoly_factor(found, a->p, a->ring);
    const slong n = several ? fmpq_mpoly_factor_length(found, a->ring) : 0;
    several = n > 1 || (n == 1 && fmpq_mpoly_factor_get_exp_si(found, 0, a->ring) > 1);
    if (several)
        *v = product_value(f, a, found);
    fmpq_mpoly_factor_clear(found, a->ring);
    return several;
}

/* Factors a sum; returns false also if it is too large. */
static bool factor_sum(struct factoring *f, const struct edges *sum, struct value *v)
{
    struct polynomial a;
    if (!worth_trying(f, &a, sum))
        return false;
    open_polynomial(&a, f->walk.to, sum);
    const bool several = factor_polynomial(f, &a, v);
    close_polynomial(&a);
    return several;
}

/* Computes the greatest common divisor of the derivatives. */
static void common_slope(struct polynomial *a, fmpq_mpoly_t slope)
{
    fmpq_mpoly_t derivative;
    fmpq_mpoly_init(derivative, a->ring);
    for (slong k = 0; k < a->variables && !fmpq_mpoly_is_one(slope, a->ring); k++) {
        fmpq_mpoly_derivative(derivative, a->p, k, a->ring);
        fmpq_mpoly_gcd(slope, slope, derivative, a->ring);
    }
    fmpq_mpoly_clear(derivative, a->ring);
}

/* Finds the constant to subtract so that p becomes divisible by a power of q, the common divisor of its derivatives.
 * Returns false if it is 0. */
static bool find_constant(struct polynomial *a, const fmpq_mpoly_t q, fmpq_t constant)
{
    fmpq_mpoly_t quotient, rest;
    fmpq_mpoly_init(quotient, a->ring);
    fmpq_mpoly_init(rest, a->ring);
    fmpq_mpoly_divrem(quotient, rest, a->p, q, a->ring);
    const bool found = fmpq_mpoly_is_fmpq(rest, a->ring) && !fmpq_mpoly_is_zero(rest, a->ring);
    if (found)
        fmpq_mpoly_get_fmpq(constant, rest, a->ring);
    fmpq_mpoly_clear(quotient, a->ring);
    fmpq_mpoly_clear(rest, a->ring);
    return found;
}

/* Writes the sum as a product, with a power of a sum, plus a constant. Where q vanishes to second order, all
 * derivatives vanish, so p is constant. */
static bool shift_sum(struct factoring *f, const struct edges *sum, struct value *v, rational *shift)
{
    struct polynomial a;
    fmpq_mpoly_t slope, q;
    fmpq_mpoly_factor_t found;
    fmpq_t constant;
    if (!worth_trying(f, &a, sum))
        return false;
    open_polynomial(&a, f->walk.to, sum);
    fmpq_mpoly_init(slope, a.ring);
    fmpq_mpoly_init(q, a.ring);
    fmpq_mpoly_factor_init(found, a.ring);
    fmpq_init(constant);
    common_slope(&a, slope);
    bool shifted = !fmpq_mpoly_is_fmpq(slope, a.ring) && fmpq_mpoly_factor(found, slope, a.ring);
    const slong n = shifted ? fmpq_mpoly_factor_length(found, a.ring) : 0;
    shifted = false;
    for (slong i = 0; i < n && !shifted; i++) {
        fmpq_mpoly_factor_get_base(q, found, i, a.ring);
        shifted = fmpq_mpoly_length(q, a.ring) > 1 && find_constant(&a, q, constant);
    }
    if (shifted) {
        *shift = rational_intern(constant);
        fmpq_mpoly_sub_fmpq(a.p, a.p, constant, a.ring);
        shifted = factor_polynomial(f, &a, v);
    }
    fmpq_clear(constant);
    fmpq_mpoly_factor_clear(found, a.ring);
    fmpq_mpoly_clear(q, a.ring);
    fmpq_mpoly_clear(slope, a.ring);
    close_polynomial(&a);
    return shifted;
}

/* Returns the representative of the variables that terms connect with variable i. */
static slong root_of(const slong *parent, slong i)
{
    while (parent[i] != i)
        i = parent[i];
    return i;
}

/* Sets part[i] to a variable of the part to which term i belongs, -1 for a constant. */
static void find_parts(struct polynomial *a, const struct dag *g, const struct edges *sum, slong *part)
{
    slong parent[MOST_VARIABLES];
    for (slong k = 0; k < a->variables; k++)
        parent[k] = k;
    for (size_t i = 0; i < sum->n; i++) {
        term_powers(a, g, sum->edge[i].node);
        part[i] = -1;
        for (slong k = 0; k < a->variables; k++)
            if (a->power[k] > 0) {
                part[i] = part[i] < 0 ? k : part[i];
                parent[root_of(parent, k)] = root_of(parent, part[i]);
            }
    }
    for (size_t i = 0; i < sum->n; i++)
        part[i] = part[i] < 0 ? -1 : root_of(parent, part[i]);
}

/* Returns true if the product of a sum of this many terms pays: two of its factors are sums, or they are shorter
 * together. Otherwise Horner's rule decides. */
static bool pays(const struct dag *g, int node, size_t terms)
{
    const struct node *n = &g->node[node];
    int sums = 0;
    size_t left = 0;
    for (size_t i = 0; n->kind == NODE_PRODUCT && i < n->edges; i++)
        if (g->node[n->edge[i].node].kind == NODE_SUM) {
            sums += n->edge[i].power;
            left += g->node[n->edge[i].node].edges;
        }
    return sums > 1 || (sums == 1 && left < terms);
}

/* Collects powers of variable k: each coefficient times the power, as a product if it factors into several sums.
 * Returns how many terms went into products. */
static size_t collect_powers(struct factoring *f, struct polynomial *a, const struct edges *sum, slong k,
                             struct edges *all)
{
    size_t factored = 0;
    for (unsigned long power = 0; power <= a->degree[k]; power++) {
        struct edges own = {0};
        struct value product;
        for (size_t i = 0; i < sum->n; i++) {
            term_powers(a, f->walk.to, sum->edge[i].node);
            if (a->power[k] == power)
                edges_add(&own, sum->edge[i].coef, sum->edge[i].node, 1);
        }
        const bool found = own.n > 2 && factor_sum(f, &own, &product) && pays(f->walk.to, product.node, own.n);
        if (found)
            edges_add(all, product.coef, product.node, 1);
        for (size_t i = 0; !found && i < own.n; i++)
            edges_add(all, own.edge[i].coef, own.edge[i].node, 1);
        factored += found ? own.n : 0;
        edges_clear(&own);
    }
    return factored;
}

/* Collects the sum by powers of the variable that brings most terms into products; returns false if none does. */
static bool collect_sum(struct factoring *f, const struct edges *sum, struct edges *all)
{
    struct polynomial a;
    size_t most = 0;
    if (!worth_trying(f, &a, sum))
        return false;
    for (slong k = 0; k < a.variables; k++) {
        struct edges trial = {0};
        const size_t factored = collect_powers(f, &a, sum, k, &trial);
        if (factored > most) {
            most = factored;
            const struct edges swap = *all;
            *all = trial;
            trial = swap;
        }
        edges_clear(&trial);
    }
    return most > 0;
}

/* Adds a part of a sum: as a product, possibly plus a constant, or as its terms. Returns whether it is a product. */
static bool add_part(struct factoring *f, const struct edges *part, bool whole, struct edges *all)
{
    struct value product;
    rational shift = ZERO;
    const bool found =
        part->n > 2 && ((!whole && factor_sum(f, part, &product) && pays(f->walk.to, product.node, part->n)) ||
                        shift_sum(f, part, &product, &shift));
    if (found) {
        edges_add(all, product.coef, product.node, 1);
        if (shift != ZERO)
            edges_add(all, shift, 0, 1);
    }
    struct edges collected = {0};
    const bool parts = !found && part->n > 3 && collect_sum(f, part, &collected);
    const struct edges *terms = parts ? &collected : part;
    for (size_t i = 0; !found && i < terms->n; i++)
        edges_add(all, terms->edge[i].coef, terms->edge[i].node, 1);
    edges_clear(&collected);
    return found || parts;
}

/* Splits an irreducible sum into parts without a common variable; returns false if no part factors. */
static bool split_sum(struct factoring *f, const struct edges *sum, struct value *v)
{
    struct polynomial a;
    struct edges all = {0};
    slong *part = new_array(sum->n, sizeof *part);
    bool factored = false;
    const bool small = worth_trying(f, &a, sum);
    if (small)
        find_parts(&a, f->walk.to, sum, part);
    for (slong k = -1; small && k < a.variables; k++) {
        struct edges own = {0};
        for (size_t i = 0; i < sum->n; i++)
            if (part[i] == k)
                edges_add(&own, sum->edge[i].coef, sum->edge[i].node, 1);
        factored |= add_part(f, &own, own.n == sum->n, &all);
        edges_clear(&own);
    }
    free(part);
    if (factored)
        *v = dag_sum(f->walk.to, &all);
    edges_clear(&all);
    return factored;
}

struct dag *shape_factor(const struct dag *g)
{
    struct factoring f = {.walk = walk_begin(g)};
    struct walk *w = &f.walk;
    size_t factored = 0;
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        struct edges sum = {0};
        if (w->uses[n] == 0)
            continue;
        for (size_t i = 0; node->kind == NODE_SUM && i < node->edges; i++) {
            const struct value v = walk_image(w, &node->edge[i]);
            edges_add(&sum, v.coef, v.node, 1);
        }
        const bool found = sum.n > 0 && (factor_sum(&f, &sum, &w->image[n]) || split_sum(&f, &sum, &w->image[n]));
        if (!found)
            w->image[n] = walk_map(w, node);
        w->to->node[w->image[n].node].kept |= node->kept;
        factored += found;
        edges_clear(&sum);
    }
    struct dag *made = walk_end(w);
    if (factored > 0)
        return made;
    dag_free(made);
    return NULL;
}
