/* Multiplying out, common denominators, shared divisions; see expand.h. Each walks the graph once, operands first, and
 * stores each node's image in the new graph. */
#include "expand.h"

#include "../graph/rewrite.h"

#include <stdlib.h>
#include <string.h>

enum {
    MOST_TERMS = 600,
    MOST_PRODUCTS = 6000,
    MOST_MULTIPLIED = 150000 /* terms, and products of terms, per pass */
};
enum { MOST_COMBINED = 20000 /* factors of a sum's terms */, MOST_JOINED = 64 /* divisions that become one */ };

/* ---- multiplying out ---- */

struct spreading {
    struct walk walk;
    struct edges *open; /* owned: terms of the nodes that dissolve where they are used */
    size_t work;        /* terms and products of terms made */
};

static void add_scaled(struct edges *sum, rational c, const struct edges *terms)
{
    for (size_t i = 0; i < terms->n; i++)
        edges_add(sum, rational_mul(c, terms->edge[i].coef), terms->edge[i].node, 1);
}

/* Adds up terms of the same node. */
static void collect_terms(struct walk *w, struct edges *terms)
{
    struct edges copy = {0};
    add_scaled(&copy, ONE, terms);
    const struct value v = dag_sum(w->to, &copy);
    terms->n = 0;
    const struct node *n = &w->to->node[v.node];
    if (v.coef == ZERO)
        return;
    if (n->kind != NODE_SUM) {
        edges_add(terms, v.coef, v.node, 1);
        return;
    }
    for (size_t i = 0; i < n->edges; i++)
        edges_add(terms, rational_mul(v.coef, n->edge[i].coef), n->edge[i].node, 1);
}

/* Multiplies *terms by `other`. Returns false, and leaves *terms unchanged, if the result is too long. */
static bool multiply_terms(struct spreading *s, struct edges *terms, const struct edges *other)
{
    struct walk *w = &s->walk;
    struct edges product = {0};
    if (terms->n * other->n > MOST_PRODUCTS || s->work > MOST_MULTIPLIED)
        return false;
    s->work += terms->n * other->n;
    for (size_t i = 0; i < terms->n; i++)
        for (size_t k = 0; k < other->n; k++) {
            const struct edge *x = &terms->edge[i], *y = &other->edge[k];
            const struct value v = dag_times(w->to, (struct value){x->coef, x->node}, (struct value){y->coef, y->node});
            edges_add(&product, v.coef, v.node, 1);
        }
    collect_terms(w, &product);
    if (product.n > MOST_TERMS) {
        edges_clear(&product);
        return false;
    }
    edges_clear(terms);
    *terms = product;
    return true;
}

/* Finds the terms of a product, its dissolved factors multiplied out as far as they stay short. */
static void product_terms(struct spreading *s, const struct node *n, struct edges *terms)
{
    struct walk *w = &s->walk;
    struct edges whole = {0};
    edges_add(terms, ONE, 0, 1);
    for (size_t i = 0; i < n->edges; i++) {
        const struct edge *e = &n->edge[i];
        int power = e->power;
        while (power > 0 && s->open[e->node].n > 0 && multiply_terms(s, terms, &s->open[e->node]))
            power--;
        if (power > 0) {
            const struct value v = w->image[e->node];
            edges_add(&whole, rational_pow(v.coef, power), v.node, power);
        }
    }
    rational coef = ONE;
    for (size_t i = 0; i < whole.n; i++) {
        coef = rational_mul(coef, whole.edge[i].coef);
        whole.edge[i].coef = ONE;
    }
    const struct value rest = dag_product(w->to, coef, &whole);
    for (size_t i = 0; i < terms->n; i++) {
        const struct value v = dag_times(w->to, (struct value){terms->edge[i].coef, terms->edge[i].node}, rest);
        terms->edge[i] = (struct edge){v.coef, v.node, 1};
    }
}

