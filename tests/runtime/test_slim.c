/* Slim, needle, flat and touched faces of every kind up to an aspect of 1e6, near the origin and 1e6 edges away from
 * it: footpoint_face_robust against a separate search by subdivision in long double. If all control points of a part
 * lie beyond a plane, so does the part, and none of its points is nearer than the plane. */
#include "../../evolve/common/stream.h"
#include "../../runtime/certain/quadratic.h"
#include "../../runtime/footpoint_face.h"
#include "../support/long_cases.h"

#include <float.h>
#include <gsl/gsl_randist.h>
#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

typedef long double real;

enum { SAMPLES = 20, SAMPLES_LONG = 2500, SEED = 20133, MOST_NODES = 9, PARTS = 280, MOST_PATCHES = 10000 };
enum shape { SLIM, SLIM_BENT, SLIM_MOVED, NEEDLE, SHEARED, OBTUSE, COLLAPSED, NEARLY_COLLAPSED, LINE, POINT, SHAPES };
enum place { FREE, TOUCHED, PLACES };

static const char *const shape_name[SHAPES] = {"slim",   "slim and bent", "slim, nodes moved", "needle",    "sheared",
                                               "obtuse", "collapsed",     "nearly collapsed",  "on a line", "a point"};

struct question {
    enum footpoint_face face;
    int nodes, corners;
    double x[3 * MOST_NODES + 3], span;
    enum shape shape;
    int on_a_line;
};

/* ---- the reference ---- */

/* A patch of degree 2: the control points r - xS of a square, or of a triangle: A, B, C, then between A and B, and so
 * on. */
struct patch {
    real p[9][3];
    int count;
};

