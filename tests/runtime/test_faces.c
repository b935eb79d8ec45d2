/* The library's faces of every kind: foot points and derivatives against quadruple precision, closest points against
 * points all over the face, many pairs against single pairs to the bit, and statuses. generated/test_curved.c tests
 * footpoint_face_robust on strongly curved faces. */
#include "../../runtime/footpoint_face.h"
#include "../support/quad_precision.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 50, PAIRS = 70, GRID = 14, C = MOST_COORDINATES };
#define UNTOUCHED 77.25

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

/* Draws a face with nodes moved by up to 0.05, and a slave node above or below a point of the face, or up to a tenth
 * beyond it. */
static void draw(uint64_t *stream, enum footpoint_face face, double *x)
{
    const struct exact_face f = exact_face_of(footpoint_face_nodes(face));
    quadruple y[C], r[3], normal[3];
    const double u = uniform(stream), v = uniform(stream), gap = 0.4 * uniform(stream) - 0.2;
    const int triangle = face <= FOOTPOINT_TRI6;
    const double xi = triangle ? 1.1 * u : 2.2 * u - 1.1, eta = triangle ? (1.1 - 1.1 * u) * v : 2.2 * v - 1.1;
    for (int i = 0; i < 3 * f.nodes; i++) {
        x[i] = 0.1 * (uniform(stream) - 0.5) + (i % 3 < 2 ? f.place[i / 3][i % 3] : 0.0);
        y[i] = x[i];
    }
    exact_point(&f, y, xi, eta, r, normal);
    for (int i = 0; i < 3; i++)
        x[3 * f.nodes + i] = (double)(r[i] + gap * normal[i]);
}

static void expect_near(double a, double b, double within, const char *what, int face)
{
    if (!(fabs(a - b) <= within))
        fail_msg("face %d, %s: %.17g, not %.17g", face, what, a, b);
}

static void foot_points_are_right(void **state)
{
    uint64_t stream = 3;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const struct exact_face f = exact_face_of(footpoint_face_nodes(face));
        for (int sample = 0; sample < SAMPLES; sample++) {
            double x[C], loc[2], gap, phi[MOST_NODES], d_xi[C], d_gap[C], again[C], r[3], n[3];
            static double hessian[C * (C + 1) / 2];
            struct exact_foot foot, moved;
            quadruple y[C];
            draw(&stream, face, x);
            assert_int_equal(footpoint_face_locate(face, x, loc, &gap), FOOTPOINT_OK);
            for (int i = 0; i < C; i++)
                y[i] = i < 3 * f.nodes + 3 ? x[i] : 0.0;
            assert_true(exact_foot_near(&f, y, loc[0], loc[1], &foot));
            expect_near(loc[0], (double)foot.xi, 1e-5, "xi", face);
            expect_near(loc[1], (double)foot.eta, 1e-5, "eta", face);
            expect_near(gap, (double)foot.gap, 1e-9, "gap", face);
            loc[0] = (double)foot.xi;
            loc[1] = (double)foot.eta;
            assert_int_equal(footpoint_face_place(face, x, loc, phi, r, NULL, n, &gap), FOOTPOINT_OK);
            for (int k = 0; k < f.nodes; k++)
                expect_near(phi[k], (double)foot.phi[k], 1e-14, "shape function", face);
            expect_near(r[0] * n[0] + r[1] * n[1] + r[2] * n[2], 0.0, 1e-14, "tangent and normal", face);
            assert_int_equal(
                footpoint_face_differentiate(face, x, loc, NULL, NULL, NULL, NULL, NULL, d_xi, NULL, d_gap),
                FOOTPOINT_OK);
            assert_int_equal(footpoint_face_hessian(face, x, loc, NULL, NULL, NULL, again, NULL, hessian),
                             FOOTPOINT_OK);
            const int c = (int)(uniform(&stream) * (3 * f.nodes + 3));
            expect_near(again[c], d_gap[c], 1e-14, "derivative of the gap, twice", face);
            y[c] += 1e-9;
            assert_true(exact_foot_near(&f, y, foot.xi, foot.eta, &moved));
            expect_near(d_xi[c], (double)((moved.xi - foot.xi) / 1e-9), 1e-7, "derivative of xi", face);
            expect_near(d_gap[c], (double)((moved.gap - foot.gap) / 1e-9), 1e-7, "derivative of the gap", face);
            expect_near(hessian[c * (c + 1) / 2 + c],
                        (double)(((moved.gap - foot.gap) / 1e-9 - (quadruple)d_gap[c]) / 0.5e-9), 1e-4,
                        "second derivative of the gap", face);
        }
    }
}

