/* Horner's rule for several variables. A sum with a single user first becomes part of it. Then each sum is factored
 * greedily: one factor is extracted from all terms that contain it; the quotient, itself factored, becomes a factor
 * that other terms may contain, too. k terms that share a factor save k-1 multiplications. Which factor goes first is
 * decided separately for each sub-sum. */
#include "horner.h"

#include "../graph/rewrite.h"

#include <stdlib.h>
#include <string.h>

/* Larger sums, and the rest after this many factors, are not factored, to bound time and stack on enormous input. */
enum { MOST_TERMS = 4000, DEEPEST = 300 };

struct term {
    rational coef;
    struct edges factors; /* powers > 0 */
};

struct terms {
    struct term *term; /* owned */
    size_t n, room;
};

struct factoring {
    struct walk walk;
    const struct policy *policy;
    struct record *record;
    int *count; /* owned: by node of the new graph, all 0 between uses */
    size_t counts;
};

static void add_term(struct terms *list, const struct dag *g, rational coef, int node)
{
    struct term *t = &APPEND(list->term, list->n, list->room);
    *t = (struct term){.coef = coef};
    const struct node *n = &g->node[node];
    if (n->kind == NODE_PRODUCT && !n->kept)
        for (size_t k = 0; k < n->edges; k++)
            edges_add(&t->factors, ONE, n->edge[k].node, n->edge[k].power);
    else if (node != 0)
        edges_add(&t->factors, ONE, node, 1);
}

/* Returns the key of a sub-sum, the same wherever and however it occurs. */
static uint64_t key_of(const struct dag *g, const struct terms *list)
{
    uint64_t key = 0;
    for (size_t i = 0; i < list->n; i++) {
        uint64_t term = rational_mod(list->term[i].coef, 0);
        for (size_t k = 0; k < list->term[i].factors.n; k++) {
            const struct edge *e = &list->term[i].factors.edge[k];
            term += random_of(g->node[e->node].mark[0] + (uint64_t)e->power);
        }
        key += random_of(term);
    }
    return key;
}

/* Returns the factor to extract next, or -1. */
static int choose_factor(struct factoring *f, const struct terms *list)
{
    const struct policy *p = f->policy;
    int best = -1, *seen;
    size_t n = 0, room = 0, shared = 0;
    double most = 0;
    if (f->counts < f->walk.to->nodes) {
        free(f->count);
        f->counts = 2 * f->walk.to->nodes;
        f->count = new_array(f->counts, sizeof *f->count);
    }
    for (size_t i = 0; i < list->n; i++)
        room += list->term[i].factors.n;
    seen = new_array(room, sizeof *seen);
    for (size_t i = 0; i < list->n; i++)
        for (size_t k = 0; k < list->term[i].factors.n; k++) {
            const int node = list->term[i].factors.edge[k].node;
            if (f->count[node]++ == 0)
                seen[n++] = node;
            shared += f->count[node] == 2;
        }
    if (shared > 0) {
        const uint64_t key = f->record || p->choices ? policy_key(CHOICE_FACTOR, key_of(f->walk.to, list)) : 0;
        const struct choice *forced = policy_find(p, key);
        record_decision(f->record, key);
        record_alternative(f->record, 0);
        for (size_t i = 0; i < n; i++) {
            if (f->count[seen[i]] < 2)
                continue;
            const uint64_t mark = f->walk.to->node[seen[i]].mark[0];
            const double score = f->count[seen[i]] + (p->preference > 0 ? p->preference * policy_random(p, mark) : 0) +
                                 (forced && forced->what == mark ? 1e9 : 0);
            record_alternative(f->record, mark);
            if (score > most || (score == most && seen[i] < best)) {
                most = score;
                best = seen[i];
            }
        }
        if (forced ? forced->what == 0 : p->plain)
            best = -1;
    }
    for (size_t i = 0; i < n; i++)
        f->count[seen[i]] = 0;
    free(seen);
    return best;
}

static struct edge *factor_of(const struct term *t, int node)
{
    for (size_t k = 0; k < t->factors.n; k++)
        if (t->factors.edge[k].node == node)
            return &t->factors.edge[k];
    return NULL;
}

/* Moves the terms that contain `node`, divided by the highest power that they share, to another list; returns that
 * power. */
