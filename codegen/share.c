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
    int count;          /* products: how often it fits; sums: 1 */
    fmpq_t ratio;       /* sums: coefficient of b over that of a; products: 1 */
    unsigned long hash; /* of the ratio */
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
    grow_array(&s->pair, s->n, &s->room, sizeof *s->pair);
    struct pair *p = &s->pair[s->n++];
    *p = (struct pair){.a = x->node, .b = y->node, .user = user, .count = count};
    fmpq_init(p->ratio);
    if (s->kind == NODE_SUM)
        fmpq_div(p->ratio, y->coef, x->coef);
    p->hash = fmpz_fdiv_ui(fmpq_numref(p->ratio), 4294967291UL) * 4294967296UL +
              fmpz_fdiv_ui(fmpq_denref(p->ratio), 4294967279UL);
}

static int compare_pairs(const void *x, const void *y)
{
    const struct pair *p = x, *q = y;
    if (p->a != q->a)
        return p->a < q->a ? -1 : 1;
    if (p->b != q->b)
        return p->b < q->b ? -1 : 1;
    if (p->hash != q->hash)
        return p->hash < q->hash ? -1 : 1;
    return (p->user > q->user) - (p->user < q->user);
}

static bool same_pair(const struct pair *p, const struct pair *q)
{
    return p->a == q->a && p->b == q->b && p->hash == q->hash && fmpq_equal(p->ratio, q->ratio);
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
        const bool plain = s->kind == NODE_PRODUCT || fmpz_is_pm1(fmpq_numref(s->pair[i].ratio));
        const long saved = (occurrences - 1) * (plain && fmpz_is_one(fmpq_denref(s->pair[i].ratio)) ? 1 : 2);
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
    struct dag *g = s->dag;
    struct edges list = {0};
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    if (p->a == p->b)
        edges_add(&list, one, p->a, 2);
    else {
        edges_add(&list, one, p->a, 1);
        edges_add(&list, s->kind == NODE_SUM ? p->ratio : one, p->b, 1);
    }
    grow_array(&g->node, g->nodes, &g->node_room, sizeof *g->node);
    grow_array(&s->uses, g->nodes, &s->use_room, sizeof *s->uses);
    s->uses[g->nodes] = 1;
    g->node[g->nodes] = (struct node){.kind = s->kind, .edge = list.edge, .edges = list.n};
    fmpq_clear(one);
    return (int)g->nodes++;
}

static struct edge *find_edge(struct node *n, int node)
{
    for (size_t i = 0; i < n->edges; i++)
        if (n->edge[i].node == node)
            return &n->edge[i];
    return NULL;
}

static void remove_edge(struct node *n, struct edge *e)
{
    fmpq_clear(e->coef);
    memmove(e, e + 1, (size_t)(n->edge + n->edges - (e + 1)) * sizeof *e);
    n->edges--;
}

/* Puts node `part` in the place of the pair. */
static void use_pair(struct sharing *s, const struct pair *p, int part)
{
    struct node *n = &s->dag->node[p->user];
    struct edges list = {n->edge, n->edges, n->edges};
    fmpq_t coef;
    fmpq_init(coef);
    struct edge *a = find_edge(n, p->a), *b = find_edge(n, p->b);
    fmpq_set(coef, a->coef);
    if (s->kind == NODE_SUM) {
        remove_edge(n, a < b ? b : a);
        remove_edge(n, a < b ? a : b);
    } else {
        a->power -= p->count * (p->a == p->b ? 2 : 1);
        if (a != b)
            b->power -= p->count;
        struct edge *later = a < b ? b : a, *earlier = a < b ? a : b;
        if (later != earlier && later->power == 0)
            remove_edge(n, later);
        if (earlier->power == 0)
            remove_edge(n, earlier);
    }
    list = (struct edges){n->edge, n->edges, n->edges};
    edges_add(&list, coef, part, p->count);
    n->edge = list.edge;
    n->edges = list.n;
    fmpq_clear(coef);
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
    for (size_t i = 0; i < s->n; i++)
        fmpq_clear(s->pair[i].ratio);
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
