/* Shares (c f) between c f + ... and c f g + ..., which saves a multiplication by c; see share_multiples.h. It runs
 * after the search for scales, which decides the coefficients. The pair (c, f) of most terms goes first. */
#include "share_multiples.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_ENTRIES = 5000 }; /* larger graphs are not searched */

/* Term `edge` of sum `sum`, separate with a coefficient of this size, is node `factor` or a product with it that has no
 * other user. */
struct entry {
    int factor;
    rational size;
    int sum;
    size_t edge;
    bool direct; /* the term is the factor itself */
};

struct entries {
    struct entry *list; /* owned */
    size_t n, room;
};

static void add_entry(struct entries *x, struct entry e)
{
    APPEND(x->list, x->n, x->room) = e;
}

static void add_sum(struct entries *x, const struct schedule *s, int sum, struct addend *term)
{
    const struct node *node = &s->dag->node[sum];
    schedule_sort_addends(s, sum, term);
    for (size_t k = 0; k < node->edges; k++) {
        const rational like = term[k].like;
        if (like == ZERO || (k > 0 && term[k - 1].like == like) || (k + 1 < node->edges && term[k + 1].like == like))
            continue;
        const int operand = node->edge[term[k].edge].node;
        const struct node *product = &s->dag->node[operand];
        add_entry(x, (struct entry){operand, term[k].size, sum, term[k].edge, true});
        for (size_t i = 0; product->kind == NODE_PRODUCT && s->uses[operand] == 1 && i < product->edges; i++)
            add_entry(x, (struct entry){product->edge[i].node, term[k].size, sum, term[k].edge, false});
    }
}

static int compare_entries(const void *a, const void *b)
{
    const struct entry *x = a, *y = b;
    if (x->factor != y->factor)
        return x->factor < y->factor ? -1 : 1;
    if (x->size != y->size)
        return x->size < y->size ? -1 : 1;
    if (x->direct != y->direct)
        return x->direct ? -1 : 1;
    if (x->sum != y->sum)
        return x->sum < y->sum ? -1 : 1;
    return (x->edge > y->edge) - (x->edge < y->edge);
}

static struct entries find_entries(const struct schedule *s)
{
    struct entries x = {0};
    size_t most = 0;
    for (size_t i = 0; i < s->n; i++)
        if (most < s->dag->node[s->order[i]].edges)
            most = s->dag->node[s->order[i]].edges;
    struct addend *term = new_array(most, sizeof *term);
    for (size_t i = 0; i < s->n && x.n < MOST_ENTRIES; i++)
        if (s->dag->node[s->order[i]].kind == NODE_SUM)
            add_sum(&x, s, s->order[i], term);
    free(term);
    if (x.n > 0)
        qsort(x.list, x.n, sizeof *x.list, compare_entries);
    return x;
}

/* Returns the end of the run of entries with the same factor and size that begins at `first`, and the multiplications
 * saved. Equal terms are shared already. */
static size_t end_of_run(const struct entries *x, size_t first, size_t *saved)
{
    size_t i = first, products = 0;
    for (; i < x->n && x->list[i].factor == x->list[first].factor && x->list[i].size == x->list[first].size; i++)
        products += !x->list[i].direct;
    const size_t terms = products + x->list[first].direct;
    *saved = products > 0 ? terms - 1 : 0;
    return i;
}

/* Copies a graph with its node numbers, although they are neither ordered nor unique, as dag_copy() requires. */
static struct dag *same_graph(const struct dag *g)
{
    struct dag *copy = dag_new(g->inputs);
    for (size_t n = 1; n < g->nodes; n++) {
        const int made = dag_append(copy, g->node[n].kind, NULL, 0);
        struct edge *edge = dag_room(copy, g->node[n].edges);
        if (g->node[n].edges > 0)
            memcpy(edge, g->node[n].edge, g->node[n].edges * sizeof *edge);
        copy->node[made].edge = edge;
        copy->node[made].edges = g->node[n].edges;
        copy->node[made].input = g->node[n].input;
        copy->node[made].divides = g->node[n].divides;
    }
    for (size_t o = 0; o < g->outputs; o++)
        dag_add_output(copy, g->output_name[o], g->output[o]);
    return copy;
}

