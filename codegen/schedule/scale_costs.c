/* Costs of nodes in the scales of a move; see scale_costs.h. Costs are stored by node, so that a move visits only nodes
 * that depend on it and whose coefficients change. */
#include "scale_costs.h"

#include <string.h>

enum { MOST_TERMS = SCALING_MOST_TERMS };

#define LEAST_GAIN 1e-9

/* Returns a coefficient in the scales of the current move. */
static rational coefficient(const struct scaling *x, int n, size_t i)
{
    const rational c = scaling_best_coefficient(x, n, i), ratio = x->ratio[n],
                   of = x->ratio[x->s->dag->node[n].edge[i].node];
    if (ratio == of)
        return c;
    const rational by = of == ONE ? ratio : rational_mul(ratio, rational_inv(of));
    return c == MINUS_ONE ? rational_neg(by) : rational_mul(c, by);
}

void scaling_set_coefficients(struct scaling *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    rational *coef = &x->coef[x->first_edge[n]];
    x->plain[n] = node->edges < MOST_TERMS;
    for (size_t i = 0; i < node->edges; i++) {
        const rational by = rational_mul(x->best[n], rational_inv(x->best[node->edge[i].node]));
        coef[i] = rational_mul(by, node->edge[i].coef);
        x->plain[n] &= coef[i] == ONE || coef[i] == MINUS_ONE;
    }
}

/* Returns the cost of multiplying by a coefficient: 0 for +-1, otherwise doublings or a multiplication. */
static double coefficient_cost(const struct schedule *s, rational c)
{
    const int doublings = schedule_doublings(s, c);
    return c == ONE || c == MINUS_ONE ? 0 : doublings > 0 ? doublings * s->model->add : s->model->mul;
}

/* Finds the sizes of a sum's coefficients, ZERO for its constant; returns how many are examined. */
static size_t find_sizes(const struct scaling *x, int n, rational size[MOST_TERMS], bool *positive)
{
    const struct node *node = &x->s->dag->node[n];
    const size_t edges = node->edges < MOST_TERMS ? node->edges : MOST_TERMS;
    *positive = false;
    for (size_t i = 0; i < edges; i++) {
        const rational c = coefficient(x, n, i);
        const bool negative = rational_sign(c) < 0;
        *positive |= rational_sign(c) > 0;
        size[i] = !node->edge[i].node ? ZERO : negative ? rational_neg(c) : c;
    }
    return edges;
}

/* Returns how often a size other than 1 occurs, or 0 if it occurred before. */
static size_t count_size(const rational *size, size_t n, size_t i)
{
    size_t times = 1;
    if (size[i] == ZERO || size[i] == ONE)
        return 0;
    for (size_t k = 0; k < i; k++)
        if (size[k] == size[i])
            return 0;
    for (size_t k = i + 1; k < n; k++)
        times += size[k] == size[i];
    return times;
}

/* Weighs a sum: equal coefficients are factored out and count once; a sum without a positive term costs extra. */
static void weigh_sum(struct scaling *x, int n, struct weight *w)
{
    const struct node *node = &x->s->dag->node[n];
    rational size[MOST_TERMS];
    bool positive;
    const size_t edges = find_sizes(x, n, size, &positive);
    w->own = positive ? 0 : NEGATION;
    for (size_t i = 0; i < edges; i++) {
        const size_t times = count_size(size, edges, i);
        if (times > 1)
            w->own += coefficient_cost(x->s, size[i]);
        if (times != 1)
            continue;
        struct shared_term *t = schedule_term(x->term, x->terms, size[i], node->edge[i].node);
        x->used += t->size == ZERO;
        t->size = size[i];
        t->node = node->edge[i].node;
        w->term[w->terms++] = t;
    }
}

/* Returns the cost as if no other sum had its separate terms. */
double scaling_sum_cost(const struct scaling *x, int n)
{
    rational size[MOST_TERMS];
    bool positive;
    const size_t edges = find_sizes(x, n, size, &positive);
    double cost = positive ? 0 : NEGATION;
    for (size_t i = 0; i < edges; i++)
        cost += count_size(size, edges, i) > 0 ? coefficient_cost(x->s, size[i]) : 0;
    return cost;
}

