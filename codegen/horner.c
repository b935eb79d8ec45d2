/* Horner's rule for several variables.  A sum that only one place uses first becomes part of that place; then each sum
 * is factored greedily: the factor that most terms share is taken out of them, the quotient and the rest are treated
 * alike.  k terms that share a factor save k-1 multiplications. */
#include "horner.h"

#include <stdlib.h>
#include <string.h>

/* Larger sums, and what is left after so many factors, stay as they are: bounded time and stack on enormous input. */
enum { MOST_TERMS = 4000, DEEPEST = 300 };

struct term {
    fmpq_t coef;
    struct edges factors; /* powers > 0 */
};

struct factoring {
    const struct dag *from;
    struct dag *to;
    struct value *image; /* owned: of each node of `from` */
    int *uses;           /* owned */
};

static void fill_term(const struct dag *g, struct term *t, const fmpq_t coef, int node)
{
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    fmpq_init(t->coef);
    fmpq_set(t->coef, coef);
    t->factors = (struct edges){0};
    const struct node *n = &g->node[node];
    if (n->kind == NODE_PRODUCT && !n->kept)
        for (size_t k = 0; k < n->edges; k++)
            edges_add(&t->factors, one, n->edge[k].node, n->edge[k].power);
    else if (node != 0)
        edges_add(&t->factors, one, node, 1);
    fmpq_clear(one);
}

/* Factor that occurs in most terms, least node number first; its number of terms in *most. */
static int commonest(const struct dag *g, const struct term *t, size_t n, size_t *most)
{
    size_t *count = new_array(g->nodes, sizeof *count);
    int best = -1;
    *most = 0;
    for (size_t i = 0; i < n; i++)
        for (size_t k = 0; k < t[i].factors.n; k++) {
            const int node = t[i].factors.edge[k].node;
            count[node]++;
            if (count[node] > *most || (count[node] == *most && node < best)) {
                *most = count[node];
                best = node;
            }
        }
    free(count);
    return best;
}

static struct edge *factor_of(const struct term *t, int node)
{
    for (size_t k = 0; k < t->factors.n; k++)
        if (t->factors.edge[k].node == node)
            return &t->factors.edge[k];
    return NULL;
}

/* Moves the terms that hold `node`, divided by the highest power they share, to a list of their own; returns that
 * power. t keeps the *rest. */
static int divide_terms(struct term *t, size_t n, int node, struct term *quotient, size_t *taken)
{
    int power = 0;
    size_t rest = 0;
    for (size_t i = 0; i < n; i++) {
        const struct edge *e = factor_of(&t[i], node);
        if (e && (power == 0 || e->power < power))
            power = e->power;
    }
    *taken = 0;
    for (size_t i = 0; i < n; i++) {
        struct edge *e = factor_of(&t[i], node);
        if (!e) {
            t[rest++] = t[i];
            continue;
        }
        e->power -= power;
        if (e->power == 0) {
            struct edges *f = &t[i].factors;
            fmpq_clear(e->coef);
            *e = f->edge[--f->n];
        }
        quotient[(*taken)++] = t[i];
    }
    return power;
}

/* Value of a list of terms; consumes them (not the array).  Recursion is as deep as the degree, at most DEEPEST. */
static void factor_terms(struct factoring *f, struct term *t, size_t n, int depth, struct value *v)
{
    struct edges sum = {0};
    struct value part;
    fmpq_t one;
    fmpq_init(one);
    fmpq_one(one);
    value_init(&part);
    while (n > 1 && n <= MOST_TERMS && depth < DEEPEST) {
        size_t most, taken;
        const int node = commonest(f->to, t, n, &most);
        if (most < 2)
            break;
        struct term *quotient = new_array(most, sizeof *quotient);
        const int power = divide_terms(t, n, node, quotient, &taken);
        n -= taken;
        factor_terms(f, quotient, taken, depth + 1, &part);
        struct edges product = {0};
        edges_add(&product, one, node, power);
        edges_add(&product, one, part.node, 1);
        dag_product(f->to, part.coef, &product, &part);
        if (!fmpq_is_zero(part.coef))
            edges_add(&sum, part.coef, part.node, 1);
        free(quotient);
    }
    for (size_t i = 0; i < n; i++) {
        dag_product(f->to, t[i].coef, &t[i].factors, &part);
        if (!fmpq_is_zero(part.coef))
            edges_add(&sum, part.coef, part.node, 1);
        fmpq_clear(t[i].coef);
    }
    dag_sum(f->to, &sum, v);
    value_clear(&part);
    fmpq_clear(one);
}

static bool joins(const struct factoring *f, const struct edge *e)
{
    return f->from->node[e->node].kind == NODE_SUM && f->uses[e->node] == 1 && fmpz_is_one(fmpq_denref(e->coef)) &&
           fmpz_is_pm1(fmpq_numref(e->coef));
}

/* Terms of a sum, those of sums inside it that nothing else uses and that are not multiplied spread (iteratively: they
 * may nest deep). */