static int divide_terms(struct terms *list, int node, struct terms *quotient)
{
    int power = 0;
    size_t rest = 0;
    for (size_t i = 0; i < list->n; i++) {
        const struct edge *e = factor_of(&list->term[i], node);
        if (e && (power == 0 || e->power < power))
            power = e->power;
    }
    for (size_t i = 0; i < list->n; i++) {
        struct edge *e = factor_of(&list->term[i], node);
        if (!e) {
            list->term[rest++] = list->term[i];
            continue;
        }
        e->power -= power;
        if (e->power == 0) {
            struct edges *factors = &list->term[i].factors;
            *e = factors->edge[--factors->n];
        }
        APPEND(quotient->term, quotient->n, quotient->room) = list->term[i];
    }
    list->n = rest;
    return power;
}

/* Returns the value of a list of terms and consumes the list. Recursion is as deep as the degree, at most DEEPEST. */
static struct value factor_terms(struct factoring *f, struct terms *list, int depth)
{
    struct edges sum = {0};
    while (list->n > 1 && list->n <= MOST_TERMS && depth < DEEPEST) {
        const int node = choose_factor(f, list);
        if (node < 0)
            break;
        struct terms quotient = {0};
        const int power = divide_terms(list, node, &quotient);
        const struct value part = factor_terms(f, &quotient, depth + 1);
        struct edges product = {0};
        edges_add(&product, ONE, node, power);
        edges_add(&product, ONE, part.node, 1);
        const struct value v = dag_product(f->walk.to, part.coef, &product);
        if (v.coef != ZERO)
            add_term(list, f->walk.to, v.coef, v.node);
    }
    for (size_t i = 0; i < list->n; i++) {
        const struct value v = dag_product(f->walk.to, list->term[i].coef, &list->term[i].factors);
        if (v.coef != ZERO)
            edges_add(&sum, v.coef, v.node, 1);
    }
    free(list->term);
    *list = (struct terms){0};
    return dag_sum(f->walk.to, &sum);
}

static bool joins(const struct factoring *f, const struct edge *e)
{
    const struct node *n = &f->walk.from->node[e->node];
    return n->kind == NODE_SUM && f->walk.uses[e->node] == 1 && (e->coef == ONE || e->coef == MINUS_ONE) &&
           !(f->policy->differences && node_is_difference(f->walk.from, n));
}

/* Gathers the terms of a sum, expanding inner sums that have no other user and are not multiplied. Iterative, because
 * they may nest deep. */
static void gather(const struct factoring *f, size_t node, struct edges *terms)
{
    const struct node *n = &f->walk.from->node[node];
    for (size_t i = 0; i < n->edges; i++)
        edges_add(terms, n->edge[i].coef, n->edge[i].node, 1);
    for (size_t i = 0; i < terms->n;) {
        const struct edge joined = terms->edge[i];
        if (!joins(f, &joined)) {
            i++;
            continue;
        }
        const struct node *inner = &f->walk.from->node[joined.node];
        terms->edge[i] = (struct edge){rational_mul(joined.coef, inner->edge[0].coef), inner->edge[0].node, 1};
        for (size_t j = 1; j < inner->edges; j++)
            edges_add(terms, rational_mul(joined.coef, inner->edge[j].coef), inner->edge[j].node, 1);
    }
}

static struct value map_sum(struct factoring *f, size_t node)
{
    struct edges edges = {0};
    struct terms list = {0};
    gather(f, node, &edges);
    for (size_t i = 0; i < edges.n; i++) {
        const struct value image = f->walk.image[edges.edge[i].node];
        add_term(&list, f->walk.to, rational_mul(edges.edge[i].coef, image.coef), image.node);
    }
    edges_clear(&edges);
    return factor_terms(f, &list, 0);
}

struct dag *horner_factor(const struct dag *g, const struct policy *policy, struct record *record)
{
    struct factoring f = {.walk = walk_begin(g), .policy = policy, .record = record};
    /* A sum expanded into its only user is not built separately. */
    bool *spread = new_array(g->nodes, sizeof *spread);
    for (size_t n = 0; n < g->nodes; n++)
        for (size_t i = 0; f.walk.uses[n] && g->node[n].kind == NODE_SUM && i < g->node[n].edges; i++)
            if (joins(&f, &g->node[n].edge[i]))
                spread[g->node[n].edge[i].node] = true;
    for (size_t n = 1; n < g->nodes; n++) {
        if (f.walk.uses[n] == 0 || spread[n])
            continue;
        f.walk.image[n] = g->node[n].kind == NODE_SUM ? map_sum(&f, n) : walk_map(&f.walk, &g->node[n]);
        f.walk.to->node[f.walk.image[n].node].kept |= g->node[n].kept;
    }
    free(f.count);
    free(spread);
    return walk_end(&f.walk);
}
