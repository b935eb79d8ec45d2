/* Order: depth first from the outputs.  Scales: a sum may be computed as any multiple of itself, since whoever uses it
 * can take the multiple back.  A local search moves the scales of like sums together (the x, y and z of a vector) and
 * lets everything homogeneous in them follow, to leave the fewest coefficients other than 1 and -1. */
#include "schedule.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SEARCHED = 1000, MOST_TERMS = 24, MOST_FACTORS = 32, SWEEPS = 3 };

#define NEGATION 0.25 /* a leading minus: at most an operation, at best none */

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

/* Scale of a node that has no choice. */
static void derive_scale(struct schedule *s, int n)
{
    const struct node *node = &s->dag->node[n];
    rational scale = ONE;
    if (node->kind == NODE_ABS)
        scale = rational_abs(s->scale[node->edge[0].node]);
    if (node->kind == NODE_INVERSE)
        scale = rational_inv(s->scale[node->edge[0].node]);
    for (size_t i = 0; node->kind == NODE_PRODUCT && i < node->edges; i++)
        scale = rational_mul(scale, rational_pow(s->scale[node->edge[i].node], node->edge[i].power));
    s->scale[n] = scale;
}

/* Cost of multiplying by a coefficient: nothing for +-1, an addition for +-2, else a multiplication. */
static double coefficient_cost(const struct schedule *s, rational c)
{
    return c == ONE || c == MINUS_ONE ? 0 : c == TWO || c == MINUS_TWO ? s->model->add : s->model->mul;
}

/* A term c x of several sums is computed once: the table holds those met in the count under way. */
static bool meet_term(struct schedule *s, rational size, int node)
{
    struct met_term *t = s->met;
    size_t i = ((size_t)size * 2654435761u + (size_t)node * 40503u) & (s->mets - 1);
    for (; t[i].count == s->count; i = (i + 1) & (s->mets - 1))
        if (t[i].size == size && t[i].node == node) {
            t[i].times++;
            return true;
        }
    t[i] = (struct met_term){size, node, 1, s->count};
    return false;
}

/* Equal coefficients of a sum are taken out together and count once; a sum without any positive term counts, too. */
static double sum_cost(struct schedule *s, int n)
{
    const struct node *node = &s->dag->node[n];
    rational coef[MOST_TERMS];
    double cost = 0;
    bool positive = false;
    const size_t edges = node->edges < MOST_TERMS ? node->edges : MOST_TERMS;
    for (size_t i = 0; i < edges; i++) {
        const rational c = schedule_coefficient(s, n, i);
        positive |= rational_sign(c) > 0;
        coef[i] = node->edge[i].node ? rational_abs(c) : ZERO;
    }
    for (size_t i = 0; i < edges; i++) {
        bool first = coef[i] > ONE, alone = first;
        for (size_t k = 0; first && k < edges; k++) {
            first = k >= i || coef[k] != coef[i];
            alone &= k == i || coef[k] != coef[i];
        }
        if (first && !(alone && meet_term(s, coef[i], node->edge[i].node)))
            cost += coefficient_cost(s, coef[i]);
    }
    return cost + (positive ? 0 : NEGATION);
}

static double node_cost(struct schedule *s, int n)
{
    const struct node *node = &s->dag->node[n];
    double cost = 0;
    if (node->kind == NODE_SUM)
        return sum_cost(s, n);
    for (size_t k = 0; node->kind >= NODE_PDIV && k < node->edges; k++)
        cost += coefficient_cost(s, schedule_coefficient(s, n, k));
    return cost;
}

static double output_cost(const struct schedule *s, const struct value *v)
{
    const rational c = rational_mul(v->coef, rational_inv(s->scale[v->node]));
    return v->node == 0 ? 0 : coefficient_cost(s, c) + (rational_sign(c) < 0 ? NEGATION : 0);
}

static double total_cost(struct schedule *s)
{
    double cost = 0;
    s->count++;
    for (size_t i = 0; i < s->n; i++)
        cost += node_cost(s, s->order[i]);
    for (size_t o = 0; o < s->dag->outputs; o++)
        cost += output_cost(s, &s->dag->output[o]);
    return cost;
}

