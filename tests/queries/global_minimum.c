/* Branches and bounds over the inside of the face, over each edge and over the corners.  At a global minimum inside, no slope is
 * left, and in no direction is the squared distance f concave; likewise along an edge.  A box of parameters is dropped if
 *   - the Bernstein coefficients of f on it are all greater than a value of f on the face,
 *   - a slope has one sign on it, or a second derivative or their determinant is negative on it.
 * It is done if f is strictly convex on it and a little beyond, so that at most one point there has no slope, and Krawczyk's operator
 * encloses such a point (R. Krawczyk, Computing 4, 1969).  All other boxes are halved.  Everything is computed in balls of arb, which
 * contain all rounding. */
#include "global_minimum.h"

enum { BOXES = 4000, DEPTH = 120, NEWTON_STEPS = 30, COARSE = 160 };

/* Part [s_at, s_at + 1] 2^-s_depth of [0,1], and so of t; the coefficients on it. */
struct box {
    arb_t b[POWERS * POWERS];
    long at[2];
    int depth[2];
};

struct search {
    struct polynomial f;
    int triangle;            /* s + t <= 1 */
    int region;              /* of candidates */
    arb_t least;             /* upper bound on the least f of the face */
    arb_t start[2], step[2]; /* s, t of the face = start + step u, if there is one parameter u */
    struct minima *found;
};

void minima_init(struct minima *found)
{
    found->n = 0;
    for (int i = 0; i < MINIMA; i++) {
        arb_init(found->at[i].z[0]);
        arb_init(found->at[i].z[1]);
        arb_init(found->at[i].square);
    }
}

void minima_clear(struct minima *found)
{
    for (int i = 0; i < MINIMA; i++) {
        arb_clear(found->at[i].z[0]);
        arb_clear(found->at[i].z[1]);
        arb_clear(found->at[i].square);
    }
}

/* ---- boxes ---- */

static void box_init(struct box *box)
{
    for (int i = 0; i < POWERS * POWERS; i++)
        arb_init(box->b[i]);
}

/* Halves `left` along a parameter by de Casteljau's rule; `right` gets the other half. */
static void halve(struct box *left, struct box *right, int along, int lines)
{
    const int stride = along == 0 ? POWERS : 1, across = along == 0 ? 1 : POWERS;
    for (int k = 0; k < 2; k++) {
        right->at[k] = left->at[k];
        right->depth[k] = left->depth[k];
    }
    left->at[along] *= 2;
    right->at[along] = left->at[along] + 1;
    right->depth[along] = ++left->depth[along];
    for (int line = 0; line < lines; line++) {
        arb_t *const l = left->b + line * across, *const r = right->b + line * across;
        arb_set(r[DEGREE * stride], l[DEGREE * stride]);
        for (int level = 1; level <= DEGREE; level++) {
            for (int i = DEGREE; i >= level; i--) {
                arb_add(l[i * stride], l[i * stride], l[(i - 1) * stride], COARSE);
                arb_mul_2exp_si(l[i * stride], l[i * stride], -1);
            }
            arb_set(r[(DEGREE - level) * stride], l[DEGREE * stride]);
        }
    }
}

/* Widens a ball to contain n numbers, of which `range` contains the first. */
static void widen(arb_t range, const arb_t x, int first)
{
    if (first)
        arb_set_round(range, x, COARSE);
    else
        arb_union(range, range, x, COARSE);
}

/* Encloses the derivative of order (p, q) over the box, up to a positive factor. */
static void slope_range(const struct box *box, int parameters, int p, int q, arb_t range)
{
    const int last = parameters == 2 ? DEGREE - q : 0;
    static const int sign[3][3] = {{1, 0, 0}, {-1, 1, 0}, {1, -2, 1}};
    arb_t d, term;
    arb_init(d);
    arb_init(term);
    for (int i = 0; i <= DEGREE - p; i++)
        for (int j = 0; j <= last; j++) {
            arb_zero(d);
            for (int k = 0; k <= p; k++)
                for (int l = 0; l <= q; l++) {
                    arb_mul_si(term, box->b[POWERS * (i + k) + j + l], sign[p][k] * sign[q][l], COARSE);
                    arb_add(d, d, term, COARSE);
                }
            widen(range, d, i == 0 && j == 0);
        }
    arb_clear(d);
    arb_clear(term);
}