/* Returns the distance of the slave node from the point (xi, eta) of its face. */
static double distance_to(const struct exact_face *f, const double *x, double xi, double eta)
{
    quadruple y[C], r[3], normal[3];
    double square = 0.0;
    for (int i = 0; i < 3 * f->nodes; i++)
        y[i] = x[i];
    exact_point(f, y, xi, eta, r, normal);
    for (int i = 0; i < 3; i++) {
        const double d = x[3 * f->nodes + i] - (double)r[i];
        square += d * d;
    }
    return sqrt(square);
}

static void nothing_is_closer(void **state)
{
    uint64_t stream = 5;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const struct exact_face f = exact_face_of(footpoint_face_nodes(face));
        const int triangle = face <= FOOTPOINT_TRI6;
        int inside = 0;
        for (int sample = 0; sample < SAMPLES; sample++) {
            double x[C], loc[2], distance, least = HUGE_VAL;
            int region;
            draw(&stream, face, x);
            assert_int_equal(footpoint_face_closest(face, x, loc, &distance, &region), FOOTPOINT_OK);
            expect_near(distance_to(&f, x, loc[0], loc[1]), fabs(distance), 1e-9, "distance", face);
            for (int i = 0; i <= GRID; i++)
                for (int j = 0; j <= (triangle ? GRID - i : GRID); j++) {
                    const double u = (double)i / GRID, v = (double)j / GRID;
                    least = fmin(least, triangle ? distance_to(&f, x, u, v) : distance_to(&f, x, 2 * u - 1, 2 * v - 1));
                }
            assert_true(fabs(distance) <= least + 1e-9 && region >= 0 && region <= 8);
            inside += region == 0;
        }
        assert_true(inside > SAMPLES / 4 && inside < SAMPLES);
    }
}

/* Consecutive faces and slave nodes, each with its own nodes. */
struct mesh {
    double xyz[PAIRS * C];
    int seg[PAIRS * MOST_NODES], slave[PAIRS];
    size_t nodes;
};

static void fill(struct mesh *m, enum footpoint_face face)
{
    uint64_t stream = 9;
    const int nodes = footpoint_face_nodes(face);
    m->nodes = 0;
    for (int i = 0; i < PAIRS; i++) {
        draw(&stream, face, m->xyz + 3 * m->nodes);
        for (int k = 0; k <= nodes; k++, m->nodes++)
            *(k < nodes ? &m->seg[nodes * i + k] : &m->slave[i]) = (int)m->nodes;
    }
}

/* Twice what footpoint_face_locate_pairs promises. */
static double both_promises(enum footpoint_face face)
{
    return face == FOOTPOINT_TRI6 ? 2e-10 : 2e-12;
}

/* Checks equal bits, or a tolerance if compilers fuse operations. */
static void expect_same(const double *a, const double *b, int n)
{
#ifdef __FMA__
    for (int i = 0; i < n; i++)
        assert_true(fabs(a[i] - b[i]) <= 1e-9);
#else
    assert_memory_equal(a, b, (size_t)n * sizeof *a);
#endif
}

