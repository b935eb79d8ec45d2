/* Linear forms written out; see expand.h.  What a genome names on the way to a vector of a segment may hide the sums
 * that its vectors share. */
#include "expand.h"

#include "../graph/rewrite.h"

#include <stdlib.h>

/* A sum of inputs, a constant, and such sums. */
static bool is_form(const struct dag *g, int n, const bool *form)
{
    const struct node *node = &g->node[n];
    bool all = node->kind == NODE_SUM;
    for (size_t i = 0; all && i < node->edges; i++) {
        const int k = node->edge[i].node;
        all = form[k] || k == 0 || g->node[k].kind == NODE_INPUT;
    }
    return all;
}

/* The image of a form: the sum of its operands' terms. */
static struct value write_out(struct walk *w, const struct node *node)
{
    struct edges terms = {0};
    for (size_t i = 0; i < node->edges; i++) {
        const struct value v = walk_image(w, &node->edge[i]);
        const struct node *operand = &w->to->node[v.node];
        if (operand->kind != NODE_SUM)
            edges_add(&terms, v.coef, v.node, 1);
        for (size_t k = 0; operand->kind == NODE_SUM && k < operand->edges; k++)
            edges_add(&terms, rational_mul(v.coef, operand->edge[k].coef), operand->edge[k].node, 1);
    }
    return dag_sum(w->to, &terms);
}

struct dag *shape_linear(const struct dag *g)
{
    struct walk w = walk_begin(g);
    bool *form = new_array(g->nodes, sizeof *form), longer = false;
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (w.uses[n] == 0)
            continue;
        form[n] = is_form(g, (int)n, form);
        for (size_t i = 0; form[n] && i < node->edges; i++)
            longer |= form[node->edge[i].node];
        w.image[n] = form[n] ? write_out(&w, node) : walk_map(&w, node);
        w.to->node[w.image[n].node].kept |= node->kept;
    }
    free(form);
    struct dag *made = walk_end(&w);
    if (longer)
        return made;
    dag_free(made);
    return NULL;
}
