/* A sum may be computed as any multiple of itself, because its users can undo the factor. So may an inverse with a
 * name, as c / d. A local search changes the scales of single sums, of similar sums together (x, y and z of a vector),
 * and of all operands that share a coefficient in a sum; everything homogeneous in them follows. It minimises the
 * number of coefficients other than 1 and -1. */
#include "scales.h"

#include "scale_costs.h"
#include "scales_memo.h"

#include <flint/flint.h>
#include <flint/longlong.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_NODES = 1000, MOST_TERMS = SCALING_MOST_TERMS, MOST_FACTORS = SCALING_MOST_FACTORS, SWEEPS = 3, DEPTH = 4 };
enum { MOST_BITS = 1 << 12 }; /* of a scale: far beyond double's range, which powers of powers would exceed */

static void add_to_set(const struct scaling *x, uint64_t *set, int n)
{
    set[x->place[n] / 64] |= (uint64_t)1 << x->place[n] % 64;
}

static size_t lowest(uint64_t set)
{
    size_t place;
    count_trailing_zeros(place, set);
    return place;
}

static bool is_wild(rational scale, int power)
{
    return scale == ZERO || (scale > MINUS_EIGHT && rational_bits(scale) * power > MOST_BITS); /* most are +-1 to +-8 */
}

/* Returns the scale of node n if it follows its operands, or ZERO if it is out of bounds. An inverse keeps its
 * numerator. */
static rational derived_scale(const struct scaling *x, int n)
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

/* ---- moves ---- */

/* Returns the ratio by which all changed terms changed, or ZERO if there are several ratios. */
static rational common_ratio(const struct scaling *x, const struct node *sum)
{
    rational common = ONE;
    for (size_t i = 0; i < sum->edges; i++) {
        const rational ratio = x->ratio[sum->edge[i].node];
        if (common != ONE && ratio != ONE && ratio != common)
            return ZERO;
        common = common == ONE ? ratio : common;
    }
    return common;
}

/* Lets a sum, whose terms changed by factors, follow the factor that makes it cheapest. If all factors are equal, its
 * coefficients do not change. */
static void follow(struct scaling *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    const rational common = x->plain[n] ? common_ratio(x, node) : ZERO;
    rational cheapest = ONE;
    double least, cost;
    if (common != ZERO) {
        scaling_plain_costs(x, n, common, &least, &cost);
        x->ratio[n] = cost < least ? common : ONE;
        return;
    }
    least = scaling_sum_cost(x, n);
    x->work += scaling_pairs_of(x, n);
    for (size_t i = 0; i < node->edges && i < MOST_TERMS && least > 0; i++) {
        const rational ratio = x->ratio[node->edge[i].node];
        if (ratio == ONE || ratio == x->ratio[n])
            continue;
        x->ratio[n] = ratio;
        x->work += scaling_pairs_of(x, n);
        cost = scaling_sum_cost(x, n);
        if (cost < least) {
            least = cost;
            cheapest = ratio;
        }
    }
    x->ratio[n] = cheapest;
}

/* Computes the new scale of a node that moves or whose operands changed. */
static void rescale(struct scaling *x, int n, rational factor)
{
    rational *scale = &x->s->scale[n];
    if (x->moves[n])
        x->ratio[n] = factor;
    else if (x->s->dag->node[n].kind == NODE_SUM)
        follow(x, n);
    else {
        *scale = derived_scale(x, n);
        x->ratio[n] = rational_mul(*scale, rational_inv(x->best[n]));
        return;
    }
    *scale = rational_mul(x->best[n], x->ratio[n]);
}

static void begin_move(struct scaling *x, int n)
{
    x->moves[n] = true;
    add_to_set(x, x->dirty, n);
}

static void forget_move(struct scaling *x)
{
    memset(x->dirty, 0, x->words * sizeof *x->dirty);
    memset(x->moves, 0, x->s->dag->nodes * sizeof *x->moves);
}

static void add_affected(struct scaling *x, int node)
{
    if (!x->listed[node])
        x->affected[x->affects++] = node;
    x->listed[node] = true;
}

static void note_change(struct scaling *x, int n)
{
    x->changed[x->changes++] = n;
    add_affected(x, n);
    for (size_t k = x->first_user[n]; k < x->first_user[n + 1]; k++) {
        add_affected(x, x->user[k]);
        if ((size_t)x->user[k] < x->s->dag->nodes)
            add_to_set(x, x->dirty, x->user[k]);
    }
}

