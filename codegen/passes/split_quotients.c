/* Quotients by products as products of quotients; see expand.h.  Where several products are divided by, in pairs, each
 * quotient of two factors may be what several terms share. */
#include "expand.h"

#include "../graph/rewrite.h"

/* The inverse of a product: an inverse, which stays whole, of each of its factors. */
static struct value invert_factors(struct walk *w, const struct node *product)
{
    struct edges all = {0};
    rational coef = ONE;
    for (size_t i = 0; i < product->edges; i++) {
        const struct edge *e = &product->edge[i];
        const struct value v = dag_inverse(w->to, w->image[e->node]);
        w->to->node[v.node].kept |= w->to->node[v.node].kind == NODE_INVERSE;
        coef = rational_mul(coef, rational_pow(v.coef, e->power));
        edges_add(&all, ONE, v.node, e->power);
    }
    return dag_product(w->to, coef, &all);
}

struct dag *shape_split(const struct dag *g)
{
    struct walk w = walk_begin(g);
    bool some = false;
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (w.uses[n] == 0)
            continue;
        const struct node *operand = node->edges > 0 ? &g->node[node->edge[0].node] : NULL;
        const bool splits = node->kind == NODE_INVERSE && operand->kind == NODE_PRODUCT && !operand->kept;
        w.image[n] = splits ? invert_factors(&w, operand) : walk_map(&w, node);
        w.to->node[w.image[n].node].kept |= node->kept && !splits;
        some |= splits;
    }
    struct dag *made = walk_end(&w);
    if (some)
        return made;
    dag_free(made);
    return NULL;
}
