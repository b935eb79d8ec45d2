/* Builds the vectors of a segment with the fewest additions; see expand.h. A vector is a sum of weight 0 of the
 * coordinates x, y or z of its nodes and the slave node, used by a node that is not such a sum. addition_chain.h finds
 * how to make the vectors, for x, y and z alike. */
#include "expand.h"

#include "../graph/rewrite.h"
#include "addition_chain.h"

#include <stdlib.h>
#include <string.h>

enum { MOST_COEFFICIENT = 1000 };

/* A node as a combination of coordinates. */
struct form {
    bool sum;       /* of coordinates of points, all x, all y or all z */
    bool vector;    /* a sum of several terms, of weight 0 */
    bool needed;    /* used by a node that is not a sum of coordinates */
    int coordinate; /* 0..2 */
    rational of[ADDITIONS_POINTS];
    struct vector direction;
    rational size; /* a vector is size * direction */
};

struct forms {
    const struct dag *g;
    const struct segment_kind *kind;
    struct form *form; /* owned: indexed by node */
    int points;
};

/* Returns the number of the point whose coordinate the input is, the slave node last; -1 for a normal. */
static int point_of(const struct segment_kind *k, size_t input)
{
    const size_t vector = input / 3, nodes = strlen(k->nodes);
    return vector < nodes ? (int)vector : vector == segment_vectors(k) ? (int)nodes : -1;
}

static size_t input_of(const struct segment_kind *k, int point, int coordinate)
{
    const size_t nodes = strlen(k->nodes), vector = (size_t)point < nodes ? (size_t)point : segment_vectors(k);
    return 3 * vector + (size_t)coordinate;
}

/* Converts a rational to an integer; returns false if it is a fraction or large. */
static bool whole(rational r, long *number)
{
    const fmpq *q = rational_value(r);
    if (!fmpz_is_one(fmpq_denref(q)) || fmpz_cmp_si(fmpq_numref(q), MOST_COEFFICIENT) > 0 ||
        fmpz_cmp_si(fmpq_numref(q), -MOST_COEFFICIENT) < 0)
        return false;
    *number = fmpz_get_si(fmpq_numref(q));
    return true;
}

/* Finds direction and size; returns false if the weight is not 0 or the numbers are too large. */
static bool find_direction(const struct forms *x, struct form *f)
{
    rational weight = ZERO, scale = ZERO;
    long divisor;
    for (int i = 0; i < x->points; i++) {
        weight = rational_add(weight, f->of[i]);
        scale = scale == ZERO && f->of[i] != ZERO ? rational_inv(f->of[i]) : scale;
    }
    for (int i = 0; i < x->points; i++) {
        const fmpz *below = fmpq_denref(rational_value(rational_mul(scale, f->of[i])));
        if (fmpz_cmp_si(below, MOST_COEFFICIENT) > 0)
            return false;
        scale = rational_mul(scale, rational_from_si(fmpz_get_si(below)));
    }
    for (int i = 0; i < x->points; i++)
        if (!whole(rational_mul(scale, f->of[i]), &f->direction.of[i]))
            return false;
    if (weight != ZERO || !vector_reduce(&f->direction, &divisor))
        return false;
    f->size = rational_mul(rational_from_si(divisor), rational_inv(scale));
    return true;
}

static void find_form(struct forms *x, size_t n)
{
    const struct node *node = &x->g->node[n];
    struct form *f = &x->form[n];
    for (int i = 0; i < x->points; i++)
        f->of[i] = ZERO;
    if (node->kind == NODE_INPUT) {
        const int point = point_of(x->kind, (size_t)node->input);
        f->sum = point >= 0;
        f->coordinate = node->input % 3;
        if (f->sum)
            f->of[point] = ONE;
        return;
    }
    f->sum = node->kind == NODE_SUM;
    f->coordinate = f->sum ? x->form[node->edge[0].node].coordinate : 0;
    for (size_t i = 0; i < node->edges && f->sum; i++) {
        const struct form *term = &x->form[node->edge[i].node];
        f->sum = term->sum && term->coordinate == f->coordinate;
        for (int k = 0; k < x->points && f->sum; k++)
            f->of[k] = rational_add(f->of[k], rational_mul(node->edge[i].coef, term->of[k]));
    }
    f->vector = f->sum && find_direction(x, f);
}

static struct forms find_forms(const struct dag *g, const struct segment_kind *k, const int *uses)
{
    struct forms x = {.g = g, .kind = k, .points = (int)strlen(k->nodes) + 1};
    x.form = new_array(g->nodes, sizeof *x.form);
    for (size_t n = 1; n < g->nodes; n++) {
        if (uses[n] == 0)
            continue;
        find_form(&x, n);
        for (size_t i = 0; !x.form[n].vector && i < g->node[n].edges; i++)
            x.form[g->node[n].edge[i].node].needed = true;
    }
    for (size_t o = 0; o < g->outputs; o++)
        x.form[g->output[o].node].needed = true;
    return x;
}