/* Multiplies the scales of the moving nodes by `factor`; their users follow. Returns false if a scale is out of
 * bounds. */
static bool move(struct scaling *x, rational factor)
{
    struct schedule *s = x->s;
    x->changes = x->affects = 0;
    for (size_t i = 0; i < x->words; i++)
        for (; x->dirty[i]; x->dirty[i] &= x->dirty[i] - 1) {
            const int m = s->order[64 * i + lowest(x->dirty[i])];
            rescale(x, m, factor);
            x->moves[m] = false;
            if (is_wild(s->scale[m], 1)) {
                s->scale[m] = x->best[m];
                x->ratio[m] = ONE;
                forget_move(x);
                return false;
            }
            if (s->scale[m] != x->best[m])
                note_change(x, m);
        }
    return true;
}

static void undo_move(struct scaling *x)
{
    for (size_t i = 0; i < x->weighed; i++)
        scaling_charge(x, &x->trial[i], -1);
    for (size_t i = 0; i < x->charges; i++)
        scaling_charge(x, &x->weight[x->trial[i].node], 1);
    for (size_t i = 0; i < x->changes; i++)
        x->s->scale[x->changed[i]] = x->best[x->changed[i]];
}

/* Accepts the move. */
static void keep_move(struct scaling *x)
{
    for (size_t i = 0; i < x->charges; i++) {
        const struct weight *trial = &x->trial[i];
        struct weight *w = &x->weight[trial->node];
        w->own = trial->own;
        w->terms = trial->terms;
        if (w->terms > 0)
            memcpy(w->term, trial->term, w->terms * sizeof *w->term);
    }
    for (size_t i = 0; i < x->changes; i++)
        x->best[x->changed[i]] = x->s->scale[x->changed[i]];
    for (size_t i = 0; i < x->affects; i++)
        if ((size_t)x->affected[i] < x->s->dag->nodes)
            scaling_set_coefficients(x, x->affected[i]);
    x->improved = true;
    x->kept++;
}

/* Tries to move the starting nodes by a factor; accepts the move if the total falls and no scale is out of bounds. */
static void try_factor(struct scaling *x, rational factor)
{
    if (2 * x->used > x->terms)
        scaling_fill_terms(x);
    const bool tame = move(x, factor);
    for (size_t i = 0; i < x->affects; i++)
        x->listed[x->affected[i]] = false;
    const bool better = scaling_charge_move(x) && tame;
    if (better)
        keep_move(x);
    else
        undo_move(x);
    for (size_t i = 0; i < x->changes; i++)
        x->ratio[x->changed[i]] = ONE;
}

/* ---- what is tried ---- */

static void add_factor(struct scaling *x, rational c)
{
    for (size_t i = 0; i < x->factors; i++)
        if (x->factor[i] == c)
            return;
    if (c != ONE && c != ZERO && x->factors < MOST_FACTORS)
        x->factor[x->factors++] = c;
}

/* Returns true for a sum of two nodes, or of a constant and a node, without coefficients: scales pass through it. */
static bool passes(const struct node *n)
{
    return n->kind == NODE_SUM && n->edges == 2 && (n->edge[0].coef == ONE || n->edge[0].coef == MINUS_ONE) &&
           (n->edge[1].coef == ONE || n->edge[1].coef == MINUS_ONE);
}

/* Adds the coefficients that a node, or a product with it, has in sums, functions and outputs. */
static void add_user_factors(struct scaling *x, int n, int depth)
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
                add_factor(x, scaling_best_coefficient(x, u, k));
        if ((user->kind == NODE_PRODUCT || passes(user)) && depth > 0)
            add_user_factors(x, u, depth - 1);
    }
}

/* Finds factors that turn a coefficient of the sum, or of a user of the sum or inverse, into 1 or -1. */
static void find_factors(struct scaling *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    x->factors = 0;
    add_factor(x, MINUS_ONE);
    add_factor(x, TWO);
    for (size_t k = 0; node->kind == NODE_SUM && k < node->edges && k < MOST_TERMS; k++)
        add_factor(x, rational_inv(scaling_best_coefficient(x, n, k)));
    add_user_factors(x, n, DEPTH);
}

