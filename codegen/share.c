/* Greedy sharing of pairs, for products of factors and for sums of terms alike: count every pair, give the one that
 * saves most a node of its own, put it in, and start over until none occurs twice. */
#include "share.h"

#include <stdlib.h>
#include <string.h>

/* Bounds that keep enormous input to some seconds; MOST_WORK counts listed pairs over all rounds. */
enum { MOST_OPERANDS = 150, MOST_PAIRS = 1 << 20, MOST_WORK = 20000000 };

/* One occurrence of a pair of operands a <= b in `user`. */
struct pair {
    int a, b, user;
    int count;      /* products: how often it fits; sums: 1 */
    rational ratio; /* sums: coefficient of b over that of a; products: ONE */
};

struct sharing {
    struct dag *dag;
    int *uses; /* owned */
    size_t use_room;
    enum node_kind kind;
    struct pair *pair; /* owned */
    size_t n, room, work;
};

static void add_pair(struct sharing *s, const struct edge *x, const struct edge *y, int user, int count)
{
    const rational ratio = s->kind == NODE_SUM ? rational_mul(y->coef, rational_inv(x->coef)) : ONE;
    grow_array(&s->pair, s->n, &s->room, sizeof *s->pair);
    s->pair[s->n++] = (struct pair){.a = x->node, .b = y->node, .user = user, .count = count, .ratio = ratio};
}

static int compare_pairs(const void *x, const void *y)
{
    const struct pair *p = x, *q = y;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    if (p->b != q->b)
        return p->b < q->b ? -1 : 1;
    if (p->ratio != q->ratio)
        return p->ratio < q->ratio ? -1 : 1;
    return (p->user > q->user) - (p->user < q->user);
}

static bool same_pair(const struct pair *p, const struct pair *q)
{
    return p->a == q->a && p->b == q->b && p->ratio == q->ratio;
}

static void list_pairs(struct sharing *s)
{
    for (size_t n = 0; n < s->dag->nodes && s->n < MOST_PAIRS; n++) {
        const struct node *node = &s->dag->node[n];
        if (!s->uses[n] || node->kind != s->kind || node->edges > MOST_OPERANDS)
            continue;
        for (size_t i = 0; i < node->edges; i++) {
            const struct edge *x = &node->edge[i];
            if (s->kind == NODE_PRODUCT && x->power > 1)
                add_pair(s, x, x, (int)n, x->power / 2);
            for (size_t j = i + 1; j < node->edges; j++) {
                const struct edge *y = &node->edge[j];
                const int count = x->power < y->power ? x->power : y->power;
                if (x->node < y->node)
                    add_pair(s, x, y, (int)n, count);
                else
                    add_pair(s, y, x, (int)n, count);
            }
        }
    }
}

/* Length of the run of equal pairs that saves most: products save one multiplication for each occurrence but the first;
 * sums one addition, and one multiplication if the ratio is not +-1. */
static size_t best_run(const struct sharing *s, size_t *start)
{
    size_t length = 0;
    long most = 0;
    for (size_t i = 0, j; i < s->n; i = j) {
        long occurrences = 0;
        for (j = i; j < s->n && same_pair(&s->pair[i], &s->pair[j]); j++)
            occurrences += s->pair[j].count;
        const bool plain = s->pair[i].ratio == ONE || s->pair[i].ratio == MINUS_ONE;
        const long saved = (occurrences - 1) * (plain ? 1 : 2);
        if (saved > most) {
            most = saved;
            length = j - i;
            *start = i;
        }
    }
    return length;
}

static int new_pair_node(struct sharing *s, const struct pair *p)
{
    const struct edge edge[2] = {{ONE, p->a, p->a == p->b ? 2 : 1}, {p->ratio, p->b, 1}};
    grow_array(&s->uses, s->dag->nodes, &s->use_room, sizeof *s->uses);
    s->uses[s->dag->nodes] = 1;
    return dag_append(s->dag, s->kind, edge, p->a == p->b ? 1 : 2);
}

/* Puts node `part` in the place of the pair. */
static void use_pair(struct sharing *s, const struct pair *p, int part)
{
    struct node *n = &s->dag->node[p->user];
    struct edge *edge = dag_room(s->dag, n->edges + 1);
    rational coef = ONE;
    size_t kept = 0;
    for (size_t i = 0; i < n->edges; i++) {
        struct edge e = n->edge[i];
        const bool mine = e.node == p->a || e.node == p->b;
        if (e.node == p->a)
            coef = e.coef;
        if (mine)
            e.power -= p->count * (p->a == p->b ? 2 : 1);
        if (e.power > 0)
            edge[kept++] = e;
    }
    edge[kept++] = (struct edge){coef, part, p->count};
    n->edge = edge;
    n->edges = kept;
}

/* The pairs' terms in a sum may meet in a user only once; of the same user, runs hold it once by construction. */
static bool share_once(struct sharing *s)
{
    size_t start = 0;
    list_pairs(s);
    s->work += s->n + s->dag->nodes;
    if (s->n > 1)
        qsort(s->pair, s->n, sizeof *s->pair, compare_pairs);
    const size_t length = best_run(s, &start);
    if (length > 0) {
        const int part = new_pair_node(s, &s->pair[start]);
        for (size_t i = start; i < start + length; i++)
            use_pair(s, &s->pair[i], part);
    }
    s->n = 0;
    return length > 0;
}

void share_pairs(struct dag *g)
{
    struct sharing s = {.dag = g, .uses = dag_uses(g), .use_room = g->nodes};
    for (int pass = 0; pass < 2; pass++) {
        s.kind = pass == 0 ? NODE_PRODUCT : NODE_SUM;
        s.work = 0;
        while (s.work < MOST_WORK && share_once(&s))
            ;
    }
    free(s.uses);
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