/* Weighs a node; w->term must have room for its edges. */
static void weigh(struct scaling *x, int n, struct weight *w)
{
    const struct dag *g = x->s->dag;
    w->node = n;
    w->own = 0;
    w->terms = 0;
    if ((size_t)n >= g->nodes) {
        const struct value *v = &g->output[(size_t)n - g->nodes];
        const rational c = rational_mul(v->coef, rational_inv(x->s->scale[v->node]));
        w->own = v->node == 0 ? 0 : coefficient_cost(x->s, c) + (rational_sign(c) < 0 ? NEGATION : 0);
        return;
    }
    if (g->node[n].kind == NODE_SUM)
        weigh_sum(x, n, w);
    for (size_t k = 0; g->node[n].kind >= NODE_PDIV && k < g->node[n].edges; k++) {
        const rational c = coefficient(x, n, k);
        if (g->node[n].edge[k].node != 0)
            w->own += coefficient_cost(x->s, c) + (c == MINUS_ONE ? NEGATION : 0);
    }
}

/* Returns the change of the total if a weight is added (+1) or removed (-1). Of equal separate terms, only the first
 * costs. */
double scaling_charge(const struct scaling *x, const struct weight *w, int sign)
{
    double cost = w->own;
    for (size_t i = 0; i < w->terms; i++) {
        struct shared_term *t = w->term[i];
        const int before = t->times;
        t->times += sign;
        cost += (before == 0) != (t->times == 0) ? coefficient_cost(x->s, t->size) : 0;
    }
    return sign * cost;
}

/* Returns the work of comparing a sum's coefficients. */
double scaling_pairs_of(const struct scaling *x, int n)
{
    const struct dag *g = x->s->dag;
    const bool sum = (size_t)n < g->nodes && g->node[n].kind == NODE_SUM;
    const size_t edges = !sum ? 0 : g->node[n].edges < MOST_TERMS ? g->node[n].edges : MOST_TERMS;
    return (double)(edges * edges);
}

/* Fills the table of terms from the best scales. */
void scaling_fill_terms(struct scaling *x)
{
    const size_t all = x->s->dag->nodes + x->s->dag->outputs;
    x->used = 0;
    memset(x->term, 0, x->terms * sizeof *x->term);
    for (size_t n = 0; n < all; n++) {
        if (n < x->s->dag->nodes && x->s->uses[n] == 0)
            continue;
        weigh(x, (int)n, &x->weight[n]);
        scaling_charge(x, &x->weight[n], 1);
        x->work += scaling_pairs_of(x, (int)n);
    }
}

/* Computes two costs of a sum without coefficients, some of whose terms changed by the same ratio: if it keeps its
 * scale, and if it follows them. */
void scaling_plain_costs(const struct scaling *x, int n, rational ratio, double *stays, double *follows)
{
    const struct node *node = &x->s->dag->node[n];
    bool rest = false, positive[2] = {false, false};
    const bool turns = rational_sign(ratio) < 0;
    for (size_t i = 0; i < node->edges; i++) {
        const int k = node->edge[i].node;
        const bool plus = scaling_best_coefficient(x, n, i) == ONE, changed = x->ratio[k] != ONE;
        positive[0] |= plus != (turns && changed);
        positive[1] |= plus != (turns && !changed);
        rest |= k != 0 && !changed;
    }
    *stays = coefficient_cost(x->s, rational_inv(ratio)) + (positive[0] ? 0 : NEGATION);
    *follows = (rest ? coefficient_cost(x->s, ratio) : 0) + (positive[1] ? 0 : NEGATION);
}

/* Returns false if the node's cost cannot have changed: products cost nothing, and a sum that followed all its operands
 * keeps its coefficients. */
static bool is_charged(const struct scaling *x, int n)
{
    if ((size_t)n >= x->s->dag->nodes)
        return true;
    const struct node *node = &x->s->dag->node[n];
    bool differs = false;
    for (size_t k = 0; node->kind != NODE_PRODUCT && node->kind != NODE_INVERSE && k < node->edges; k++)
        differs |= x->ratio[node->edge[k].node] != x->ratio[n];
    return differs;
}

bool scaling_charge_move(struct scaling *x)
{
    struct shared_term **term = x->own;
    double difference = 0;
    x->charges = 0;
    for (size_t i = 0; i < x->affects; i++)
        if (is_charged(x, x->affected[i])) {
            x->trial[x->charges++].node = x->affected[i];
            difference += scaling_charge(x, &x->weight[x->affected[i]], -1);
            x->work += scaling_pairs_of(x, x->affected[i]);
        }
    for (x->weighed = 0; x->weighed < x->charges && difference < -LEAST_GAIN; x->weighed++) {
        struct weight *w = &x->trial[x->weighed];
        w->term = term;
        weigh(x, w->node, w);
        term += w->terms;
        difference += scaling_charge(x, w, 1);
    }
    return x->weighed == x->charges && difference < -LEAST_GAIN;
}
