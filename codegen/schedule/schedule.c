/* Orders statements in stages: everything that no choice (min, max, protected quotient) decides precedes the first
 * choices, then come those choices, then everything that only they decide, and so on. So arithmetic forms long runs,
 * and the two choices of a clamp are adjacent. Compilers turn choices into jumps and do not reorder across them; in
 * vectorised loops, code between choices needs masks. Inside a stage of arithmetic, the node with the longest chain to
 * an output comes first, because processors look ahead only so far and compilers keep the order. So similar chains,
 * such as x, y and z, run in parallel. Among nodes with chains of similar length, the node that frees most values comes
 * first, because registers are few. scales.c chooses the scales. */
#include "schedule.h"

#include <limits.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_COUNTED = 20000, /* edges of sums; in larger graphs, no terms are shared */
    SLACK = 16,           /* cycles, four operations: similar length */
    WINDOW = 1000         /* nodes examined for a place */
};

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
        s->alone[g->output[o].node]++;
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
            s->alone[k] += n->kind != NODE_PRODUCT;
            if (!seen[k]) {
                seen[k] = true;
                stack[depth++] = (struct frame){k, 0};
            }
        }
    }
    free(stack);
    free(seen);
}

static int find_stage(const struct node *n, const int *stage)
{
    const bool choice = node_chooses(n);
    int latest = choice;
    for (size_t i = 0; i < n->edges; i++) {
        const int of = stage[n->edge[i].node], least = of + (of % 2 != choice);
        latest = least > latest ? least : latest;
    }
    return latest;
}

/* Sorts the order by stages; the order inside a stage is kept. */
static void order_stages(struct schedule *s)
{
    int *order = arena_array(&s->arena, s->dag->nodes, sizeof *order), last = 0;
    for (size_t i = 0; i < s->n; i++) {
        const int of = s->stage[s->order[i]] = find_stage(&s->dag->node[s->order[i]], s->stage);
        last = of > last ? of : last;
    }
    size_t *next = new_array((size_t)last + 2, sizeof *next); /* place of a stage's next node */
    for (size_t i = 0; i < s->n; i++)
        next[s->stage[s->order[i]] + 1]++;
    for (int k = 0; k < last; k++)
        next[k + 1] += next[k];
    for (size_t i = 0; i < s->n; i++)
        order[next[s->stage[s->order[i]]]++] = s->order[i];
    free(next);
    s->order = order;
}

/* Returns the time from operand i of node n being ready until the node is ready, as the C text chains operations. */
static double find_delay(const struct node *n, size_t i, const struct cost_model *c)
{
    const struct edge *e = &n->edge[i];
    const size_t last = n->edges - (i > 1 ? i : 1);
    switch (n->kind) {
    case NODE_SUM:
        return (double)last * c->add + (e->coef == ONE || e->coef == MINUS_ONE ? 0 : c->mul);
    case NODE_PRODUCT:
        return (double)(last + (size_t)(e->power > 1)) * c->mul;
    case NODE_INVERSE:
        return c->div;
    case NODE_PDIV:
        return c->compare + c->div;
    default:
        return n->kind < NODE_UNARY ? c->compare : unary_cost(c, n->kind - NODE_UNARY);
    }
}

struct place {
    int node, stage;
    double wait; /* longest chain from the node to an output */
    size_t before;
};

static int compare_places(const void *a, const void *b)
{
    const struct place *x = a, *y = b;
    if (x->stage != y->stage)
        return x->stage < y->stage ? -1 : 1;
    if (x->stage % 2 == 0 && x->wait != y->wait)
        return x->wait > y->wait ? -1 : 1;
    return (x->before > y->before) - (x->before < y->before);
}

/* Counts the values, inputs aside, that have the node as their last user. */
static int count_freed(const struct schedule *s, const struct node *n, const int *left)
{
    int freed = 0;
    for (size_t i = 0; i < n->edges; i++) {
        const int k = n->edge[i].node;
        freed += left[k] == 1 && s->dag->node[k].edges > 0;
    }
    return freed;
}

/* Chooses the next ready place among those from `first` on. */
static size_t choose_place(const struct schedule *s, const struct place *place, size_t first, const int *left,
                           const bool *done)
{
    size_t best = first;
    int most = -1;
    for (size_t i = first; i < s->n && i < first + WINDOW && most < INT_MAX; i++) {
        const struct node *n = &s->dag->node[place[i].node];
        bool ready = !done[place[i].node];
        if (place[i].stage != place[first].stage || place[i].wait < place[first].wait - SLACK)
            break;
        for (size_t k = 0; ready && k < n->edges; k++)
            ready = done[n->edge[k].node];
        const int freed = !ready ? -1 : n->edges == 0 ? INT_MAX : count_freed(s, n, left);
        if (freed > most) {
            most = freed;
            best = i;
        }
    }
    return best;
}

/* Converts sorted places to the order; choices stay sorted. */
static void order_places(struct schedule *s, const struct place *place)
{
    int *left = new_array(s->dag->nodes, sizeof *left); /* by node; remaining uses */
    bool *done = new_array(s->dag->nodes, sizeof *done);
    size_t first = 0;
    memcpy(left, s->uses, s->dag->nodes * sizeof *left);
    for (size_t k = 0; k < s->n; k++) {
        while (done[place[first].node])
            first++;
        const size_t next = place[first].stage % 2 ? first : choose_place(s, place, first, left, done);
        const struct node *n = &s->dag->node[place[next].node];
        for (size_t i = 0; i < n->edges; i++)
            left[n->edge[i].node]--;
        s->order[k] = place[next].node;
        done[s->order[k]] = true;
    }
    free(left);
    free(done);
}

