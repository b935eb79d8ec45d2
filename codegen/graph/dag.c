/* The graph of values; see dag.h. Every maker normalises (coefficients out, operands sorted, equal operands collected)
 * and then looks the result up by its value at the random points. */
#include "dag.h"

#include "../base/random.h"
#include "unary.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { POOL = 4096, MOST_POWER = 64 /* higher powers stay separate factors */ };

void edges_add(struct edges *list, rational coef, int node, int power)
{
    APPEND(list->edge, list->n, list->room) = (struct edge){coef, node, power};
}

void edges_clear(struct edges *list)
{
    free(list->edge);
    *list = (struct edges){0};
}

struct value dag_constant(rational c)
{
    return (struct value){c, 0};
}

static struct value value_of(rational coef, int node)
{
    return (struct value){coef, coef == ZERO ? 0 : node};
}

static uint64_t hash_of(const mp_limb_t mark[PRIMES])
{
    return random_of(mark[0] ^ random_of(mark[1]));
}

static int find(const struct dag *g, const mp_limb_t mark[PRIMES])
{
    size_t probe = 0;
    for (int n; (n = index_next(&g->known, hash_of(mark), &probe)) >= 0;)
        if (g->node[n].mark[0] == mark[0] && g->node[n].mark[1] == mark[1])
            return n;
    return -1;
}

struct edge *dag_room(struct dag *g, size_t n)
{
    if (g->pools == 0 || g->pool_used + n > g->pool_size) {
        grow_array(&g->pool, g->pools, &g->pool_room, sizeof *g->pool);
        g->pool_size = n > POOL ? n : POOL;
        g->pool[g->pools++] = new_array(g->pool_size, sizeof **g->pool);
        g->pool_used = 0;
    }
    g->pool_used += n;
    return g->pool[g->pools - 1] + g->pool_used - n;
}

int dag_append(struct dag *g, enum node_kind kind, const struct edge *edge, size_t n)
{
    grow_array(&g->node, g->nodes, &g->node_room, sizeof *g->node);
    struct node *node = &g->node[g->nodes];
    *node = (struct node){.kind = kind, .edges = n, .divides = kind == NODE_INVERSE};
    node->partial = node->divides || node_is_root(kind);
    if (n > 0) {
        node->edge = dag_room(g, n);
        memcpy(node->edge, edge, n * sizeof *edge);
    }
    for (size_t i = 0; i < n; i++) {
        node->divides |= g->node[edge[i].node].divides;
        node->partial |= g->node[edge[i].node].partial;
    }
    return (int)g->nodes++;
}

/* Returns a node with this value, existing or new. */
static int make(struct dag *g, enum node_kind kind, int input, const struct edges *list, const mp_limb_t mark[PRIMES])
{
    const int known = find(g, mark);
    if (known >= 0)
        return known;
    const int n = dag_append(g, kind, list ? list->edge : NULL, list ? list->n : 0);
    g->node[n].input = input;
    memcpy(g->node[n].mark, mark, sizeof g->node[n].mark);
    index_add(&g->known, hash_of(mark), n);
    return n;
}

struct dag *dag_new(size_t inputs)
{
    struct dag *g = new_array(1, sizeof *g);
    rational_start();
    g->inputs = inputs;
    make(g, NODE_ONE, 0, NULL, (mp_limb_t[PRIMES]){1, 1});
    return g;
}

void dag_free(struct dag *g)
{
    if (!g)
        return;
    for (size_t i = 0; i < g->pools; i++)
        free(g->pool[i]);
    for (size_t i = 0; i < g->outputs; i++)
        free(g->output_name[i]);
    free(g->pool);
    free(g->removed);
    free(g->lost);
    free(g->node);
    index_free(&g->known);
    free(g->output);
    free(g->output_name);
    free(g);
}

struct dag *dag_copy(const struct dag *g)
{
    struct dag *c = dag_new(g->inputs);
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *from = &g->node[n];
        const struct edges list = {from->edge, from->edges, from->edges};
        const int made = make(c, from->kind, from->input, &list, from->mark);
        c->node[made].kept = from->kept;
    }
    for (size_t i = 0; i < g->outputs; i++)
        dag_add_output(c, g->output_name[i], g->output[i]);
    dag_inherit_removed(c, g);
    return c;
}

void dag_add_output(struct dag *g, const char *name, struct value v)
{
    grow_array(&g->output, g->outputs, &g->output_room, sizeof *g->output);
    grow_array(&g->output_name, g->outputs, &g->output_name_room, sizeof *g->output_name);
    g->output[g->outputs] = v;
    g->output_name[g->outputs++] = new_text(name, strlen(name));
}

