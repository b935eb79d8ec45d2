/* Composes seeds of programs; see compose.h. Starts from each pair of `starts` and applies the scene's functions in
 * turn. Each round keeps the most promising candidates: those that come closest to the front, or whose continuations
 * do, so that a step is kept if it pays only together with the next step. This covers truncated iterations of every
 * length and mixture: a Gauss-Newton step, two Newton steps, (7) solved for xi and then a Newton step ... */
#include "compose.h"

#include "../genotype/lines_text.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = 2048, WIDTH = 64 };
static const double smallest = 1e-300; /* errors are clamped to it, so that 0 can be compared */

struct candidate {
    int *gene; /* owned */
    size_t length, parent;
    double cost, error;
    double promise; /* error over the front's error at the same cost: the least over itself and its continuations */
};

struct candidates {
    struct candidate *c; /* owned */
    size_t n, room;
};

struct composer {
    const struct gene_set *genes;
    const struct prices *prices;
    struct objective *objective; /* owned: on `thin` */
    int last;
    struct columns thin;           /* owned */
    struct lines_counter *counter; /* owned */
    struct lines *lines;           /* owned */
    struct front *found;
    uint64_t *seen; /* owned: hashes of all candidates */
    size_t seens, room;
};

/* Returns true the first time a hash is seen. */
static bool is_new(struct composer *s, uint64_t hash)
{
    for (size_t i = 0; i < s->seens; i++)
        if (s->seen[i] == hash)
            return false;
    APPEND(s->seen, s->seens, s->room) = hash;
    return true;
}

/* Measures a composition. Returns false if it exceeds the front's cost limit or the length limit, or was seen
 * before. */
static bool measure(struct composer *s, struct candidate *x)
{
    const struct genes t = {x->gene, x->length};
    if (x->length > s->found->max_length)
        return false;
    const struct operation_count o = count_lines(s->counter, &t, s->last);
    x->cost = operations_price(&o, s->prices);
    if (front_place(s->found, x->cost) > s->found->limit)
        return false;
    if (!is_new(s, o.hash))
        return false;
    x->error = objective_error(s->objective, &t, s->last, INFINITY);
    if (x->error < INFINITY)
        front_offer(s->found, &t, x->error, x->cost);
    return true;
}

/* Adds the program in s->lines if it can be measured. */
static void add(struct composer *s, struct candidates *to, size_t parent)
{
    struct candidate fresh = {.gene = new_array(s->found->max_length, sizeof *fresh.gene), .parent = parent};
    struct genes t = {fresh.gene, 0};
    const bool good = lines_store(s->lines, s->found->max_length, &t);
    fresh.length = t.length;
    if (good && measure(s, &fresh)) {
        APPEND(to->c, to->n, to->room) = fresh;
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
        for (size_t k = 0; k < s->genes->functions; k++) {
            const struct genes t = {list->c[i].gene, list->c[i].length};
            lines_load(s->lines, &t, -1, LINES_INNER);
            lines_call(s->lines, s->genes->operation[s->genes->operations + k] - GENE_FUNCTION, s->lines->root);
            add(s, &all, i);
        }
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

/* Sets keep[i] if candidate i is among the most promising. */
static void choose(struct candidates *list, bool *keep)
{
    struct candidate **order = new_array(list->n, sizeof *order);
    for (size_t i = 0; i < list->n; i++)
        order[i] = &list->c[i];
    qsort(order, list->n, sizeof *order, compare);
    for (size_t i = 0; i < list->n && i < WIDTH; i++)
        keep[order[i] - list->c] = true;
    free(order);
}

/* Replaces the list by the continuations of its most promising candidates. */
static void advance(struct composer *s, struct candidates *list)
{
    struct candidates all = continuations(s, list), next = {0};
    bool *keep = new_array(list->n, sizeof *keep);
    look_ahead(s, list, &all);
    choose(list, keep);
    for (size_t i = 0; i < all.n; i++) {
        if (keep[all.c[i].parent]) {
            APPEND(next.c, next.n, next.room) = all.c[i];
        } else {
            free(all.c[i].gene);
        }
    }
    free(all.c);
    free(keep);
    drop(list);
    *list = next;
}

/* Adds each pair of different terminals, if a tier names no starts. With equal terminals both answers would be one
 * line, and every change would affect both. */
static void add_pairs(struct composer *s, struct candidates *list)
{
    for (size_t i = 0; i < s->genes->symbols; i++)
        for (size_t k = 0; k < s->genes->symbols; k++) {
            const struct genes t = {(int[2]){s->genes->symbol[i], s->genes->symbol[k]}, 2};
            if (i == k && s->genes->symbols > 1)
                continue;
            lines_load(s->lines, &t, -1, LINES_INNER);
            add(s, list, 0);
        }
}

/* Adds the frame's values p, q as a program of the terminals. */
static void add_start(struct composer *s, char *const name[2], struct candidates *list)
{
    struct genes t = {new_array(s->found->max_length, sizeof *t.gene), 0};
    if (lines_read_values(s->lines, name, s->genes, s->found->max_length, &t)) {
        lines_load(s->lines, &t, -1, LINES_INNER);
        add(s, list, 0);
    }
    free(t.gene);
}

static bool same_names(char *const *a, size_t n, char *const *b, size_t m)
{
    bool same = n == m;
    for (size_t i = 0; same && i < n; i++)
        same = strcmp(a[i], b[i]) == 0;
    return same;
}

bool compose_alike(const struct tier *a, const struct tier *b)
{
    return a->program && b->program && a->max_length == b->max_length && a->rational == b->rational &&
           same_names(a->terminal, a->terminals, b->terminal, b->terminals) &&
           same_names(a->function, a->functions, b->function, b->functions) && a->starts == b->starts &&
           same_names((char *const *)a->start, 2 * a->starts, (char *const *)b->start, 2 * b->starts) &&
           strcmp(a->last ? a->last : "", b->last ? b->last : "") == 0;
}

void compose_programs(const struct tier *tier, const struct gene_set *genes, const struct objective *objective,
                      int last, const struct prices *prices, struct front *found)
{
    const size_t stride = objective->table->n / ROWS;
    struct composer s = {.genes = genes, .prices = prices, .found = found, .last = last};
    struct candidates list = {0};
    s.thin = columns_thin(objective->table, stride > 1 ? stride : 1);
    s.objective = objective_new(objective->program, &s.thin, objective->norm);
    s.objective->decimal = true;
    s.counter = lines_counter_new(s.objective->rules);
    s.lines = lines_new(s.objective->rules);
    for (size_t i = 0; i < tier->starts; i++)
        add_start(&s, tier->start[i], &list);
    if (tier->starts == 0)
        add_pairs(&s, &list);
    while (list.n > 0)
        advance(&s, &list);
    drop(&list);
    lines_counter_free(s.counter);
    lines_free(s.lines);
    objective_free(s.objective);
    columns_free(&s.thin);
    free(s.seen);
}
