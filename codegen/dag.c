/* The graph of values; see dag.h.  Every maker normalises (coefficients out, operands sorted, equal ones collected) and
 * then looks the result up by its value at the random points. */
#include "dag.h"

#include <flint/nmod_vec.h>
#include <flint/ulong_extras.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

static const mp_limb_t prime[2] = {1152921504606846883UL, 1152921504606846697UL}; /* below 2^60 */

static uint64_t mix(uint64_t z)
{
    z += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

static nmod_t modulus(int k)
{
    nmod_t m;
    nmod_init(&m, prime[k]);
    return m;
}

void edges_add(struct edges *list, const fmpq *coef, int node, int power)
{
    grow_array(&list->edge, list->n, &list->room, sizeof *list->edge);
    struct edge *e = &list->edge[list->n++];
    fmpq_init(e->coef);
    fmpq_set(e->coef, coef);
    e->node = node;
    e->power = power;
}

void edges_clear(struct edges *list)
{
    for (size_t i = 0; i < list->n; i++)
        fmpq_clear(list->edge[i].coef);
    free(list->edge);
    *list = (struct edges){0};
}

void value_init(struct value *v)
{
    fmpq_init(v->coef);
    v->node = 0;
}

void value_clear(struct value *v)
{
    fmpq_clear(v->coef);
}

static void set_value(struct value *v, const fmpq_t coef, int node)
{
    fmpq_set(v->coef, coef);
    v->node = fmpq_is_zero(coef) ? 0 : node;
}

static size_t bucket_of(const struct dag *g, const unsigned long mark[2])
{
    return (size_t)mix(mark[0] ^ mix(mark[1])) & (g->buckets - 1);
}

static void insert(struct dag *g, int n)
{
    size_t i = bucket_of(g, g->node[n].mark);
    while (g->bucket[i])
        i = (i + 1) & (g->buckets - 1);
    g->bucket[i] = n + 1;
}

static void grow_buckets(struct dag *g)
{
    free(g->bucket);
    g->buckets = g->buckets ? 2 * g->buckets : 1024;
    g->bucket = new_array(g->buckets, sizeof *g->bucket);
    for (size_t n = 0; n < g->nodes; n++)
        insert(g, (int)n);
}

static int find(const struct dag *g, const unsigned long mark[2])
{
    for (size_t i = bucket_of(g, mark); g->bucket[i]; i = (i + 1) & (g->buckets - 1)) {
        const int n = g->bucket[i] - 1;
        if (g->node[n].mark[0] == mark[0] && g->node[n].mark[1] == mark[1])
            return n;
    }
    return -1;
}

/* A node with this value: the one that exists, or a new one that takes the list over. */
static int make(struct dag *g, enum node_kind kind, int input, struct edges *list, const unsigned long mark[2])
{
    const int known = find(g, mark);
    if (known >= 0)
        return known;
    if (2 * (g->nodes + 1) > g->buckets)
        grow_buckets(g);
    grow_array(&g->node, g->nodes, &g->node_room, sizeof *g->node);
    struct node *n = &g->node[g->nodes];
    *n = (struct node){.kind = kind, .input = input, .mark = {mark[0], mark[1]}};
    if (list) {
        n->edge = list->edge;
        n->edges = list->n;
        *list = (struct edges){0};
    }
    insert(g, (int)g->nodes);
    return (int)g->nodes++;
}

struct dag *dag_new(size_t inputs)
{
    struct dag *g = new_array(1, sizeof *g);
    g->inputs = inputs;
    grow_buckets(g);
    make(g, NODE_ONE, 0, NULL, (unsigned long[2]){1, 1});
    return g;
}

void dag_free(struct dag *g)
{
    if (!g)
        return;
    for (size_t n = 0; n < g->nodes; n++) {
        for (size_t i = 0; i < g->node[n].edges; i++)
            fmpq_clear(g->node[n].edge[i].coef);
        free(g->node[n].edge);
    }
    for (size_t i = 0; i < g->outputs; i++) {
        value_clear(&g->output[i]);
        free(g->output_name[i]);
    }
    free(g->node);
    free(g->bucket);
    free(g->output);
    free(g->output_name);
    free(g);
}

struct dag *dag_copy(const struct dag *g)
{
    struct dag *c = dag_new(g->inputs);
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *from = &g->node[n];
        struct edges list = {0};
        for (size_t i = 0; i < from->edges; i++)
            edges_add(&list, from->edge[i].coef, from->edge[i].node, from->edge[i].power);
        const int made = make(c, from->kind, from->input, &list, from->mark);
        c->node[made].kept = from->kept;
        edges_clear(&list);
    }
    for (size_t i = 0; i < g->outputs; i++)
        dag_add_output(c, g->output_name[i], &g->output[i]);
    c->removed = g->removed;
    return c;
}