struct value dag_input(struct dag *g, size_t input)
{
    const mp_limb_t mark[PRIMES] = {random_of(2 * input + 1) % rational_prime[0],
                                    random_of(2 * input + 2) % rational_prime[1]};
    return value_of(ONE, make(g, NODE_INPUT, (int)input, NULL, mark));
}

static int by_node(const void *a, const void *b)
{
    const struct edge *x = a, *y = b;
    return (x->node > y->node) - (x->node < y->node);
}

static void sort_edges(struct edges *list)
{
    if (list->n > 16) {
        qsort(list->edge, list->n, sizeof *list->edge, by_node);
        return;
    }
    for (size_t i = 1; i < list->n; i++) {
        const struct edge e = list->edge[i];
        size_t k = i;
        for (; k > 0 && list->edge[k - 1].node > e.node; k--)
            list->edge[k] = list->edge[k - 1];
        list->edge[k] = e;
    }
}

/* Sorts operands, adds up coefficients (sums) or powers (products) of the same node, and drops operands that vanish. */
static void collect(struct dag *g, struct edges *list, bool sum)
{
    size_t n = 0;
    sort_edges(list);
    for (size_t i = 0; i < list->n;) {
        struct edge e = list->edge[i++];
        for (; i < list->n && list->edge[i].node == e.node; i++)
            if (sum)
                e.coef = rational_add(e.coef, list->edge[i].coef);
            else
                e.power += list->edge[i].power;
        if (sum ? e.coef != ZERO : e.power != 0)
            list->edge[n++] = e;
        else
            dag_lose(g, e.node);
    }
    list->n = n;
}

/* Notes lost operands, after a list was looked up and a different node of the same value was found. */
static void note_replaced(struct dag *g, int made, enum node_kind kind, const struct edges *list)
{
    const struct node *n = &g->node[made];
    bool same = n->kind == kind && n->edges == list->n;
    for (size_t i = 0; same && i < list->n; i++)
        same = n->edge[i].node == list->edge[i].node && n->edge[i].power == list->edge[i].power;
    for (size_t i = 0; !same && i < list->n; i++)
        dag_lose(g, list->edge[i].node);
}

struct value dag_sum(struct dag *g, struct edges *terms)
{
    struct value v = {ZERO, 0};
    collect(g, terms, true);
    if (terms->n > 0) {
        /* The leading term must not be the constant 1, so that x + 2 and 2x + 4 are x + 2 times 1 and 2. */
        const rational lead = terms->edge[terms->edge[0].node == 0 && terms->n > 1 ? 1 : 0].coef;
        mp_limb_t mark[PRIMES] = {0};
        for (size_t i = 0; lead != ONE && i < terms->n; i++)
            terms->edge[i].coef = rational_mul(terms->edge[i].coef, rational_inv(lead));
        for (size_t i = 0; i < terms->n; i++) {
            const struct edge *e = &terms->edge[i];
            for (int k = 0; k < PRIMES; k++)
                mark[k] =
                    nmod_add(mark[k], nmod_mul(rational_mod(e->coef, k), g->node[e->node].mark[k], rational_modulus[k]),
                             rational_modulus[k]);
        }
        if (terms->n == 1)
            v = value_of(lead, terms->edge[0].node);
        else if (mark[0] != 0 || mark[1] != 0)
            v = value_of(lead, make(g, NODE_SUM, 0, terms, mark));
        if (terms->n > 1)
            note_replaced(g, v.node, NODE_SUM, terms);
    }
    edges_clear(terms);
    return v;
}

static int invert_node(struct dag *g, int node)
{
    mp_limb_t mark[PRIMES];
    if (g->node[node].kind == NODE_INVERSE) {
        dag_lose(g, node);
        return g->node[node].edge[0].node;
    }
    struct edge e = {ONE, node, 1};
    const struct edges list = {&e, 1, 1};
    for (int k = 0; k < PRIMES; k++)
        mark[k] = nmod_inv(g->node[node].mark[k], rational_modulus[k]);
    const int made = make(g, NODE_INVERSE, 0, &list, mark);
    note_replaced(g, made, NODE_INVERSE, &list);
    return made;
}

static bool spreads(const struct node *n, int power)
{
    for (size_t k = 0; k < n->edges; k++)
        if (abs(power) > MOST_POWER / n->edge[k].power)
            return false;
    return true;
}

