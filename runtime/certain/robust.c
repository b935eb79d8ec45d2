/* Finds the closest point of a segment, with certainty.  The header's answer is taken if the header proves it.  Otherwise Newton's
 * method leads to a foot point inside, with the proof of certify.c; then the nearest point of the four edges is tried.  Both are
 * tested for a nearer point.  If all of this fails, all candidates are compared with twice the digits: the nearest points of the
 * edges and all stationary points, a list that stationary.c proves complete. */
#include "robust.h"

#include "bilinear.h"
#include "stationary.h"

#include "../../generated/footpoint_quad4.h"

#define ACCURACY 0x1p-36    /* error of m1 xi and m2 eta, over m: suffices for 1e-10 of the edge in space */
#define SAME_POINT 1e-10    /* points this near in space, over m, count as equal */
#define TIE 0x1p-34         /* over m: distances with a smaller difference are equal; below 1e-10 */
#define FLAT 1e-6           /* determinant of a Hessian, over h11 h22: points of its valley are as near */
#define SAME_SQUARE 0x1p-96 /* of squared distances, over these and m^2: rounding of xi and eta may hide it */
#define STEEP 1e-4          /* curvature of the squared distance along an edge: otherwise rounding may move the point */
#define SIZABLE 1e-20       /* |r_xi x r_eta|^2 over m^4: above rounding of nodes on a line */
#define CLEAR 1e-6          /* of squares of areas, lengths and angles: above rounding */
#define NEAR_EDGE (10.0 * FOOTPOINT_QUAD4_ACCURATE_PROMISE)
#define FAR_START 2.0 /* from farther away no foot point is searched */

enum { STEPS = 4, EDGES = 4, MOST = STATIONARY_MOST + EDGES };

struct answer {
    double loc[2], dist;
    int side; /* of the face: 1 or -1 if rounding cannot change it, otherwise 0 */
};

/* The nearest point of an edge. */
struct edge_point {
    double loc[2], d[3], square;
};

/* Moves to a nearby foot point by Newton's method.  Returns 1 if it is proved, lies in the segment, and no point is nearer. */
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
            answer->dist = sqrt(vector_dot(p.d, p.d));
            return 1;
        }
        xi = x;
        eta = y;
    }
    return 0;
}

/* Finds the nearest point of edge k, in the order AB, DC, AD, BC. */
static void nearest_of_edge(const struct bilinear *f, int k, struct edge_point *c)
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
}

/* Returns 1 if a coordinate, at the end `at` of its range, -1 or 1, leads away from xS when it turns back into the segment.  The slope
 * is a . d or b . d, with the rounding error `error`. */
static int leads_away(double at, double slope, double error)
{
    return at <= -1.0 ? slope < -error : at >= 1.0 && slope > error;
}

static int leads_nearer(double at, double slope, double error)
{
    return at <= -1.0 ? slope > error : at >= 1.0 && slope < -error;
}

/* Returns 1 if a point that is nearest on its edge stays nearest because points inside are farther; at a corner either edge
 * suffices. */
static int is_held(const struct bilinear *f, const double loc[2], const struct bilinear_point *p)
{
    const double error = p->error * f->m;
    return (leads_away(loc[0], p->f1, error) || leads_away(loc[1], p->f2, error)) &&
           !leads_nearer(loc[0], p->f1, error) && !leads_nearer(loc[1], p->f2, error);
}

/* Returns 1 or -1 if xS is before or behind the point p by far more than rounding and the margin of the rule for edges. */
static int side_of(const struct bilinear *f, const struct bilinear_point *p)
{
    double normal[3];
    vector_cross(p->a, p->b, normal);
    const double mm = f->m * f->m, nn = vector_dot(normal, normal), dd = vector_dot(p->d, p->d);
    const double ahead = vector_dot(normal, p->d);
    if (!(nn > CLEAR * mm * mm && dd > CLEAR * CLEAR * mm && ahead * ahead > CLEAR * CLEAR * nn * dd))
        return 0;
    return ahead < 0.0 ? -1 : 1;
}