void dag_add_output(struct dag *g, const char *name, const struct value *v)
{
    grow_array(&g->output, g->outputs, &g->output_room, sizeof *g->output);
    grow_array(&g->output_name, g->outputs, &g->output_name_room, sizeof *g->output_name);
    value_init(&g->output[g->outputs]);
    set_value(&g->output[g->outputs], v->coef, v->node);
    g->output_name[g->outputs++] = new_text(name, strlen(name));
}

static mp_limb_t rational_mod(const fmpq_t c, int k)
{
    const nmod_t m = modulus(k);
    const mp_limb_t n = fmpz_fdiv_ui(fmpq_numref(c), prime[k]), d = fmpz_fdiv_ui(fmpq_denref(c), prime[k]);
    return nmod_mul(n, nmod_inv(d, m), m);
}

void dag_input(struct dag *g, size_t input, struct value *v)
{
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    const unsigned long mark[2] = {mix(2 * input + 1) % prime[0], mix(2 * input + 2) % prime[1]};
    set_value(v, one, make(g, NODE_INPUT, (int)input, NULL, mark));
    fmpq_clear(one);
}

static int by_node(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    return (x->node > y->node) - (x->node < y->node);
}

/* Sort; add up coefficients (sums) or powers (products) of the same node; drop what vanishes. */
static void collect(struct edges *list, bool sum)
{
    size_t n = 0;
    if (list->n == 0)
        return;
    qsort(list->edge, list->n, sizeof *list->edge, by_node);
    for (size_t i = 1; i <= list->n; i++) {
        struct edge *kept = &list->edge[n];
        if (i < list->n && list->edge[i].node == kept->node) {
            if (sum)
                fmpq_add(kept->coef, kept->coef, list->edge[i].coef);
            else
                kept->power += list->edge[i].power;
            fmpq_clear(list->edge[i].coef);
            continue;
        }
        if (sum ? fmpq_is_zero(kept->coef) : kept->power == 0)
            fmpq_clear(kept->coef);
        else
            n++;
        if (i < list->n)
            list->edge[n] = list->edge[i];
    }
    list->n = n;
}

void dag_sum(struct dag *g, struct edges *terms, struct value *v)
{
    unsigned long mark[2];
    fmpq_t lead, zero;
    collect(terms, true);
    fmpq_init(lead);
    fmpq_init(zero);
    if (terms->n == 0) {
        set_value(v, zero, 0);
    } else {
        /* the leading term is not the constant 1, so that x + 2 and 2x + 4 are x + 2 times 1 and 2 */
        const size_t first = terms->edge[0].node == 0 && terms->n > 1 ? 1 : 0;
        fmpq_set(lead, terms->edge[first].coef);
        for (size_t i = 0; i < terms->n; i++)
            fmpq_div(terms->edge[i].coef, terms->edge[i].coef, lead);
        for (int k = 0; k < 2; k++) {
            mark[k] = 0;
            for (size_t i = 0; i < terms->n; i++)
                mark[k] = nmod_add(
                    mark[k],
                    nmod_mul(rational_mod(terms->edge[i].coef, k), g->node[terms->edge[i].node].mark[k], modulus(k)),
                    modulus(k));
        }
        if (mark[0] == 0 && mark[1] == 0)
            set_value(v, zero, 0);
        else if (terms->n == 1)
            set_value(v, lead, terms->edge[0].node);
        else
            set_value(v, lead, make(g, NODE_SUM, 0, terms, mark));
    }
    fmpq_clear(lead);
    fmpq_clear(zero);
    edges_clear(terms);
}

static int invert_node(struct dag *g, int node)
{
    struct edges list = {0};
    fmpq_t one;
    unsigned long mark[2];
    if (g->node[node].kind == NODE_INVERSE)
        return g->node[node].edge[0].node;
    fmpq_init(one);
    fmpq_one(one);
    edges_add(&list, one, node, 1);
    for (int k = 0; k < 2; k++)
        mark[k] = nmod_inv(g->node[node].mark[k], modulus(k));
    const int made = make(g, NODE_INVERSE, 0, &list, mark);
    edges_clear(&list);
    fmpq_clear(one);
    return made;
}

enum { MOST_POWER = 64 }; /* products of a higher power stay factors of their own */

static bool spreads(const struct node *n, int power)
{
    for (size_t k = 0; k < n->edges; k++)
        if (abs(power) > MOST_POWER / n->edge[k].power)
            return false;
    return true;
}

/* Factors that are inverses or products of their own are spread first; x and 1/x meet in `collect` by their powers. */
static void spread_factors(struct dag *g, struct edges *list)
{
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    for (size_t i = 0; i < list->n;) {
        struct edge *e = &list->edge[i];
        const struct node *n = &g->node[e->node];
        const int power = e->power;
        if (n->kept) {
            i++;
        } else if (n->kind == NODE_INVERSE && abs(power) < MOST_POWER) {
            e->node = n->edge[0].node;
            e->power = -power;
        } else if (n->kind == NODE_PRODUCT && spreads(n, power)) {
            const size_t parts = n->edges;
            const int node = e->node;
            for (size_t k = 1; k < parts; k++)
                edges_add(list, one, g->node[node].edge[k].node, g->node[node].edge[k].power * power);
            list->edge[i].power = g->node[node].edge[0].power * power;
            list->edge[i].node = g->node[node].edge[0].node;
        } else
            i++;
    }
    fmpq_clear(one);
}

