/* The closest point of a segment, with certainty: the iteration-free search; one step of Newton's method with the proof
 * of certify.c; and the test that no other point is nearer.  On ordinary meshes that is all.  Where a foot point is not
 * inside, the nearest point of the four edges is tried, with the same test.  Else all candidates, stationary points and
 * edges, are compared. */
#include "bilinear.h"

#include "../generated/footpoint_quad4.h"

#define ACCURACY 0x1p-36 /* of m1 xi and m2 eta, over m: 1e-10 of the edge in space needs no more */
#define SAME_POINT 1e-10 /* points of space that near, over m, are one */
#define TIE_UNITS 64.0   /* rounding errors by which distances may differ that are equal */
#define CONTENDER 1e-8   /* over m + s: candidates that much farther than the nearest are out of the question */
#define STEEP 1e-4       /* of the distance's square around a point of an edge: else rounding might move that too far */
#define FAR_START 2.0    /* no foot point of the segment is looked for from farther away */

enum { STEPS = 4, EDGES = 4, MOST = BILINEAR_STATIONARY + EDGES };

struct answer {
    double loc[2], dist;
};

/* A candidate and xS - r there. */
struct candidate {
    double loc[2], d[3], square;
    int edge, least, certain; /* whether it is on an edge, may be a local minimum, has a proof */
};

static double signed_length(const double a[3], const double b[3], const double d[3])
{
    double n[3];
    vector_cross(a, b, n);
    const double size = sqrt(vector_dot(d, d));
    return vector_dot(n, d) < 0.0 ? -size : size;
}

/* From near a foot point to it, by Newton's method.  1 if it is proved, lies in the segment, and nothing is nearer. */
static int find_foot(const struct bilinear *f, double xi, double eta, struct answer *answer)
{
    for (int n = 0; n < STEPS; n++) {
        struct bilinear_point p;
        struct bilinear_proof proof;
        if (!(fabs(xi) <= FAR_START && fabs(eta) <= FAR_START))
            return 0;
        const int proved = footpoint_bilinear_prove(f, xi, eta, &p, &proof);
        if (proved < 0)
            return 0;
        const double x = xi + proof.move[0], y = eta + proof.move[1];
        if (proved && proof.radius_after <= ACCURACY * f->m) {
            const double u = bilinear_clamp(x), v = bilinear_clamp(y);
            if (fabs(u - x) * f->m1 > proof.radius_after || fabs(v - y) * f->m2 > proof.radius_after ||
                !footpoint_bilinear_is_nearest(f, &p, xi, eta, proof.radius, 0.0))
                return 0;
            for (int i = 0; i < 3; i++)
                p.d[i] -= p.a[i] * (u - xi) + (p.b[i] + f->c3[i] * (u - xi)) * (v - eta);
            answer->loc[0] = u;
            answer->loc[1] = v;
            answer->dist = signed_length(p.a, p.b, p.d);
            return 1;
        }
        xi = x;
        eta = y;
    }
    return 0;
}

/* The nearest point of edge k, in the order AB, DC, AD, BC. */
static void nearest_of_edge(const struct bilinear *f, int k, struct candidate *c)
{
    const double *const along = k == 0 ? f->ab : k == 1 ? f->dc : k == 2 ? f->ad : f->bc;
    const double *const start = k == 1 ? f->ad : k == 3 ? f->ab : NULL;
    double from[3];
    for (int i = 0; i < 3; i++)
        from[i] = start ? f->as[i] - start[i] : f->as[i];
    const double square = vector_dot(along, along), product = vector_dot(along, from);
    const double t = product <= 0.0 || !(square > 0.0) ? 0.0 : product >= square ? 1.0 : product / square;
    for (int i = 0; i < 3; i++)
        c->d[i] = from[i] - t * along[i];
    c->square = vector_dot(c->d, c->d);
    c->loc[k > 1] = 2.0 * t - 1.0;
    c->loc[k <= 1] = k & 1 ? 1.0 : -1.0;
    c->edge = 1;
}