static int all_above(const struct box *box, int parameters, const arb_t limit)
{
    for (int i = 0; i < POWERS; i++)
        for (int j = 0; j < (parameters == 2 ? POWERS : 1); j++)
            if (!arb_gt(box->b[POWERS * i + j], limit))
                return 0;
    return 1;
}

/* Sets z to the box, widened by a little of its size. */
static void box_ball(const struct box *box, int parameters, arb_t z[2])
{
    for (int k = 0; k < 2; k++) {
        arb_zero(z[k]);
        if (k >= parameters)
            continue;
        arb_set_si(z[k], 2 * box->at[k] + 1);
        mag_set_d(arb_radref(z[k]), 1 + 1e-12);
        arb_mul_2exp_si(z[k], z[k], -box->depth[k] - 1);
    }
}

/* ---- a stationary point ---- */

/* Computes step = -H^-1 gradient, with H of the jet; returns 0 if H may be singular. */
static int newton_step(int parameters, arb_t jet[JET], arb_t gradient[2], arb_t step[2])
{
    arb_t det, a;
    arb_init(det);
    arb_init(a);
    arb_zero(step[1]);
    if (parameters == 1) {
        arb_set(det, jet[D_SS]);
        arb_div(step[0], gradient[0], det, PRECISION);
    } else {
        arb_mul(det, jet[D_SS], jet[D_TT], PRECISION);
        arb_submul(det, jet[D_ST], jet[D_ST], PRECISION);
        arb_mul(a, jet[D_TT], gradient[0], PRECISION);
        arb_submul(a, jet[D_ST], gradient[1], PRECISION);
        arb_div(step[0], a, det, PRECISION);
        arb_mul(a, jet[D_SS], gradient[1], PRECISION);
        arb_submul(a, jet[D_ST], gradient[0], PRECISION);
        arb_div(step[1], a, det, PRECISION);
    }
    const int regular = !arb_contains_zero(det);
    arb_neg(step[0], step[0]);
    arb_neg(step[1], step[1]);
    arb_clear(det);
    arb_clear(a);
    return regular;
}

static void jet_init(arb_t jet[JET])
{
    for (int k = 0; k < JET; k++)
        arb_init(jet[k]);
}

static void jet_clear(arb_t jet[JET])
{
    for (int k = 0; k < JET; k++)
        arb_clear(jet[k]);
}

/* Iterates Newton's method from the middle of z; returns 0 unless it stops near the square. */
static int converge(const struct polynomial *f, arb_t z[2])
{
    arb_t jet[JET], step[2];
    mag_t size;
    int stands = 0;
    jet_init(jet);
    arb_init(step[0]);
    arb_init(step[1]);
    mag_init(size);
    for (int i = 0; i < NEWTON_STEPS && !stands; i++) {
        mag_zero(arb_radref(z[0]));
        mag_zero(arb_radref(z[1]));
        polynomial_jet(f, z, jet);
        if (!newton_step(f->parameters, jet, jet + D_S, step))
            break;
        stands = 1;
        for (int k = 0; k < f->parameters; k++) {
            arb_add(z[k], z[k], step[k], PRECISION);
            arb_get_mag(size, step[k]);
            stands &= mag_cmp_2exp_si(size, -PRECISION / 2) < 0;
            arb_get_mag(size, z[k]);
            i = mag_cmp_2exp_si(size, 3) > 0 ? NEWTON_STEPS : i;
        }
    }
    mag_zero(arb_radref(z[0]));
    mag_zero(arb_radref(z[1]));
    jet_clear(jet);
    arb_clear(step[0]);
    arb_clear(step[1]);
    mag_clear(size);
    return stands;
}

/* Proves that exactly one stationary point is near z, and encloses it: K = z - H(z)^-1 g(z) + (1 - H(z)^-1 H(X)) (X - z) lies
 * inside X = z +- 2^-140.  Computed as z - H(z)^-1 (g(z) + (H(X) - H(z)) (X - z)). */
