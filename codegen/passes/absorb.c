/* Coefficients of outputs, absorbed by what their sums are made of; see absorb.h. */
#include "absorb.h"

#include <stdlib.h>
#include <string.h>

struct absorbing {
    const struct dag *from;
    struct dag *to;
    rational *size; /* owned: by node, the coefficient that this sum absorbs, or ZERO */
    bool *own;      /* owned: by node, it is a term of such a sum */
    int *image;     /* owned: by node */
    struct multiple {
        rational size; /* ZERO: none yet */
        int node;
    } * multiple; /* owned: by node, the last one that was made */
};

/* The sums that stand in nothing but outputs, always with the same coefficient up to its sign; how many. */
static size_t find_sums(struct absorbing *a)
{
    const struct dag *g = a->from;
    int *uses = dag_uses(g);
    size_t sums = 0;
    for (size_t o = 0; o < g->outputs; o++) {
        const int n = g->output[o].node;
        const rational size = rational_abs(g->output[o].coef);
        if (g->node[n].kind == NODE_SUM && size != ONE && (a->size[n] == ZERO || a->size[n] == size)) {
            a->size[n] = size;
            uses[n]--;
        }
    }
    for (size_t n = 0; n < g->nodes; n++) {
        a->size[n] = uses[n] > 0 ? ZERO : a->size[n];
        sums += a->size[n] != ZERO;
        for (size_t i = 0; a->size[n] != ZERO && i < g->node[n].edges; i++)
            a->own[g->node[n].edge[i].node] |= rational_abs(g->node[n].edge[i].coef) == ONE;
    }
    free(uses);
    return sums;
}

/* Node n times `size`: a product by way of a factor that is a term, else a sum of one term. */
static int multiply(struct absorbing *a, int n, rational size)
{
    const struct node *node = &a->from->node[n];
    if (a->multiple[n].size == size)
        return a->multiple[n].node;
    int made;
    size_t k = 0;
    while (node->kind == NODE_PRODUCT && k < node->edges &&
           !(a->own[node->edge[k].node] && a->from->node[node->edge[k].node].kind != NODE_PRODUCT))
        k++;
    if (node->kind == NODE_PRODUCT && k < node->edges) {
        struct edge *edge = new_array(node->edges + 1, sizeof *edge);
        size_t edges = 0;
        for (size_t i = 0; i < node->edges; i++) {
            edge[edges] = (struct edge){ONE, a->image[node->edge[i].node], node->edge[i].power - (i == k)};
            edges += edge[edges].power > 0;
        }
        edge[edges++] = (struct edge){ONE, multiply(a, node->edge[k].node, size), 1};
        made = dag_append(a->to, NODE_PRODUCT, edge, edges);
        free(edge);
    } else {
        const struct edge one = {size, a->image[n], 1};
        made = dag_append(a->to, NODE_SUM, &one, 1);
    }
    a->multiple[n] = (struct multiple){size, made};
    return made;
}

static void copy_node(struct absorbing *a, size_t n)
{
    const struct node *node = &a->from->node[n];
    struct edge *edge = new_array(node->edges, sizeof *edge);
    for (size_t i = 0; i < node->edges; i++) {
        const struct edge *e = &node->edge[i];
        edge[i] = (struct edge){e->coef, a->image[e->node], e->power};
        if (a->size[n] == ZERO)
            continue;
        if (e->node == 0 || rational_abs(e->coef) != ONE)
            edge[i].coef = rational_mul(a->size[n], e->coef);
        else
            edge[i].node = multiply(a, e->node, a->size[n]);
    }
    a->image[n] = dag_append(a->to, node->kind, edge, node->edges);
    struct node *made = &a->to->node[a->image[n]];
    made->input = node->input;
    made->kept = node->kept;
    memcpy(made->mark, node->mark, sizeof made->mark);
    free(edge);
}

struct dag *absorb_coefficients(const struct dag *g)
{
    struct absorbing a = {.from = g, .size = new_array(g->nodes, sizeof *a.size)};
    a.own = new_array(g->nodes, sizeof *a.own);
    if (find_sums(&a) > 1) {
        a.image = new_array(g->nodes, sizeof *a.image);
        a.multiple = new_array(g->nodes, sizeof *a.multiple);
        a.to = dag_new(g->inputs);
        for (size_t n = 1; n < g->nodes; n++)
            copy_node(&a, n);
        for (size_t o = 0; o < g->outputs; o++) {
            const struct value *v = &g->output[o];
            const rational coef = a.size[v->node] == ZERO ? v->coef : rational_sign(v->coef) < 0 ? MINUS_ONE : ONE;
            dag_add_output(a.to, g->output_name[o], (struct value){coef, a.image[v->node]});
        }
        dag_inherit_removed(a.to, g);
    }
    free(a.size);
    free(a.own);
    free(a.image);
    free(a.multiple);
    return a.to;
}
