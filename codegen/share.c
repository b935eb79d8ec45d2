/* Greedy sharing of pairs, for products of factors and for sums of terms alike: the pair that saves most is given a
 * node of its own wherever it occurs, until none occurs twice.  A hash table counts all pairs; each round takes the
 * pairs of the nodes that it rewrites out and puts their new ones in. */
#include "share.h"

#include "policy.h"

#include <stdlib.h>
#include <string.h>

/* Bounds that keep enormous input to some seconds; MOST_WORK counts pairs and places looked at. */
enum { MOST_OPERANDS = 150, MOST_PAIRS = 1 << 20, MOST_WORK = 100000000 };

/* A pair of operands a <= b. */
struct pair {
    int a, b;
    rational ratio; /* sums: coefficient of b over that of a; products: ONE */
    int count;      /* how often it occurs; may be 0 */
};

struct sharing {
    struct dag *dag;
    bool *used; /* owned: by node */
    size_t used_room;
    enum node_kind kind;
    struct pair *pair; /* owned: hash table; a is -1 where it is empty */
    size_t room, n;
    size_t work;
};

static size_t place_of(const struct sharing *s, int a, int b, rational ratio)
{
    size_t i = policy_mix((uint64_t)a << 40 ^ (uint64_t)b << 20 ^ (uint64_t)ratio) & (s->room - 1);
    while (s->pair[i].a >= 0 && (s->pair[i].a != a || s->pair[i].b != b || s->pair[i].ratio != ratio))
        i = (i + 1) & (s->room - 1);
    return i;
}

static void clear_table(struct sharing *s, size_t room)
{
    free(s->pair);
    s->room = room;
    s->n = 0;
    s->pair = new_array(room, sizeof *s->pair);
    for (size_t i = 0; i < room; i++)
        s->pair[i].a = -1;
}

static void grow_table(struct sharing *s)
{
    struct pair *old = s->pair;
    const size_t room = s->room;
    s->pair = NULL;
    clear_table(s, 2 * room);
    for (size_t i = 0; i < room; i++)
        if (old[i].a >= 0 && old[i].count > 0) {
            s->pair[place_of(s, old[i].a, old[i].b, old[i].ratio)] = old[i];
            s->n++;
        }
    free(old);
}

static void count_pair(struct sharing *s, const struct edge *x, const struct edge *y, int count)
{
    const bool swap = x->node > y->node;
    const struct edge *first = swap ? y : x, *second = swap ? x : y;
    const rational ratio = s->kind == NODE_SUM ? rational_mul(second->coef, rational_inv(first->coef)) : ONE;
    if (2 * s->n > s->room)
        grow_table(s);
    struct pair *p = &s->pair[place_of(s, first->node, second->node, ratio)];
    if (p->a < 0) {
        *p = (struct pair){first->node, second->node, ratio, 0};
        s->n++;
    }
    p->count += count;
}

/* The pairs of a node come (sign 1) or go (-1).  A factor may be paired with itself. */
static void count_node(struct sharing *s, const struct node *node, int sign)
{
    if (node->kind != s->kind || node->edges > MOST_OPERANDS)
        return;
    s->work += node->edges * node->edges;
    for (size_t i = 0; i < node->edges; i++) {
        const struct edge *x = &node->edge[i];
        if (s->kind == NODE_PRODUCT && x->power > 1)
            count_pair(s, x, x, sign * (x->power / 2));
        for (size_t j = i + 1; j < node->edges; j++)
            count_pair(s, x, &node->edge[j], sign * (x->power < node->edge[j].power ? x->power : node->edge[j].power));
    }
}

/* Saved by giving a pair a node of its own: in products one multiplication for each occurrence but the first; in sums
 * one addition, and one multiplication if the ratio is not +-1. */
static long saving(const struct sharing *s, const struct pair *p)
{
    const bool plain = s->kind == NODE_PRODUCT || p->ratio == ONE || p->ratio == MINUS_ONE;
    return (p->count - 1L) * (plain ? 1 : 2);
}

static bool precedes(const struct pair *p, const struct pair *q)
{
    return p->a != q->a ? p->a < q->a : p->b != q->b ? p->b < q->b : p->ratio < q->ratio;
}

static const struct pair *best_pair(struct sharing *s)
{
    const struct pair *best = NULL;
    long most = 0;
    s->work += s->room;
    for (size_t i = 0; i < s->room; i++) {
        const struct pair *p = &s->pair[i];
        if (p->a < 0 || p->count < 2)
            continue;
        const long saved = saving(s, p);
        if (saved > most || (saved == most && precedes(p, best))) {
            most = saved;
            best = p;
        }
    }
    return best;
}

