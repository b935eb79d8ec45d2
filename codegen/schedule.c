/* Order: depth first from the outputs.  Scales: a sum may be computed as any multiple of itself, since whoever uses it
 * can take the multiple back; a local search picks, sum by sum, the multiple that leaves the fewest different
 * coefficients other than 1 and -1 (equal ones are taken out together when emitted). */
#include "schedule.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_SEARCHED = 300, SWEEPS = 3 };

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

static bool is_unit(const fmpq_t c)
{
    return fmpz_is_one(fmpq_denref(c)) && fmpz_is_pm1(fmpq_numref(c));
}

/* Different coefficients of a sum other than +-1, and one for a sum without any positive term. */
static long sum_cost(const struct schedule *s, int n, fmpq *coef)
{
    const struct node *node = &s->dag->node[n];
    long cost = 0;
    bool positive = false;
    for (size_t i = 0; i < node->edges; i++) {
        schedule_coefficient(s, n, i, &coef[i]);
        positive |= fmpq_sgn(&coef[i]) > 0;
        fmpq_abs(&coef[i], &coef[i]);
        bool counts = node->edge[i].node != 0 && !is_unit(&coef[i]);
        for (size_t k = 0; counts && k < i; k++)
            counts = !fmpq_equal(&coef[i], &coef[k]) || node->edge[k].node == 0;
        cost += counts;
    }
    return 2 * cost + !positive;
}

static long total_cost(struct schedule *s, fmpq *work)
{
    const struct dag *g = s->dag;
    fmpq_t c;
    long cost = 0;
    fmpq_init(c);
    for (size_t i = 0; i < s->n; i++) {
        const int n = s->order[i];
        const enum node_kind kind = g->node[n].kind;
        if (kind == NODE_SUM)
            cost += sum_cost(s, n, work);
        else {
            derive_scale(s, n);
            for (size_t k = 0; kind >= NODE_PDIV && k < g->node[n].edges; k++) {
                schedule_coefficient(s, n, k, c);
                cost += is_unit(c) ? 0 : 2;
            }
        }
    }
    for (size_t o = 0; o < g->outputs; o++) {
        fmpq_div(c, g->output[o].coef, &s->scale[g->output[o].node]);
        cost += is_unit(c) || g->output[o].node == 0 ? 0 : 2;
        cost += fmpq_sgn(c) < 0;
    }
    fmpq_clear(c);
    return cost;
}

/* Tries scale `candidate` for sum n; keeps it if the total falls. */
static void try_scale(struct schedule *s, int n, const fmpq_t candidate, long *least, fmpq *work)
{
    fmpq_t kept;
    fmpq_init(kept);
    fmpq_set(kept, &s->scale[n]);
    fmpq_set(&s->scale[n], candidate);
    const long cost = total_cost(s, work);
    if (cost < *least)
        *least = cost;
    else
        fmpq_set(&s->scale[n], kept);
    fmpq_clear(kept);
}

static void search_scales(struct schedule *s, size_t widest)
{
    fmpq *work = _fmpq_vec_init((slong)widest);
    fmpq_t c;
    fmpq_init(c);
    long least = total_cost(s, work);
    for (int sweep = 0; sweep < SWEEPS; sweep++) {
        const long before = least;
        for (size_t i = 0; i < s->n; i++) {
            const int n = s->order[i];
            const struct node *node = &s->dag->node[n];
            if (node->kind != NODE_SUM)
                continue;
            for (size_t k = 0; k < node->edges && k < 12; k++) { /* make this term's coefficient 1 */
                fmpq_div(c, &s->scale[node->edge[k].node], node->edge[k].coef);
                try_scale(s, n, c, &least, work);
            }
            for (size_t j = i + 1; j < s->n; j++) /* make a user's coefficient 1 */
                for (size_t k = 0; k < s->dag->node[s->order[j]].edges; k++)
                    if (s->dag->node[s->order[j]].kind == NODE_SUM && s->dag->node[s->order[j]].edge[k].node == n) {
                        fmpq_mul(c, s->dag->node[s->order[j]].edge[k].coef, &s->scale[s->order[j]]);
                        try_scale(s, n, c, &least, work);
                    }
            for (size_t o = 0; o < s->dag->outputs; o++)
                if (s->dag->output[o].node == n)
                    try_scale(s, n, s->dag->output[o].coef, &least, work);
            fmpq_neg(c, &s->scale[n]);
            try_scale(s, n, c, &least, work);
        }
        if (least == before)
            break;
    }
    total_cost(s, work); /* leaves the derived scales of the choice kept */
    fmpq_clear(c);
    _fmpq_vec_clear(work, (slong)widest);
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
