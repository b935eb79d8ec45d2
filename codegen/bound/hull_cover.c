/* The parts of a hull; see hull.h.
 *
 * All points make one part if its bounds of rounding errors are near the largest errors that the program has at any of them to
 * first order.  If not, each part takes all points, of those that none before it took, with which its bounds stay close to that.
 * So products of what is large at different points, which make bounds useless, do not come about.  Points with small errors
 * come first, so that a part is refused few of them before it is as large as it gets. */
#include "rounding_bound.h"

#include <stdlib.h>

/* Bounds over the largest first-order errors.  More than twice, as a hull is twice as wide as its points. */
#define CLOSE 4.0
#define MOST_WORK 2e10 /* about half a minute */
#define FIRST 0.3      /* of that, for a first look at all points */
enum { TRIES_A_POINT = 20, MOST_PARTS = 64, PATIENCE = 24 /* points refused in a row */ };

struct point {
    double size; /* the largest first-order error of any joint */
    long place;  /* where it is kept */
};

struct cover {
    struct hull *hull;
    size_t variables;
    double *at;               /* owned: by place and variable */
    double *first;            /* owned: by output, the largest first-order error */
    struct part_bound *bound; /* owned */
    double *error;            /* owned: by operation, of the last part that was tried */
    double work;              /* left */
};

/* One that grows. */
struct growing {
    struct hull_part points; /* owned: limits of its points themselves */
    struct hull_part part;   /* owned: the same, widened */
};

/* Of derivatives at a point, and of errors in a part. */
static double point_work(const struct hull *h)
{
    return 3 * (double)(h->joints + 1) * (double)h->program->ops;
}

static double part_work(const struct hull *h)
{
    return (75 + 0.25 * (double)h->joints) * (double)(h->joints + 1) * (double)h->program->ops;
}

static void go_to(const struct cover *c, long place)
{
    hull_go(c->hull, c->at + (size_t)place * c->variables);
}

static struct growing widened(struct hull_part points)
{
    struct growing g = {points, hull_part_copy(&points)};
    hull_part_widen(&g.part);
    return g;
}

static void growing_free(struct growing *g)
{
    hull_part_free(&g->points);
    hull_part_free(&g->part);
}

/* Whether all of a part's bounds are close to the first-order errors; where these are 0, all are. */
static bool is_close(struct cover *c, const struct hull_part *part)
{
    const struct hull *h = c->hull;
    bool close = true;
    part_bound_at(c->bound, part, c->error);
    c->work -= part_work(h);
    for (size_t i = 0; i < h->program->outputs; i++)
        close = close && (c->first[i] == 0 || c->error[h->program->output[i]] <= CLOSE * c->first[i]);
    return close;
}

/* The part with so many, or as many as there are, of the next points that it does not hold; where these end. */
static long offer(struct cover *c, const struct growing *g, const struct point *point, long points, long *many,
                  struct growing *with)
{
    struct hull_part limits = hull_part_copy(&g->points);
    long n = 0, k = 0;
    for (; k < points && n < *many; k++) {
        go_to(c, point[k].place);
        c->work -= point_work(c->hull);
        if (!hull_part_holds(c->hull, &g->part)) {
            hull_part_raise(c->hull, &limits);
            n++;
        }
    }
    *many = n;
    *with = widened(limits);
    return k;
}

/* The points that the part does not hold first; how many these are. */
static long left_by(struct cover *c, const struct hull_part *part, struct point *point, long points)
{
    long left = 0;
    for (long k = 0; k < points; k++) {
        go_to(c, point[k].place);
        c->work -= point_work(c->hull);
        if (!hull_part_holds(c->hull, part))
            point[left++] = point[k];
    }
    c->hull->points += points - left;
    return left;
}