/* State of the search: the schedule's scales are those of a move under way, `best` the best so far. */
struct search {
    struct schedule *s;
    rational *best;     /* owned: by node */
    int *level;         /* owned: longest way from an input */
    size_t *first_user; /* owned: of node n, user[first_user[n]] to user[first_user[n + 1] - 1] */
    int *user;          /* owned */
    rational factor[MOST_FACTORS]; /* to try on the sum at hand */
    size_t factors;
    double least;
};

static void list_users(struct search *x)
{
    const struct schedule *s = x->s;
    size_t *next = new_array(s->dag->nodes + 2, sizeof *next); /* shifted by one while counting */
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < s->dag->node[s->order[i]].edges; k++)
            next[s->dag->node[s->order[i]].edge[k].node + 2]++;
    for (size_t n = 1; n < s->dag->nodes + 2; n++)
        next[n] += next[n - 1];
    x->user = new_array(next[s->dag->nodes + 1], sizeof *x->user);
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < s->dag->node[s->order[i]].edges; k++)
            x->user[next[s->dag->node[s->order[i]].edge[k].node + 1]++] = s->order[i];
    x->first_user = next;
}

/* A sum whose terms have changed by factors takes the one of them that makes it cheapest: if all are the same, its
 * coefficients stay as they are. */
static void follow(struct search *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    rational *scale = &x->s->scale[n], cheapest = *scale;
    x->s->count++;
    double least = node_cost(x->s, n);
    for (size_t i = 0; i < node->edges && i < MOST_TERMS; i++) {
        const int k = node->edge[i].node;
        if (x->s->scale[k] == x->best[k])
            continue;
        *scale = rational_mul(x->best[n], rational_mul(x->s->scale[k], rational_inv(x->best[k])));
        x->s->count++;
        const double cost = node_cost(x->s, n);
        if (cost < least) {
            least = cost;
            cheapest = *scale;
        }
    }
    *scale = cheapest;
}

static bool alike(const struct search *x, int m, int n)
{
    const struct node *a = &x->s->dag->node[m], *b = &x->s->dag->node[n];
    bool same = a->kind == NODE_SUM && x->level[m] == x->level[n] && a->edges == b->edges;
    for (size_t k = 0; same && k < a->edges; k++)
        same = a->edge[k].coef == b->edge[k].coef;
    return same;
}

/* Multiplies the scale of a sum, or of all sums like it (same level, same coefficients), by `factor`; what uses them
 * follows.  The move stands if the total falls. */
static void try_factor(struct search *x, int n, rational factor, bool all)
{
    struct schedule *s = x->s;
    for (size_t i = 0; i < s->n; i++) {
        const int m = s->order[i];
        if (m == n || (all && alike(x, m, n)))
            s->scale[m] = rational_mul(s->scale[m], factor);
        else if (s->dag->node[m].kind == NODE_SUM)
            follow(x, m);
        else
            derive_scale(s, m);
    }
    const double cost = total_cost(s);
    const bool better = cost < x->least - 1e-9;
    memcpy(better ? x->best : s->scale, better ? s->scale : x->best, s->dag->nodes * sizeof *s->scale);
    if (better)
        x->least = cost;
}

static void add_factor(struct search *x, rational c)
{
    for (size_t i = 0; i < x->factors; i++)
        if (x->factor[i] == c)
            return;
    if (c != ONE && c != ZERO && x->factors < MOST_FACTORS)
        x->factor[x->factors++] = c;
}

