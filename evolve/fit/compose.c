/* Compositions of functions; see compose.h.  A search by breadth: of the compositions of one length those are
 * continued that are, or whose continuations by one function are, nearest to the front of error against cost: what
 * leads to xi and eta in the end may come last.  Truncated iterations of any length and mixture are among them:
 * gauss_newton from p, newton newton, inside newton inside newton ... */
#include "compose.h"

#include "fit_constants.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 2048, WIDTH = 64 };
static const double smallest = 1e-300; /* an error of 0 is compared, too */

struct candidate {
    int *gene; /* owned */
    size_t length, parent;
    double cost, error;
    double promise; /* error over the front's at its cost: the least of itself and its continuations */
    uint64_t hash;
};

struct candidates {
    struct candidate *c; /* owned */
    size_t n, room;
};

struct composer {
    const struct gene_set *genes;
    const struct prices *prices;
    struct objective *objective;  /* owned: on `thin` */
    struct columns thin;          /* owned */
    struct twin_counter *counter; /* owned */
    struct front *found;
};

/* Measure a composition; false where it costs more than the front has room for, or is longer. */
static bool measure(struct composer *s, struct candidate *x)
{
    const struct tree t = {x->gene, x->length};
    if (x->length > s->found->max_length)
        return false;
    const struct operation_count o = count_twin_operations(s->counter, &t);
    x->cost = operations_price(&o, s->prices);
    if (front_place(s->found, x->cost) > s->found->limit)
        return false;
    x->hash = o.hash;
    x->error = objective_error(s->objective, &t, s->thin.count, INFINITY);
    if (x->error < INFINITY)
        front_offer(s->found, &t, x->error, x->cost);
    return true;
}

/* Add f(x), or the leaf f where x is NULL, if it can be measured. */
static void add(struct composer *s, struct candidates *to, int f, const struct candidate *x, size_t parent)
{
    const size_t length = x ? x->length + 1 : 1;
    struct candidate fresh = {.gene = new_array(length, sizeof *fresh.gene), .length = length, .parent = parent};
    fresh.gene[0] = f;
    if (x)
        memcpy(fresh.gene + 1, x->gene, x->length * sizeof *x->gene);
    if (measure(s, &fresh)) {
        grow_array(&to->c, to->n, &to->room, sizeof *to->c);
        to->c[to->n++] = fresh;
    } else {
        free(fresh.gene);
    }
}

static void drop(struct candidates *list)
{
    for (size_t i = 0; i < list->n; i++)
        free(list->c[i].gene);
    free(list->c);
    *list = (struct candidates){0};
}

static int compare(const void *a, const void *b)
{
    const struct candidate *p = *(struct candidate *const *)a, *q = *(struct candidate *const *)b;
    if (p->promise != q->promise)
        return p->promise < q->promise ? -1 : 1;
    if (p->error != q->error)
        return p->error < q->error ? -1 : 1;
    if (p->length != q->length)
        return p->length < q->length ? -1 : 1;
    return memcmp(p->gene, q->gene, p->length * sizeof *p->gene);
}

static struct candidates continuations(struct composer *s, const struct candidates *list)
{
    struct candidates all = {0};
    for (size_t i = 0; i < list->n; i++)
        for (size_t k = 0; k < s->genes->functions; k++)
            add(s, &all, s->genes->operation[s->genes->operations + k], &list->c[i], i);
    return all;
}

static double ratio(const struct composer *s, const struct candidate *x)
{
    return x->error < INFINITY ? (x->error + smallest) / (front_error(s->found, x->cost) + smallest) : INFINITY;
}

static void look_ahead(const struct composer *s, struct candidates *list, const struct candidates *all)
{
    for (size_t i = 0; i < list->n; i++)
        list->c[i].promise = ratio(s, &list->c[i]);
    for (size_t i = 0; i < all->n; i++) {
        struct candidate *from = &list->c[all->c[i].parent];
        from->promise = fmin(from->promise, ratio(s, &all->c[i]));
    }
}

static bool is_repeated(struct candidate *const *order, size_t n, uint64_t hash)
{
    for (size_t i = 0; i < n; i++)
        if (order[i]->hash == hash)
            return true;
    return false;
}

/* keep[i]: candidate i is one of the most promising; each value once. */
static void choose(struct candidates *list, bool *keep)
{
    struct candidate **order = new_array(list->n, sizeof *order);
    size_t kept = 0;
    for (size_t i = 0; i < list->n; i++)
        order[i] = &list->c[i];
    qsort(order, list->n, sizeof *order, compare);
    for (size_t i = 0; i < list->n && kept < WIDTH; i++) {
        if (is_repeated(order, i, order[i]->hash))
            continue;
        keep[order[i] - list->c] = true;
        kept++;
    }
    free(order);
}

/* The continuations of the most promising candidates in the list's place. */
static void advance(struct composer *s, struct candidates *list)
{
    struct candidates all = continuations(s, list), next = {0};
    bool *keep = new_array(list->n, sizeof *keep);
    look_ahead(s, list, &all);
    choose(list, keep);
    for (size_t i = 0; i < all.n; i++) {
        if (keep[all.c[i].parent]) {
            grow_array(&next.c, next.n, &next.room, sizeof *next.c);
            next.c[next.n++] = all.c[i];
        } else {
            free(all.c[i].gene);
        }
    }
    free(all.c);
    free(keep);
    drop(list);
    *list = next;
}

void compose_twins(const struct gene_set *genes, const struct objective *objective, const struct prices *prices,
                   struct front *found)
{
    const size_t stride = objective->table->n / ROWS;
    struct composer s = {.genes = genes, .prices = prices, .found = found};
    struct candidates list = {0};
    s.thin = columns_thin(objective->table, stride > 1 ? stride : 1);
    s.objective = objective_new(objective->program, &s.thin, objective->norm);
    s.objective->decimal = true;
    s.counter = twin_counter_new(s.objective->twins);
    for (size_t i = 0; i < genes->symbols; i++)
        add(&s, &list, genes->symbol[i], NULL, 0);
    while (list.n > 0)
        advance(&s, &list);
    drop(&list);
    twin_counter_free(s.counter);
    objective_free(s.objective);
    columns_free(&s.thin);
}
