/* A sum may be computed as any multiple of itself, since whoever uses it can take the multiple back; so may an inverse
 * that has a name, as c / d.  A local search moves the scales of single ones, of like sums together (the x, y and z of
 * a vector), and of all that stand in a sum with the same coefficient, and lets everything homogeneous in them follow,
 * to leave the fewest coefficients other than 1 and -1.  Costs are kept by node, so that a move touches only what
 * depends on it. */
#include "scales.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 1000, MOST_TERMS = 24, MOST_FACTORS = 32, SWEEPS = 3, DEPTH = 4 };
enum { MOST_BITS = 1 << 12 }; /* of a scale: far beyond double's range, and powers of powers would go on growing */

static const double NEGATION = 0.25; /* a leading minus: at most an operation, at best none */

/* State of the search: the schedule's scales are those of the move under way, `best` the best so far.  An output counts
 * as a node beyond the graph's. */
struct search {
    struct schedule *s;
    rational *best;           /* owned: by node */
    int *level;               /* owned: by node, longest way from an input */
    size_t *first_user;       /* owned: user[first_user[n]] to user[first_user[n + 1] - 1] are those of node n */
    int *user;                /* owned */
    bool *moves;              /* owned: by node, the move begins with its scale; false between moves */
    bool *dirty;              /* owned: by node, an operand's scale has changed */
    int *changed, *affected;  /* owned: nodes whose scale the move changed, whose cost it changed */
    bool *listed;             /* owned: by node, is in `affected` */
    struct shared_term *term; /* owned: the terms that stand alone, with the best scales */
    size_t terms, used;
    rational factor[MOST_FACTORS]; /* to try on the sum at hand */
    size_t factors;
    bool improved;
    double work; /* pairs of terms compared */
};

static rational coefficient(const struct dag *g, const rational *scale, int n, size_t i)
{
    const struct edge *e = &g->node[n].edge[i];
    return rational_mul(rational_mul(scale[n], e->coef), rational_inv(scale[e->node]));
}

static bool is_wild(rational scale, int power)
{
    return scale == ZERO || (double)fmpq_height_bits(rational_value(scale)) * power > MOST_BITS;
}

/* Scale of node n when it follows its operands; ZERO if it is wild.  An inverse keeps its numerator. */
static rational derived_scale(const struct search *x, int n)
{
    const struct schedule *s = x->s;
    const struct node *node = &s->dag->node[n];
    rational scale = ONE;
    if (node->kind == NODE_ABS)
        scale = rational_abs(s->scale[node->edge[0].node]);
    if (node->kind == NODE_INVERSE) {
        const rational numerator = rational_mul(x->best[n], x->best[node->edge[0].node]);
        scale = rational_mul(numerator, rational_inv(s->scale[node->edge[0].node]));
    }
    for (size_t i = 0; node->kind == NODE_PRODUCT && i < node->edges; i++) {
        const struct edge *e = &node->edge[i];
        if (is_wild(s->scale[e->node], e->power) || is_wild(scale, 1))
            return ZERO;
        scale = rational_mul(scale, rational_pow(s->scale[e->node], e->power));
    }
    return scale;
}

/* Cost of multiplying by a coefficient: nothing for +-1, else doublings or a multiplication. */
static double coefficient_cost(const struct schedule *s, rational c)
{
    const int doublings = schedule_doublings(s, c);
    return c == ONE || c == MINUS_ONE ? 0 : doublings > 0 ? doublings * s->model->add : s->model->mul;
}

/* A term that stands alone comes (+1) or goes (-1): only the first of its kind costs. */
static double charge_term(struct search *x, rational size, int node, int sign)
{
    struct shared_term *t = schedule_term(x->term, x->terms, size, node);
    const int before = t->times;
    x->used += t->size == 0;
    *t = (struct shared_term){size, node, before + sign};
    return (before == 0) != (t->times == 0) ? sign * coefficient_cost(x->s, size) : 0;
}

/* Equal coefficients of a sum are taken out together and count once; a sum without any positive term counts, too.  With
 * sign 0 terms count as if nobody else had them. */