static void pairs_are_single_ones(void **state)
{
    static const size_t counts[] = {0, 1, 31, 32, 33, PAIRS};
    static struct mesh m;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const int nodes = footpoint_face_nodes(face);
        double loc[2 * PAIRS], gap[PAIRS], one[2], one_gap;
        int status[PAIRS];
        fill(&m, face);
        for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
            assert_int_equal(
                footpoint_face_locate_pairs(face, counts[c], m.xyz, m.nodes, m.seg, m.slave, loc, gap, status), 0);
            for (size_t i = 0; i < counts[c]; i++) {
                assert_int_equal(status[i], FOOTPOINT_OK);
                assert_int_equal(footpoint_face_locate(face, m.xyz + 3 * m.seg[(size_t)nodes * i], one, &one_gap), 0);
                if (face != FOOTPOINT_TRI3) { /* other steps, the same promise */
                    const double both = both_promises(face);
                    assert_true(fabs(one[0] - loc[2 * i]) <= both * fmax(1, fabs(one[0])));
                    assert_true(fabs(one[1] - loc[2 * i + 1]) <= both * fmax(1, fabs(one[1])));
                    assert_true(fabs(one_gap - gap[i]) <= 1e-12);
                    continue;
                }
                expect_same(one, loc + 2 * i, 2);
                expect_same(&one_gap, gap + i, 1);
            }
        }
        for (size_t i = 0; i < PAIRS; i++)
            loc[2 * i] = gap[i] = UNTOUCHED;
        m.seg[nodes * 3 + 1] = -1;
        m.slave[40] = (int)m.nodes;
        m.xyz[3 * m.seg[nodes * 5] + 2] = (double)NAN;
        for (int k = 0; k < nodes; k++) /* without area */
            m.seg[nodes * 7 + k] = m.seg[nodes * 8];
        assert_int_equal(footpoint_face_locate_pairs(face, PAIRS, m.xyz, m.nodes, m.seg, m.slave, loc, gap, status), 4);
        assert_int_equal(footpoint_face_locate_pairs(face, PAIRS, m.xyz, m.nodes, m.seg, m.slave, loc, gap, NULL), 4);
        for (size_t i = 0; i < PAIRS; i++) {
            assert_int_equal(status[i], i == 3 || i == 40 ? FOOTPOINT_ERR_ARGUMENT
                                        : i == 5          ? FOOTPOINT_ERR_NOT_FINITE
                                        : i == 7          ? FOOTPOINT_ERR_DEGENERATE
                                                          : FOOTPOINT_OK);
            assert_true((gap[i] == UNTOUCHED) == (status[i] < 0) && (loc[2 * i] == UNTOUCHED) == (status[i] < 0));
        }
    }
}

/* Includes distorted faces, far slave nodes and pairs without an answer. */
static void robust_pairs_are_single_ones(void **state)
{
    static const size_t counts[] = {0, 1, 31, 32, 33, PAIRS};
    static struct mesh m;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const int nodes = footpoint_face_nodes(face);
        double loc[2 * PAIRS], distance[PAIRS];
        int region[PAIRS], status[PAIRS];
        fill(&m, face);
        for (size_t k = 0; k < m.nodes; k += 7)
            m.xyz[3 * k + k % 3] += 0.5;
        for (size_t i = 0; i < PAIRS; i += 3)
            m.xyz[3 * (size_t)m.slave[i] + i % 2] += 1.5;
        m.seg[nodes * 3 + 1] = -1;
        m.slave[40] = (int)m.nodes;
        m.xyz[3 * m.seg[nodes * 5] + 2] = (double)NAN;
        for (int k = 0; k < nodes; k++) /* without area */
            m.seg[nodes * 7 + k] = m.seg[nodes * 8];
        for (size_t c = 0; c < sizeof counts / sizeof *counts; c++) {
            size_t bad = 0;
            for (size_t i = 0; i < PAIRS; i++)
                loc[2 * i] = loc[2 * i + 1] = distance[i] = region[i] = -99;
            const size_t failed = footpoint_face_robust_pairs(face, counts[c], m.xyz, m.nodes, m.seg, m.slave, loc,
                                                              distance, region, status);
            for (size_t i = 0; i < counts[c]; i++) {
                double x[C], one[2] = {-99, -99}, d = -99;
                int where = -99, good = i != 3 && i != 40;
                for (int k = 0; good && k <= nodes; k++)
                    memcpy(x + 3 * k, m.xyz + 3 * (k < nodes ? m.seg[(size_t)nodes * i + (size_t)k] : m.slave[i]),
                           3 * sizeof *x);
                assert_int_equal(status[i],
                                 good ? footpoint_face_robust(face, x, one, &d, &where) : FOOTPOINT_ERR_ARGUMENT);
                if (face == FOOTPOINT_TRI3 || face == FOOTPOINT_QUAD4 || !(status[i] >= FOOTPOINT_OK)) {
                    expect_same(one, loc + 2 * i, 2);
                    expect_same(&d, distance + i, 1);
                } else { /* from other foot points */
                    expect_near(loc[2 * i], one[0], both_promises(face), "xi", face);
                    expect_near(loc[2 * i + 1], one[1], both_promises(face), "eta", face);
                    expect_near(distance[i], d, 1e-12, "distance", face);
                }
                assert_int_equal(region[i], where);
                bad += status[i] != FOOTPOINT_OK && status[i] != FOOTPOINT_OUTSIDE;
            }
            assert_int_equal(failed, bad);
        }
        assert_int_equal(
            footpoint_face_robust_pairs(face, 3, m.xyz, m.nodes, m.seg, m.slave, loc, distance, NULL, NULL), 0);
    }
}

