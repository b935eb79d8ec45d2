/* Rewrites (1 - x) e and (1 + x) e as e - x e and e + x e, one multiplication for two; see distribute.h. Products of
 * two factors are read both ways, e (c + v) and e' (c' + v'), and grouped by e and v. No cycle can arise: e v uses
 * fewer values than e (c + v). */
#include "distribute.h"

#include "scales.h"

#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3, MOST_OPERANDS = 200 };

/* Node `product` is e (c + v). */
struct reading {
    int e, v, product, factor; /* `factor` is c + v */
    rational c;
};

struct readings {
    struct reading *list; /* owned */
    size_t n, room;
};

static int compare_readings(const void *a, const void *b)
{
    const struct reading *x = a, *y = b;
    if (x->e != y->e)
        return x->e < y->e ? -1 : 1;
    if (x->v != y->v)
        return x->v < y->v ? -1 : 1;
    if ((x->c == ZERO) != (y->c == ZERO))
        return x->c == ZERO ? -1 : 1;
    return (x->product > y->product) - (x->product < y->product);
}

static void add_reading(struct readings *r, struct reading x)
{
    APPEND(r->list, r->n, r->room) = x;
}

static void read_product(struct readings *r, const struct dag *g, int product, int e, int factor)
{
    const struct node *n = &g->node[factor];
    add_reading(r, (struct reading){e, factor, product, factor, ZERO});
    if (n->kind != NODE_SUM || n->edges != 2)
        return;
    const size_t one = n->edge[0].node == 0 ? 0 : 1;
    if (n->edge[one].node == 0 && n->edge[1 - one].coef == ONE)
        add_reading(r, (struct reading){e, n->edge[1 - one].node, product, factor, n->edge[one].coef});
}

static void read_products(struct readings *r, const struct schedule *s)
{
    for (size_t i = 0; i < s->n; i++) {
        const struct node *n = &s->dag->node[s->order[i]];
        if (n->kind != NODE_PRODUCT)
            continue;
        if (n->edges == 1 && n->edge[0].power == 2)
            read_product(r, s->dag, s->order[i], n->edge[0].node, n->edge[0].node);
        if (n->edges != 2 || n->edge[0].power != 1 || n->edge[1].power != 1)
            continue;
        read_product(r, s->dag, s->order[i], n->edge[0].node, n->edge[1].node);
        read_product(r, s->dag, s->order[i], n->edge[1].node, n->edge[0].node);
    }
}

/* Returns the saving if the product is written as e v + c e, given e v. */
static double saving(const struct schedule *s, const struct reading *x)
{
    const int doublings = schedule_doublings(s, x->c);
    const double coefficient = x->c == ONE || x->c == MINUS_ONE ? 0
                               : doublings > 0                  ? doublings * s->model->add
                                                                : s->model->mul;
    return s->model->mul - coefficient - (s->uses[x->factor] > 1 ? s->model->add : 0);
}

/* Rewrites the products of one e and one v; a reading with c = 0 comes first. */
static bool distribute(struct dag *g, const struct schedule *s, const struct reading *x, size_t n, bool *done)
{
    const bool plain = x[0].c == ZERO;
    double saved = plain ? 0 : -s->model->mul;
    for (size_t i = 0; i < n; i++)
        saved += x[i].c != ZERO && !done[x[i].product] && saving(s, &x[i]) > 0 ? saving(s, &x[i]) : 0;
    if (saved <= 0)
        return false;
    const struct edge square = {ONE, x[0].e, 2}, pair[2] = {{ONE, x[0].e, 1}, {ONE, x[0].v, 1}};
    const bool same = x[0].e == x[0].v;
    const int ev = plain ? x[0].product : dag_append(g, NODE_PRODUCT, same ? &square : pair, same ? 1 : 2);
    for (size_t i = 0; i < n; i++) {
        if (x[i].c == ZERO || done[x[i].product] || saving(s, &x[i]) <= 0)
            continue;
        struct edge *edge = dag_room(g, 2);
        edge[0] = (struct edge){x[i].c, x[0].e, 1};
        edge[1] = (struct edge){ONE, ev, 1};
        struct node *product = &g->node[x[i].product];
        product->kind = NODE_SUM;
        product->edge = edge;
        product->edges = 2;
        done[x[i].product] = true;
    }
    return true;
}

/* ---- sums of products ---- */

/* A product e (v + c), c = +-1, with a sum as its only user, of which it is operand `edge`. */
struct term {
    size_t edge;
    int e, v;
    rational c;
    bool single; /* v + c has no other user */
};