void dag_product(struct dag *g, const fmpq_t coef, struct edges *factors, struct value *v)
{
    unsigned long mark[2] = {1, 1};
    struct edges kept = {0}, below = {0};
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    spread_factors(g, factors);
    int divisors = 0, left = 0;
    for (size_t i = 0; i < factors->n; i++)
        divisors += factors->edge[i].power < 0 ? -factors->edge[i].power : 0;
    collect(factors, false);
    for (size_t i = 0; i < factors->n; i++) {
        const struct edge *e = &factors->edge[i];
        if (e->node == 0)
            continue;
        if (e->power > 0)
            edges_add(&kept, one, e->node, e->power);
        else {
            edges_add(&below, one, e->node, -e->power);
            left -= e->power;
        }
    }
    g->removed += (size_t)(divisors - left);
    if (below.n > 0) { /* all divisors together are one inverse */
        struct value denominator;
        value_init(&denominator);
        dag_product(g, one, &below, &denominator);
        edges_add(&kept, one, invert_node(g, denominator.node), 1);
        value_clear(&denominator);
        collect(&kept, false);
    }
    for (size_t i = 0; i < kept.n; i++)
        for (int k = 0; k < 2; k++)
            mark[k] = nmod_mul(
                mark[k], nmod_pow_ui(g->node[kept.edge[i].node].mark[k], (mp_limb_t)kept.edge[i].power, modulus(k)),
                modulus(k));
    if (fmpq_is_zero(coef) || kept.n == 0)
        set_value(v, coef, 0);
    else if (kept.n == 1 && kept.edge[0].power == 1)
        set_value(v, coef, kept.edge[0].node);
    else {
        const size_t before = g->nodes;
        const int node = make(g, NODE_PRODUCT, 0, &kept, mark);
        if (below.n == 0 && left > 0 && (size_t)node < before && g->node[node].kind != NODE_PRODUCT)
            g->removed++; /* a division disappeared into an equal value */
        set_value(v, coef, node);
    }
    fmpq_clear(one);
    edges_clear(&kept);
    edges_clear(&below);
    edges_clear(factors);
}

bool dag_inverse(struct dag *g, const struct value *a, struct value *v)
{
    fmpq_t c;
    if (fmpq_is_zero(a->coef))
        return false;
    fmpq_init(c);
    fmpq_inv(c, a->coef);
    set_value(v, c, a->node ? invert_node(g, a->node) : 0);
    fmpq_clear(c);
    return true;
}

/* A function that is opaque to the random points takes as its value a hash of its kind and of its arguments' values. */
void dag_function(struct dag *g, enum node_kind kind, const struct value *a, const struct value *b, struct value *v)
{
    struct edges list = {0};
    unsigned long mark[2];
    fmpq_t outside;
    fmpq_init(outside);
    fmpq_one(outside);
    edges_add(&list, a->coef, a->node, 1);
    if (kind == NODE_ABS) { /* |c a| = |c| |a| */
        fmpq_abs(outside, list.edge[0].coef);
        fmpq_one(list.edge[0].coef);
    }
    if (kind == NODE_PDIV || kind == NODE_MIN || kind == NODE_MAX)
        edges_add(&list, b->coef, b->node, 1);
    if (kind == NODE_PDIV) { /* where the divisor is not 0 its coefficient may stand in the dividend */
        fmpq_div(list.edge[0].coef, list.edge[0].coef, list.edge[1].coef);
        fmpq_one(list.edge[1].coef);
    }
    for (int k = 0; k < 2; k++) {
        uint64_t part[2] = {0, 0};
        for (size_t i = 0; i < list.n; i++)
            part[i] = nmod_mul(rational_mod(list.edge[i].coef, k), g->node[list.edge[i].node].mark[k], modulus(k));
        const bool commutes = kind == NODE_MIN || kind == NODE_MAX;
        if (commutes && part[1] < part[0]) {
            const uint64_t swap = part[0];
            part[0] = part[1];
            part[1] = swap;
        }
        mark[k] = mix(part[0] ^ mix(part[1] ^ mix((uint64_t)kind * 3 + (uint64_t)k))) % prime[k];
    }
    set_value(v, outside, make(g, kind, 0, &list, mark));
    fmpq_clear(outside);
    edges_clear(&list);
}

int *dag_uses(const struct dag *g)
{
    int *uses = new_array(g->nodes, sizeof *uses);
    for (size_t i = 0; i < g->outputs; i++)
        uses[g->output[i].node]++;
    for (size_t n = g->nodes; n-- > 0;)
        if (uses[n])
            for (size_t i = 0; i < g->node[n].edges; i++)
                uses[g->node[n].edge[i].node]++;
    return uses;
}