/* Starts from answers that are off by up to 0.3, or from NaN, and includes pairs without an answer. */
static void tracked_pairs_are_located_ones(void **state)
{
    static struct mesh m;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const int nodes = footpoint_face_nodes(face);
        double loc[2 * PAIRS], gap[PAIRS], tracked[2 * PAIRS], height[PAIRS];
        int status[PAIRS], again[PAIRS];
        fill(&m, face);
        m.seg[nodes * 3 + 1] = -1;
        m.xyz[3 * m.seg[nodes * 5] + 2] = (double)NAN;
        for (int i = 0; i < PAIRS; i++)
            loc[2 * i] = loc[2 * i + 1] = tracked[2 * i] = tracked[2 * i + 1] = (double)NAN;
        const size_t failed =
            footpoint_face_locate_pairs(face, PAIRS, m.xyz, m.nodes, m.seg, m.slave, loc, gap, status);
        for (int moved = 0; moved < 4; moved++) {
            assert_int_equal(footpoint_track_pairs(face, PAIRS, m.xyz, m.nodes, m.seg, m.slave, tracked, height, again),
                             failed);
            for (int i = 0; i < PAIRS; i++) {
                assert_int_equal(again[i], status[i]);
                for (int k = 0; k < 2 && status[i] == FOOTPOINT_OK; k++) {
                    assert_true(fabs(tracked[2 * i + k] - loc[2 * i + k]) < 4e-10);
                    tracked[2 * i + k] += 0.003 * moved * moved * moved * (i % 7 - 3);
                }
                if (status[i] == FOOTPOINT_OK)
                    assert_true(fabs(height[i] - gap[i]) < 1e-12);
                else
                    assert_true(tracked[2 * i] != tracked[2 * i]); /* untouched */
            }
        }
        double x[C], one[2] = {(double)NAN, 0.0}, d = 0.0;
        for (int k = 0; k <= nodes; k++)
            memcpy(x + 3 * k, m.xyz + 3 * (k < nodes ? m.seg[k] : m.slave[0]), 3 * sizeof *x);
        assert_int_equal(footpoint_track(face, x, one, &d), FOOTPOINT_OK);
        assert_true(fabs(one[0] - loc[0]) < 2e-10 && fabs(one[1] - loc[1]) < 2e-10 && fabs(d - gap[0]) < 1e-12);
    }
}