static bool read_term(const struct schedule *s, int sum, size_t edge, int position, struct term *t)
{
    const struct node *node = &s->dag->node[sum], *n = &s->dag->node[node->edge[edge].node];
    if (n->kind != NODE_PRODUCT || s->uses[node->edge[edge].node] > 1 || n->edges != 2 ||
        n->edge[0].power + n->edge[1].power > 2)
        return false;
    const struct node *f = &s->dag->node[n->edge[position].node];
    if (f->kind != NODE_SUM || f->edges != 2)
        return false;
    const size_t one = f->edge[0].node == 0 ? 0 : 1;
    const rational c = f->edge[one].coef;
    *t =
        (struct term){edge, n->edge[1 - position].node, f->edge[1 - one].node, c, s->uses[n->edge[position].node] == 1};
    for (size_t i = 0; i < node->edges; i++)
        if (node->edge[i].node == t->e)
            return false;
    return f->edge[one].node == 0 && f->edge[1 - one].coef == ONE && (c == ONE || c == MINUS_ONE);
}

static int compare_terms(const void *a, const void *b)
{
    const struct term *x = a, *y = b;
    return x->v != y->v ? (x->v > y->v) - (x->v < y->v) : (x->edge > y->edge) - (x->edge < y->edge);
}

/* Rewrites terms of one v: a e (v + 1) + b f (v - 1) becomes a e - b f + v (a e + b f). */
static void spread_terms(struct dag *g, int sum, const struct term *t, size_t n)
{
    struct edges inner = {0};
    const rational first = g->node[sum].edge[t[0].edge].coef;
    for (size_t i = 0; i < n; i++)
        edges_add(&inner, rational_mul(g->node[sum].edge[t[i].edge].coef, rational_inv(first)), t[i].e, 1);
    const int other = dag_append(g, NODE_SUM, inner.edge, inner.n);
    const struct edge pair[2] = {{ONE, t[0].v, 1}, {ONE, other, 1}};
    const int product = dag_append(g, NODE_PRODUCT, pair, 2);
    struct node *node = &g->node[sum];
    struct edge *edge = dag_room(g, node->edges + 1);
    memcpy(edge, node->edge, node->edges * sizeof *edge);
    for (size_t i = 0; i < n; i++)
        edge[t[i].edge] = (struct edge){rational_mul(edge[t[i].edge].coef, t[i].c), t[i].e, 1};
    edge[node->edges++] = (struct edge){first, product, 1};
    node->edge = edge;
    edges_clear(&inner);
}

/* Trades several multiplications for one, with an extra addition for each, and one fewer for each v + c that
 * vanishes. */
static void spread_sum(struct dag *g, const struct schedule *s, int sum)
{
    const size_t edges = g->node[sum].edges;
    struct term *t = new_array(edges, sizeof *t);
    size_t n = 0;
    for (size_t i = 0; i < edges; i++)
        n += read_term(s, sum, i, 0, &t[n]) || read_term(s, sum, i, 1, &t[n]);
    qsort(t, n, sizeof *t, compare_terms);
    for (size_t i = 0, k; i < n; i = k) {
        double saved = -s->model->mul;
        for (k = i; k < n && t[k].v == t[i].v; k++)
            saved += s->model->mul - (t[k].single ? 0 : s->model->add);
        if (saved > 0)
            spread_terms(g, sum, &t[i], k - i);
    }
    free(t);
}

static void spread_sums(struct dag *g, const struct cost_model *m)
{
    struct schedule *s = scaled_schedule(g, m, SCALES_KEPT, NULL);
    for (size_t i = 0; i < s->n; i++)
        if (g->node[s->order[i]].kind == NODE_SUM && g->node[s->order[i]].edges <= MOST_OPERANDS)
            spread_sum(g, s, s->order[i]);
    schedule_free(s);
}

static bool distribute_all(struct dag *g, const struct cost_model *m)
{
    struct schedule *s = scaled_schedule(g, m, SCALES_KEPT, NULL);
    struct readings r = {0};
    bool *done = new_array(g->nodes, sizeof *done), any = false;
    read_products(&r, s);
    if (r.n > 0)
        qsort(r.list, r.n, sizeof *r.list, compare_readings);
    for (size_t i = 0, k; i < r.n; i = k) {
        for (k = i + 1; k < r.n && r.list[k].e == r.list[i].e && r.list[k].v == r.list[i].v;)
            k++;
        any |= distribute(g, s, &r.list[i], k - i, done);
    }
    schedule_free(s);
    free(r.list);
    free(done);
    return any;
}

void distribute_products(struct dag *g, const struct cost_model *m)
{
    for (int round = 0; round < ROUNDS && distribute_all(g, m); round++)
        ;
    spread_sums(g, m);
}