/* Finds the nearest point of the edges.  Returns 1 if the segment has an inside and no point there is nearer. */
static int find_edge(const struct bilinear *f, struct answer *answer)
{
    struct edge_point best, c;
    struct bilinear_point p;
    double normal[3];
    nearest_of_edge(f, 0, &best);
    for (int k = 1; k < EDGES; k++) {
        nearest_of_edge(f, k, &c);
        if (c.square < best.square)
            best = c;
    }
    bilinear_at(f, best.loc[0], best.loc[1], &p);
    if ((fabs(best.loc[0]) < 1.0 && !(p.error <= ACCURACY * p.h11)) ||
        (fabs(best.loc[1]) < 1.0 && !(p.error <= ACCURACY * p.h22)))
        return 0; /* rounding may move it so far along the edge */
    if (!is_held(f, best.loc, &p) || !footpoint_bilinear_is_nearest(f, &p, best.loc[0], best.loc[1], 0.0, STEEP))
        return 0;
    vector_cross(p.a, p.b, normal);
    if (!(vector_dot(normal, normal) > SIZABLE * (f->m * f->m) * (f->m * f->m)) && !footpoint_bilinear_has_area(f))
        return 0;
    answer->loc[0] = best.loc[0];
    answer->loc[1] = best.loc[1];
    answer->dist = sqrt(best.square);
    answer->side = side_of(f, &p);
    return 1;
}

/* A candidate: r is right to `reach`, over m, or stands for several points that near to each other; `least` if it may be a
 * local minimum. */
struct candidate {
    double loc[2], d[3], reach, variation;
    struct twofold square; /* of the distance, which may be less by variation x m if there are several points */
    int edge, least, flat, several;
};

/* Completes the candidate at its loc by (7), (8) and the Hessian with twice the digits, so that only the rounding of loc is left.
 * The candidate is not a local minimum if the distance falls into the segment, or if it is a saddle. */
static void complete(const double *const x[5], const struct bilinear *f, struct candidate *c)
{
    struct bilinear_wide w;
    footpoint_bilinear_wide_at(x, f->exponent, c->loc, &w);
    const struct twofold h11 = twofold_dot(w.a, w.a), h22 = twofold_dot(w.b, w.b);
    const struct twofold h12 = twofold_subtract(twofold_dot(w.a, w.b), twofold_dot(w.c, w.d));
    const double turn = fabs(h12.high), noise = 8.0 * (BILINEAR_UNIT + c->reach);
    for (int i = 0; i < 3; i++)
        c->d[i] = w.d[i].high;
    c->square = twofold_dot(w.d, w.d);
    c->flat = 0;
    if (c->edge) {
        c->least = !leads_nearer(c->loc[0], twofold_dot(w.a, w.d).high, noise * (turn + h11.high)) &&
                   !leads_nearer(c->loc[1], twofold_dot(w.b, w.d).high, noise * (turn + h22.high));
        return;
    }
    const double determinant = twofold_subtract(twofold_multiply(h11, h22), twofold_multiply(h12, h12)).high;
    const double bend = 8.0 * (fabs(twofold_dot(w.a, w.c).high) + fabs(twofold_dot(w.b, w.c).high));
    c->flat = determinant < FLAT * h11.high * h22.high;
    c->least = determinant > -noise * (h11.high * h22.high + turn * turn + bend * (turn + h11.high + h22.high));
}

/* Does the same with twice the digits. */
static void nearest_of_edge_widely(const double *const x[5], const struct bilinear *f, int k, struct candidate *c)
{
    static const int end[][2] = {{0, 1}, {3, 2}, {0, 3}, {1, 2}};
    struct twofold along[3], from[3];
    for (int i = 0; i < 3; i++) {
        along[i] = bilinear_difference(x[end[k][1]][i], x[end[k][0]][i], f->exponent);
        from[i] = bilinear_difference(x[4][i], x[end[k][0]][i], f->exponent);
    }
    const struct twofold square = twofold_dot(along, along);
    const double t = square.high > 0.0 ? twofold_divide(twofold_dot(along, from), square).high : 0.0;
    c->loc[k > 1] = bilinear_clamp(2.0 * t - 1.0);
    c->loc[k <= 1] = k & 1 ? 1.0 : -1.0;
    c->edge = 1;
    c->reach = c->variation = 0.0;
    c->several = 0;
    complete(x, f, c);
}

