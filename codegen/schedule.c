/* Order: depth first from the outputs.  Scales: a sum may be computed as any multiple of itself, since whoever uses it
 * can take the multiple back.  A local search moves the scales of like sums together (the x, y and z of a vector) and
 * lets everything homogeneous in them follow, to leave the fewest coefficients other than 1 and -1. */
#include "schedule.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SEARCHED = 1000, MOST_TERMS = 12, SWEEPS = 3 };

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

void schedule_coefficient(const struct schedule *s, int n, size_t i, fmpq_t coef)
{
    const struct edge *e = &s->dag->node[n].edge[i];
    fmpq_mul(coef, &s->scale[n], e->coef);
    fmpq_div(coef, coef, &s->scale[e->node]);
}

/* Scale of a node that has no choice. */
static void derive_scale(struct schedule *s, int n)
{
    const struct node *node = &s->dag->node[n];
    fmpq *scale = &s->scale[n];
    fmpq_one(scale);
    if (node->kind == NODE_ABS)
        fmpq_abs(scale, &s->scale[node->edge[0].node]);
    if (node->kind == NODE_INVERSE)
        fmpq_inv(scale, &s->scale[node->edge[0].node]);
    if (node->kind != NODE_PRODUCT)
        return;
    fmpq_t power;
    fmpq_init(power);
    for (size_t i = 0; i < node->edges; i++) {
        fmpq_pow_si(power, &s->scale[node->edge[i].node], node->edge[i].power);
        fmpq_mul(scale, scale, power);
    }
    fmpq_clear(power);
}

static bool is_whole(const fmpq_t c, long size)
{
    return fmpz_is_one(fmpq_denref(c)) && fmpz_cmpabs(fmpq_numref(c), (fmpz[1]){size}) == 0;
}

/* Cost of multiplying by a coefficient: nothing for +-1, an addition for +-2, else a multiplication. */
static long coefficient_cost(const fmpq_t c)
{
    return is_whole(c, 1) ? 0 : is_whole(c, 2) ? 1 : 2;
}

/* Equal coefficients of a sum are taken out together and count once; a sum without any positive term counts, too. */
static long sum_cost(const struct schedule *s, int n, fmpq *coef)
{
    const struct node *node = &s->dag->node[n];
    long cost = 0;
    bool positive = false;
    for (size_t i = 0; i < node->edges; i++) {
        schedule_coefficient(s, n, i, &coef[i]);
        positive |= fmpq_sgn(&coef[i]) > 0;
        fmpq_abs(&coef[i], &coef[i]);
        bool counts = node->edge[i].node != 0;
        for (size_t k = 0; counts && k < i; k++)
            counts = !fmpq_equal(&coef[i], &coef[k]) || node->edge[k].node == 0;
        cost += counts ? 2 * coefficient_cost(&coef[i]) : 0;
    }
    return cost + !positive;
}

static long node_cost(const struct schedule *s, int n, fmpq *work)
{
    const struct node *node = &s->dag->node[n];
    long cost = 0;
    if (node->kind == NODE_SUM)
        return sum_cost(s, n, work);
    for (size_t k = 0; node->kind >= NODE_PDIV && k < node->edges; k++) {
        schedule_coefficient(s, n, k, &work[0]);
        cost += 2 * coefficient_cost(&work[0]);
    }
    return cost;
}

static long total_cost(const struct schedule *s, fmpq *work)
{
    long cost = 0;
    for (size_t i = 0; i < s->n; i++)
        cost += node_cost(s, s->order[i], work);
    for (size_t o = 0; o < s->dag->outputs; o++) {
        const struct value *v = &s->dag->output[o];
        fmpq_div(&work[0], v->coef, &s->scale[v->node]);
        cost += v->node == 0 ? 0 : 2 * coefficient_cost(&work[0]) + (fmpq_sgn(&work[0]) < 0);
    }
    return cost;
}

/* State of the search: `trial` are the scales of a move under way, the schedule's own are the best so far. */
struct search {
    struct schedule *s;
    fmpq *best, *work, *chosen; /* owned: by node; by edge; two */
    int *level;                 /* owned: longest way from an input */
    long least;
};

/* A sum whose terms have changed by factors takes the one of them that makes it cheapest: if all are the same, its
 * coefficients stay as they are. */
static void follow(struct search *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    fmpq *scale = &x->s->scale[n], *cheapest = &x->chosen[0], *ratio = &x->chosen[1];
    long least = node_cost(x->s, n, x->work);
    fmpq_set(cheapest, scale);
    for (size_t i = 0; i < node->edges && i < MOST_TERMS; i++) {
        const int k = node->edge[i].node;
        fmpq_div(ratio, &x->s->scale[k], &x->best[k]);
        if (fmpq_is_one(ratio))
            continue;
        fmpq_mul(scale, &x->best[n], ratio);
        const long cost = node_cost(x->s, n, x->work);
        if (cost < least) {
            least = cost;
            fmpq_set(cheapest, scale);
        }
    }
    fmpq_set(scale, cheapest);
}