/* Makes a part of points, those of them that it does not take first; how many these are. */
static long grow(struct cover *c, struct growing *g, struct point *point, long points)
{
    long left = 0, many = 1, k = 0;
    bool empty = true;
    for (int refused = 0; k < points && refused < PATIENCE && c->work > 0;) {
        struct growing with;
        const long end = k + offer(c, g, point + k, points - k, &many, &with);
        if (many == 0 || is_close(c, &with.part)) {
            growing_free(g);
            *g = with;
            c->hull->points += end - k;
            k = end;
            many *= 2;
            refused = 0;
            empty = false;
            continue;
        }
        growing_free(&with);
        if (many == 1) { /* the last one */
            c->hull->points += end - k - 1;
            if (!empty) /* or none is close with it */
                point[left++] = point[end - 1];
            k = end;
            refused += !empty;
        } else
            many /= 2;
    }
    while (k < points)
        point[left++] = point[k++];
    return left_by(c, &g->part, point, left);
}

static void make_parts(struct cover *c, struct point *point, long points)
{
    struct hull *h = c->hull;
    while (points > 0 && h->parts < MOST_PARTS && c->work > 0) {
        const long before = h->points;
        struct growing g = widened(hull_part_new(h));
        points = grow(c, &g, point, points);
        if (h->points > before)
            h->part[h->parts++] = hull_part_copy(&g.part);
        growing_free(&g);
    }
}

static double largest_sum(const struct hull *h)
{
    double largest = 0;
    for (size_t k = 0; k < h->joints; k++)
        largest = greater(largest, h->sum[h->op[k]]);
    return largest;
}

static int compare_points(const void *a, const void *b)
{
    const struct point *x = a, *y = b;
    return x->size != y->size ? (x->size > y->size) - (x->size < y->size)
                              : (x->place > y->place) - (x->place < y->place);
}

/* First-order errors, and the limits of all points that have derivatives.  How many these are. */
static long look(struct cover *c, struct point *point, long points, struct hull_part *all)
{
    struct hull *h = c->hull;
    const double unit = h->region->known->arithmetic.unit;
    long n = 0;
    for (long k = 0; k < points; k++) {
        go_to(c, k);
        if (!hull_part_raise(h, all))
            continue;
        point[n++] = (struct point){largest_sum(h), k};
        for (size_t i = 0; i < h->program->outputs; i++)
            c->first[i] = greater(c->first[i], unit * h->sum[h->program->output[i]]);
    }
    qsort(point, (size_t)n, sizeof *point, compare_points);
    return n;
}

/* If bounds are close nowhere, as where errors are not what they are to first order, one part of all serves, too. */
static void cover(struct cover *c, struct point *point, long points)
{
    struct hull *h = c->hull;
    struct hull_part all = hull_part_new(h);
    h->part = new_array(MOST_PARTS, sizeof *h->part);
    points = look(c, point, points, &all);
    hull_part_widen(&all);
    if (!is_close(c, &all))
        make_parts(c, point, points);
    if (points > 0 && h->parts == 0) {
        h->part[h->parts++] = hull_part_copy(&all);
        h->points = points;
    }
    hull_part_free(&all);
}

static long draw_points(struct region *r, long points, unsigned long seed, double *at)
{
    uint64_t stream = seed;
    long n = 0, tries = TRIES_A_POINT * points;
    while (n < points && region_draw(r, &stream, 0, true, &tries, at + (size_t)n * r->known->variables))
        n++;
    return n;
}

struct hull *hull_new(struct region *r, const struct program *p, long points, unsigned long seed)
{
    struct hull *h = hull_of_program(r, p);
    struct cover c = {.hull = h, .variables = r->known->variables, .work = MOST_WORK};
    const double most = FIRST * MOST_WORK / point_work(h);
    points = (double)points < most ? points : (long)most;
    struct point *point = new_array((size_t)points + 1, sizeof *point);
    c.at = new_array((size_t)points * c.variables + 1, sizeof *c.at);
    c.first = new_array(p->outputs, sizeof *c.first);
    c.error = new_array(p->ops, sizeof *c.error);
    c.bound = part_bound_new(h);
    points = draw_points(r, points, seed, c.at);
    cover(&c, point, points);
    free(point);
    free(c.at);
    free(c.first);
    free(c.error);
    part_bound_free(c.bound);
    return h;
}

bool hull_holds(struct hull *h, const double *at)
{
    bool held = false;
    hull_go(h, at);
    for (size_t k = 0; k < h->parts && !held; k++)
        held = hull_part_holds(h, &h->part[k]);
    return held;
}