static int list_all(const double *const x[5], const struct bilinear *f, struct candidate c[])
{
    struct stationary_point point[STATIONARY_MOST];
    for (int k = 0; k < EDGES; k++)
        nearest_of_edge_widely(x, f, k, &c[k]);
    if (!footpoint_bilinear_has_area(f))
        return EDGES; /* the edges cover the line that it is on */
    const int inside = footpoint_bilinear_stationary(x, f, point);
    for (int k = 0; k < inside; k++) {
        struct candidate *const to = &c[EDGES + k];
        to->loc[0] = point[k].z[0];
        to->loc[1] = point[k].z[1];
        to->reach = point[k].reach;
        to->variation = point[k].variation;
        to->several = point[k].several;
        to->edge = 0;
        complete(x, f, to);
    }
    return EDGES + inside;
}

/* Returns the squared distance of b less the squared distance of a. */
static double rise(const struct candidate *a, const struct candidate *b)
{
    return twofold_subtract(b->square, a->square).high;
}

/* Returns 1 if another candidate is a different point and as near. */
static int is_tied(const struct bilinear *f, const struct candidate *best, const struct candidate *c)
{
    double apart[3];
    vector_sub(c->d, best->d, apart);
    const double both = sqrt(best->square.high) + sqrt(c->square.high);
    return c->least && bilinear_largest(apart) > SAME_POINT * f->m && rise(best, c) <= TIE * f->m * both;
}

/* Finds the nearest of all candidates; among those as near it prefers a local minimum. */
static int compare_all(const double *const x[5], const struct bilinear *f, struct answer *answer)
{
    struct candidate c[MOST];
    const int all = list_all(x, f, c);
    int best = 0;
    for (int k = 1; k < all; k++) {
        const double higher = rise(&c[best], &c[k]), same = SAME_SQUARE * (c[best].square.high + f->m * f->m);
        if (higher < -same || (higher <= same && c[k].least > c[best].least) || (higher < 0.0 && c[k].least))
            best = k;
    }
    answer->loc[0] = c[best].loc[0];
    answer->loc[1] = c[best].loc[1];
    answer->dist = sqrt(vector_dot(c[best].d, c[best].d));
    if (!footpoint_bilinear_has_area(f))
        return FOOTPOINT_NO_AREA;
    if (!c[best].least)
        return FOOTPOINT_UNPROVED;
    for (int k = 0; k < all; k++)
        if (bilinear_larger(sqrt(c[k].square.high) - c[k].variation * f->m, 0.0) <
            sqrt(c[best].square.high) - TIE * f->m)
            return FOOTPOINT_UNPROVED;
    for (int k = 0; k < all; k++)
        if (k != best && is_tied(f, &c[best], &c[k]))
            return FOOTPOINT_NOT_UNIQUE;
    if (c[best].reach > SAME_POINT)
        return c[best].several || c[best].flat ? FOOTPOINT_NOT_UNIQUE : FOOTPOINT_UNPROVED; /* of its place */
    return FOOTPOINT_OK;
}

/* Measures the distance to a segment whose corners coincide. */
static int nearest_of_point(const double xA[3], const double xS[3], double loc[2], double *dist)
{
    double d[3];
    vector_sub(xS, xA, d);
    const double most = bilinear_largest(d);
    for (int i = 0; i < 3; i++)
        d[i] = most > 0.0 ? d[i] / most : 0.0;
    const double distance = most * sqrt(vector_dot(d, d));
    if (!isfinite(distance))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = loc[1] = 0.0;
    *dist = distance;
    return FOOTPOINT_NO_AREA;
}

static int is_on_edge(const double loc[2])
{
    return fabs(loc[0]) >= 1.0 || fabs(loc[1]) >= 1.0;
}

/* Returns 1 if xS lies behind the point at loc, by the rule of generated/; scales small segments. */
static int is_behind(const double *const x[5], const struct bilinear *f, const double loc[2])
{
    const double *z[5];
    double y[5][3];
    if (f->exponent == 0)
        return footpoint_detail_quad4_behind(x, loc, is_on_edge(loc), NULL);
    for (int k = 0; k < 5; k++) {
        for (int i = 0; i < 3; i++)
            y[k][i] = ldexp(x[k][i], -f->exponent);
        z[k] = y[k];
    }
    return footpoint_detail_quad4_behind(z, loc, is_on_edge(loc), NULL);
}

static const double middle[2];