static double charge_sum(struct search *x, const rational *scale, int n, int sign)
{
    const struct node *node = &x->s->dag->node[n];
    const size_t edges = node->edges < MOST_TERMS ? node->edges : MOST_TERMS;
    const int factor = sign ? sign : 1;
    rational coef[MOST_TERMS];
    double cost = 0;
    bool positive = false;
    x->work += (double)(edges * edges);
    for (size_t i = 0; i < edges; i++) {
        const rational c = coefficient(x->s->dag, scale, n, i);
        positive |= rational_sign(c) > 0;
        coef[i] = node->edge[i].node ? rational_abs(c) : ZERO;
    }
    for (size_t i = 0; i < edges; i++) {
        bool first = coef[i] > ONE, alone = first;
        for (size_t k = 0; first && k < edges; k++) {
            first = k >= i || coef[k] != coef[i];
            alone &= k == i || coef[k] != coef[i];
        }
        if (first && alone && sign)
            cost += charge_term(x, coef[i], node->edge[i].node, sign);
        else if (first)
            cost += factor * coefficient_cost(x->s, coef[i]);
    }
    return cost + (positive ? 0 : factor * NEGATION);
}

/* Change of the total when a node's cost, with those scales, comes or goes. */
static double charge(struct search *x, const rational *scale, int n, int sign)
{
    const struct dag *g = x->s->dag;
    double cost = 0;
    if ((size_t)n >= g->nodes) {
        const struct value *v = &g->output[(size_t)n - g->nodes];
        const rational c = rational_mul(v->coef, rational_inv(scale[v->node]));
        return v->node == 0 ? 0 : sign * (coefficient_cost(x->s, c) + (rational_sign(c) < 0 ? NEGATION : 0));
    }
    if (g->node[n].kind == NODE_SUM)
        return charge_sum(x, scale, n, sign);
    for (size_t k = 0; g->node[n].kind >= NODE_PDIV && k < g->node[n].edges; k++) {
        const rational c = coefficient(g, scale, n, k);
        const bool constant = g->node[n].edge[k].node == 0;
        cost += constant ? 0 : sign * (coefficient_cost(x->s, c) + (c == MINUS_ONE ? NEGATION : 0));
    }
    return cost;
}

/* The table of terms from the best scales. */
static void fill_terms(struct search *x)
{
    x->used = 0;
    memset(x->term, 0, x->terms * sizeof *x->term);
    for (size_t i = 0; i < x->s->n; i++)
        charge(x, x->best, x->s->order[i], 1);
}

/* A sum whose terms have changed by factors takes the one of them that makes it cheapest: if all are the same, its
 * coefficients stay as they are. */
