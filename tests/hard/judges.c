/* Judges functions with certain answers; see judges.h. */
#include "judges.h"

#include "../../runtime/footpoint.h"

#include <math.h>

#define ERROR 1e-10       /* permitted error of footpoint_robust in space, over the longest edge */
#define ROUNDING 1e-14    /* of a distance */
#define LEAST 0x1p-1074   /* the same if it is a denormal number */
#define FARTHEST 1e11     /* longest edges up to which an answer is required */
#define DEGENERATE 1e-5   /* least eigenvalue of a Hessian, over its diagonal, that counts as 0 */
#define INSIDE (1 - 1e-9) /* a stationary point inside this range must be found ... */
#define APART 1e-7        /* ... if no other is as near, in xi and eta ... */
#define REGULAR 1e-10     /* ... and if the determinant of its Hessian exceeds this, over its terms */
#define SETTLED 1e-9      /* permitted distance of a listed point from a stationary point, in space or in xi and eta */
#define CLEAR 1e-4        /* points so far apart, and so regular, must be separated */

#define NODES(h) (h)->x[0], (h)->x[1], (h)->x[2], (h)->x[3], (h)->x[4]
#define UNTOUCHED 7

static void blame(struct tally *a, long *what, const char *why)
{
    a->why = why;
    (*what)++;
}

static void count_status(struct tally *a, int status)
{
    a->calls++;
    a->answered += status == FOOTPOINT_OK;
    a->outside += status == FOOTPOINT_OUTSIDE;
    a->not_unique += status == FOOTPOINT_NOT_UNIQUE;
    a->unproved += status == FOOTPOINT_UNPROVED || status == FOOTPOINT_ERR_UNPROVED;
    a->refused += (status < FOOTPOINT_OK && status != FOOTPOINT_ERR_UNPROVED) || status == FOOTPOINT_NO_AREA;
}

/* ---- footpoint_robust ---- */

/* Returns the difference of the distances of q and p. */
static double rise(const struct truth_surface *f, wide p_square, wide q_square)
{
    const double both = verdict_root(p_square) + verdict_root(q_square);
    (void)f;
    return both > 0 ? (double)(q_square - p_square) / both : 0;
}

/* Returns 1 if there are several closest points, or one whose place depends on rounding. */
static int is_ambiguous(const struct truth *t)
{
    const double tie = ERROR * t->surface.edge;
    for (int k = 1; k < t->count; k++)
        if (rise(&t->surface, t->point[0].square, t->point[k].square) <= tie &&
            truth_between(&t->surface, t->point[0].z, t->point[k].z) > 0.1 * ERROR)
            return 1;
    return !t->all || t->point[0].least < DEGENERATE * (1 + t->surface.distance);
}

/* Returns the tied closest point at z, or NULL. */
static const struct truth_point *find_point(const struct truth *t, const wide z[2], double *error)
{
    const double near = ERROR * t->surface.edge;
    *error = INFINITY;
    for (int k = 0; k < t->count && rise(&t->surface, t->point[0].square, t->point[k].square) <= near; k++) {
        const double away = truth_between(&t->surface, z, t->point[k].z);
        *error = fmin(*error, away);
        if (away <= near)
            return &t->point[k];
    }
    return NULL;
}

