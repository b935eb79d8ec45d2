/* Greedy sharing of pairs, for products of factors and sums of terms. The pair that saves most gets a node of its own
 * wherever it occurs, until no pair occurs twice. A hash table counts all pairs; each round removes the pairs of the
 * nodes that it rewrites and inserts their new pairs. A heap contains every pair with an upper bound of its saving; an
 * outdated entry is noticed when it reaches the top. */
#include "cse.h"

#include "choices.h"

#include <stdlib.h>
#include <string.h>

/* Bounds that limit enormous input to some seconds; MOST_WORK counts pairs and places examined. */
enum { MOST_OPERANDS = 150, MOST_PAIRS = 1 << 20, MOST_WORK = 100000000, QUEUE_WORK = 10 };

/* A pair of operands a <= b. */
struct pair {
    int a, b;
    rational ratio; /* sums: coefficient of b over coefficient of a; products: ONE */
    int count;      /* occurrences; may be 0 */
    long queued;    /* greatest saving among its heap entries; 0: not in the heap */
};

/* A pair in the heap. */
struct entry {
    long saved;
    int a, b;
    rational ratio;
};

struct sharing {
    struct dag *dag;
    bool *used; /* owned: indexed by node */
    size_t used_room;
    enum node_kind kind;
    struct pair *pair; /* owned: hash table; a is -1 in an empty slot */
    size_t room, n;
    struct entry *heap; /* owned: the first entry saves most */
    size_t queue, heap_room;
    bool queues; /* rising counts are pushed on the heap */
    int *member; /* owned: the used nodes of that kind */
    size_t members, member_room;
    size_t work;
};

static size_t place_of(const struct sharing *s, int a, int b, rational ratio)
{
    size_t i = random_of((uint64_t)a << 40 ^ (uint64_t)b << 20 ^ (uint64_t)ratio) & (s->room - 1);
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

/* Returns the saving if a pair gets a node of its own: for products, one multiplication for each occurrence but the
 * first; for sums, one addition, and one multiplication if the ratio is not +-1. */
static long saving(const struct sharing *s, const struct pair *p)
{
    const bool plain = s->kind == NODE_PRODUCT || p->ratio == ONE || p->ratio == MINUS_ONE;
    return (p->count - 1L) * (plain ? 1 : 2);
}

static bool precedes(const struct entry *p, const struct entry *q)
{
    return p->saved != q->saved ? p->saved > q->saved
           : p->a != q->a       ? p->a < q->a
           : p->b != q->b       ? p->b < q->b
                                : p->ratio < q->ratio;
}

static void queue_pair(struct sharing *s, struct pair *p)
{
    const struct entry e = {saving(s, p), p->a, p->b, p->ratio};
    if (e.saved <= p->queued)
        return;
    p->queued = e.saved;
    grow_array(&s->heap, s->queue, &s->heap_room, sizeof *s->heap);
    size_t i = s->queue++;
    for (; i > 0 && precedes(&e, &s->heap[(i - 1) / 2]); i = (i - 1) / 2)
        s->heap[i] = s->heap[(i - 1) / 2];
    s->heap[i] = e;
}

/* Removes the first entry from the heap. */
static struct entry next_entry(struct sharing *s)
{
    const struct entry first = s->heap[0], last = s->heap[--s->queue];
    size_t i = 0;
    for (size_t k = 1; k < s->queue; k = 2 * i + 1) {
        k += k + 1 < s->queue && precedes(&s->heap[k + 1], &s->heap[k]);
        if (!precedes(&s->heap[k], &last))
            break;
        s->heap[i] = s->heap[k];
        i = k;
    }
    s->heap[i] = last;
    return first;
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
        *p = (struct pair){first->node, second->node, ratio, 0, 0};
        s->n++;
    }
    p->count += count;
    if (s->queues && count > 0)
        queue_pair(s, p);
}

/* Adds (sign 1) or removes (-1) the pairs of a node: those with one of the operands a, b, c, or all if a is -1. A
 * factor may be paired with itself. */
