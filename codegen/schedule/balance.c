/* Orders operands by the time at which they are ready; see balance.h. A node is ready when its last operand is ready
 * and its own operation is done. */
#include "balance.h"

#include "scales.h"

#include <stdlib.h>

enum { MOST_OPERANDS = 200 }; /* longer lists are not sorted */

struct operand {
    struct edge edge;
    double ready;
};

static double later(double a, double b)
{
    return a > b ? a : b;
}

/* Inserts into a list sorted by time, latest first. */
static void put_operand(struct operand *list, size_t *n, struct operand o)
{
    size_t i = (*n)++;
    for (; i > 0 && list[i - 1].ready < o.ready; i--)
        list[i] = list[i - 1];
    list[i] = o;
}

/* Lists factors one by one, and terms with the time of their coefficient. */
static size_t list_operands(const struct node *n, const double *ready, const struct cost_model *m, struct operand *list)
{
    size_t count = 0;
    for (size_t i = 0; i < n->edges; i++) {
        const struct edge *e = &n->edge[i];
        const bool scaled = n->kind == NODE_SUM && e->node != 0 && e->coef != ONE && e->coef != MINUS_ONE;
        for (int k = 0; k < (n->kind == NODE_SUM ? 1 : e->power); k++)
            put_operand(list, &count, (struct operand){{e->coef, e->node, 1}, ready[e->node] + (scaled ? m->mul : 0)});
    }
    return count;
}

static size_t operand_count(const struct node *n)
{
    size_t count = 0;
    for (size_t i = 0; i < n->edges; i++)
        count += n->kind == NODE_SUM ? 1 : (size_t)n->edge[i].power;
    return count;
}

static double function_time(const struct node *n, const double *ready, const struct cost_model *m)
{
    const double step = n->kind >= NODE_UNARY                             ? unary_cost(m, n->kind - NODE_UNARY)
                        : n->kind == NODE_INVERSE || n->kind == NODE_PDIV ? m->div
                                                                          : m->compare;
    double start = 0;
    for (size_t i = 0; i < n->edges; i++)
        start = later(start, ready[n->edge[i].node]);
    return n->edges > 0 ? start + step : 0;
}

/* Sorts a node's operands; returns the time at which the chain over them is ready. */
static double sort_node(struct dag *g, int n, const double *ready, const struct cost_model *m)
{
    const double step = g->node[n].kind == NODE_SUM ? m->add : m->mul;
    struct operand list[MOST_OPERANDS];
    size_t count = list_operands(&g->node[n], ready, m, list), kept = 0;
    double time = 0;
    for (size_t i = count; i-- > 0;) {
        struct edge *e = &g->node[n].edge[kept];
        time = i + 1 == count ? list[i].ready : later(time, list[i].ready) + step;
        if (kept > 0 && g->node[n].kind == NODE_PRODUCT && e[-1].node == list[i].edge.node)
            e[-1].power++;
        else {
            *e = list[i].edge;
            kept++;
        }
    }
    return time;
}

void balance_order(struct dag *g)
{
    struct schedule *s = scaled_schedule(g, &cost_cycles, SCALES_KEPT, NULL);
    double *ready = new_array(g->nodes, sizeof *ready);
    for (size_t i = 0; i < s->n; i++) {
        const int n = s->order[i];
        const struct node *node = &g->node[n];
        const bool list = node->kind == NODE_SUM || node->kind == NODE_PRODUCT;
        const bool sorts = list && operand_count(node) <= MOST_OPERANDS;
        ready[n] = sorts ? sort_node(g, n, ready, &cost_cycles) : function_time(node, ready, &cost_cycles);
    }
    schedule_free(s);
    free(ready);
}