static void sum_terms(struct spreading *s, const struct node *n, struct edges *terms)
{
    struct walk *w = &s->walk;
    for (size_t i = 0; i < n->edges; i++) {
        const struct edge *e = &n->edge[i];
        if (s->open[e->node].n > 0 && terms->n < MOST_PRODUCTS)
            add_scaled(terms, e->coef, &s->open[e->node]);
        else {
            const struct value v = walk_image(w, e);
            if (v.coef != ZERO)
                edges_add(terms, v.coef, v.node, 1);
        }
    }
    collect_terms(w, terms);
}

/* Returns the group of a sum. Sums of the same variable form a group: 1 + x and 1 - x. */
static mp_limb_t group_of(const struct dag *g, const struct node *n)
{
    const int first = n->edge[n->edge[0].node == 0 && n->edges > 1 ? 1 : 0].node;
    return g->node[first].mark[0];
}

struct dag *shape_dissolve(const struct dag *g, const struct policy *policy, struct record *record)
{
    struct spreading s = {.walk = walk_begin(g), .open = new_array(g->nodes, sizeof *s.open)};
    struct walk *w = &s.walk;
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (w->uses[n] == 0)
            continue;
        if (node->kind != NODE_SUM && node->kind != NODE_PRODUCT) {
            w->image[n] = walk_map(w, node);
            w->to->node[w->image[n].node].kept |= node->kept;
            continue;
        }
        struct edges terms = {0};
        if (node->kind == NODE_SUM)
            sum_terms(&s, node, &terms);
        else
            product_terms(&s, node, &terms);
        const bool plain = node->kind == NODE_PRODUCT && terms.n == 1 && !node->kept;
        const bool whole = policy->differences && node_is_difference(g, node);
        const bool dissolves =
            plain || (terms.n <= MOST_TERMS && !whole &&
                      policy_flag(policy, record, CHOICE_DISSOLVE, node->mark[0], group_of(g, node)));
        s.work += terms.n;
        if (dissolves && terms.n > 0)
            add_scaled(&s.open[n], ONE, &terms);
        w->image[n] = dag_sum(w->to, &terms);
        if (node->kept && !dissolves)
            w->to->node[w->image[n].node].kept = true;
    }
    for (size_t n = 0; n < g->nodes; n++)
        edges_clear(&s.open[n]);
    free(s.open);
    return walk_end(w);
}

/* ---- common denominators ---- */

/* num / (product of the factors den). */
struct fraction {
    struct value num;
    struct edges den; /* owned; nodes and powers */
};

static struct value whole_value(struct walk *w, const struct fraction *f)
{
    struct edges list = {0};
    for (size_t i = 0; i < f->den.n; i++)
        edges_add(&list, ONE, f->den.edge[i].node, -f->den.edge[i].power);
    edges_add(&list, ONE, f->num.node, 1);
    return dag_product(w->to, f->num.coef, &list);
}

/* Adds the factors of a node to a list. */
static void add_factors(const struct dag *g, struct edges *list, int node, int power)
{
    const struct node *n = &g->node[node];
    if (n->kind != NODE_PRODUCT || n->kept) {
        if (node != 0)
            edges_add(list, ONE, node, power);
        return;
    }
    for (size_t i = 0; i < n->edges; i++)
        edges_add(list, ONE, n->edge[i].node, n->edge[i].power * power);
}

/* Returns the power of a factor in a list, or 0. */
static int power_in(const struct edges *list, int node)
{
    for (size_t i = 0; i < list->n; i++)
        if (list->edge[i].node == node)
            return list->edge[i].power;
    return 0;
}

/* Replaces *list by its least common multiple with `other`. */
static void widen(struct edges *list, const struct edges *other)
{
    for (size_t i = 0; i < other->n; i++) {
        const struct edge *e = &other->edge[i];
        size_t k = 0;
        while (k < list->n && list->edge[k].node != e->node)
            k++;
        if (k == list->n)
            edges_add(list, ONE, e->node, e->power);
        else if (list->edge[k].power < e->power)
            list->edge[k].power = e->power;
    }
}

