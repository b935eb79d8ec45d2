/* Factoring over the rationals, with FLINT.  Equal factors of a numerator and of its denominator meet as equal nodes
 * and cancel by themselves; so this is also the reduction of quotients to lowest terms.  What is irreducible may be a
 * sum of parts without a common variable that are not: (a + b)^2 + (c - d)^2.  See shape.h. */
#include "shape.h"

#include "walk.h"

#include <flint/fmpq_mpoly_factor.h>
#include <stdlib.h>

/* Larger polynomials stay as they are: FLINT's time is not bounded otherwise. */
enum { MOST_TERMS = 400, MOST_VARIABLES = 24, MOST_DENSE = 200000 };

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

/* Exponents of one term; false if there are too many variables. */
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

static bool worth_trying(struct polynomial *a, const struct dag *g, const struct edges *sum)
{
    double dense = 1;
    a->variables = 0;
    if (sum->n > MOST_TERMS)
        return false;
    for (size_t i = 0; i < sum->n; i++)
        if (!term_powers(a, g, sum->edge[i].node))
            return false;
    for (slong i = 0; i < a->variables; i++)
        dense *= (double)a->degree[i] + 1;
    return a->variables > 0 && dense <= MOST_DENSE;
}

static bool split_sum(struct dag *to, const struct edges *sum, struct value *v);

static struct value polynomial_value(struct polynomial *a, const fmpq_mpoly_t p, struct dag *to)
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
        const struct value v = dag_product(to, rational_intern(c), &factors);
        edges_add(&terms, v.coef, v.node, 1);
    }
    fmpq_clear(c);
    struct value sum;
    if (!split_sum(to, &terms, &sum))
        return dag_sum(to, &terms);
    edges_clear(&terms);
    return sum;
}

/* Product of the factors found. */
static struct value product_value(struct polynomial *a, const fmpq_mpoly_factor_t found, struct dag *to)
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
        const struct value f = polynomial_value(a, base, to);
        coef = rational_mul(coef, rational_pow(f.coef, power));
        edges_add(&factors, ONE, f.node, power);
    }
    fmpq_mpoly_clear(base, a->ring);
    fmpq_clear(c);
    return dag_product(to, coef, &factors);
}

/* The sum as a product of irreducible polynomials; false if it is one itself, or too large. */
static bool factor_sum(struct dag *to, const struct edges *sum, struct value *v)
{
    struct polynomial a;
    fmpq_mpoly_factor_t found;
    if (!worth_trying(&a, to, sum))
        return false;
    fmpq_mpoly_ctx_init(a.ring, a.variables, ORD_LEX);
    fmpq_mpoly_init(a.p, a.ring);
    fmpq_mpoly_factor_init(found, a.ring);
    for (size_t i = 0; i < sum->n; i++) {
        term_powers(&a, to, sum->edge[i].node);
        fmpq_mpoly_push_term_fmpq_ui(a.p, rational_value(sum->edge[i].coef), a.power, a.ring);
    }
    fmpq_mpoly_sort_terms(a.p, a.ring);
    fmpq_mpoly_combine_like_terms(a.p, a.ring);
    bool several = !fmpq_mpoly_is_zero(a.p, a.ring) && fmpq_mpoly_factor(found, a.p, a.ring);
    const slong n = several ? fmpq_mpoly_factor_length(found, a.ring) : 0;
    several = n > 1 || (n == 1 && fmpq_mpoly_factor_get_exp_si(found, 0, a.ring) > 1);
    if (several)
        *v = product_value(&a, found, to);
    fmpq_mpoly_factor_clear(found, a.ring);
    fmpq_mpoly_clear(a.p, a.ring);
    fmpq_mpoly_ctx_clear(a.ring);
    return several;
}

/* The first of the variables that term after term connects with variable i. */
static slong root_of(const slong *parent, slong i)
{
    while (parent[i] != i)
        i = parent[i];
    return i;
}

/* part[i]: the part that term i belongs to, -1 for a constant; returns false if all terms hang together. */
static bool find_parts(struct polynomial *a, const struct dag *g, const struct edges *sum, slong *part)
{
    slong parent[MOST_VARIABLES], parts = 0;
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
    for (slong k = 0; k < a->variables; k++)
        parts += parent[k] == k;
    for (size_t i = 0; i < sum->n; i++)
        part[i] = part[i] < 0 ? -1 : root_of(parent, part[i]);
    return parts > 1;
}

/* A factor is a power of a sum: others are Horner's choice. */
static bool has_power(const struct dag *g, int node)
{
    const struct node *n = &g->node[node];
    bool power = false;
    for (size_t i = 0; n->kind == NODE_PRODUCT && i < n->edges; i++)
        power |= g->node[n->edge[i].node].kind == NODE_SUM && n->edge[i].power > 1;
    return power;
}

/* The sum as one of parts without a common variable, some of which factor; false if none does. */
static bool split_sum(struct dag *to, const struct edges *sum, struct value *v)
{
    struct polynomial a;
    struct edges all = {0};
    slong *part = new_array(sum->n, sizeof *part);
    bool factored = false;
    if (worth_trying(&a, to, sum) && find_parts(&a, to, sum, part))
        for (slong k = -1; k < a.variables; k++) {
            struct edges own = {0};
            struct value product;
            for (size_t i = 0; i < sum->n; i++)
                if (part[i] == k)
                    edges_add(&own, sum->edge[i].coef, sum->edge[i].node, 1);
            const bool found = own.n > 2 && factor_sum(to, &own, &product) && has_power(to, product.node);
            for (size_t i = 0; !found && i < own.n; i++)
                edges_add(&all, own.edge[i].coef, own.edge[i].node, 1);
            if (found)
                edges_add(&all, product.coef, product.node, 1);
            factored |= found;
            edges_clear(&own);
        }
    free(part);
    if (factored)
        *v = dag_sum(to, &all);
    edges_clear(&all);
    return factored;
}

struct dag *shape_factor(const struct dag *g)
{
    struct walk w = walk_begin(g);
    size_t factored = 0;
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        struct edges sum = {0};
        if (w.uses[n] == 0)
            continue;
        for (size_t i = 0; node->kind == NODE_SUM && i < node->edges; i++) {
            const struct value v = walk_image(&w, &node->edge[i]);
            edges_add(&sum, v.coef, v.node, 1);
        }
        const bool found = sum.n > 0 && factor_sum(w.to, &sum, &w.image[n]);
        if (!found)
            w.image[n] = walk_map(&w, node);
        w.to->node[w.image[n].node].kept |= node->kept;
        factored += found;
        edges_clear(&sum);
    }
    struct dag *made = walk_end(&w);
    if (factored > 0)
        return made;
    dag_free(made);
    return NULL;
}