/* Finds the closest point if the header proves nothing, from a place near a foot point. */
static int closest_with_certainty(const double *const x[5], const double from[2], double loc[2], double *dist)
{
    struct bilinear f;
    struct answer answer = {.side = 0};
    int status = footpoint_bilinear_of(x[0], x[1], x[2], x[3], x[4], &f);
    if (status == FOOTPOINT_ERR_DEGENERATE)
        return nearest_of_point(x[0], x[4], loc, dist);
    if (status != FOOTPOINT_OK)
        return status;
    if (!find_foot(&f, from[0], from[1], &answer) && !find_edge(&f, &answer))
        status = compare_all(x, &f, &answer);
    if (answer.side < 0 || (answer.side == 0 && status != FOOTPOINT_NO_AREA && is_behind(x, &f, answer.loc)))
        answer.dist = -answer.dist;
    if (f.exponent != 0)
        answer.dist = ldexp(answer.dist, f.exponent);
    if (!isfinite(answer.dist))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = answer.loc[0];
    loc[1] = answer.loc[1];
    *dist = answer.dist;
    return status == FOOTPOINT_OK && is_on_edge(loc) ? FOOTPOINT_OUTSIDE : status;
}

/* Returns 1 if an error within the promise may change on which side of an edge the point is. */
static inline int is_near_edge(const double loc[2])
{
    const double u = fabs(loc[0]), v = fabs(loc[1]);
    return (u > 1.0 - NEAR_EDGE && u < 1.0) || (v > 1.0 - NEAR_EDGE && v < 1.0);
}

/* Returns 1 if products of eight lengths stay in the range of double, so that the header raises no exception. */
static inline int is_of_ordinary_size(const double *const x[5])
{
    double size = 0.0;
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            size += fabs(x[k][i] - x[4][i]);
    return isgreater(size, 1e-30) && isless(size, 1e30);
}

/* Moves a point inside an edge to the nearest point of that edge, to rounding: neighbours that share the edge find the same
 * distance. */
static inline void settle_on_edge(const double *const x[5], double loc[2], double *dist)
{
    const int across = fabs(loc[0]) == 1.0; /* the edge has a constant xi */
    const int from = across ? (loc[0] < 0.0 ? 0 : 1) : (loc[1] < 0.0 ? 0 : 3);
    const int to = across ? (loc[0] < 0.0 ? 3 : 2) : (loc[1] < 0.0 ? 1 : 2);
    double e[3], d[3];
    vector_sub(x[to], x[from], e);
    vector_sub(x[4], x[from], d);
    const double square = vector_dot(e, e);
    if (!(square > 0.0)) /* its ends coincide */
        return;
    const double t = fmin(fmax(vector_dot(e, d) / square, 0.0), 1.0);
    for (int i = 0; i < 3; i++)
        d[i] -= t * e[i];
    loc[across] = 2.0 * t - 1.0;
    *dist = copysign(sqrt(vector_dot(d, d)), *dist);
}

static inline int finish(const double *const x[5], int is_ordinary, const struct robust_start *start, double loc[2],
                         double *dist)
{
    int status;
    if (is_ordinary && start->status == FOOTPOINT_OK && !is_near_edge(start->loc)) {
        loc[0] = start->loc[0];
        loc[1] = start->loc[1];
        *dist = start->distance;
        status = is_on_edge(loc) ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK;
    } else
        status = closest_with_certainty(x, start->status >= FOOTPOINT_OK ? start->loc : middle, loc, dist);
    if (is_ordinary && status == FOOTPOINT_OUTSIDE && (fabs(loc[0]) != 1.0 || fabs(loc[1]) != 1.0))
        settle_on_edge(x, loc, dist);
    return status;
}

int footpoint_robust_from(const double *const x[5], const struct robust_start *start, double loc[2], double *dist)
{
    return finish(x, is_of_ordinary_size(x), start, loc, dist);
}

int footpoint_robust(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *dist)
{
    const double *const x[5] = {xA, xB, xC, xD, xS};
    const int is_ordinary = is_of_ordinary_size(x);
    struct robust_start start = {FOOTPOINT_ERR_DOMAIN, {0.0, 0.0}, 0.0};
    int region;
    if (is_ordinary)
        start.status = footpoint_quad4_accurate_closest(xA, xB, xC, xD, xS, start.loc, &start.distance, &region);
    return finish(x, is_ordinary, &start, loc, dist);
}