static void the_nearest_face_is_chosen(void **state)
{
    static struct mesh m;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const int nodes = footpoint_face_nodes(face);
        fill(&m, face);
        for (int i = 0; i < PAIRS; i++) { /* side by side */
            for (int k = 0; k < nodes; k++)
                m.xyz[3 * m.seg[nodes * i + k]] += 0.05 * i;
            m.xyz[3 * m.slave[i]] += 0.05 * i;
        }
        for (int s = 0; s < PAIRS; s++)
            for (size_t n = 0; n <= PAIRS; n += n < 3 ? 1 : 33) {
                const double *const xS = m.xyz + 3 * m.slave[s];
                double loc[2] = {UNTOUCHED, 0}, distance, least = HUGE_VAL;
                size_t chosen = 99;
                int region;
                for (size_t i = 0; i < n; i++) {
                    double x[C], at[2], d;
                    int where;
                    for (int k = 0; k <= nodes; k++)
                        memcpy(x + 3 * k, k < nodes ? m.xyz + 3 * m.seg[(size_t)nodes * i + (size_t)k] : xS,
                               3 * sizeof *x);
                    if (footpoint_face_robust(face, x, at, &d, &where) >= FOOTPOINT_OK)
                        least = fmin(least, fabs(d));
                }
                const int status = footpoint_face_select(face, m.xyz, n, m.seg, xS, &chosen, loc, &distance, &region);
                assert_int_equal(status, n > 0 ? FOOTPOINT_OK : FOOTPOINT_ERR_DOMAIN);
                if (status == FOOTPOINT_OK)
                    expect_near(fabs(distance), least, 1e-12, "least distance", face);
                assert_true(status == FOOTPOINT_OK ? chosen < n : chosen == 99 && loc[0] == UNTOUCHED);
            }
        m.seg[4] = -1;
        double loc[2], distance;
        size_t chosen;
        int region;
        assert_int_equal(footpoint_face_select(face, m.xyz, 3, m.seg, m.xyz, &chosen, loc, &distance, &region),
                         FOOTPOINT_ERR_ARGUMENT);
    }
}

/* ---- with certainty ---- */

static double largest(const double *x, const double *xS, int n)
{
    double most = 0.0;
    for (int i = 0; i < n; i++)
        most = fmax(most, fabs(x[i] - xS[i % 3]));
    return most;
}

/* Faces of any size, with any first corner. */
static void robust_is_closest(void **state)
{
    uint64_t stream = 7;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const int nodes = footpoint_face_nodes(face), corners = face <= FOOTPOINT_TRI6 ? 3 : 4;
        for (int sample = 0; sample < 4 * SAMPLES; sample++) {
            double x[C], y[C], loc[2], at[2], distance, d;
            int region, where;
            draw(&stream, face, x);
            assert_int_equal(footpoint_face_closest(face, x, loc, &distance, &region), FOOTPOINT_OK);
            const int status = footpoint_face_robust(face, x, at, &d, &where);
            assert_int_equal(status, where ? FOOTPOINT_OUTSIDE : FOOTPOINT_OK);
            expect_near(d, distance, 1e-10, "robust", face);
            expect_near(at[0], loc[0], 1e-6, "xi", face);
            expect_near(at[1], loc[1], 1e-6, "eta", face);
            assert_int_equal(where, region);
            for (int exponent = -1000; exponent <= 1000; exponent += 400) {
                for (int i = 0; i < 3 * nodes + 3; i++)
                    y[i] = ldexp(x[i], exponent);
                assert_int_equal(footpoint_face_robust(face, y, loc, &distance, &region), status);
                assert_true(region == where);
                expect_near(ldexp(distance, -exponent), d, 1e-15, "in another unit", face);
            }
            for (int k = 0; k < nodes; k++) /* A takes B's place, and so on */
                memcpy(y + 3 * k,
                       x + 3 * (k < corners       ? (k + 1) % corners
                                : k < 2 * corners ? corners + (k + 1) % corners
                                                  : k),
                       3 * sizeof *y);
            memcpy(y + 3 * nodes, x + 3 * nodes, 3 * sizeof *y);
            assert_int_equal(footpoint_face_robust(face, y, loc, &distance, &region), status);
            expect_near(fabs(distance), fabs(d), 1e-14, "from another corner", face);
            const int turned = where == 0         ? 0
                               : where <= corners ? 1 + (where + corners - 2) % corners
                                                  : corners + 1 + (where - 2) % corners;
            assert_int_equal(region, turned);
        }
    }
}