/* Multiplies the scales of all sums like n (same level, same coefficients) by `factor`; what uses them follows.  The
 * move stands if the total falls. */
static void try_factor(struct search *x, int n, const fmpq_t factor)
{
    struct schedule *s = x->s;
    const struct node *model = &s->dag->node[n];
    if (fmpq_is_one(factor))
        return;
    for (size_t i = 0; i < s->n; i++) {
        const int m = s->order[i];
        const struct node *node = &s->dag->node[m];
        bool alike = node->kind == NODE_SUM && x->level[m] == x->level[n] && node->edges == model->edges;
        for (size_t k = 0; alike && k < node->edges; k++)
            alike = fmpq_equal(node->edge[k].coef, model->edge[k].coef);
        if (alike)
            fmpq_mul(&s->scale[m], &s->scale[m], factor);
        else if (node->kind == NODE_SUM)
            follow(x, m);
        else
            derive_scale(s, m);
    }
    const long cost = total_cost(s, x->work);
    const bool better = cost < x->least;
    for (size_t i = 0; i < s->n; i++) {
        const int m = s->order[i];
        if (better)
            fmpq_set(&x->best[m], &s->scale[m]);
        else
            fmpq_set(&s->scale[m], &x->best[m]);
    }
    if (better)
        x->least = cost;
}

/* Factors that make one coefficient of the sum, or of a user, 1 or -1. */
static void improve_sum(struct search *x, size_t position)
{
    struct schedule *s = x->s;
    const struct dag *g = s->dag;
    const int n = s->order[position];
    fmpq_t c;
    fmpq_init(c);
    for (size_t k = 0; k < g->node[n].edges && k < MOST_TERMS; k++) {
        schedule_coefficient(s, n, k, c);
        fmpq_inv(c, c);
        try_factor(x, n, c);
    }
    for (size_t j = position + 1; j < s->n; j++)
        for (size_t k = 0; k < g->node[s->order[j]].edges; k++)
            if (g->node[s->order[j]].kind == NODE_SUM && g->node[s->order[j]].edge[k].node == n) {
                schedule_coefficient(s, s->order[j], k, c);
                try_factor(x, n, c);
            }
    for (size_t o = 0; o < g->outputs; o++)
        if (g->output[o].node == n) {
            fmpq_div(c, g->output[o].coef, &s->scale[n]);
            try_factor(x, n, c);
        }
    for (long factor = -1; factor <= 2; factor += 3) {
        fmpq_set_si(c, factor, 1);
        try_factor(x, n, c);
    }
    fmpq_clear(c);
}

static void search_scales(struct schedule *s, size_t widest)
{
    struct search x = {.s = s};
    x.best = _fmpq_vec_init((slong)s->dag->nodes);
    x.work = _fmpq_vec_init((slong)widest);
    x.chosen = _fmpq_vec_init(2);
    x.level = new_array(s->dag->nodes, sizeof *x.level);
    for (size_t i = 0; i < s->n; i++) {
        const struct node *node = &s->dag->node[s->order[i]];
        fmpq_one(&x.best[s->order[i]]);
        for (size_t k = 0; k < node->edges; k++)
            if (x.level[s->order[i]] <= x.level[node->edge[k].node])
                x.level[s->order[i]] = x.level[node->edge[k].node] + 1;
    }
    x.least = total_cost(s, x.work);
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        const long before = x.least;
        for (size_t i = 0; i < s->n; i++)
            if (s->dag->node[s->order[i]].kind == NODE_SUM)
                improve_sum(&x, i);
        if (x.least == before)
            break;
    }
    _fmpq_vec_clear(x.best, (slong)s->dag->nodes);
    _fmpq_vec_clear(x.work, (slong)widest);
    _fmpq_vec_clear(x.chosen, 2);
    free(x.level);
}

struct schedule *schedule_new(const struct dag *g)
{
    struct schedule *s = new_array(1, sizeof *s);
    size_t widest = 1;
    s->dag = g;
    s->order = new_array(g->nodes, sizeof *s->order);
    s->uses = new_array(g->nodes, sizeof *s->uses);
    s->scale = _fmpq_vec_init((slong)g->nodes);
    order_nodes(s);
    for (size_t n = 0; n < g->nodes; n++) {
        fmpq_one(&s->scale[n]);
        if (g->node[n].edges > widest)
            widest = g->node[n].edges;
    }
    if (s->n <= MOST_SEARCHED)
        search_scales(s, widest);
    return s;
}

void schedule_free(struct schedule *s)
{
    if (!s)
        return;
    _fmpq_vec_clear(s->scale, (slong)s->dag->nodes);
    free(s->order);
    free(s->uses);
    free(s);
}