/* Computes n = r_xi x r_eta at z; returns |r_xi|^2 |r_eta|^2. */
static wide normal_at(const struct truth_surface *f, const wide z[2], wide n[3])
{
    wide a[3], b[3], aa = 0, bb = 0;
    for (int k = 0; k < 3; k++) {
        a[k] = f->c1[k] + z[1] * f->c3[k];
        b[k] = f->c2[k] + z[0] * f->c3[k];
        aa += a[k] * a[k];
        bb += b[k] * b[k];
    }
    for (int k = 0; k < 3; k++)
        n[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
    return aa * bb;
}

static wide product(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns (xS - r) . n at z, over the product of the lengths of its terms; 0 if the normal is not clear.  If |r_xi x r_eta| is less
 * than 1/1024 of its value 1/1024 of the way to the middle, n is the normal there. */
static double side_of(const struct truth_surface *f, const wide z[2])
{
    const wide inwards[2] = {z[0] * 1023 / 1024, z[1] * 1023 / 1024};
    wide d[3], n[3], m[3];
    truth_offset(f, z, d);
    const wide spread = normal_at(f, z, n), nn = product(n, n), dd = product(d, d);
    (void)normal_at(f, inwards, m);
    const wide ratio = nn * 1024 * 1024 / product(m, m);
    if (!(nn > (wide)1e-12 * spread && nn > (wide)1e-24 &&
          dd > (wide)1e-18)) /* rounding of loc determines the normal */
        return 0;
    if (ratio > (wide)0.99 && ratio < (wide)1.01)
        return 0;
    const wide *const normal = ratio < 1 ? m : n;
    const double side = (double)product(normal, d) / sqrt((double)product(normal, normal)) / sqrt((double)dd);
    return fabs(side) > 1e-5 ? side : 0;
}

/* Judges an answer with the status OK or OUTSIDE. */
static void judge_point(const struct truth *t, int status, const double loc[2], double dist, struct tally *a)
{
    const wide z[2] = {loc[0], loc[1]};
    double error;
    const struct truth_point *const p = find_point(t, z, &error);
    if (!p) {
        blame(a, &a->wrong, "the point is not the closest one");
        a->worst = fmax(a->worst, error);
        return;
    }
    a->worst = fmax(a->worst, error);
    if (side_of(&t->surface, z) * dist < 0)
        blame(a, &a->wrong, "the sign of the distance");
    if (status == FOOTPOINT_OUTSIDE && fabs(loc[0]) < 1 && fabs(loc[1]) < 1)
        blame(a, &a->wrong_status, "outside, with a point that is not on the edge");
    if (status == FOOTPOINT_OK && p->on_edge) {
        wide g[2];
        truth_gradient(&t->surface, p->z, g);
        if (fabs((double)g[0]) + fabs((double)g[1]) > 1e-9 * (1 + t->surface.distance))
            blame(a, &a->wrong_status, "no foot point");
    }
}

void judge_robust(const struct hard_case *h, struct truth *t, struct tally *a)
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, dist = UNTOUCHED, error;
    const int status = footpoint_robust(NODES(h), loc, &dist);
    count_status(a, status);
    if (status < FOOTPOINT_OK) {
        if (status != FOOTPOINT_ERR_DOMAIN || t->surface.distance < FARTHEST)
            blame(a, &a->wrong_status, "refused");
        if (loc[0] != UNTOUCHED || loc[1] != UNTOUCHED || dist != UNTOUCHED)
            blame(a, &a->wrong_status, "written in spite of the status");
        return;
    }
    if (!(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1 && isfinite(dist))) {
        blame(a, &a->wrong, "not in the segment");
        return;
    }
    if (t->count == 0) {
        if (status != FOOTPOINT_NO_AREA)
            blame(a, &a->wrong_status, "a single point that is not degenerate");
        return;
    }
    const wide z[2] = {loc[0], loc[1]};
    if (!find_point(t, z, &error))
        truth_add(t, loc);
    const struct truth_surface *const f = &t->surface;
    const double true_dist = verdict_root(t->point[0].square), near = ERROR * f->edge + ROUNDING * true_dist;
    if (!(fabs(fabs(dist) - true_dist * f->scale) <= near * f->scale + LEAST) ||
        !(rise(f, t->point[0].square, truth_square(f, z)) <= near)) {
        a->worst = fmax(a->worst, fabs(fabs(dist) / f->scale - true_dist));
        blame(a, &a->wrong, "the distance");
        return;
    }
    if (status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE)
        judge_point(t, status, loc, dist, a);
    if (status == FOOTPOINT_NOT_UNIQUE && !is_ambiguous(t))
        blame(a, &a->wrong_status, "unique");
    if (status == FOOTPOINT_NO_AREA && truth_has_area(h))
        blame(a, &a->wrong_status, "not degenerate");
}

/* ---- footpoint_stationary ---- */

static double apart(const long double p[2], const long double q[2])
{
    return fmax((double)fabsl(p[0] - q[0]), (double)fabsl(p[1] - q[1]));
}

/* Returns the distance, in xi and eta, of root k from any other root and from undecided boxes. */
static double separation(const struct boxes_list *list, int k)
{
    double least = INFINITY;
    for (int i = 0; i < list->roots; i++)
        if (i != k)
            least = fmin(least, apart(list->root[i], list->root[k]));
    for (int i = 0; i < list->leaves; i++)
        least = fmin(least, apart(list->leaf[i], list->root[k]) < 1e-4 ? 0 : INFINITY);
    return least;
}

/* Returns the distance from root to the nearest point of a list, in space. */
static double nearest_of(const struct truth *t, const long double root[2], double loc[][2], int count)
{
    double least = INFINITY;
    for (int i = 0; i < count; i++) {
        const wide z[2] = {loc[i][0], loc[i][1]}, y[2] = {root[0], root[1]};
        const long double at[2] = {loc[i][0], loc[i][1]};
        least = fmin(least, fmin(apart(at, root), truth_between(&t->surface, z, y)));
    }
    return least;
}

static int is_stationary(const struct truth *t, double loc[2])
{
    const long double at[2] = {loc[0], loc[1]};
    const wide y[2] = {loc[0], loc[1]};
    wide z[2], g[2];
    double m1 = 0, m2 = 0;
    for (int k = 0; k < t->list.roots; k++)
        if (apart(t->list.root[k], at) < SETTLED)
            return 1;
    if (truth_stationary(&t->surface, loc, z) &&
        (fmax(fabs((double)z[0] - loc[0]), fabs((double)z[1] - loc[1])) < SETTLED ||
         truth_between(&t->surface, z, y) < SETTLED))
        return 1;
    truth_gradient(&t->surface, y, g);
    for (int k = 0; k < 3; k++) {
        m1 = fmax(m1, fabs((double)t->surface.c1[k]) + fabs((double)t->surface.c3[k]));
        m2 = fmax(m2, fabs((double)t->surface.c2[k]) + fabs((double)t->surface.c3[k]));
    }
    return fabs((double)g[0]) <= 1e-12 * m1 * (1 + t->surface.distance) &&
           fabs((double)g[1]) <= 1e-12 * m2 * (1 + t->surface.distance);
}

/* Returns 1 if no edge is short and no two neighbouring edges are nearly parallel. */
static int is_clear(const struct hard_case *h)
{
    double e[4][3], length[4], most = 0;
    for (int i = 0; i < 4; i++) {
        for (int k = 0; k < 3; k++)
            e[i][k] = h->x[(i + 1) % 4][k] - h->x[i][k];
        length[i] = sqrt(e[i][0] * e[i][0] + e[i][1] * e[i][1] + e[i][2] * e[i][2]);
        most = fmax(most, length[i]);
    }
    for (int i = 0; i < 4; i++) {
        const double *const a = e[i], *const b = e[(i + 1) % 4];
        double normal = 0;
        for (int k = 0; k < 3; k++)
            normal = fmax(normal, fabs(a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]));
        if (!(length[i] > CLEAR * most && normal > CLEAR * length[i] * length[(i + 1) % 4]))
            return 0;
    }
    return 1;
}