/* Faces without area or with several closest points, and far slave nodes, have an honest status. */
static void robust_is_sure_or_unproved(void **state)
{
    uint64_t stream = 11;
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const struct exact_face f = exact_face_of(footpoint_face_nodes(face));
        double x[C], loc[2], distance;
        int region;
        for (int flat = 0; flat < 2; flat++) { /* all nodes at a point or on a line; xS 5 away */
            for (int i = 0; i < 3 * f.nodes; i++)
                x[i] = i % 3 < 1 + flat ? 3.0 : 2.0 * (flat ? f.place[i / 3][0] + f.place[i / 3][1] : 0.0) + 1.0;
            x[3 * f.nodes] = 6.0, x[3 * f.nodes + 1] = flat ? 7.0 : 1.0, x[3 * f.nodes + 2] = flat ? 1.0 : 5.0;
            const int status = footpoint_face_robust(face, x, loc, &distance, &region);
            assert_true(status == FOOTPOINT_NO_AREA || (flat && status == FOOTPOINT_UNPROVED));
            expect_near(distance, 5.0, 1e-9, "without area", face);
        }
        for (int line = 0; line < 15; line++) { /* no normal, so no sign */
            for (int i = 0; i <= f.nodes; i++) {
                const double step = 1.6 * uniform(&stream) - 0.8;
                for (int k = 0; k < 3; k++)
                    x[3 * i + k] = i < f.nodes ? step * (k - 1.3) : uniform(&stream) - 0.5;
            }
            const int status = footpoint_face_robust(face, x, loc, &distance, &region);
            assert_true((status == FOOTPOINT_NO_AREA || status == FOOTPOINT_UNPROVED) && distance > 0.0);
        }
        for (double far = 1e3; far < 1e12; far *= 1e3) {
            draw(&stream, face, x);
            for (int i = 0; i < 3; i++)
                x[3 * f.nodes + i] += far * (i - 1.2);
            const int status = footpoint_face_robust(face, x, loc, &distance, &region);
            assert_true(status >= FOOTPOINT_OK && status != FOOTPOINT_UNPROVED);
            assert_true(far > 1e4 || status <= FOOTPOINT_OUTSIDE);
            const double span = largest(x, x + 3 * f.nodes, 3 * f.nodes);
            for (int i = 0; i < f.nodes; i++)
                assert_true(fabs(distance) <= distance_to(&f, x, f.place[i][0], f.place[i][1]) + 1e-10 * span);
            expect_near(distance_to(&f, x, loc[0], loc[1]), fabs(distance), 1e-12 * span, "from afar", face);
        }
    }
    double dome[C], loc[2], distance; /* its corners are equally near to points on the axis far below */
    int region;
    const struct exact_face f = exact_face_of(9);
    for (int i = 0; i < 27; i++)
        dome[i] = i % 3 < 2 ? f.place[i / 3][i % 3]
                            : -0.3 * (f.place[i / 3][0] * f.place[i / 3][0] + f.place[i / 3][1] * f.place[i / 3][1]);
    dome[27] = dome[28] = 0.0, dome[29] = -4.0;
    assert_int_equal(footpoint_face_robust(FOOTPOINT_QUAD9, dome, loc, &distance, &region), FOOTPOINT_NOT_UNIQUE);
    expect_near(distance, -sqrt(2.0 + 3.4 * 3.4), 1e-12, "corners of a dome", FOOTPOINT_QUAD9);
    assert_true(region >= 5);
    dome[29] = -1.0 / 0.6; /* the centre of curvature of its top */
    const int status = footpoint_face_robust(FOOTPOINT_QUAD9, dome, loc, &distance, &region);
    assert_true(status == FOOTPOINT_NOT_UNIQUE || status == FOOTPOINT_OK);
    expect_near(distance, dome[29], 1e-10, "top of a dome", FOOTPOINT_QUAD9);
}