/* The coefficients with which a node, or a product that it is a factor of, stands in sums and outputs. */
static void add_user_factors(struct search *x, int n, int depth)
{
    const struct schedule *s = x->s;
    for (size_t i = x->first_user[n]; i < x->first_user[n + 1]; i++) {
        const int u = x->user[i];
        const struct node *user = &s->dag->node[u];
        for (size_t k = 0; user->kind == NODE_SUM && k < user->edges; k++)
            if (user->edge[k].node == n)
                add_factor(x, schedule_coefficient(s, u, k));
        if (user->kind == NODE_PRODUCT && depth > 0)
            add_user_factors(x, u, depth - 1);
    }
    for (size_t o = 0; o < s->dag->outputs; o++)
        if (s->dag->output[o].node == n)
            add_factor(x, rational_mul(s->dag->output[o].coef, rational_inv(s->scale[n])));
}

/* Factors that make one coefficient of the sum, or of a user, 1 or -1. */
static void improve_sum(struct search *x, size_t position)
{
    const int n = x->s->order[position];
    const struct node *node = &x->s->dag->node[n];
    x->factors = 0;
    add_factor(x, MINUS_ONE);
    add_factor(x, TWO);
    for (size_t k = 0; k < node->edges && k < MOST_TERMS; k++)
        add_factor(x, rational_inv(schedule_coefficient(x->s, n, k)));
    add_user_factors(x, n, 3);
    bool others = false;
    for (size_t i = 0; !others && i < x->s->n; i++)
        others = x->s->order[i] != n && alike(x, x->s->order[i], n);
    for (size_t i = 0; i < x->factors; i++) {
        try_factor(x, n, x->factor[i], false);
        if (others)
            try_factor(x, n, x->factor[i], true);
    }
}

static void search_scales(struct schedule *s)
{
    struct search x = {.s = s};
    x.best = new_array(s->dag->nodes, sizeof *x.best);
    x.level = new_array(s->dag->nodes, sizeof *x.level);
    memcpy(x.best, s->scale, s->dag->nodes * sizeof *x.best);
    for (size_t i = 0; i < s->n; i++) {
        const struct node *node = &s->dag->node[s->order[i]];
        for (size_t k = 0; k < node->edges; k++)
            if (x.level[s->order[i]] <= x.level[node->edge[k].node])
                x.level[s->order[i]] = x.level[node->edge[k].node] + 1;
    }
    list_users(&x);
    x.least = total_cost(s);
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        const double before = x.least;
        for (size_t i = 0; i < s->n; i++)
            if (s->dag->node[s->order[i]].kind == NODE_SUM)
                improve_sum(&x, i);
        if (x.least == before)
            break;
    }
    free(x.best);
    free(x.level);
    free(x.user);
    free(x.first_user);
}

struct schedule *schedule_new(const struct dag *g, const struct cost_model *model)
{
    struct schedule *s = new_array(1, sizeof *s);
    s->dag = g;
    s->model = model;
    s->order = new_array(g->nodes, sizeof *s->order);
    s->uses = new_array(g->nodes, sizeof *s->uses);
    s->scale = new_array(g->nodes, sizeof *s->scale);
    for (size_t n = 0; n < g->nodes; n++)
        s->scale[n] = ONE;
    order_nodes(s);
    size_t edges = 0;
    for (size_t n = 0; n < g->nodes; n++)
        edges += g->node[n].kind == NODE_SUM ? g->node[n].edges : 0;
    for (s->mets = 16; s->mets < 2 * edges; s->mets *= 2)
        ;
    s->met = new_array(s->mets, sizeof *s->met);
    total_cost(s); /* leaves the table filled */
    return s;
}

void schedule_improve(struct schedule *s)
{
    if (s->n <= MOST_SEARCHED)
        search_scales(s);
    total_cost(s);
}

bool schedule_shares_term(const struct schedule *s, rational size, int node)
{
    const struct met_term *t = s->met;
    size_t i = ((size_t)size * 2654435761u + (size_t)node * 40503u) & (s->mets - 1);
    while (t[i].count == s->count && (t[i].size != size || t[i].node != node))
        i = (i + 1) & (s->mets - 1);
    return t[i].count == s->count && t[i].times > 1;
}

void schedule_free(struct schedule *s)
{
    if (!s)
        return;
    free(s->met);
    free(s->scale);
    free(s->order);
    free(s->uses);
    free(s);
}