/* Tries a factor on all sums similar to n, unless another of them tried it and nothing has changed since. */
static void try_circle(struct scaling *x, int n, rational factor)
{
    struct tried *t = &x->tried[x->circle[n]];
    const double before = x->work;
    size_t i = 0;
    if (t->kept != x->kept)
        *t = (struct tried){.kept = x->kept};
    while (i < t->n && t->factor[i] != factor)
        i++;
    if (i < t->n) {
        x->work += t->work[i];
        return;
    }
    begin_move(x, n);
    for (int twin = x->twin[n]; twin != n; twin = x->twin[twin])
        begin_move(x, twin);
    try_factor(x, factor);
    if (t->n < MOST_FACTORS) {
        t->factor[t->n] = factor;
        t->work[t->n++] = x->work - before;
    }
}

/* Tries to improve a node, unless nothing has changed since its last trial. */
static void improve_node(struct scaling *x, size_t position)
{
    const int n = x->s->order[position];
    const long kept = x->kept;
    if (x->failed[position] == kept)
        return;
    find_factors(x, n);
    for (size_t i = 0; i < x->factors; i++) {
        begin_move(x, n);
        try_factor(x, x->factor[i]);
        if (x->twin[n] != n)
            try_circle(x, n, x->factor[i]);
    }
    x->failed[position] = x->kept == kept ? kept : 0;
}

static bool is_movable(const struct scaling *x, int n)
{
    return x->s->dag->node[n].kind == NODE_SUM || schedule_has_numerator(x->s, n);
}

/* Returns the node whose move rescales operand n: itself or a factor of it; -1 if there is no such node. */
static int mover_of(const struct scaling *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    if (is_movable(x, n))
        return n;
    for (size_t k = 0; node->kind == NODE_PRODUCT && k < node->edges; k++)
        if (node->edge[k].power == 1 && is_movable(x, node->edge[k].node))
            return node->edge[k].node;
    return -1;
}

/* Moves all operands that share a coefficient of sum n at once, so that they absorb it. */
static void improve_group(struct scaling *x, int n)
{
    const struct node *node = &x->s->dag->node[n];
    x->factors = 0;
    for (size_t k = 0; k < node->edges && k < MOST_TERMS; k++)
        if (node->edge[k].node != 0)
            add_factor(x, rational_abs(scaling_best_coefficient(x, n, k)));
    for (size_t i = 0; i < x->factors; i++) {
        size_t movers = 0;
        for (size_t k = 0; k < node->edges; k++) {
            const int mover = mover_of(x, node->edge[k].node);
            if (mover < 0 || x->moves[mover] || rational_abs(scaling_best_coefficient(x, n, k)) != x->factor[i])
                continue;
            begin_move(x, mover);
            movers++;
        }
        if (movers > 1)
            try_factor(x, x->factor[i]);
        else
            forget_move(x);
    }
}

static void list_users(struct scaling *x)
{
    const struct schedule *s = x->s;
    const struct dag *g = s->dag;
    size_t *next = arena_array(&x->arena, g->nodes + 2, sizeof *next); /* shifted by one while counting */
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < g->node[s->order[i]].edges; k++)
            next[g->node[s->order[i]].edge[k].node + 2]++;
    for (size_t o = 0; o < g->outputs; o++)
        next[g->output[o].node + 2]++;
    for (size_t n = 1; n < g->nodes + 2; n++)
        next[n] += next[n - 1];
    x->user = arena_array(&x->arena, next[g->nodes + 1], sizeof *x->user);
    for (size_t i = 0; i < s->n; i++)
        for (size_t k = 0; k < g->node[s->order[i]].edges; k++)
            x->user[next[g->node[s->order[i]].edge[k].node + 1]++] = s->order[i];
    for (size_t o = 0; o < g->outputs; o++)
        x->user[next[g->output[o].node + 1]++] = (int)(g->nodes + o);
    x->first_user = next;
}

static bool alike(const struct dag *g, const int *level, int m, int n)
{
    const struct node *a = &g->node[m], *b = &g->node[n];
    bool same = level[m] == level[n] && a->edges == b->edges;
    for (size_t k = 0; same && k < a->edges; k++)
        same = a->edge[k].coef == b->edge[k].coef;
    return same;
}

/* Links sums at the same distance from the inputs with the same coefficients into circles. */
static void find_twins(struct scaling *x)
{
    const struct schedule *s = x->s;
    int *level = new_array(s->dag->nodes, sizeof *level), *first = new_array(s->n, sizeof *first);
    size_t circles = 0;
    for (size_t i = 0; i < s->n; i++) {
        const int n = s->order[i];
        const struct node *node = &s->dag->node[n];
        size_t k = 0;
        x->twin[n] = x->circle[n] = n;
        for (size_t e = 0; e < node->edges; e++)
            if (level[n] <= level[node->edge[e].node])
                level[n] = level[node->edge[e].node] + 1;
        while (node->kind == NODE_SUM && k < circles && !alike(s->dag, level, first[k], n))
            k++;
        if (node->kind != NODE_SUM)
            continue;
        if (k == circles)
            first[circles++] = n;
        x->circle[n] = first[k];
        x->twin[n] = x->twin[first[k]];
        x->twin[first[k]] = n;
    }
    free(level);
    free(first);
}