/* Adds fractions, unless the common denominator would have too many factors. */
static struct fraction add_fractions(struct walk *w, const struct node *n, const struct fraction *f)
{
    struct fraction sum = {{ZERO, 0}, {0}};
    struct edges terms = {0};
    for (size_t i = 0; i < n->edges && sum.den.n * n->edges <= MOST_COMBINED; i++)
        widen(&sum.den, &f[n->edge[i].node].den);
    if (sum.den.n * n->edges > MOST_COMBINED) {
        edges_clear(&sum.den);
        for (size_t i = 0; i < n->edges; i++) {
            const struct value v = whole_value(w, &f[n->edge[i].node]);
            edges_add(&terms, rational_mul(n->edge[i].coef, v.coef), v.node, 1);
        }
        sum.num = dag_sum(w->to, &terms);
        return sum;
    }
    for (size_t i = 0; i < n->edges; i++) {
        const struct fraction *part = &f[n->edge[i].node];
        struct edges factors = {0};
        for (size_t k = 0; k < sum.den.n; k++)
            edges_add(&factors, ONE, sum.den.edge[k].node,
                      sum.den.edge[k].power - power_in(&part->den, sum.den.edge[k].node));
        edges_add(&factors, ONE, part->num.node, 1);
        const struct value v = dag_product(w->to, rational_mul(n->edge[i].coef, part->num.coef), &factors);
        if (v.coef != ZERO)
            edges_add(&terms, v.coef, v.node, 1);
    }
    sum.num = dag_sum(w->to, &terms);
    for (size_t i = 0; sum.num.coef == ZERO && i < sum.den.n; i++)
        dag_remove(w->to, sum.den.edge[i].node);
    if (sum.num.coef == ZERO)
        edges_clear(&sum.den);
    return sum;
}

/* Cancels factors that numerator and denominator share; their zeros are removed singularities. */
static void cancel(struct walk *w, struct fraction *f)
{
    struct edges num = {0};
    add_factors(w->to, &num, f->num.node, 1);
    for (size_t i = 0; i < f->den.n; i++) {
        const int common = power_in(&num, f->den.edge[i].node);
        const int least = common < f->den.edge[i].power ? common : f->den.edge[i].power;
        if (least > 0) {
            edges_add(&num, ONE, f->den.edge[i].node, -least);
            f->den.edge[i].power -= least;
            dag_remove(w->to, f->den.edge[i].node);
        }
    }
    size_t kept = 0;
    for (size_t i = 0; i < f->den.n; i++)
        if (f->den.edge[i].power > 0)
            f->den.edge[kept++] = f->den.edge[i];
    f->den.n = kept;
    f->num = dag_product(w->to, f->num.coef, &num);
}

static struct fraction multiply_fractions(struct walk *w, const struct node *n, const struct fraction *f)
{
    struct fraction product = {{ONE, 0}, {0}};
    struct edges num = {0};
    for (size_t i = 0; i < n->edges; i++) {
        const struct fraction *part = &f[n->edge[i].node];
        const int power = n->edge[i].power;
        product.num.coef = rational_mul(product.num.coef, rational_pow(part->num.coef, power));
        edges_add(&num, ONE, part->num.node, power);
        for (size_t k = 0; k < part->den.n; k++) {
            const struct edge *e = &part->den.edge[k];
            size_t at = 0;
            while (at < product.den.n && product.den.edge[at].node != e->node)
                at++;
            if (at == product.den.n)
                edges_add(&product.den, ONE, e->node, e->power * power);
            else
                product.den.edge[at].power += e->power * power;
        }
    }
    product.num = dag_product(w->to, product.num.coef, &num);
    cancel(w, &product);
    return product;
}

static struct fraction invert_fraction(struct walk *w, const struct fraction *f)
{
    struct fraction inverse = {{ONE, 0}, {0}};
    struct edges num = {0};
    for (size_t i = 0; i < f->den.n; i++)
        edges_add(&num, ONE, f->den.edge[i].node, f->den.edge[i].power);
    inverse.num = dag_product(w->to, rational_inv(f->num.coef), &num);
    add_factors(w->to, &inverse.den, f->num.node, 1);
    for (size_t i = 0; i < f->den.n; i++)
        dag_remove(w->to, f->den.edge[i].node);
    return inverse;
}