/* At the end `at` of its range, -1 or 1, a coordinate leads away from xS if it turns back into the segment: the slope
 * is a . d or b . d, beyond which rounding is `error`. */
static int leads_away(double at, double slope, double error)
{
    return at <= -1.0 ? slope < -error : at >= 1.0 && slope > error;
}

static int leads_nearer(double at, double slope, double error)
{
    return at <= -1.0 ? slope > error : at >= 1.0 && slope < -error;
}

/* A point that is nearest on its edge stays so if inside lies what is farther; at a corner one of two will do. */
static int is_held(const struct bilinear *f, const double loc[2], const struct bilinear_point *p)
{
    const double error = p->error * f->m;
    return (leads_away(loc[0], p->f1, error) || leads_away(loc[1], p->f2, error)) &&
           !leads_nearer(loc[0], p->f1, error) && !leads_nearer(loc[1], p->f2, error);
}

/* The nearest point of the edges.  1 if nothing inside is nearer. */
static int find_edge(const struct bilinear *f, struct answer *answer)
{
    struct candidate best, c;
    struct bilinear_point p;
    nearest_of_edge(f, 0, &best);
    for (int k = 1; k < EDGES; k++) {
        nearest_of_edge(f, k, &c);
        if (c.square < best.square)
            best = c;
    }
    bilinear_at(f, best.loc[0], best.loc[1], &p);
    if (!is_held(f, best.loc, &p) || !footpoint_bilinear_is_nearest(f, &p, best.loc[0], best.loc[1], 0.0, STEEP))
        return 0;
    answer->loc[0] = best.loc[0];
    answer->loc[1] = best.loc[1];
    answer->dist = signed_length(p.a, p.b, best.d);
    return 1;
}

static void set_inside(const struct bilinear *f, const double loc[2], struct candidate *c)
{
    struct bilinear_point p;
    c->loc[0] = bilinear_clamp(loc[0]);
    c->loc[1] = bilinear_clamp(loc[1]);
    bilinear_at(f, c->loc[0], c->loc[1], &p);
    for (int i = 0; i < 3; i++)
        c->d[i] = p.d[i];
    c->square = vector_dot(p.d, p.d);
    c->edge = 0;
}

/* A stationary point, refined; one that is a saddle for certain is no local minimum. */
static void complete_inside(const double *const x[5], const struct bilinear *f, struct candidate *c)
{
    struct bilinear_point p;
    double radius;
    c->certain = footpoint_bilinear_refine(x, f, c->loc, &radius);
    set_inside(f, c->loc, c);
    bilinear_at(f, c->loc[0], c->loc[1], &p);
    c->least = p.h11 * p.h22 - p.h12 * p.h12 > -4.0 * p.error * (p.h11 + p.h22 + fabs(p.h12));
}

/* A point of an edge that is not held there has to be a foot point. */
static void complete_edge(const double *const x[5], const struct bilinear *f, struct candidate *c)
{
    struct bilinear_point p;
    double z[2] = {c->loc[0], c->loc[1]}, radius;
    bilinear_at(f, c->loc[0], c->loc[1], &p);
    const double error = p.error * f->m;
    c->certain = is_held(f, c->loc, &p) ||
                 (footpoint_bilinear_refine(x, f, z, &radius) && fabs(z[0] - c->loc[0]) * f->m1 <= ACCURACY * f->m &&
                  fabs(z[1] - c->loc[1]) * f->m2 <= ACCURACY * f->m);
    c->least = !leads_nearer(c->loc[0], p.f1, error) && !leads_nearer(c->loc[1], p.f2, error);
}

static int is_nearer(const struct candidate *c, const struct candidate *than)
{
    return c->least != than->least ? c->least : c->square < than->square;
}