/* Computes the point by shape functions of corners and mid-sides, by the degree of the face in each direction. */
static void point_at(const struct question *q, real a, real b, real r[3])
{
    const real u = a, v = b, w = 1 - u - v;
    const real l[3] = {w, u, v}, p[3] = {(1 - 2 * a) * (1 - a), 4 * a * (1 - a), a * (2 * a - 1)},
               s[3] = {(1 - 2 * b) * (1 - b), 4 * b * (1 - b), b * (2 * b - 1)};
    static const int at[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    real phi[9];
    for (int n = 0; n < q->nodes; n++) {
        const real c = at[n][0] ? a : 1 - a, d = at[n][1] ? b : 1 - b;
        if (q->nodes == 3)
            phi[n] = l[n];
        else if (q->nodes == 6)
            phi[n] = n < 3 ? l[n] * (2 * l[n] - 1) : 4 * l[n - 3] * l[(n - 2) % 3];
        else if (q->nodes == 4)
            phi[n] = c * d;
        else
            phi[n] = p[at[n][0]] * s[at[n][1]];
    }
    if (q->nodes == 8) { /* nine nodes, the last in the middle of the others */
        const real middle = p[1] * s[1];
        for (int n = 0; n < 8; n++)
            phi[n] += middle * (n < 4 ? -0.25L : 0.5L);
    }
    for (int k = 0; k < 3; k++) {
        r[k] = 0;
        for (int n = 0; n < q->nodes; n++)
            r[k] += phi[n] * ((real)q->x[3 * n + k] - q->x[3 * q->nodes + k]);
    }
}

/* Computes the middle control point of a parabola from its values. */
static void control(const real *low, real *middle, const real *high)
{
    for (int k = 0; k < 3; k++)
        middle[k] = 2 * middle[k] - (low[k] + high[k]) / 2;
}

static void patch_of(const struct question *q, struct patch *n)
{
    static const int at[6][2] = {{0, 0}, {2, 0}, {0, 2}, {1, 0}, {1, 1}, {0, 1}};
    n->count = q->corners == 3 ? 6 : 9;
    for (int i = 0; i < n->count; i++)
        if (q->corners == 3)
            point_at(q, at[i][0] / 2.0L, at[i][1] / 2.0L, n->p[i]);
        else
            point_at(q, i / 3 / 2.0L, i % 3 / 2.0L, n->p[i]);
    for (int i = 0; i < 3; i++)
        if (q->corners == 3)
            control(n->p[i], n->p[3 + i], n->p[(i + 1) % 3]);
        else
            control(n->p[3 * i], n->p[3 * i + 1], n->p[3 * i + 2]);
    for (int j = 0; j < 3 && q->corners == 4; j++)
        control(n->p[j], n->p[3 + j], n->p[6 + j]);
}

static real dot(const real a[3], const real b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

struct nearest {
    real best, slack, point[3];
    long patches;
};

static void look_at(struct nearest *s, const real r[3])
{
    const real d = sqrtl(dot(r, r));
    if (d < s->best) {
        s->best = d;
        memcpy(s->point, r, sizeof s->point);
    }
}

/* Computes a point of the patch in its middle. */
static void middle_of(const struct patch *n, real m[3])
{
    static const real square[9] = {1, 2, 1, 2, 4, 2, 1, 2, 1}, triangle[6] = {1, 1, 1, 2, 2, 2};
    for (int k = 0; k < 3; k++) {
        m[k] = 0;
        for (int i = 0; i < n->count; i++)
            m[k] += (n->count == 9 ? square[i] / 16 : triangle[i] / 9) * n->p[i][k];
    }
}

/* Returns the distance of the farthest plane, across the direction of the middle or of the nearest control point,
 * beyond which all control points lie. */
static real lower_bound(const struct patch *n, const real middle[3])
{
    real bound = 0;
    const real *nearest = n->p[0];
    for (int i = 1; i < n->count; i++)
        if (dot(n->p[i], n->p[i]) < dot(nearest, nearest))
            nearest = n->p[i];
    for (int t = 0; t < 2; t++) {
        const real *const g = t ? nearest : middle, length = sqrtl(dot(g, g));
        real least = HUGE_VALL;
        for (int i = 0; i < n->count && length > 0; i++)
            least = fminl(least, dot(g, n->p[i]) / length);
        bound = length > 0 ? fmaxl(bound, least) : bound;
    }
    return bound;
}

static void mean(const real a[3], const real b[3], real c[3])
{
    for (int k = 0; k < 3; k++)
        c[k] = (a[k] + b[k]) / 2;
}

/* Splits the parabola of control points i, j, k of n into two halves. */
static void halve_row(const struct patch *n, int i, int j, int k, struct patch half[2])
{
    memcpy(half[0].p[i], n->p[i], sizeof n->p[i]);
    memcpy(half[1].p[k], n->p[k], sizeof n->p[k]);
    mean(n->p[i], n->p[j], half[0].p[j]);
    mean(n->p[j], n->p[k], half[1].p[j]);
    mean(half[0].p[j], half[1].p[j], half[0].p[k]);
    memcpy(half[1].p[i], half[0].p[k], sizeof n->p[i]);
}

/* Halves a triangle at the middle of the edge that starts at corner `a`. */
static void halve_triangle(const struct patch *n, int a, struct patch half[2])
{
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    half[0] = half[1] = *n;
    halve_row(n, a, 3 + a, b, half);
    mean(n->p[3 + b], n->p[3 + c], half[0].p[3 + b]);
    memcpy(half[1].p[3 + c], half[0].p[3 + b], sizeof n->p[0]);
}

static real apart(const real a[3], const real b[3])
{
    const real d[3] = {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
    return sqrtl(dot(d, d));
}

static real length_of(const struct patch *n, int i, int j, int k)
{
    return apart(n->p[i], n->p[j]) + apart(n->p[j], n->p[k]);
}

/* Halves a patch across the longest row of control points. */
static void halve(const struct patch *n, struct patch half[2])
{
    real longest[3] = {0, 0, 0};
    half[0].count = half[1].count = n->count;
    for (int i = 0; i < 3; i++)
        if (n->count == 6)
            longest[i] = length_of(n, i, 3 + i, (i + 1) % 3);
        else {
            longest[0] = fmaxl(longest[0], length_of(n, 3 * i, 3 * i + 1, 3 * i + 2));
            longest[1] = fmaxl(longest[1], length_of(n, i, 3 + i, 6 + i));
        }
    const int most = longest[1] > longest[0] ? 1 + (longest[2] > longest[1]) : 2 * (longest[2] > longest[0]);
    if (n->count == 6) {
        halve_triangle(n, most, half);
        return;
    }
    for (int i = 0; i < 3; i++)
        halve_row(n, most ? i : 3 * i, most ? 3 + i : 3 * i + 1, most ? 6 + i : 3 * i + 2, half);
}

static void search_patch(struct nearest *s, const struct patch *n)
{
    static const int corner[4] = {0, 2, 6, 8};
    struct patch half[2];
    real middle[2][3], bound[2];
    if (++s->patches > MOST_PATCHES)
        return;
    halve(n, half);
    for (int h = 0; h < 2; h++) {
        middle_of(&half[h], middle[h]);
        look_at(s, middle[h]);
        for (int i = 0; i < n->count / 2; i++)
            look_at(s, half[h].p[n->count == 6 ? i : corner[i]]);
        bound[h] = lower_bound(&half[h], middle[h]);
    }
    const int first = dot(middle[1], middle[1]) < dot(middle[0], middle[0]);
    for (int h = 0; h < 2; h++)
        if (bound[h ^ first] < s->best - s->slack)
            search_patch(s, &half[h ^ first]);
}

/* Brings a patch whose control points are on a line, to rounding, and a point of it to their places along the line.
 *   @return the distance of the line */
static real straighten(struct patch *n, real r[3])
{
    real e[3] = {0, 0, 0}, d[3], longest = 0, away[3];
    for (int i = 1; i < n->count; i++)
        if (apart(n->p[i], n->p[0]) > longest) {
            longest = apart(n->p[i], n->p[0]);
            for (int k = 0; k < 3; k++)
                e[k] = (n->p[i][k] - n->p[0][k]) / longest;
        }
    const real along = dot(r, e);
    for (int k = 0; k < 3; k++)
        away[k] = r[k] - along * e[k];
    for (int i = 0; i <= n->count; i++) {
        real *const p = i < n->count ? n->p[i] : r;
        memcpy(d, p, sizeof d);
        p[0] = dot(d, e), p[1] = p[2] = 0;
    }
    return sqrtl(dot(away, away));
}

/* ---- faces ---- */

static double flat(gsl_rng *r, double most)
{
    return gsl_ran_flat(r, -most, most);
}

static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
static const double three[6][2] = {{-1, -1}, {1, -1}, {-1, 1}, {0, -1}, {0, 0}, {-1, 0}};

/* Draws nodes in the unit square, then makes the face slim by `thin`. */
static void draw_shape(enum shape shape, gsl_rng *r, struct question *q)
{
    const double thin = pow(10, gsl_ran_flat(r, -6, 0));
    const double move = shape == SLIM_MOVED ? 0.1 : 0, bend = shape == SLIM ? 0 : 0.1, twist = flat(r, bend);
    const double round[2] = {flat(r, bend), flat(r, bend)}, turn = gsl_ran_flat(r, 0, 7);
    for (int n = 0; n < q->nodes; n++) {
        const double *const p = q->corners == 3 ? three[n] : square[n];
        double *const x = q->x + 3 * n, u = 0.5 * p[0], v = 0.5 * p[1];
        if (shape == OBTUSE)
            u += 0.5 * (v + 0.5);
        x[0] = u + flat(r, move);
        x[1] = v + flat(r, move);
        x[2] = round[0] * u * u + twist * u * v + round[1] * v * v + flat(r, 0.5 * move);
        if (shape == SLIM || shape == SLIM_BENT || shape == SLIM_MOVED || shape == OBTUSE) {
            x[1] *= thin;
            x[2] = x[2] * (shape == SLIM_BENT ? 1 : thin) + (shape == SLIM_BENT ? 0.2 * x[0] * x[0] - x[2] : 0);
        } else if (shape == NEEDLE || shape == NEARLY_COLLAPSED || shape == COLLAPSED)
            x[1] *= shape == COLLAPSED ? 0.5 - u : 0.5 - u + thin * (0.5 + u);
        else if (shape == SHEARED)
            x[0] += x[1] / thin;
        if (shape == NEEDLE)
            x[1] *= 10 * thin, x[2] *= thin;
        if (shape == LINE)
            x[1] = cos(turn) * x[0], x[2] = sin(turn) * x[0];
        if (shape == POINT)
            x[0] = x[1] = x[2] = 0;
    }
    if (shape == SHEARED)
        for (int i = 0; i < 3 * q->nodes; i++)
            q->x[i] *= thin;
}

static void draw_place(enum place place, gsl_rng *r, struct question *q)
{
    double *const s = q->x + 3 * q->nodes;
    const double near = pow(10, gsl_ran_flat(r, -9, 0));
    const int at = (int)gsl_rng_uniform_int(r, 4);
    s[0] = s[1] = s[2] = 0;
    if (place == FREE) {
        for (int k = 0; k < 3; k++)
            s[k] = flat(r, 2);
        return;
    }
    real p[3], a = gsl_rng_uniform(r), b = gsl_rng_uniform(r);
    if (at == 1)
        b = 0;
    if (q->corners == 3)
        a *= 1 - b;
    point_at(q, a, b, p);
    for (int k = 0; k < 3; k++)
        s[k] = at == 0 ? q->x[k] : at < 3 ? (double)p[k] : (double)p[k] + flat(r, near);
}

static void turn(gsl_rng *r, struct question *q)
{
    double t[3][3], away[3];
    for (int i = 0; i < 2; i++)
        gsl_ran_dir_3d(r, &t[i][0], &t[i][1], &t[i][2]);
    for (int k = 0; k < 3; k++)
        t[2][k] = t[0][(k + 1) % 3] * t[1][(k + 2) % 3] - t[0][(k + 2) % 3] * t[1][(k + 1) % 3];
    const double length = sqrt(t[2][0] * t[2][0] + t[2][1] * t[2][1] + t[2][2] * t[2][2]);
    for (int k = 0; k < 3; k++)
        t[2][k] /= length;
    for (int k = 0; k < 3; k++)
        t[1][k] = t[2][(k + 1) % 3] * t[0][(k + 2) % 3] - t[2][(k + 2) % 3] * t[0][(k + 1) % 3];
    const int far = (int)gsl_rng_uniform_int(r, 3) == 0;
    for (int k = 0; k < 3; k++)
        away[k] = far ? flat(r, 1e6) : 0;
    for (int n = 0; n <= q->nodes; n++) {
        const double y[3] = {q->x[3 * n], q->x[3 * n + 1], q->x[3 * n + 2]};
        for (int k = 0; k < 3; k++)
            q->x[3 * n + k] = t[0][k] * y[0] + t[1][k] * y[1] + t[2][k] * y[2] + away[k];
    }
}

static void draw(enum shape shape, enum place place, gsl_rng *r, struct question *q)
{
    q->nodes = footpoint_face_nodes(q->face);
    q->corners = q->face <= FOOTPOINT_TRI6 ? 3 : 4;
    draw_shape(shape, r, q);
    draw_place(place, r, q);
    turn(r, q);
    q->shape = shape;
    q->on_a_line = shape == LINE;
    q->span = DBL_MIN;
    for (int i = 0; i < 3 * q->nodes; i++)
        q->span = fmax(q->span, fabs(q->x[i] - q->x[3 * q->nodes + i % 3]));
}

/* ---- answers ---- */

struct tally {
    long all, status[FOOTPOINT_STATUS_MOST + 1], wrong, unknown, slow;
    double longer;
};

/* Returns the number of parts that the search visits: about 280 take 50 times as long as an ordinary call. */
static int parts_of(const struct question *q)
{
    const double middle = q->corners == 3 ? 1.0 / 3 : 0;
    double start[2] = {middle, middle}, loc[2], distance;
    int left = INT_MAX;
    if (q->nodes <= 4)
        return 0;
    (void)footpoint_face_locate(q->face, q->x, start, &distance);
    (void)footpoint_quadratic_closest(q->nodes, q->x, start, loc, &distance, &left);
    return INT_MAX - left;
}

/* Checks that the distance is that of loc, that no point is nearer beyond the promise, and that the status fits loc's
 * region. */
static void ask(const struct question *q, struct tally *t)
{
    struct patch n;
    struct nearest s = {HUGE_VALL, 1e-11L * q->span, {0}, 0};
    double loc[2], distance;
    real r[3];
    int region;
    const int status = footpoint_face_robust(q->face, q->x, loc, &distance, &region);
    assert_in_range(status, 0, FOOTPOINT_STATUS_MOST);
    t->all++;
    t->status[status]++;
    t->slow += parts_of(q) > PARTS;
    patch_of(q, &n);
    if (q->corners == 3)
        point_at(q, loc[0], loc[1], r);
    else
        point_at(q, (1 + (real)loc[0]) / 2, (1 + (real)loc[1]) / 2, r);
    const real off = fabsl(sqrtl(dot(r, r)) - fabs(distance)), aside = q->on_a_line ? straighten(&n, r) : 0;
    look_at(&s, r);
    search_patch(&s, &n);
    if (s.patches > MOST_PATCHES) {
        t->unknown++;
        return;
    }
    const double longer = (double)((fabs(distance) - hypotl(s.best, aside)) / q->span);
    if (status != FOOTPOINT_UNPROVED)
        t->longer = fmax(t->longer, longer);
    const int sure = status <= FOOTPOINT_OUTSIDE;
    if ((status == FOOTPOINT_UNPROVED || longer < 1e-10) && off <= 1e-15L * q->span &&
        (!sure || ((status == FOOTPOINT_OUTSIDE) == (region > 0) && apart(r, s.point) < 1e-4L * q->span)) &&
        (status == FOOTPOINT_NO_AREA) >= (q->shape == LINE || q->shape == POINT))
        return;
    if (t->wrong++ < 5) {
        printf("# %s, status %d, loc %.17g %.17g, distance %.17g, least %.17Lg\n", shape_name[q->shape], status, loc[0],
               loc[1], distance, hypotl(s.best, aside));
        for (int i = 0; i <= q->nodes; i++)
            printf("#   %a %a %a\n", q->x[3 * i], q->x[3 * i + 1], q->x[3 * i + 2]);
    }
}

static void slim_faces(void **state)
{
    gsl_rng *const r = stream_new();
    const int count = (int)long_cases(SAMPLES, SAMPLES_LONG);
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        struct tally t = {0};
        for (int family = 0; family < SHAPES * PLACES; family++)
            for (int i = 0; i < count; i++) {
                struct question q = {.face = face};
                stream_key(r, SEED, (uint64_t)face, (uint64_t)family, (uint64_t)i);
                draw((enum shape)(family / PLACES), (enum place)(family % PLACES), r, &q);
                ask(&q, &t);
            }
        printf("# %d nodes: %ld inside, %ld outside, %ld not unique, %ld without area, %ld unproved; %ld wrong, %ld "
               "slow, %ld "
               "not known; longer by %.1e\n",
               footpoint_face_nodes(face), t.status[FOOTPOINT_OK], t.status[FOOTPOINT_OUTSIDE],
               t.status[FOOTPOINT_NOT_UNIQUE], t.status[FOOTPOINT_NO_AREA], t.status[FOOTPOINT_UNPROVED], t.wrong,
               t.slow, t.unknown, t.longer);
        assert_true(t.wrong == 0 && t.unknown <= t.all / 20);
        assert_true(10000 * t.status[FOOTPOINT_UNPROVED] <= t.all);
        assert_true(t.slow <= 2 + t.all / 1000); /* 5 in 10,000 of tri6, so 2 of a share of 1,500 are likely */
        assert_true(200 * t.status[FOOTPOINT_NOT_UNIQUE] <= t.all);
        if (face == FOOTPOINT_TRI3)
            assert_true(t.status[FOOTPOINT_UNPROVED] == 0 && t.status[FOOTPOINT_NOT_UNIQUE] == 0 && t.longer < 1e-15);
    }
    gsl_rng_free(r);
}

/* If corners C and D coincide, or B and C of a triangle, several (xi,eta) are one point in space. */
static void collapsed_corners_are_one_point(void **state)
{
    gsl_rng *const r = stream_new();
    const int count = (int)long_cases(100, 5000);
    (void)state;
    stream_key(r, SEED, 99, 0, 0);
    for (enum footpoint_face face = FOOTPOINT_QUAD8; face <= FOOTPOINT_QUAD9; face++)
        for (int i = 0; i < count; i++) {
            struct question q = {.face = face, .nodes = footpoint_face_nodes(face), .corners = 4};
            double loc[2], distance, above = gsl_ran_flat(r, 0.01, 1);
            int region;
            for (int n = 0; n < q.nodes; n++) {
                const double u = 0.5 * square[n][0], v = 0.5 + 0.5 * square[n][1];
                q.x[3 * n] = u * (1 - v);
                q.x[3 * n + 1] = v;
                q.x[3 * n + 2] = -0.2 * v * v;
            }
            q.x[3 * q.nodes] = 0;
            q.x[3 * q.nodes + 1] = 1 + above;
            q.x[3 * q.nodes + 2] = -0.2 + flat(r, 0.3) * above;
            const double *const s = q.x + 3 * q.nodes, d[2] = {s[1] - 1, s[2] + 0.2};
            assert_int_equal(footpoint_face_robust(face, q.x, loc, &distance, &region), FOOTPOINT_OUTSIDE);
            assert_true(region == 3 || region >= 7);
            assert_true(fabs(fabs(distance) - hypot(d[0], d[1])) < 1e-10);
        }
    gsl_rng_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(slim_faces),
        cmocka_unit_test(collapsed_corners_are_one_point),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