static int enclose(const struct polynomial *f, arb_t z[2])
{
    arb_t jet[JET], wide[JET], box[2], off[2], right[2], step[2];
    jet_init(jet);
    jet_init(wide);
    for (int k = 0; k < 2; k++)
        arb_init(box[k]), arb_init(off[k]), arb_init(right[k]), arb_init(step[k]);
    for (int k = 0; k < f->parameters; k++) {
        mag_set_ui_2exp_si(arb_radref(off[k]), 1, -140);
        arb_add(box[k], z[k], off[k], PRECISION);
    }
    polynomial_jet(f, z, jet);
    polynomial_jet(f, box, wide);
    for (int k = 0; k < f->parameters; k++) {
        arb_set(right[k], jet[D_S + k]);
        for (int l = 0; l < f->parameters; l++) {
            const int d = D_SS + k + l;
            arb_sub(wide[VALUE], wide[d], jet[d], PRECISION);
            arb_addmul(right[k], wide[VALUE], off[l], PRECISION);
        }
    }
    int proved = newton_step(f->parameters, jet, right, step);
    for (int k = 0; k < f->parameters && proved; k++) {
        arb_add(z[k], z[k], step[k], PRECISION);
        proved = arb_contains_interior(box[k], z[k]);
    }
    jet_clear(jet);
    jet_clear(wide);
    for (int k = 0; k < 2; k++)
        arb_clear(box[k]), arb_clear(off[k]), arb_clear(right[k]), arb_clear(step[k]);
    return proved;
}

/* ---- candidates ---- */

static int is_near(const struct minimum *a, const struct minimum *b)
{
    int near = 1;
    arb_t off;
    mag_t size;
    arb_init(off);
    mag_init(size);
    for (int k = 0; k < 2; k++) {
        arb_sub(off, a->z[k], b->z[k], PRECISION);
        arb_get_mag(size, off);
        near &= mag_cmp_2exp_si(size, -133) < 0; /* 1e-40 */
    }
    arb_clear(off);
    mag_clear(size);
    return near;
}

/* Keeps a candidate, the last in the list, unless it is a duplicate: of two in one place the corner's or edge's stays. */
static int keep_candidate(struct search *s)
{
    struct minimum *const c = &s->found->at[s->found->n];
    c->region = s->region;
    for (int i = 0; i < s->found->n; i++)
        if (is_near(c, &s->found->at[i]))
            return 1;
    if (arb_lt(c->square, s->least)) {
        arb_get_ubound_arf(arb_midref(s->least), c->square, PRECISION);
        mag_zero(arb_radref(s->least));
    }
    return ++s->found->n < MINIMA;
}

/* Returns 1 if a point of two parameters, or of one, lies on the closed face or may. */
static int may_hold(const struct search *s, arb_t z[2])
{
    arb_t sum;
    arb_init(sum);
    int may = 1;
    for (int k = 0; k < s->f.parameters; k++) {
        arb_sub_ui(sum, z[k], 1, PRECISION);
        may &= !arb_is_negative(z[k]) && !arb_is_positive(sum);
    }
    arb_add(sum, z[0], z[1], PRECISION);
    arb_sub_ui(sum, sum, 1, PRECISION);
    if (s->triangle && s->f.parameters == 2)
        may &= !arb_is_positive(sum);
    arb_clear(sum);
    return may;
}

static int is_convex(const struct polynomial *f, arb_t z[2])
{
    arb_t jet[JET];
    jet_init(jet);
    polynomial_jet(f, z, jet);
    arb_mul(jet[VALUE], jet[D_SS], jet[D_TT], PRECISION);
    arb_submul(jet[VALUE], jet[D_ST], jet[D_ST], PRECISION);
    const int convex = arb_is_positive(jet[D_SS]) && (f->parameters == 1 || arb_is_positive(jet[VALUE]));
    jet_clear(jet);
    return convex;
}

/* Settles a box.  Returns 1 if f is strictly convex on the box and a little beyond, and its only stationary point there is found, or
 * lies beside the face.  A point on the border of a box is in both.  Returns -1 if there is no room. */