static struct scaling *scaling_new(struct schedule *s)
{
    const size_t nodes = s->dag->nodes, all = nodes + s->dag->outputs;
    struct scaling *x = new_array(1, sizeof *x);
    size_t edges = 0;
    for (size_t i = 0; i < s->n; i++)
        edges += s->dag->node[s->order[i]].edges;
    for (x->terms = 64; x->terms < 8 * edges; x->terms *= 2)
        ;
    x->s = s;
    x->words = s->n / 64 + 1;
    x->best = arena_array(&x->arena, nodes, sizeof *x->best);
    x->ratio = arena_array(&x->arena, nodes, sizeof *x->ratio);
    x->first_edge = arena_array(&x->arena, nodes, sizeof *x->first_edge);
    x->coef = arena_array(&x->arena, edges, sizeof *x->coef);
    x->plain = arena_array(&x->arena, nodes, sizeof *x->plain);
    x->place = arena_array(&x->arena, nodes, sizeof *x->place);
    x->twin = arena_array(&x->arena, nodes, sizeof *x->twin);
    x->circle = arena_array(&x->arena, nodes, sizeof *x->circle);
    x->tried = arena_array(&x->arena, nodes, sizeof *x->tried);
    x->moves = arena_array(&x->arena, nodes, sizeof *x->moves);
    x->dirty = arena_array(&x->arena, x->words, sizeof *x->dirty);
    x->changed = arena_array(&x->arena, nodes, sizeof *x->changed);
    x->affected = arena_array(&x->arena, all, sizeof *x->affected);
    x->listed = arena_array(&x->arena, all, sizeof *x->listed);
    x->weight = arena_array(&x->arena, all, sizeof *x->weight);
    x->trial = arena_array(&x->arena, all, sizeof *x->trial);
    x->own = arena_array(&x->arena, 2 * edges, sizeof *x->own);
    x->term = arena_array(&x->arena, x->terms, sizeof *x->term);
    x->failed = arena_array(&x->arena, s->n, sizeof *x->failed);
    x->kept = 1;
    memcpy(x->best, s->scale, nodes * sizeof *x->best);
    for (size_t n = 0; n < nodes; n++)
        x->ratio[n] = ONE;
    for (size_t i = 0, first = 0; i < s->n; first += s->dag->node[s->order[i++]].edges) {
        x->place[s->order[i]] = i;
        x->first_edge[s->order[i]] = first;
        x->weight[s->order[i]].term = x->own + edges + first;
        scaling_set_coefficients(x, s->order[i]);
    }
    list_users(x);
    find_twins(x);
    scaling_fill_terms(x);
    return x;
}

static void scaling_free(struct scaling *x)
{
    arena_free(&x->arena);
    free(x);
}

/* Changes the scales, which must all be ONE; returns the work, in pairs of terms compared. */
static double improve(struct schedule *s, bool groups)
{
    if (s->n > MOST_NODES)
        return 0;
    struct scaling *x = scaling_new(s);
    x->improved = true;
    for (int sweep = 0; sweep < SWEEPS && x->improved; sweep++) {
        x->improved = false;
        for (size_t i = 0; i < s->n; i++)
            if (is_movable(x, s->order[i]))
                improve_node(x, i);
        for (size_t i = 0; groups && i < s->n; i++)
            if (s->dag->node[s->order[i]].kind == NODE_SUM)
                improve_group(x, s->order[i]);
    }
    const double work = x->work;
    scaling_free(x);
    return work;
}

struct schedule *scaled_schedule(const struct dag *g, const struct cost_model *model, enum scale_search search,
                                 struct scales_memo *memo)
{
    struct schedule *s = schedule_new(g, model);
    const bool groups = search == SCALES_GROUPS;
    if (search != SCALES_KEPT && !(memo && scales_recall(memo, s, groups))) {
        s->work = improve(s, groups);
        if (memo)
            scales_remember(memo, s, groups);
    }
    schedule_finish(s);
    return s;
}
