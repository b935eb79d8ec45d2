/* Rewriting graphs; see rewrite.h. */
#include "rewrite.h"

#include <stdlib.h>

struct walk walk_begin(const struct dag *g)
{
    struct walk w = {.from = g, .to = dag_new(g->inputs), .uses = dag_uses(g)};
    w.image = new_array(g->nodes, sizeof *w.image);
    w.image[0] = dag_constant(ONE);
    dag_inherit_removed(w.to, g);
    return w;
}

struct dag *walk_end(struct walk *w)
{
    for (size_t i = 0; i < w->from->outputs; i++) {
        const struct value image = w->image[w->from->output[i].node];
        dag_add_output(w->to, w->from->output_name[i],
                       (struct value){rational_mul(w->from->output[i].coef, image.coef), image.node});
    }
    free(w->image);
    free(w->uses);
    return w->to;
}

struct value walk_image(const struct walk *w, const struct edge *e)
{
    const struct value image = w->image[e->node];
    return (struct value){rational_mul(e->coef, image.coef), image.node};
}

static struct value map_sum(struct walk *w, const struct node *n)
{
    struct edges terms = {0};
    for (size_t i = 0; i < n->edges; i++) {
        const struct value v = walk_image(w, &n->edge[i]);
        if (v.coef != ZERO)
            edges_add(&terms, v.coef, v.node, 1);
    }
    return dag_sum(w->to, &terms);
}

static struct value map_product(struct walk *w, const struct node *n)
{
    struct edges factors = {0};
    rational coef = ONE;
    for (size_t i = 0; i < n->edges; i++) {
        const struct value v = w->image[n->edge[i].node];
        coef = rational_mul(coef, rational_pow(v.coef, n->edge[i].power));
        edges_add(&factors, ONE, v.node, n->edge[i].power);
    }
    return dag_product(w->to, coef, &factors);
}

struct value walk_map(struct walk *w, const struct node *n)
{
    if (n->kind == NODE_INPUT)
        return dag_input(w->to, (size_t)n->input);
    if (n->kind == NODE_SUM)
        return map_sum(w, n);
    if (n->kind == NODE_PRODUCT)
        return map_product(w, n);
    const struct value a = walk_image(w, &n->edge[0]);
    if (n->kind == NODE_INVERSE)
        return dag_inverse(w->to, a);
    return dag_function(w->to, n->kind, a, n->edges > 1 ? walk_image(w, &n->edge[1]) : a);
}

struct dag *walk_again(const struct dag *g)
{
    struct walk w = walk_begin(g);
    int *stack = new_array(g->nodes, sizeof *stack);
    size_t *next = new_array(g->nodes, sizeof *next); /* next operand to visit, plus one once the node is on the
                                                       * stack */
    for (size_t o = 0; o < g->outputs; o++) {
        size_t depth = 0;
        if (g->output[o].node != 0 && next[g->output[o].node] == 0)
            stack[depth++] = g->output[o].node;
        while (depth > 0) {
            const int n = stack[depth - 1];
            const struct node *node = &g->node[n];
            if (next[n] < node->edges) {
                const int k = node->edge[next[n]++].node;
                if (k != 0 && next[k] == 0)
                    stack[depth++] = k;
                continue;
            }
            w.image[n] = walk_map(&w, node);
            w.to->node[w.image[n].node].kept |= node->kept;
            next[n] = node->edges + 1;
            depth--;
        }
    }
    free(stack);
    free(next);
    return walk_end(&w);
}
