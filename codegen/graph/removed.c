/* Singularities that a graph lost: divisors and root arguments of its genome that no used node has; see dag.h. Whoever
 * makes a value with less than its operands notes the loss. Only at the end, residues at the random points decide
 * whether the singularity remains elsewhere, so more may be noted than is lost. */
#include "dag.h"

#include <stdlib.h>

void dag_lose(struct dag *g, int node)
{
    if (g->node[node].partial)
        APPEND(g->lost, g->losses, g->loss_room) = node;
}

/* A list of singularities, removed or in use. */
struct removals {
    struct removal *removal; /* owned */
    size_t n, room;
};

static void add_removal(struct removals *list, const struct dag *g, const struct edge *e, bool root)
{
    struct removal r = {.root = root};
    for (int k = 0; k < PRIMES; k++)
        r.mark[k] = nmod_mul(rational_mod(e->coef, k), g->node[e->node].mark[k], rational_modulus[k]);
    APPEND(list->removal, list->n, list->room) = r;
}

/* Adds the factors of a divisor. */
static void add_factors(struct removals *list, const struct dag *g, int divisor)
{
    const struct node *d = &g->node[divisor];
    const bool product = d->kind == NODE_PRODUCT;
    for (size_t k = 0; k < (product ? d->edges : 1); k++)
        add_removal(list, g, &(struct edge){ONE, product ? d->edge[k].node : divisor, 1}, false);
}

/* Adds a node's divisors and root arguments. */
static void add_singularities(struct removals *list, const struct dag *g, const struct node *n)
{
    if (n->kind == NODE_INVERSE)
        add_factors(list, g, n->edge[0].node);
    else if (node_is_root(n->kind))
        add_removal(list, g, &n->edge[0], true);
}

static int compare_removals(const void *a, const void *b)
{
    const struct removal *x = a, *y = b;
    return x->root != y->root ? (x->root > y->root) - (x->root < y->root)
                              : (x->mark[0] > y->mark[0]) - (x->mark[0] < y->mark[0]);
}

/* Sorts, and removes duplicates. */
static void sort_removals(struct removals *list)
{
    size_t n = 0;
    if (list->n > 0)
        qsort(list->removal, list->n, sizeof *list->removal, compare_removals);
    for (size_t i = 0; i < list->n; i++)
        if (n == 0 || compare_removals(&list->removal[n - 1], &list->removal[i]) != 0)
            list->removal[n++] = list->removal[i];
    list->n = n;
}

void dag_remove(struct dag *g, int node)
{
    struct removals list = {g->removed, g->removals, g->removal_room};
    dag_lose(g, node);
    add_factors(&list, g, node);
    g->removed = list.removal;
    g->removals = list.n;
    g->removal_room = list.room;
}

/* Returns removals noted before, and the divisors and roots of lost nodes. The caller frees it. */
static struct removals all_removals(const struct dag *g)
{
    struct removals all = {0};
    bool *lost = new_array(g->nodes, sizeof *lost);
    for (size_t i = 0; i < g->removals; i++)
        APPEND(all.removal, all.n, all.room) = g->removed[i];
    for (size_t i = 0; i < g->losses; i++)
        lost[g->lost[i]] = true;
    for (size_t n = g->losses ? g->nodes : 0; n-- > 0;) {
        const struct node *node = &g->node[n];
        if (!lost[n] || !node->partial)
            continue;
        add_singularities(&all, g, node);
        for (size_t i = 0; i < node->edges; i++)
            lost[node->edge[i].node] = true;
    }
    free(lost);
    sort_removals(&all);
    return all;
}

void dag_inherit_removed(struct dag *g, const struct dag *from)
{
    struct removals all = all_removals(from);
    for (size_t i = 0; i < all.n; i++)
        APPEND(g->removed, g->removals, g->removal_room) = all.removal[i];
    free(all.removal);
}

/* Returns true if a is a multiple of b; for roots, a positive multiple. Sums of other graphs have other leading
 * coefficients. */
static bool is_multiple(const struct removal *a, const struct removal *b)
{
    mp_limb_t ratio[PRIMES];
    rational c;
    for (int k = 0; k < PRIMES; k++)
        if (b->mark[k] == 0)
            return false;
        else
            ratio[k] = nmod_div(a->mark[k], b->mark[k], rational_modulus[k]);
    return a->root == b->root && rational_reconstruct(ratio, &c) && (!a->root || rational_sign(c) > 0);
}

/* Returns true if a sorted list contains the same removal or, if it is short, a multiple. */
static bool is_among(const struct removal *r, const struct removals *list)
{
    enum { MOST_COMPARED = 200 };
    if (list->n == 0)
        return false;
    bool found = bsearch(r, list->removal, list->n, sizeof *r, compare_removals) != NULL;
    for (size_t i = 0; i < list->n && list->n <= MOST_COMPARED && !found; i++)
        found = is_multiple(r, &list->removal[i]);
    return found;
}

struct removed dag_removed(const struct dag *g)
{
    struct removed removed = {0, 0};
    struct removals all = all_removals(g), used = {0}, counted = {0};
    int *uses = all.n ? dag_uses(g) : NULL;
    for (size_t n = 0; uses && n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (!uses[n])
            continue;
        add_singularities(&used, g, node);
        if (node->kind == NODE_INVERSE)
            add_removal(&used, g, &node->edge[0], false);
    }
    sort_removals(&used);
    for (size_t i = 0; i < all.n; i++) {
        if (is_among(&all.removal[i], &used) || is_among(&all.removal[i], &counted))
            continue;
        APPEND(counted.removal, counted.n, counted.room) = all.removal[i];
        *(all.removal[i].root ? &removed.roots : &removed.divisions) += 1;
    }
    free(uses);
    free(all.removal);
    free(used.removal);
    free(counted.removal);
    return removed;
}