static void gather(const struct factoring *f, size_t node, struct edges *terms)
{
    const struct node *n = &f->from->node[node];
    for (size_t i = 0; i < n->edges; i++)
        edges_add(terms, n->edge[i].coef, n->edge[i].node, 1);
    for (size_t i = 0; i < terms->n;) {
        const int k = terms->edge[i].node;
        if (!joins(f, &terms->edge[i])) {
            i++;
            continue;
        }
        fmpq_t coef, product;
        fmpq_init(coef);
        fmpq_init(product);
        fmpq_set(coef, terms->edge[i].coef);
        for (size_t j = 0; j < f->from->node[k].edges; j++) {
            const struct edge *e = &f->from->node[k].edge[j];
            fmpq_mul(product, coef, e->coef);
            if (j == 0) {
                fmpq_set(terms->edge[i].coef, product);
                terms->edge[i].node = e->node;
            } else
                edges_add(terms, product, e->node, 1);
        }
        fmpq_clear(coef);
        fmpq_clear(product);
    }
}

static void map_sum(struct factoring *f, size_t node, struct value *v)
{
    struct edges terms = {0};
    fmpq_t coef;
    gather(f, node, &terms);
    struct term *t = new_array(terms.n, sizeof *t);
    fmpq_init(coef);
    for (size_t i = 0; i < terms.n; i++) {
        const struct value *image = &f->image[terms.edge[i].node];
        fmpq_mul(coef, terms.edge[i].coef, image->coef);
        fill_term(f->to, &t[i], coef, image->node);
    }
    factor_terms(f, t, terms.n, 0, v);
    free(t);
    fmpq_clear(coef);
    edges_clear(&terms);
}

static void map_product(struct factoring *f, const struct node *n, struct value *v)
{
    struct edges factors = {0};
    fmpq_t coef, power;
    fmpq_init(coef);
    fmpq_init(power);
    fmpq_one(coef);
    for (size_t i = 0; i < n->edges; i++) {
        const struct value *image = &f->image[n->edge[i].node];
        fmpq_pow_si(power, image->coef, n->edge[i].power);
        fmpq_mul(coef, coef, power);
        edges_add(&factors, power, image->node, n->edge[i].power);
    }
    dag_product(f->to, coef, &factors, v);
    fmpq_clear(coef);
    fmpq_clear(power);
}

static void map_function(struct factoring *f, const struct node *n, struct value *v)
{
    struct value a[2];
    for (size_t i = 0; i < 2; i++) {
        value_init(&a[i]);
        if (i < n->edges) {
            const struct value *image = &f->image[n->edge[i].node];
            fmpq_mul(a[i].coef, n->edge[i].coef, image->coef);
            a[i].node = image->node;
        }
    }
    if (n->kind == NODE_INVERSE)
        dag_inverse(f->to, &a[0], v);
    else
        dag_function(f->to, n->kind, &a[0], &a[1], v);
    value_clear(&a[0]);
    value_clear(&a[1]);
}

struct dag *horner_factor(const struct dag *g)
{
    struct factoring f = {.from = g, .to = dag_new(g->inputs), .uses = dag_uses(g)};
    f.image = new_array(g->nodes, sizeof *f.image);
    /* a sum spread into its only user is not built on its own */
    bool *spread = new_array(g->nodes, sizeof *spread);
    for (size_t n = 0; n < g->nodes; n++)
        for (size_t i = 0; f.uses[n] && g->node[n].kind == NODE_SUM && i < g->node[n].edges; i++)
            if (joins(&f, &g->node[n].edge[i]))
                spread[g->node[n].edge[i].node] = true;
    for (size_t n = 0; n < g->nodes; n++) {
        const struct node *node = &g->node[n];
        value_init(&f.image[n]);
        if (n == 0)
            fmpq_one(f.image[n].coef);
        else if (f.uses[n] == 0 || spread[n])
            continue;
        else if (node->kind == NODE_INPUT)
            dag_input(f.to, (size_t)node->input, &f.image[n]);
        else if (node->kind == NODE_SUM)
            map_sum(&f, n, &f.image[n]);
        else if (node->kind == NODE_PRODUCT)
            map_product(&f, node, &f.image[n]);
        else
            map_function(&f, node, &f.image[n]);
        if (node->kept)
            f.to->node[f.image[n].node].kept = true;
    }
    for (size_t i = 0; i < g->outputs; i++) {
        struct value v;
        value_init(&v);
        const struct value *image = &f.image[g->output[i].node];
        fmpq_mul(v.coef, g->output[i].coef, image->coef);
        v.node = image->node;
        dag_add_output(f.to, g->output_name[i], &v);
        value_clear(&v);
    }
    for (size_t n = 0; n < g->nodes; n++)
        value_clear(&f.image[n]);
    free(f.image);
    free(f.uses);
    free(spread);
    f.to->removed = g->removed;
    return f.to;
}