static void statuses(void **state)
{
    double x[C] = {0}, loc[2] = {0, 0}, gap = UNTOUCHED;
    size_t chosen;
    int status = 0, region;
    const int none[2] = {0, 0};
    (void)state;
    for (int face = -1; face <= FOOTPOINT_FACES; face += FOOTPOINT_FACES + 1) {
        const enum footpoint_face no = (enum footpoint_face)face;
        assert_int_equal(footpoint_face_nodes(no), 0);
        assert_int_equal(footpoint_face_locate(no, x, loc, &gap), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_closest(no, x, loc, &gap, &region), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_robust(no, x, loc, &gap, &region), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_select(no, x, 1, none, x, &chosen, loc, &gap, &region), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_place(no, x, loc, NULL, NULL, NULL, NULL, &gap), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_differentiate(no, x, loc, NULL, NULL, NULL, NULL, NULL, x, x, x),
                         FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_hessian(no, x, loc, NULL, NULL, NULL, NULL, NULL, x), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_face_locate_pairs(no, 1, x, 2, none, none, loc, &gap, &status), 1);
        assert_int_equal(status, FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_track(no, x, loc, &gap), FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(footpoint_track_pairs(no, 1, x, 2, none, none, loc, &gap, &status), 1);
        assert_int_equal(footpoint_face_robust_pairs(no, 1, x, 2, none, none, loc, &gap, NULL, &status), 1);
        assert_int_equal(status, FOOTPOINT_ERR_ARGUMENT);
    }
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        uint64_t stream = 1;
        memset(x, 0, sizeof x); /* no area */
        assert_int_equal(footpoint_face_locate(face, x, loc, &gap), FOOTPOINT_ERR_DEGENERATE);
        assert_int_equal(footpoint_face_place(face, x, loc, NULL, NULL, NULL, NULL, &gap), FOOTPOINT_ERR_DEGENERATE);
        assert_int_equal(footpoint_face_hessian(face, x, loc, &gap, NULL, NULL, NULL, NULL, NULL),
                         FOOTPOINT_ERR_DEGENERATE);
        draw(&stream, face, x);
        x[4] = INFINITY;
        assert_int_equal(footpoint_face_locate(face, x, loc, &gap), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_face_closest(face, x, loc, &gap, &region), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_face_robust(face, x, loc, &gap, &region), FOOTPOINT_ERR_NOT_FINITE);
        assert_int_equal(footpoint_face_differentiate(face, x, loc, NULL, NULL, NULL, NULL, &gap, NULL, NULL, NULL),
                         FOOTPOINT_ERR_NOT_FINITE);
    }
    assert_true(gap == UNTOUCHED);
}

/* A slave node a hundred edges beside a plane face still has a foot point in its plane. */
static void far_foot_points_are_found(void **state)
{
    (void)state;
    for (enum footpoint_face face = FOOTPOINT_TRI3; face < FOOTPOINT_FACES; face++) {
        const struct exact_face f = exact_face_of(footpoint_face_nodes(face));
        const double far[3] = {200.0, -140.0, 0.5};
        double x[C] = {0}, loc[2], gap;
        for (int i = 0; i < 3 * f.nodes; i++)
            x[i] = i % 3 < 2 ? f.place[i / 3][i % 3] : 0.0;
        memcpy(x + 3 * f.nodes, far, sizeof far);
        const int status = footpoint_face_locate(face, x, loc, &gap);
        /* rounding may prevent the proof */
        assert_true(status == FOOTPOINT_OK || (f.nodes > 4 && status == FOOTPOINT_UNPROVED));
        expect_near(loc[0], far[0], 1e-6, "xi", face);
        expect_near(loc[1], far[1], 1e-6, "eta", face);
        expect_near(gap, far[2], 1e-6, "gap", face);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(foot_points_are_right),
        cmocka_unit_test(far_foot_points_are_found),
        cmocka_unit_test(nothing_is_closer),
        cmocka_unit_test(pairs_are_single_ones),
        cmocka_unit_test(the_nearest_face_is_chosen),
        cmocka_unit_test(robust_is_closest),
        cmocka_unit_test(robust_is_sure_or_unproved),
        cmocka_unit_test(robust_pairs_are_single_ones),
        cmocka_unit_test(tracked_pairs_are_located_ones),
        cmocka_unit_test(statuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