static int settle(struct search *s, const struct box *box)
{
    struct minimum *const c = &s->found->at[s->found->n];
    arb_t jet[JET], whole[2], z[2];
    jet_init(jet);
    for (int k = 0; k < 2; k++)
        arb_init(whole[k]), arb_init(z[k]);
    box_ball(box, s->f.parameters, whole);
    arb_set(z[0], whole[0]);
    arb_set(z[1], whole[1]);
    int done = is_convex(&s->f, whole) && converge(&s->f, z) && enclose(&s->f, z) && arb_contains(whole[0], z[0]) &&
               arb_contains(whole[1], z[1]);
    if (done && may_hold(s, z)) {
        polynomial_jet(&s->f, z, jet);
        arb_set(c->square, jet[VALUE]);
        for (int k = 0; k < 2; k++)
            if (s->f.parameters == 2) {
                arb_set(c->z[k], z[k]);
            } else {
                arb_set(c->z[k], s->start[k]);
                arb_addmul(c->z[k], s->step[k], z[0], PRECISION);
            }
        done = keep_candidate(s) ? 1 : -1;
    }
    jet_clear(jet);
    for (int k = 0; k < 2; k++)
        arb_clear(whole[k]), arb_clear(z[k]);
    return done;
}

/* ---- branch and bound ---- */

enum fate { DROPPED, HALVED, FULL };

static int is_outside(const struct search *s, const struct box *box)
{
    const int deep = box->depth[0] > box->depth[1] ? box->depth[0] : box->depth[1];
    return s->triangle && s->f.parameters == 2 &&
           ((box->at[0] << (deep - box->depth[0])) + (box->at[1] << (deep - box->depth[1]))) >= 1L << deep;
}

/* Decides about a box; along: the parameter in which f varies more on it. */
static enum fate judge_box(struct search *s, const struct box *box, int *along)
{
    const int two = s->f.parameters == 2;
    arb_t d[5], det;
    mag_t size[2];
    enum fate fate = HALVED;
    *along = 0;
    if (is_outside(s, box) || all_above(box, s->f.parameters, s->least))
        return DROPPED;
    arb_init(det);
    mag_init(size[0]);
    mag_init(size[1]);
    for (int k = 0; k < 5; k++)
        arb_init(d[k]);
    slope_range(box, s->f.parameters, 1, 0, d[0]);
    slope_range(box, s->f.parameters, 2, 0, d[2]);
    if (two) {
        slope_range(box, 2, 0, 1, d[1]);
        slope_range(box, 2, 0, 2, d[3]);
        slope_range(box, 2, 1, 1, d[4]);
    }
    arb_get_mag(size[0], d[0]);
    arb_get_mag(size[1], d[1]);
    *along = two && mag_cmp(size[1], size[0]) > 0;
    /* Differences of n = 4 coefficients: d2/ds2 has 4 3, d2/dsdt 4 4. */
    arb_mul(det, d[2], d[3], COARSE);
    arb_mul_ui(det, det, 9, COARSE);
    arb_mul(d[4], d[4], d[4], COARSE);
    arb_mul_ui(d[4], d[4], 16, COARSE);
    arb_sub(det, det, d[4], COARSE);
    if (!arb_contains_zero(d[0]) || (two && !arb_contains_zero(d[1])) || arb_is_negative(d[2]) ||
        (two && (arb_is_negative(d[3]) || arb_is_negative(det)))) {
        fate = DROPPED;
    } else if (arb_is_positive(d[2]) && (!two || arb_is_positive(det))) {
        const int done = settle(s, box);
        fate = done < 0 ? FULL : done ? DROPPED : HALVED;
    }
    arb_clear(det);
    mag_clear(size[0]);
    mag_clear(size[1]);
    for (int k = 0; k < 5; k++)
        arb_clear(d[k]);
    return fate;
}

/* Returns 1 if every box is dropped or done. */
static int search_boxes(struct search *s)
{
    static struct box stack[DEPTH];
    static int ready;
    for (int i = 0; i < DEPTH && !ready; i++)
        box_init(&stack[i]);
    ready = 1;
    for (int i = 0; i < POWERS * POWERS; i++)
        arb_set_round(stack[0].b[i], s->f.b[i], COARSE);
    stack[0].at[0] = stack[0].at[1] = stack[0].depth[0] = stack[0].depth[1] = 0;
    int n = 1, boxes = 0;
    while (n > 0) {
        int along;
        const enum fate fate = judge_box(s, &stack[n - 1], &along);
        if (fate == DROPPED) {
            n--;
            continue;
        }
        if (fate == FULL || n == DEPTH || ++boxes > BOXES || stack[n - 1].depth[along] > 50)
            return 0;
        halve(&stack[n - 1], &stack[n], along, s->f.parameters == 2 ? POWERS : 1);
        n++;
    }
    return 1;
}