void judge_stationary(const struct hard_case *h, const struct truth *t, struct tally *a)
{
    double loc[FOOTPOINT_STATIONARY_MOST][2];
    const struct boxes_list *const list = &t->list;
    int count = -1, clear = 1;
    const int status = footpoint_stationary(NODES(h), loc, &count);
    count_status(a, status);
    if (status == FOOTPOINT_ERR_DEGENERATE && t->count > 0 && truth_has_area(h))
        blame(a, &a->wrong_status, "not degenerate");
    if (status == FOOTPOINT_ERR_DOMAIN && t->surface.distance < FARTHEST)
        blame(a, &a->wrong_status, "refused");
    if (status != FOOTPOINT_OK && status != FOOTPOINT_NOT_UNIQUE)
        return;
    if (count < 0 || count > FOOTPOINT_STATIONARY_MOST) {
        blame(a, &a->wrong, "the number of points");
        return;
    }
    for (int i = 0; i < count; i++)
        if (!(fabs(loc[i][0]) <= 1 && fabs(loc[i][1]) <= 1))
            blame(a, &a->wrong, "a point outside");
        else if (status == FOOTPOINT_OK && !is_stationary(t, loc[i]))
            blame(a, &a->wrong, "a point that is not stationary");
    for (int k = 0; k < list->roots; k++) {
        const double away = separation(list, k), regular = boxes_regularity(&t->segment, list->root[k]);
        clear = clear && away > CLEAR && regular > CLEAR;
        if (status != FOOTPOINT_OK || !list->complete || !(away > APART && regular > REGULAR) || !truth_has_area(h) ||
            fmax(fabs((double)list->root[k][0]), fabs((double)list->root[k][1])) > INSIDE)
            continue;
        const double error = nearest_of(t, list->root[k], loc, count);
        a->worst = fmax(a->worst, error);
        if (!(error <= SETTLED))
            blame(a, &a->wrong, "a point is missing");
    }
    if (status == FOOTPOINT_NOT_UNIQUE && list->complete && list->leaves == 0 && clear && is_clear(h))
        blame(a, &a->wrong_status, "all points are clear");
}