struct dag *shape_combine(const struct dag *g, const struct policy *policy, struct record *record)
{
    struct walk w = walk_begin(g);
    struct fraction *f = new_array(g->nodes, sizeof *f);
    f[0].num = dag_constant(ONE);
    for (size_t n = 1; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        if (w.uses[n] == 0)
            continue;
        if (node->kind == NODE_INVERSE && policy_flag(policy, record, CHOICE_COMBINE, node->mark[0], node->mark[0]))
            f[n] = invert_fraction(&w, &f[node->edge[0].node]);
        else if (node->kind == NODE_SUM)
            f[n] = add_fractions(&w, node, f);
        else if (node->kind == NODE_PRODUCT)
            f[n] = multiply_fractions(&w, node, f);
        else {
            for (size_t i = 0; i < node->edges; i++)
                w.image[node->edge[i].node] = whole_value(&w, &f[node->edge[i].node]);
            f[n].num = walk_map(&w, node);
        }
        if (node->kept && f[n].den.n == 0)
            w.to->node[f[n].num.node].kept = true;
    }
    for (size_t i = 0; i < g->outputs; i++)
        w.image[g->output[i].node] = whole_value(&w, &f[g->output[i].node]);
    for (size_t n = 0; n < g->nodes; n++)
        edges_clear(&f[n].den);
    free(f);
    return walk_end(&w);
}

/* ---- one division for several ---- */

/* Returns level[nodes], how many divisions follow one another up to each node. The caller frees it. */
static int *division_levels(const struct dag *g)
{
    int *level = new_array(g->nodes, sizeof *level);
    for (size_t n = 0; n < g->nodes; n++) {
        for (size_t i = 0; i < g->node[n].edges; i++)
            if (level[n] < level[g->node[n].edge[i].node])
                level[n] = level[g->node[n].edge[i].node];
        level[n] += g->node[n].kind == NODE_INVERSE;
    }
    return level;
}

/* Computes the images of several inverses by one division. */
static void join_inverses(struct walk *w, struct edges all)
{
    const struct dag *g = w->from;
    struct edges below = {0};
    for (size_t i = 0; i < all.n; i++)
        edges_add(&below, ONE, w->image[g->node[all.edge[i].node].edge[0].node].node, 1);
    const struct value r = dag_inverse(w->to, dag_product(w->to, ONE, &below));
    w->to->node[r.node].kept |= all.n > 1;
    for (size_t i = 0; i < all.n; i++) {
        struct edges factors = {0};
        const struct value own = w->image[g->node[all.edge[i].node].edge[0].node];
        edges_add(&factors, ONE, r.node, 1);
        for (size_t k = 0; k < all.n; k++)
            if (k != i)
                edges_add(&factors, ONE, w->image[g->node[all.edge[k].node].edge[0].node].node, 1);
        w->image[all.edge[i].node] = dag_product(w->to, rational_inv(own.coef), &factors);
    }
}

/* Computes the images of all inverses of a level. */
static void join_level(struct walk *w, const int *level, int at)
{
    const struct dag *g = w->from;
    struct edges all = {0};
    for (size_t n = 0; n < g->nodes; n++)
        if (w->uses[n] && level[n] == at && g->node[n].kind == NODE_INVERSE)
            edges_add(&all, ONE, (int)n, 1);
    for (size_t i = 0; i < all.n; i += MOST_JOINED)
        join_inverses(w, (struct edges){all.edge + i, all.n - i < MOST_JOINED ? all.n - i : MOST_JOINED, 0});
    edges_clear(&all);
}

struct dag *shape_join(const struct dag *g)
{
    struct walk w = walk_begin(g);
    int *level = division_levels(g), deepest = 0;
    for (size_t n = 0; n < g->nodes; n++)
        deepest = w.uses[n] && level[n] > deepest ? level[n] : deepest;
    for (int at = 0; at <= deepest; at++) {
        if (at > 0)
            join_level(&w, level, at);
        for (size_t n = 1; n < g->nodes; n++)
            if (w.uses[n] && level[n] == at && g->node[n].kind != NODE_INVERSE) {
                w.image[n] = walk_map(&w, &g->node[n]);
                w.to->node[w.image[n].node].kept |= g->node[n].kept;
            }
    }
    free(level);
    return walk_end(&w);
}