/* Nearest of all candidates. */
static int compare_all(const double *const x[5], const struct bilinear *f, struct answer *answer)
{
    struct candidate c[MOST];
    double loc[BILINEAR_STATIONARY][2];
    const int inside = footpoint_bilinear_stationary(f, loc), all = inside + EDGES;
    double nearest = HUGE_VAL;
    int best = 0;
    for (int k = 0; k < all; k++) {
        if (k < inside)
            set_inside(f, loc[k], &c[k]);
        else
            nearest_of_edge(f, k - inside, &c[k]);
        nearest = c[k].square < nearest ? c[k].square : nearest;
    }
    for (int k = 0; k < all; k++) {
        if (sqrt(c[k].square) > sqrt(nearest) + CONTENDER * (f->m + f->s))
            c[k].least = c[k].certain = 0;
        else if (k < inside)
            complete_inside(x, f, &c[k]);
        else
            complete_edge(x, f, &c[k]);
        best = is_nearer(&c[k], &c[best]) ? k : best;
    }
    struct bilinear_point p;
    bilinear_at(f, c[best].loc[0], c[best].loc[1], &p);
    answer->loc[0] = c[best].loc[0];
    answer->loc[1] = c[best].loc[1];
    answer->dist = signed_length(p.a, p.b, c[best].d);
    if (!footpoint_bilinear_has_area(f)) {
        answer->dist = fabs(answer->dist);
        return FOOTPOINT_ERR_DEGENERATE;
    }
    const double least = sqrt(c[best].square), tie = TIE_UNITS * BILINEAR_UNIT * (f->s + f->m);
    for (int k = 0; k < all; k++) {
        double apart[3];
        vector_sub(c[k].d, c[best].d, apart);
        if (c[k].least && bilinear_largest(apart) > SAME_POINT * f->m && sqrt(c[k].square) <= least + tie)
            return FOOTPOINT_NOT_UNIQUE;
        if (c[k].certain && bilinear_largest(apart) <= SAME_POINT * f->m)
            c[best].certain = 1;
    }
    return !c[best].certain || !c[best].least ? FOOTPOINT_NOT_UNIQUE : c[best].edge ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
}

/* All corners are one. */
static int nearest_of_point(const double xA[3], const double xS[3], double loc[2], double *dist)
{
    double d[3], most = 0.0;
    for (int i = 0; i < 3; i++) {
        d[i] = 0.5 * xS[i] - 0.5 * xA[i];
        most = bilinear_larger(most, fabs(d[i]));
    }
    if (most > 0.25 * DBL_MAX)
        return FOOTPOINT_ERR_DOMAIN;
    for (int i = 0; i < 3; i++)
        d[i] = most > 0.0 ? d[i] / most : 0.0;
    loc[0] = loc[1] = 0.0;
    *dist = 2.0 * most * sqrt(vector_dot(d, d));
    return FOOTPOINT_ERR_DEGENERATE;
}

int footpoint_robust(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *dist)
{
    const double *const x[5] = {xA, xB, xC, xD, xS};
    struct bilinear f;
    struct answer answer;
    int status = footpoint_bilinear_of(xA, xB, xC, xD, xS, &f);
    if (status == FOOTPOINT_ERR_DEGENERATE)
        return nearest_of_point(xA, xS, loc, dist);
    if (status != FOOTPOINT_OK)
        return status;
    double xi = 0.0, eta = 0.0;
    if (f.exponent == 0)
        footpoint_quad4_precise_at(xA, xB, xC, xD, xS, &xi, &eta);
    if (!find_foot(&f, xi, eta, &answer))
        status = find_edge(&f, &answer) ? FOOTPOINT_OUTSIDE : compare_all(x, &f, &answer);
    if (f.exponent != 0)
        answer.dist = ldexp(answer.dist, f.exponent);
    if (!isfinite(answer.dist))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = answer.loc[0];
    loc[1] = answer.loc[1];
    *dist = answer.dist;
    return status;
}