static void follow(struct search *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    rational *scale = &x->s->scale[n], cheapest = *scale;
    double least = charge_sum(x, x->s->scale, n, 0);
    for (size_t i = 0; i < node->edges && i < MOST_TERMS; i++) {
        const int k = node->edge[i].node;
        if (x->s->scale[k] == x->best[k])
            continue;
        *scale = rational_mul(x->best[n], rational_mul(x->s->scale[k], rational_inv(x->best[k])));
        const double cost = charge_sum(x, x->s->scale, n, 0);
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
    bool same = a->kind == NODE_SUM && b->kind == NODE_SUM && x->level[m] == x->level[n] && a->edges == b->edges;
    for (size_t k = 0; same && k < a->edges; k++)
        same = a->edge[k].coef == b->edge[k].coef;
    return same;
}

static void add_affected(struct search *x, size_t *n, int node)
{
    if (!x->listed[node])
        x->affected[(*n)++] = node;
    x->listed[node] = true;
}

/* Multiplies the scales of the nodes that are to move, none of them before `position`, by `factor`; what uses them
 * follows.  The move stands if the total falls and no scale is wild. */
static void try_factor(struct search *x, size_t position, rational factor)
{
    struct schedule *s = x->s;
    size_t changed = 0, affected = 0;
    double difference = 0;
    bool wild = false;
    if (2 * x->used > x->terms)
        fill_terms(x);
    for (size_t i = position; i < s->n; i++) {
        const int m = s->order[i];
        const bool moves = x->moves[m];
        x->moves[m] = false;
        if (wild) {
            x->dirty[m] = false;
            continue;
        }
        if (moves)
            s->scale[m] = rational_mul(s->scale[m], factor);
        else if (!x->dirty[m])
            continue;
        else if (s->dag->node[m].kind == NODE_SUM)
            follow(x, m);
        else
            s->scale[m] = derived_scale(x, m);
        x->dirty[m] = false;
        wild = is_wild(s->scale[m], 1);
        if (wild)
            s->scale[m] = x->best[m];
        if (s->scale[m] == x->best[m])
            continue;
        x->changed[changed++] = m;
        add_affected(x, &affected, m);
        for (size_t k = x->first_user[m]; k < x->first_user[m + 1]; k++) {
            add_affected(x, &affected, x->user[k]);
            x->dirty[x->user[k]] = true;
        }
    }
    for (size_t i = 0; i < affected; i++)
        difference += charge(x, x->best, x->affected[i], -1);
    for (size_t i = 0; i < affected; i++)
        difference += charge(x, s->scale, x->affected[i], 1);
    const bool better = !wild && difference < -1e-9;
    for (size_t i = 0; i < affected; i++) {
        x->listed[x->affected[i]] = false;
        if (!better)
            charge(x, s->scale, x->affected[i], -1);
    }
    for (size_t i = 0; !better && i < affected; i++)
        charge(x, x->best, x->affected[i], 1);
    for (size_t i = 0; i < changed; i++) {
        const int m = x->changed[i];
        *(better ? &x->best[m] : &s->scale[m]) = better ? s->scale[m] : x->best[m];
    }
    x->improved |= better;
}

static void add_factor(struct search *x, rational c)
{
    for (size_t i = 0; i < x->factors; i++)
        if (x->factor[i] == c)
            return;
    if (c != ONE && c != ZERO && x->factors < MOST_FACTORS)
        x->factor[x->factors++] = c;
}

/* A sum of two nodes or of a constant and one, without coefficients: scales pass through it. */
static bool passes(const struct node *n)
{
    return n->kind == NODE_SUM && n->edges == 2 && (n->edge[0].coef == ONE || n->edge[0].coef == MINUS_ONE) &&
           (n->edge[1].coef == ONE || n->edge[1].coef == MINUS_ONE);
}

/* The coefficients with which a node, or a product that it is a factor of, stands in sums, functions and outputs. */
static void add_user_factors(struct search *x, int n, int depth)
{
    const struct dag *g = x->s->dag;
    for (size_t i = x->first_user[n]; i < x->first_user[n + 1]; i++) {
        const int u = x->user[i];
        if ((size_t)u >= g->nodes) {
            add_factor(x, rational_mul(g->output[(size_t)u - g->nodes].coef, rational_inv(x->best[n])));
            continue;
        }
        const struct node *user = &g->node[u];
        const bool multiplies = user->kind == NODE_SUM || user->kind >= NODE_PDIV;
        for (size_t k = 0; multiplies && k < user->edges; k++)
            if (user->edge[k].node == n)
                add_factor(x, coefficient(g, x->best, u, k));
        if ((user->kind == NODE_PRODUCT || passes(user)) && depth > 0)
            add_user_factors(x, u, depth - 1);
    }
}

/* Factors that make one coefficient of the sum, or of a user of the sum or inverse, 1 or -1. */
static void improve_node(struct search *x, size_t position)
{
    const int n = x->s->order[position];
    const struct node *node = &x->s->dag->node[n];
    bool others = false;
    x->factors = 0;
    add_factor(x, MINUS_ONE);
    add_factor(x, TWO);
    for (size_t k = 0; node->kind == NODE_SUM && k < node->edges && k < MOST_TERMS; k++)
        add_factor(x, rational_inv(coefficient(x->s->dag, x->best, n, k)));
    add_user_factors(x, n, DEPTH);
    for (size_t i = 0; !others && i < x->s->n; i++)
        others = i != position && alike(x, x->s->order[i], n);
    for (size_t i = 0; i < x->factors; i++) {
        x->moves[n] = true;
        try_factor(x, position, x->factor[i]);
        for (size_t k = 0; others && k < x->s->n; k++)
            x->moves[x->s->order[k]] = x->s->order[k] == n || alike(x, x->s->order[k], n);
        if (others)
            try_factor(x, 0, x->factor[i]);
    }
}

static bool is_movable(const struct search *x, int n)
{
    return x->s->dag->node[n].kind == NODE_SUM || schedule_has_numerator(x->s, n);
}

/* What gives operand n another scale: itself or a factor of it; -1 if nothing does. */
static int mover_of(const struct search *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    if (is_movable(x, n))
        return n;
    for (size_t k = 0; node->kind == NODE_PRODUCT && k < node->edges; k++)
        if (node->edge[k].power == 1 && is_movable(x, node->edge[k].node))
            return node->edge[k].node;
    return -1;
}

/* Operands that share a coefficient of sum n take it over, all at once. */
static void improve_group(struct search *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    x->factors = 0;
    for (size_t k = 0; k < node->edges && k < MOST_TERMS; k++)
        if (node->edge[k].node != 0)
            add_factor(x, rational_abs(coefficient(x->s->dag, x->best, n, k)));
    for (size_t i = 0; i < x->factors; i++) {
        size_t movers = 0;
        for (size_t k = 0; k < node->edges; k++) {
            const int mover = mover_of(x, node->edge[k].node);
            if (mover < 0 || x->moves[mover] || rational_abs(coefficient(x->s->dag, x->best, n, k)) != x->factor[i])
                continue;
            x->moves[mover] = true;
            movers++;
        }
        if (movers > 1)
            try_factor(x, 0, x->factor[i]);
        else
            memset(x->moves, 0, x->s->dag->nodes * sizeof *x->moves);
    }
}

static void list_users(struct search *x)
{
    const struct schedule *s = x->s;
    const struct dag *g = s->dag;
    size_t *next = new_array(g->nodes + 2, sizeof *next); /* shifted by one while counting */
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < g->node[s->order[i]].edges; k++)
            next[g->node[s->order[i]].edge[k].node + 2]++;
    for (size_t o = 0; o < g->outputs; o++)
        next[g->output[o].node + 2]++;
    for (size_t n = 1; n < g->nodes + 2; n++)
        next[n] += next[n - 1];
    x->user = new_array(next[g->nodes + 1], sizeof *x->user);
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < g->node[s->order[i]].edges; k++)
            x->user[next[g->node[s->order[i]].edge[k].node + 1]++] = s->order[i];
    for (size_t o = 0; o < g->outputs; o++)
        x->user[next[g->output[o].node + 1]++] = (int)(g->nodes + o);
    x->first_user = next;
}