/* Counts the additions of the vectors as they are, in the coordinate with most. */
static int count_additions(const struct forms *x)
{
    int count[3] = {0}, most = 0;
    for (size_t n = 1; n < x->g->nodes; n++)
        if (x->form[n].vector)
            count[x->form[n].coordinate] += (int)x->g->node[n].edges - 1;
    for (int c = 0; c < 3; c++)
        most = count[c] > most ? count[c] : most;
    return most;
}

/* Lists the directions of the needed vectors; returns 0 if there are too many. */
static int list_directions(const struct forms *x, struct vector direction[ADDITIONS_VECTORS])
{
    int count = 0;
    for (size_t n = 1; n < x->g->nodes; n++) {
        const struct form *f = &x->form[n];
        int i = 0;
        while (i < count && !vector_equal(&direction[i], &f->direction))
            i++;
        if (!f->vector || !f->needed || i < count)
            continue;
        if (count == ADDITIONS_VECTORS)
            return 0;
        direction[count++] = f->direction;
    }
    return count;
}

/* ---- the new graph ---- */

static struct value scaled(struct value v, rational by)
{
    return (struct value){rational_mul(by, v.coef), v.node};
}

static void make_values(struct dag *to, const struct forms *x, const struct additions *a, int coordinate,
                        struct value *value)
{
    for (int i = 0; i < a->points; i++)
        value[i] = dag_input(to, input_of(x->kind, i, coordinate));
    for (int i = a->points; i < a->values; i++) {
        const struct addition *s = &a->addition[i];
        const struct value left = scaled(value[s->a], rational_from_si(s->p)),
                           right = scaled(value[s->b], rational_from_si(s->q));
        struct edges terms = {0};
        edges_add(&terms, left.coef, left.node, 1);
        edges_add(&terms, right.coef, right.node, 1);
        value[i] = scaled(dag_sum(to, &terms), rational_inv(rational_from_si(s->d)));
    }
}

static struct dag *rewrite(const struct forms *x, const struct additions *a)
{
    struct walk w = walk_begin(x->g);
    struct value value[3][ADDITIONS_VALUES];
    for (int c = 0; c < 3; c++)
        make_values(w.to, x, a, c, value[c]);
    for (size_t n = 1; n < x->g->nodes; n++) {
        const struct form *f = &x->form[n];
        if (w.uses[n] == 0 || (f->vector && !f->needed))
            continue;
        if (f->vector) {
            int i = 0;
            while (!vector_equal(&a->value[i], &f->direction))
                i++;
            w.image[n] = scaled(value[f->coordinate][i], f->size);
        } else {
            w.image[n] = walk_map(&w, &x->g->node[n]);
            w.to->node[w.image[n].node].kept |= x->g->node[n].kept;
        }
    }
    return walk_end(&w);
}

/* Finds additions for the directions: fewer than now if all ways can be tried, otherwise along a tree. */
static bool find_additions(const struct forms *x, uint64_t seed, struct additions *a)
{
    struct vector direction[ADDITIONS_VECTORS];
    const int n = list_directions(x, direction);
    if (n == 0)
        return false;
    if (additions_few(x->points, 1))
        return additions_few(x->points, n) && additions_find(x->points, direction, n, count_additions(x) - 1, a);
    return additions_along_tree(x->points, direction, n, seed, a);
}

/* Returns true if a sum uses coordinates as one difference of two, or not at all. */
static bool takes_differences(const struct dag *g, const struct segment_kind *k, const struct node *sum)
{
    const struct edge *first = NULL;
    bool paired = true;
    for (size_t i = 0; i < sum->edges; i++) {
        const struct node *term = &g->node[sum->edge[i].node];
        if (term->kind != NODE_INPUT || point_of(k, (size_t)term->input) < 0)
            continue;
        if (!first) {
            first = &sum->edge[i];
            paired = false;
        } else if (paired || rational_add(first->coef, sum->edge[i].coef) != ZERO ||
                   g->node[first->node].input % 3 != term->input % 3)
            return false;
        else
            paired = true;
    }
    return paired;
}

bool shape_is_relative(const struct dag *g, const struct segment_kind *k)
{
    int *uses = dag_uses(g);
    bool relative = true;
    for (size_t n = 1; n < g->nodes && relative; n++) {
        const struct node *node = &g->node[n];
        if (uses[n] == 0 || node->kind == NODE_INPUT)
            continue;
        if (node->kind == NODE_SUM)
            relative = takes_differences(g, k, node);
        for (size_t i = 0; node->kind != NODE_SUM && i < node->edges && relative; i++) {
            const struct node *of = &g->node[node->edge[i].node];
            relative = of->kind != NODE_INPUT || point_of(k, (size_t)of->input) < 0;
        }
    }
    free(uses);
    return relative;
}

bool shape_differs_first(const struct segment_kind *k)
{
    return !additions_few((int)strlen(k->nodes) + 1, 1);
}

struct dag *shape_differences(const struct dag *g, const struct segment_kind *k, uint64_t seed)
{
    struct additions a;
    struct dag *made = NULL;
    if (strlen(k->nodes) + 1 > ADDITIONS_POINTS)
        return NULL;
    int *uses = dag_uses(g);
    struct forms x = find_forms(g, k, uses);
    if (find_additions(&x, seed, &a))
        made = rewrite(&x, &a);
    free(x.form);
    free(uses);
    return made;
}