/* Expands factors that are themselves inverses or products. `collect` then cancels x and 1/x by their powers. */
static void spread_factors(struct dag *g, struct edges *list)
{
    for (size_t i = 0; i < list->n;) {
        struct edge *e = &list->edge[i];
        const struct node *n = &g->node[e->node];
        const int power = e->power;
        if (n->kept) {
            i++;
        } else if (n->kind == NODE_INVERSE && abs(power) < MOST_POWER) {
            if (power < 0)
                dag_lose(g, e->node);
            e->node = n->edge[0].node;
            e->power = -power;
        } else if (n->kind == NODE_PRODUCT && spreads(n, power)) {
            e->node = n->edge[0].node;
            e->power = n->edge[0].power * power;
            for (size_t k = 1; k < n->edges; k++)
                edges_add(list, ONE, n->edge[k].node, n->edge[k].power * power);
        } else
            i++;
    }
}

/* Notes divisors that cancelled or whose power decreased. after: `before` collected. */
static void note_cancelled(struct dag *g, struct edges *before, const struct edges *after)
{
    size_t k = 0;
    sort_edges(before);
    for (size_t i = 0; i < before->n;) {
        const int node = before->edge[i].node;
        int below = 0;
        for (; i < before->n && before->edge[i].node == node; i++)
            below += before->edge[i].power < 0 ? before->edge[i].power : 0;
        while (k < after->n && after->edge[k].node < node)
            k++;
        const bool left = k < after->n && after->edge[k].node == node && after->edge[k].power < 0;
        if ((left ? after->edge[k].power : 0) > below)
            dag_remove(g, node);
    }
}

struct value dag_product(struct dag *g, rational coef, struct edges *factors)
{
    mp_limb_t mark[PRIMES] = {1, 1};
    struct edges kept = {0}, below = {0};
    struct value v = {coef, 0};
    bool divides = false;
    for (size_t i = 0; i < factors->n; i++)
        divides = divides || factors->edge[i].power < 0 || g->node[factors->edge[i].node].divides;
    spread_factors(g, factors);
    if (divides) {
        struct edges before = {0};
        for (size_t i = 0; i < factors->n; i++)
            edges_add(&before, ONE, factors->edge[i].node, factors->edge[i].power);
        collect(g, factors, false);
        note_cancelled(g, &before, factors);
        edges_clear(&before);
    } else
        collect(g, factors, false);
    for (size_t i = 0; i < factors->n; i++) {
        const struct edge *e = &factors->edge[i];
        if (e->node == 0)
            continue;
        if (coef == ZERO)
            e->power < 0 ? dag_remove(g, e->node) : dag_lose(g, e->node);
        if (e->power > 0)
            edges_add(&kept, ONE, e->node, e->power);
        else
            edges_add(&below, ONE, e->node, -e->power);
    }
    if (below.n > 0) { /* all divisors together make a single inverse */
        edges_add(&kept, ONE, invert_node(g, dag_product(g, ONE, &below).node), 1);
        collect(g, &kept, false);
    }
    for (size_t i = 0; i < kept.n; i++)
        for (int k = 0; k < PRIMES; k++)
            mark[k] = nmod_mul(
                mark[k],
                nmod_pow_ui(g->node[kept.edge[i].node].mark[k], (mp_limb_t)kept.edge[i].power, rational_modulus[k]),
                rational_modulus[k]);
    if (coef == ZERO)
        v = value_of(ZERO, 0);
    else if (kept.n == 1 && kept.edge[0].power == 1)
        v = value_of(coef, kept.edge[0].node);
    else if (kept.n > 0) {
        v = value_of(coef, make(g, NODE_PRODUCT, 0, &kept, mark));
        note_replaced(g, v.node, NODE_PRODUCT, &kept);
    }
    edges_clear(&kept);
    edges_clear(&below);
    edges_clear(factors);
    return v;
}

struct value dag_times(struct dag *g, struct value a, struct value b)
{
    struct edges factors = {0};
    edges_add(&factors, ONE, a.node, 1);
    edges_add(&factors, ONE, b.node, 1);
    return dag_product(g, rational_mul(a.coef, b.coef), &factors);
}

struct value dag_inverse(struct dag *g, struct value a)
{
    return value_of(rational_inv(a.coef), a.node ? invert_node(g, a.node) : 0);
}

struct value dag_number(struct dag *g, struct value v)
{
    rational c;
    if (v.node == 0 || g->node[v.node].kind != NODE_SUM || !rational_reconstruct(g->node[v.node].mark, &c))
        return v;
    dag_lose(g, v.node);
    return dag_constant(rational_mul(v.coef, c));
}

bool node_chooses(const struct node *n)
{
    return n->kind == NODE_PDIV || n->kind == NODE_MIN || n->kind == NODE_MAX;
}

bool node_is_difference(const struct dag *g, const struct node *n)
{
    return n->kind == NODE_SUM && n->edges == 2 && n->edge[0].coef == ONE && n->edge[1].coef == MINUS_ONE &&
           g->node[n->edge[0].node].kind == NODE_INPUT && g->node[n->edge[1].node].kind == NODE_INPUT;
}