static int new_pair_node(struct sharing *s, const struct pair *p)
{
    const struct edge edge[2] = {{ONE, p->a, p->a == p->b ? 2 : 1}, {p->ratio, p->b, 1}};
    grow_array(&s->used, s->dag->nodes, &s->used_room, sizeof *s->used);
    s->used[s->dag->nodes] = true;
    return dag_append(s->dag, s->kind, edge, p->a == p->b ? 1 : 2);
}

/* How often the pair fits into a node. */
static int fits(const struct sharing *s, const struct node *n, const struct pair *p)
{
    const struct edge *a = NULL, *b = NULL;
    for (size_t i = 0; i < n->edges; i++) {
        if (n->edge[i].node == p->a)
            a = &n->edge[i];
        if (n->edge[i].node == p->b)
            b = &n->edge[i];
    }
    if (!a || !b)
        return 0;
    if (s->kind == NODE_SUM)
        return rational_mul(b->coef, rational_inv(a->coef)) == p->ratio;
    return a == b ? a->power / 2 : a->power < b->power ? a->power : b->power;
}

/* Puts node `part` in the place of the pair. */
static void use_pair(struct sharing *s, int user, const struct pair *p, int count, int part)
{
    struct edge *edge = dag_room(s->dag, s->dag->node[user].edges + 1);
    struct node *n = &s->dag->node[user];
    rational coef = ONE;
    size_t kept = 0;
    for (size_t i = 0; i < n->edges; i++) {
        struct edge e = n->edge[i];
        if (e.node == p->a)
            coef = e.coef;
        if (e.node == p->a || e.node == p->b)
            e.power -= count * (p->a == p->b ? 2 : 1);
        if (e.power > 0)
            edge[kept++] = e;
    }
    edge[kept++] = (struct edge){coef, part, count};
    n->edge = edge;
    n->edges = kept;
}

static void share_pair(struct sharing *s, struct pair p)
{
    const size_t nodes = s->dag->nodes;
    const int part = new_pair_node(s, &p);
    for (size_t n = 0; n < nodes; n++) {
        const struct node *node = &s->dag->node[n];
        s->work += node->edges;
        if (!s->used[n] || node->kind != s->kind || node->edges > MOST_OPERANDS)
            continue;
        const int count = fits(s, node, &p);
        if (count == 0)
            continue;
        count_node(s, node, -1);
        use_pair(s, (int)n, &p, count, part);
        count_node(s, &s->dag->node[n], 1);
    }
    count_node(s, &s->dag->node[part], 1);
}

static void share_kind(struct sharing *s, enum node_kind kind)
{
    const struct pair *best;
    s->kind = kind;
    s->work = 0;
    clear_table(s, 256);
    for (size_t n = 0; n < s->dag->nodes && s->n < MOST_PAIRS; n++)
        if (s->used[n])
            count_node(s, &s->dag->node[n], 1);
    while (s->work < MOST_WORK && (best = best_pair(s)))
        share_pair(s, *best);
}

void share_pairs(struct dag *g)
{
    struct sharing s = {.dag = g};
    int *uses = dag_uses(g);
    s.used = new_array(g->nodes, sizeof *s.used);
    s.used_room = g->nodes;
    for (size_t n = 0; n < g->nodes; n++)
        s.used[n] = uses[n] > 0;
    share_kind(&s, NODE_PRODUCT);
    share_kind(&s, NODE_SUM);
    free(uses);
    free(s.used);
    free(s.pair);
}

void share_multiples(struct dag *g)
{
    int *uses = dag_uses(g), *times = new_array(g->nodes, sizeof *times), *alias = new_array(g->nodes, sizeof *alias);
    const size_t nodes = g->nodes;
    for (size_t n = 0; n < nodes; n++)
        for (size_t i = 0; uses[n] && g->node[n].kind == NODE_PRODUCT && i < g->node[n].edges; i++)
            times[g->node[n].edge[i].node]++;
    for (size_t n = 1; n < nodes; n++)
        if (times[n] > 1 && (g->node[n].kind == NODE_INPUT || g->node[n].kind == NODE_PRODUCT)) {
            const struct edge e = {ONE, (int)n, 1};
            alias[n] = dag_append(g, NODE_SUM, &e, 1);
        }
    for (size_t n = 0; n < nodes; n++)
        for (size_t i = 0; g->node[n].kind == NODE_PRODUCT && i < g->node[n].edges; i++)
            if (alias[g->node[n].edge[i].node])
                g->node[n].edge[i].node = alias[g->node[n].edge[i].node];
    free(uses);
    free(times);
    free(alias);
}