static void corner_of(int triangle, int corner, int at[2])
{
    static const int of[2][4][2] = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0, 0}, {1, 0}, {0, 1}, {0, 0}}};
    at[0] = of[triangle][corner][0];
    at[1] = of[triangle][corner][1];
}

/* Evaluates f at some points of the face. */
static void look_around(struct search *s)
{
    arb_t z[2], jet[JET];
    jet_init(jet);
    arb_init(z[0]);
    arb_init(z[1]);
    for (int i = 0; i <= 8; i++)
        for (int j = 0; j <= (s->triangle ? 8 - i : 8); j++) {
            arb_set_si(z[0], i);
            arb_set_si(z[1], j);
            arb_mul_2exp_si(z[0], z[0], -3);
            arb_mul_2exp_si(z[1], z[1], -3);
            polynomial_jet(&s->f, z, jet);
            arb_get_ubound_arf(arb_midref(jet[D_S]), jet[VALUE], PRECISION);
            mag_zero(arb_radref(jet[D_S]));
            if ((i == 0 && j == 0) || arb_lt(jet[D_S], s->least))
                arb_set(s->least, jet[D_S]);
        }
    jet_clear(jet);
    arb_clear(z[0]);
    arb_clear(z[1]);
}

static int search_corners(struct search *s, int corners)
{
    arb_t jet[JET], z[2];
    int room = 1;
    jet_init(jet);
    arb_init(z[0]);
    arb_init(z[1]);
    for (int c = 0; c < corners && room; c++) {
        struct minimum *const m = &s->found->at[s->found->n];
        int at[2];
        corner_of(s->triangle, c, at);
        for (int k = 0; k < 2; k++) {
            arb_set_si(z[k], at[k]);
            arb_set(m->z[k], z[k]);
        }
        polynomial_jet(&s->f, z, jet);
        arb_set(m->square, jet[VALUE]);
        s->region = 1 + corners + c;
        room = keep_candidate(s);
    }
    jet_clear(jet);
    arb_clear(z[0]);
    arb_clear(z[1]);
    return room;
}

static int search_edge(struct search *s, enum query_kind kind, const double *x, int edge)
{
    int from[2], to[2];
    corner_of(s->triangle, edge, from);
    corner_of(s->triangle, (edge + 1) % query_kind_corners[kind], to);
    for (int k = 0; k < 2; k++) {
        arb_set_si(s->start[k], from[k]);
        arb_set_si(s->step[k], to[k] - from[k]);
    }
    s->region = 1 + edge;
    polynomial_of_edge(&s->f, kind, x, edge);
    return search_boxes(s);
}

/* Keeps only the candidates that may be least. */
static void keep_least(struct minima *found)
{
    int kept = 0, best = 0;
    for (int i = 1; i < found->n; i++)
        if (arb_lt(found->at[i].square, found->at[best].square))
            best = i;
    for (int i = 0; i < found->n; i++)
        if (arb_overlaps(found->at[i].square, found->at[best].square)) {
            struct minimum *const a = &found->at[kept], *const b = &found->at[i];
            if (kept == best && kept < i)
                best = i;
            arb_swap(a->z[0], b->z[0]);
            arb_swap(a->z[1], b->z[1]);
            arb_swap(a->square, b->square);
            const int region = a->region;
            a->region = b->region;
            b->region = region;
            if (best == i)
                best = kept;
            kept++;
        }
    found->n = kept;
}

int minima_find(enum query_kind kind, const double *x, struct minima *found)
{
    struct search s = {.triangle = query_kind_corners[kind] == 3, .found = found};
    polynomial_init(&s.f);
    arb_init(s.least);
    for (int k = 0; k < 2; k++)
        arb_init(s.start[k]), arb_init(s.step[k]);
    found->n = 0;
    polynomial_of_face(&s.f, kind, x);
    look_around(&s);
    int all = search_corners(&s, query_kind_corners[kind]);
    for (int edge = 0; edge < query_kind_corners[kind] && all; edge++)
        all = search_edge(&s, kind, x, edge);
    polynomial_of_face(&s.f, kind, x);
    s.region = 0;
    all = all && search_boxes(&s);
    keep_least(found);
    polynomial_clear(&s.f);
    arb_clear(s.least);
    for (int k = 0; k < 2; k++)
        arb_clear(s.start[k]), arb_clear(s.step[k]);
    return all;
}