/* Sorts each stage of arithmetic by waiting chains. No node waits longer than its operands; ties keep the order. */
static void order_urgent(struct schedule *s)
{
    struct place *place = new_array(s->n, sizeof *place);
    double *wait = new_array(s->dag->nodes, sizeof *wait);
    for (size_t k = s->n; k-- > 0;) {
        const int n = s->order[k];
        const struct node *node = &s->dag->node[n];
        for (size_t i = 0; i < node->edges; i++) {
            double *of = &wait[node->edge[i].node];
            const double time = wait[n] + find_delay(node, i, &cost_cycles);
            *of = time > *of ? time : *of;
        }
        place[k] = (struct place){n, s->stage[n], wait[n], k};
    }
    qsort(place, s->n, sizeof *place, compare_places);
    order_places(s, place);
    free(place);
    free(wait);
}

rational schedule_coefficient(const struct schedule *s, int n, size_t i)
{
    const struct edge *e = &s->dag->node[n].edge[i];
    return rational_mul(rational_mul(s->scale[n], e->coef), rational_inv(s->scale[e->node]));
}

bool schedule_has_numerator(const struct schedule *s, int n)
{
    const int uses = s->uses[n], products = uses - s->alone[n];
    return s->dag->node[n].kind == NODE_INVERSE && uses > 1 && (uses - 1) * s->model->div >= products * s->model->mul;
}

static int compare_addends(const void *a, const void *b)
{
    const struct addend *x = a, *y = b;
    return x->like != y->like ? (x->like > y->like) - (x->like < y->like) : (x->edge > y->edge) - (x->edge < y->edge);
}

void schedule_sort_addends(const struct schedule *s, int n, struct addend *sorted)
{
    const struct node *node = &s->dag->node[n];
    for (size_t k = 0; k < node->edges; k++) {
        const rational coef = schedule_coefficient(s, n, k), size = rational_abs(coef);
        sorted[k] = (struct addend){coef, size, node->edge[k].node == 0 || size == ONE ? ZERO : size, k};
    }
    qsort(sorted, node->edges, sizeof *sorted, compare_addends);
}

/* Counts in how many sums each term size * node is separate, with its own coefficient. */
static void count_terms(struct schedule *s, size_t most_edges)
{
    struct addend *term = new_array(most_edges, sizeof *term);
    for (size_t i = 0; i < s->n; i++) {
        const struct node *node = &s->dag->node[s->order[i]];
        if (node->kind != NODE_SUM)
            continue;
        schedule_sort_addends(s, s->order[i], term);
        for (size_t k = 0; k < node->edges; k++) {
            if (term[k].like == ZERO || (k > 0 && term[k - 1].like == term[k].like) ||
                (k + 1 < node->edges && term[k + 1].like == term[k].like))
                continue;
            const int operand = node->edge[term[k].edge].node;
            struct shared_term *t = schedule_term(s->term, s->terms, term[k].size, operand);
            *t = (struct shared_term){term[k].size, operand, t->times + 1};
        }
    }
    free(term);
}

struct shared_term *schedule_term(struct shared_term *table, size_t room, rational size, int node)
{
    size_t i = ((size_t)size * 2654435761u + (size_t)node * 40503u) & (room - 1);
    while (table[i].size != 0 && (table[i].size != size || table[i].node != node))
        i = (i + 1) & (room - 1);
    return &table[i];
}

bool schedule_shares_term(const struct schedule *s, rational size, int node)
{
    return schedule_term(s->term, s->terms, size, node)->times > 1;
}

int schedule_doublings(const struct schedule *s, rational c)
{
    const rational size = rational_abs(c);
    const int n = size == TWO ? 1 : size == FOUR ? 2 : size == EIGHT ? 3 : 0;
    return n * s->model->add < s->model->mul ? n : 0;
}

struct schedule *schedule_new(const struct dag *g, const struct cost_model *model)
{
    struct schedule *s = new_array(1, sizeof *s);
    s->dag = g;
    s->model = model;
    s->order = arena_array(&s->arena, g->nodes, sizeof *s->order);
    s->uses = arena_array(&s->arena, g->nodes, sizeof *s->uses);
    s->alone = arena_array(&s->arena, g->nodes, sizeof *s->alone);
    s->stage = arena_array(&s->arena, g->nodes, sizeof *s->stage);
    s->scale = arena_array(&s->arena, g->nodes, sizeof *s->scale);
    for (size_t n = 0; n < g->nodes; n++)
        s->scale[n] = ONE;
    order_nodes(s);
    order_stages(s);
    return s;
}

void schedule_finish(struct schedule *s)
{
    size_t edges = 0;
    for (size_t n = 0; n < s->dag->nodes; n++)
        edges += s->dag->node[n].kind == NODE_SUM ? s->dag->node[n].edges : 0;
    order_urgent(s);
    for (s->terms = 16; s->terms < 2 * edges; s->terms *= 2)
        ;
    s->term = arena_array(&s->arena, s->terms, sizeof *s->term);
    if (edges <= MOST_COUNTED)
        count_terms(s, edges);
}

void schedule_free(struct schedule *s)
{
    if (!s)
        return;
    arena_free(&s->arena);
    free(s);
}