/* Returns the scales of the schedule by node, except for inverses: here they are 1 / emitted value, as in a graph.
 * Another search chooses their numerators. The caller frees it. */
static rational *plain_scales(const struct schedule *s)
{
    rational *scale = new_array(s->dag->nodes, sizeof *scale);
    for (size_t i = 0; i < s->n; i++) {
        const int n = s->order[i];
        const struct node *node = &s->dag->node[n];
        scale[n] = node->kind == NODE_PRODUCT ? ONE : s->scale[n];
        if (node->kind == NODE_INVERSE)
            scale[n] = rational_inv(scale[node->edge[0].node]);
        for (size_t k = 0; node->kind == NODE_PRODUCT && k < node->edges; k++)
            scale[n] = rational_mul(scale[n], rational_pow(scale[node->edge[k].node], node->edge[k].power));
    }
    return scale;
}

/* Returns the graph with the schedule's scales as coefficients. */
static struct dag *scaled_graph(const struct schedule *s)
{
    struct dag *g = same_graph(s->dag);
    for (size_t i = 0; i < s->n; i++) {
        const int n = s->order[i];
        struct node *node = &g->node[n];
        for (size_t k = 0; node->kind != NODE_PRODUCT && node->kind != NODE_INVERSE && k < node->edges; k++)
            node->edge[k].coef = schedule_coefficient(s, n, k);
    }
    for (size_t o = 0; o < g->outputs; o++)
        g->output[o].coef = rational_mul(g->output[o].coef, rational_inv(s->scale[g->output[o].node]));
    return g;
}

static rational sign_of(rational c)
{
    return rational_sign(c) < 0 ? MINUS_ONE : ONE;
}

/* Replaces size and factor by node `multiple`, their product. */
static void use_multiple(struct dag *g, const struct entry *e, int multiple)
{
    struct edge *term = &g->node[e->sum].edge[e->edge];
    const int operand = term->node;
    term->coef = sign_of(term->coef);
    if (e->direct) {
        term->node = multiple;
        return;
    }
    struct edge *edge = dag_room(g, g->node[operand].edges + 1);
    struct node *product = &g->node[operand];
    size_t kept = 0;
    for (size_t i = 0; i < product->edges; i++) {
        edge[kept] = product->edge[i];
        edge[kept].power -= product->edge[i].node == e->factor;
        kept += edge[kept].power > 0;
    }
    edge[kept++] = (struct edge){ONE, multiple, 1};
    product->edge = edge;
    product->edges = kept;
}

/* Moves the run into the graph and removes all other entries of its terms from the list. */
static void take_run(struct dag *g, struct entries *x, size_t first, size_t end)
{
    const struct edge own = {x->list[first].size, x->list[first].factor, 1};
    const int multiple = dag_append(g, NODE_SUM, &own, 1);
    size_t kept = 0;
    for (size_t i = first; i < end; i++)
        use_multiple(g, &x->list[i], multiple);
    struct entries taken = {0};
    for (size_t i = first; i < end; i++)
        add_entry(&taken, x->list[i]);
    for (size_t i = 0; i < x->n; i++) {
        bool gone = false;
        for (size_t k = 0; k < taken.n && !gone; k++)
            gone = x->list[i].sum == taken.list[k].sum && x->list[i].edge == taken.list[k].edge;
        if (!gone)
            x->list[kept++] = x->list[i];
    }
    x->n = kept;
    free(taken.list);
}

struct dag *multiples_taken(const struct schedule *schedule, size_t *saved)
{
    struct schedule plain = *schedule, *s = &plain;
    plain.scale = plain_scales(schedule);
    struct entries x = find_entries(s);
    struct dag *g = NULL;
    *saved = 0;
    while (x.n < MOST_ENTRIES) {
        size_t most = 0, best = 0, best_end = 0, gain;
        for (size_t i = 0, end; i < x.n; i = end) {
            end = end_of_run(&x, i, &gain);
            if (gain > most) {
                most = gain;
                best = i;
                best_end = end;
            }
        }
        if (most == 0)
            break;
        if (!g)
            g = scaled_graph(s);
        take_run(g, &x, best, best_end);
        *saved += most;
    }
    free(x.list);
    free(plain.scale);
    return g;
}