/* ---- footpoint_locate, footpoint_certify ---- */

void judge_locate(const struct hard_case *h, const struct truth *t, struct tally *a)
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED;
    const int status = footpoint_locate(NODES(h), loc, &gap);
    count_status(a, status);
    if (status != FOOTPOINT_OK) {
        if (loc[0] != UNTOUCHED || loc[1] != UNTOUCHED || gap != UNTOUCHED)
            blame(a, &a->wrong_status, "written in spite of the status");
        return;
    }
    if (!isfinite(loc[0]) || !isfinite(loc[1]) || !isfinite(gap)) {
        blame(a, &a->wrong, "not finite");
        return;
    }
    if (t->count == 0)
        return;
    const double error = verdict_free(t, loc, BANNER_WORST);
    a->worst = fmax(a->worst, error);
    if (!(error <= BANNER_WORST))
        blame(a, &a->wrong, "no foot point, or not the closest");
}

static uint64_t scramble(uint64_t z)
{
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    return (z ^ z >> 27) * 0x94d049bb133111ebu;
}

/* Returns 1 if exactly one stationary point lies within rho of loc; some cases also start from the corners of that box. */
static int is_true(const struct truth_surface *f, const double loc[2], const double rho[2], int corners,
                   double *tightest)
{
    wide z[2], y[2];
    if (!truth_stationary(f, loc, z))
        return 0;
    const double off = fmax(fabs((double)(z[0] - loc[0])) / rho[0], fabs((double)(z[1] - loc[1])) / rho[1]);
    *tightest = fmax(*tightest, off);
    for (int k = 0; k < corners; k++) {
        const double from[2] = {loc[0] + (k & 1 ? rho[0] : -rho[0]), loc[1] + (k & 2 ? rho[1] : -rho[1])};
        if (!truth_stationary(f, from, y))
            continue;
        const int same = fabs((double)(y[0] - z[0])) < 1e-15 && fabs((double)(y[1] - z[1])) < 1e-15;
        const int within = fabs((double)(y[0] - loc[0])) < rho[0] && fabs((double)(y[1] - loc[1])) < rho[1];
        if (within && !same)
            return 0;
    }
    return off <= 1;
}

void judge_certify(const struct hard_case *h, uint64_t key, struct tally *a)
{
    struct truth_surface f;
    double loc[2] = {0, 0}, dist, rho[2];
    if (footpoint_locate(NODES(h), loc, &dist) != FOOTPOINT_OK &&
        footpoint_robust(NODES(h), loc, &dist) == FOOTPOINT_ERR_DOMAIN)
        return;
    const double off = key & 1 ? 0 : pow(10, -16 * ((double)(scramble(key) >> 11) * 0x1p-53));
    loc[0] += off * ((double)(scramble(key + 1) >> 11) * 0x1p-52 - 1);
    loc[1] += off * ((double)(scramble(key + 2) >> 11) * 0x1p-52 - 1);
    const int status = footpoint_certify(NODES(h), loc, rho);
    count_status(a, status);
    if (status != FOOTPOINT_OK)
        return;
    if (!truth_surface_of(h, &f) || !is_true(&f, loc, rho, key % 8 ? 0 : 4, &a->worst))
        blame(a, &a->wrong, "a certificate");
}

void judge_not_finite(const struct hard_case *h, struct tally *robust, struct tally *stationary, struct tally *locate)
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, dist = UNTOUCHED, list[FOOTPOINT_STATIONARY_MOST][2];
    int count = UNTOUCHED;
    const int status[3] = {footpoint_robust(NODES(h), loc, &dist), footpoint_stationary(NODES(h), list, &count),
                           footpoint_locate(NODES(h), loc, &dist)};
    struct tally *const all[3] = {robust, stationary, locate};
    for (int k = 0; k < 3; k++) {
        count_status(all[k], status[k]);
        if (status[k] != FOOTPOINT_ERR_NOT_FINITE)
            blame(all[k], &all[k]->wrong_status, "numbers that are not finite");
    }
    if (loc[0] != UNTOUCHED || loc[1] != UNTOUCHED || dist != UNTOUCHED || count != UNTOUCHED)
        blame(robust, &robust->wrong_status, "written in spite of the status");
}