static void count_node(struct sharing *s, const struct node *node, int a, int b, int c, int sign)
{
    if (node->kind != s->kind || node->edges > MOST_OPERANDS)
        return;
    for (size_t i = 0; i < node->edges; i++) {
        const struct edge *x = &node->edge[i];
        const bool all = a < 0 || x->node == a || x->node == b || x->node == c;
        s->work += all ? 2 * node->edges : node->edges / 4;
        if (all && s->kind == NODE_PRODUCT && x->power > 1)
            count_pair(s, x, x, sign * (x->power / 2));
        for (size_t j = i + 1; j < node->edges; j++) {
            const struct edge *y = &node->edge[j];
            if (all || y->node == a || y->node == b || y->node == c)
                count_pair(s, x, y, sign * (x->power < y->power ? x->power : y->power));
        }
    }
}

/* Removes the pair that saves most from the heap; returns false if no pair saves anything. */
static bool best_pair(struct sharing *s, struct pair *best)
{
    while (s->queue > 0) {
        const struct entry e = next_entry(s);
        struct pair *p = &s->pair[place_of(s, e.a, e.b, e.ratio)];
        s->work += QUEUE_WORK;
        if (p->a < 0 || e.saved != p->queued)
            continue; /* it was pushed again */
        p->queued = 0;
        *best = *p;
        if (saving(s, p) == e.saved)
            return true;
        queue_pair(s, p);
    }
    return false;
}

static void add_member(struct sharing *s, int node)
{
    APPEND(s->member, s->members, s->member_room) = node;
}

static int new_pair_node(struct sharing *s, const struct pair *p)
{
    const struct edge edge[2] = {{ONE, p->a, p->a == p->b ? 2 : 1}, {p->ratio, p->b, 1}};
    grow_array(&s->used, s->dag->nodes, &s->used_room, sizeof *s->used);
    s->used[s->dag->nodes] = true;
    return dag_append(s->dag, s->kind, edge, p->a == p->b ? 1 : 2);
}

/* Returns how often the pair fits into a node. */
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

/* Replaces the pair by node `part`. */
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
    const size_t members = s->members;
    const int part = new_pair_node(s, &p);
    add_member(s, part);
    for (size_t i = 0; i < members; i++) {
        const int n = s->member[i];
        const struct node *node = &s->dag->node[n];
        s->work += 1 + node->edges;
        const int count = node->edges > MOST_OPERANDS ? 0 : fits(s, node, &p);
        if (count == 0)
            continue;
        const int a = node->edges < MOST_OPERANDS ? p.a : -1; /* with another operand, its pairs no longer count */
        count_node(s, node, a, p.b, part, -1);
        use_pair(s, n, &p, count, part);
        count_node(s, &s->dag->node[n], a, p.b, part, 1);
    }
    count_node(s, &s->dag->node[part], -1, -1, -1, 1);
}

static void share_kind(struct sharing *s, enum node_kind kind)
{
    struct pair best;
    s->kind = kind;
    s->work = s->queue = 0;
    s->queues = false;
    clear_table(s, 256);
    s->members = 0;
    for (size_t n = 0; n < s->dag->nodes; n++)
        if (s->used[n] && s->dag->node[n].kind == kind)
            add_member(s, (int)n);
    for (size_t i = 0; i < s->members && s->n < MOST_PAIRS; i++)
        count_node(s, &s->dag->node[s->member[i]], -1, -1, -1, 1);
    for (size_t i = 0; i < s->room; i++)
        if (s->pair[i].a >= 0)
            queue_pair(s, &s->pair[i]);
    s->queues = true;
    while (s->work < MOST_WORK && best_pair(s, &best))
        share_pair(s, best);
}

size_t share_pairs(struct dag *g)
{
    size_t work;
    struct sharing s = {.dag = g};
    int *uses = dag_uses(g);
    s.used = new_array(g->nodes, sizeof *s.used);
    s.used_room = g->nodes;
    for (size_t n = 0; n < g->nodes; n++)
        s.used[n] = uses[n] > 0;
    share_kind(&s, NODE_PRODUCT);
    work = s.work;
    share_kind(&s, NODE_SUM);
    work += s.work;
    free(uses);
    free(s.used);
    free(s.pair);
    free(s.heap);
    free(s.member);
    return work;
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