static bool fold_unary(unsigned k, rational c, rational *value)
{
    fmpq_t q;
    fmpq_init(q);
    fmpq_set(q, rational_value(c));
    const bool exact = unary_exact(k, q, q);
    if (exact)
        *value = rational_intern(q);
    fmpq_clear(q);
    return exact;
}

/* Folds a function of constants, or a function that its definition decides. Returns true if *v is set. */
static bool fold(struct dag *g, enum node_kind kind, struct value x, struct value y, struct value *v)
{
    const bool same = x.node == y.node && x.coef == y.coef, constant = x.node == 0 && y.node == 0;
    if (kind == NODE_PDIV && (same || y.coef == ZERO)) {
        dag_lose(g, x.node);
        *v = dag_constant(ONE);
    } else if (kind == NODE_PDIV && y.node == 0)
        *v = value_of(rational_mul(x.coef, rational_inv(y.coef)), x.node);
    else if ((kind == NODE_MIN || kind == NODE_MAX) && (same || constant)) {
        const bool less = fmpq_cmp(rational_value(x.coef), rational_value(y.coef)) < 0;
        *v = less == (kind == NODE_MIN) ? x : y;
    } else
        return kind >= NODE_UNARY && x.node == 0 && fold_unary((unsigned)(kind - NODE_UNARY), x.coef, &v->coef);
    return true;
}

/* A function without a value at the random points gets a hash of its kind and its arguments' values instead. */
struct value dag_function(struct dag *g, enum node_kind kind, struct value a, struct value b)
{
    struct edge edge[2] = {{a.coef, a.node, 1}, {b.coef, b.node, 1}};
    const bool two = kind < NODE_UNARY, commutes = kind == NODE_MIN || kind == NODE_MAX;
    const struct edges list = {edge, two ? 2 : 1, 2};
    mp_limb_t mark[PRIMES];
    rational outside = ONE;
    struct value folded = {ZERO, 0};
    if (fold(g, kind, a, b, &folded))
        return folded;
    if (kind == NODE_ABS) { /* |c a| = |c| |a| */
        outside = rational_abs(a.coef);
        edge[0].coef = ONE;
    }
    if (kind == NODE_PDIV) { /* outside a zero divisor, its coefficient may move to the dividend */
        edge[0].coef = rational_mul(a.coef, rational_inv(b.coef));
        edge[1].coef = ONE;
    }
    for (int k = 0; k < PRIMES; k++) {
        uint64_t part[2] = {0, 0};
        for (size_t i = 0; i < list.n; i++)
            part[i] = nmod_mul(rational_mod(edge[i].coef, k), g->node[edge[i].node].mark[k], rational_modulus[k]);
        const uint64_t low = part[0] < part[1] || !commutes ? part[0] : part[1], high = part[0] ^ part[1] ^ low;
        mark[k] = random_of(low ^ random_of(high ^ random_of((uint64_t)kind * 3 + (uint64_t)k))) % rational_prime[k];
    }
    return value_of(outside, make(g, kind, 0, &list, mark));
}

/* Finds the least and greatest power with which a node's value scales with the inputs, from its operands' powers.
 * Powers of hostile genomes could overflow an integer, so they are clamped at MOST. */
static void find_degrees(const struct node *n, int *low, int *high, size_t at)
{
    enum { MOST = 1 << 20 };
    double least = n->kind == NODE_INPUT, most = least;
    for (size_t i = 0; i < n->edges; i++) {
        const double l = low[n->edge[i].node], h = high[n->edge[i].node];
        if (n->kind == NODE_PRODUCT) {
            least += n->edge[i].power * l;
            most += n->edge[i].power * h;
        } else if (n->kind == NODE_INVERSE || (n->kind == NODE_PDIV && i == 1)) {
            least -= h;
            most -= l;
        } else {
            least = i == 0 || l < least ? l : least;
            most = i == 0 || h > most ? h : most;
        }
    }
    low[at] = (int)fmax(-MOST, fmin(least, MOST));
    high[at] = (int)fmax(-MOST, fmin(most, MOST));
}

int dag_degree(const struct dag *g)
{
    int *uses = dag_uses(g), *low = new_array(g->nodes, sizeof *low), *high = new_array(g->nodes, sizeof *high);
    int degree = 0;
    for (size_t n = 1; n < g->nodes; n++) {
        if (!uses[n])
            continue;
        find_degrees(&g->node[n], low, high, n);
        degree = -low[n] > degree ? -low[n] : degree;
        degree = high[n] > degree ? high[n] : degree;
    }
    free(uses);
    free(low);
    free(high);
    return degree;
}
