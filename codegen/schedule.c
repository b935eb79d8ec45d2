/* Order: depth first from the outputs.  The scales are chosen in scales.c. */
#include "schedule.h"

#include "scales.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_COUNTED = 20000 }; /* edges of sums; beyond, no terms are shared */

static void order_nodes(struct schedule *s)
{
    const struct dag *g = s->dag;
    struct frame {
        int node;
        size_t edge;
    } *stack = new_array(g->nodes + 1, sizeof *stack);
    bool *seen = new_array(g->nodes, sizeof *seen);
    for (size_t o = 0; o < g->outputs; o++) {
        size_t depth = 0;
        s->uses[g->output[o].node]++;
        if (seen[g->output[o].node])
            continue;
        stack[depth++] = (struct frame){g->output[o].node, 0};
        seen[g->output[o].node] = true;
        while (depth > 0) {
            struct frame *top = &stack[depth - 1];
            const struct node *n = &g->node[top->node];
            if (top->edge == n->edges) {
                s->order[s->n++] = top->node;
                depth--;
                continue;
            }
            const int k = n->edge[top->edge++].node;
            s->uses[k]++;
            if (!seen[k]) {
                seen[k] = true;
                stack[depth++] = (struct frame){k, 0};
            }
        }
    }
    free(stack);
    free(seen);
}

rational schedule_coefficient(const struct schedule *s, int n, size_t i)
{
    const struct edge *e = &s->dag->node[n].edge[i];
    return rational_mul(rational_mul(s->scale[n], e->coef), rational_inv(s->scale[e->node]));
}

static int compare_addends(const void *a, const void *b)
{
    const struct addend *x = a, *y = b;
    return x->like != y->like ? (x->like > y->like) - (x->like < y->like) : (x->edge > y->edge) - (x->edge < y->edge);
}

void schedule_sort_addends(const struct schedule *s, int n, struct addend *sorted)
{
    const struct node *node = &s->dag->node[n];
    for (size_t k = 0; k < node->edges; k++) {
        const rational coef = schedule_coefficient(s, n, k), size = rational_abs(coef);
        sorted[k] = (struct addend){coef, size, node->edge[k].node == 0 || size == ONE ? ZERO : size, k};
    }
    qsort(sorted, node->edges, sizeof *sorted, compare_addends);
}

/* Counts in how many sums each term size * node stands alone with its coefficient. */
static void count_terms(struct schedule *s, size_t most_edges)
{
    struct addend *term = new_array(most_edges, sizeof *term);
    for (size_t i = 0; i < s->n; i++) {
        const struct node *node = &s->dag->node[s->order[i]];
        if (node->kind != NODE_SUM)
            continue;
        schedule_sort_addends(s, s->order[i], term);
        for (size_t k = 0; k < node->edges; k++) {
            if (term[k].like == ZERO || (k > 0 && term[k - 1].like == term[k].like) ||
                (k + 1 < node->edges && term[k + 1].like == term[k].like))
                continue;
            const int operand = node->edge[term[k].edge].node;
            struct shared_term *t = schedule_term(s->term, s->terms, term[k].size, operand);
            *t = (struct shared_term){term[k].size, operand, t->times + 1};
        }
    }
    free(term);
}

struct shared_term *schedule_term(struct shared_term *table, size_t room, rational size, int node)
{
    size_t i = ((size_t)size * 2654435761u + (size_t)node * 40503u) & (room - 1);
    while (table[i].size != 0 && (table[i].size != size || table[i].node != node))
        i = (i + 1) & (room - 1);
    return &table[i];
}

bool schedule_shares_term(const struct schedule *s, rational size, int node)
{
    return schedule_term(s->term, s->terms, size, node)->times > 1;
}

int schedule_doublings(const struct schedule *s, rational c)
{
    const rational size = rational_abs(c);
    const int n = size == TWO ? 1 : size == FOUR ? 2 : size == EIGHT ? 3 : 0;
    return n * s->model->add < s->model->mul ? n : 0;
}

struct schedule *schedule_new(const struct dag *g, const struct cost_model *model, bool search)
{
    struct schedule *s = new_array(1, sizeof *s);
    size_t edges = 0;
    s->dag = g;
    s->model = model;
    s->order = new_array(g->nodes, sizeof *s->order);
    s->uses = new_array(g->nodes, sizeof *s->uses);
    s->scale = new_array(g->nodes, sizeof *s->scale);
    for (size_t n = 0; n < g->nodes; n++) {
        s->scale[n] = ONE;
        edges += g->node[n].kind == NODE_SUM ? g->node[n].edges : 0;
    }
    order_nodes(s);
    if (search)
        s->work = scales_improve(s);
    for (s->terms = 16; s->terms < 2 * edges; s->terms *= 2)
        ;
    s->term = new_array(s->terms, sizeof *s->term);
    if (edges <= MOST_COUNTED)
        count_terms(s, edges);
    return s;
}

void schedule_free(struct schedule *s)
{
    if (!s)
        return;
    free(s->term);
    free(s->scale);
    free(s->order);
    free(s->uses);
    free(s);
}