static void find_levels(struct search *x)
{
    for (size_t i = 0; i < x->s->n; i++) {
        const int n = x->s->order[i];
        const struct node *node = &x->s->dag->node[n];
        for (size_t k = 0; k < node->edges; k++)
            if (x->level[n] <= x->level[node->edge[k].node])
                x->level[n] = x->level[node->edge[k].node] + 1;
    }
}

/* Changes the scales, all ONE so far; returns the work, in pairs of terms compared. */
static double improve(struct schedule *s, bool groups)
{
    const size_t all = s->dag->nodes + s->dag->outputs;
    size_t edges = 0;
    if (s->n > MOST_NODES)
        return 0;
    struct search x = {.s = s};
    for (size_t i = 0; i < s->n; i++)
        edges += s->dag->node[s->order[i]].edges;
    for (x.terms = 64; x.terms < 8 * edges; x.terms *= 2)
        ;
    x.best = new_array(s->dag->nodes, sizeof *x.best);
    x.level = new_array(s->dag->nodes, sizeof *x.level);
    x.moves = new_array(all, sizeof *x.moves);
    x.dirty = new_array(all, sizeof *x.dirty);
    x.listed = new_array(all, sizeof *x.listed);
    x.changed = new_array(all, sizeof *x.changed);
    x.affected = new_array(all, sizeof *x.affected);
    x.term = new_array(x.terms, sizeof *x.term);
    memcpy(x.best, s->scale, s->dag->nodes * sizeof *x.best);
    list_users(&x);
    find_levels(&x);
    fill_terms(&x);
    x.improved = true;
    for (int sweep = 0; sweep < SWEEPS && x.improved; sweep++) {
        x.improved = false;
        for (size_t i = 0; i < s->n; i++)
            if (is_movable(&x, s->order[i]))
                improve_node(&x, i);
        for (size_t i = 0; groups && i < s->n; i++)
            if (s->dag->node[s->order[i]].kind == NODE_SUM)
                improve_group(&x, s->order[i]);
    }
    free(x.best);
    free(x.level);
    free(x.first_user);
    free(x.user);
    free(x.moves);
    free(x.dirty);
    free(x.listed);
    free(x.changed);
    free(x.affected);
    free(x.term);
    return x.work;
}

struct schedule *scaled_schedule(const struct dag *g, const struct cost_model *model, enum scale_search search)
{
    struct schedule *s = schedule_new(g, model);
    if (search != SCALES_KEPT)
        s->work = improve(s, search == SCALES_GROUPS);
    schedule_finish(s);
    return s;
}
