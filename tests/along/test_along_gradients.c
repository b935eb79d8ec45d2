/* Checks derivatives of projection along a direction, FOOTPOINT_KIND_GRADIENTS_ALONG_OF(footpoint_KIND_along), against
 * differences of two solutions by Newton's method in quadruple precision. Faces and lines are ordinary, or faces are
 * slim and lines nearly parallel to them. Results with FOOTPOINT_OK must be right to 1e-9 of the row's sum. The
 * library's projections must equal the headers'. Some hundred lines a kind; FOOTPOINT_LONG=1: 1e5. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad8_derivatives.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_quad9_derivatives.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri3_derivatives.h"
#include "../../generated/footpoint_tri6.h"
#include "../../generated/footpoint_tri6_derivatives.h"
#include "../../runtime/footpoint_face.h"
#include "../support/kind_arguments.h"
#include "../support/long_cases.h"
#include "along_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { SHORT = 120, LONG = 100000, LINES = 100 };

struct answer {
    double loc[2], dist, d[3][MOST_ALONG];
};

typedef int call(along_vectors x, struct answer *a);

#define KIND(kind, KIND)                                                                                               \
    FOOTPOINT_##KIND##_GRADIENTS_ALONG_OF(footpoint_##kind##_along) static int call_##kind(along_vectors x,            \
                                                                                           struct answer *a)           \
    {                                                                                                                  \
        return footpoint_##kind##_along_gradients(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), x[VECTORS_OF_##kind],  \
                                                  a->loc, &a->dist, a->d[0], a->d[1], a->d[2]);                        \
    }                                                                                                                  \
    static int place_##kind(along_vectors x, struct answer *a)                                                         \
    {                                                                                                                  \
        return footpoint_##kind##_gradients_along(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), x[VECTORS_OF_##kind],  \
                                                  a->loc, &a->dist, a->d[0], NULL, a->d[2]);                           \
    }
KIND(tri3, TRI3)
KIND(tri6, TRI6)
KIND(quad4, QUAD4)
KIND(quad8, QUAD8)
KIND(quad9, QUAD9)

static const struct kind {
    const char *name;
    int nodes;
    enum footpoint_face face;
    call *joined, *place;
} kind[] = {{"tri3", 3, FOOTPOINT_TRI3, call_tri3, place_tri3},
            {"tri6", 6, FOOTPOINT_TRI6, call_tri6, place_tri6},
            {"quad4", 4, FOOTPOINT_QUAD4, call_quad4, place_quad4},
            {"quad8", 8, FOOTPOINT_QUAD8, call_quad8, place_quad8},
            {"quad9", 9, FOOTPOINT_QUAD9, call_quad9, place_quad9}};

enum { KINDS = sizeof kind / sizeof *kind };

/* Checks that the derivatives along a random change of all coordinates are the differences of two solutions. */
static void judge(uint64_t *stream, const struct kind *k, along_vectors x, const struct answer *a)
{
    const struct exact_face f = exact_face_of(k->nodes);
    const int all = 3 * k->nodes + 6;
    const double step = 1e-12;
    const double shorter = along_length(x[k->nodes + 1]), from[3] = {a->loc[0], a->loc[1], a->dist};
    quadruple y[2][MOST_ALONG], at[2][3];
    double by[MOST_ALONG];
    for (int i = 0; i < all; i++) {
        by[i] = (2.0 * along_uniform(stream) - 1.0) * (i < all - 3 ? 1.0 : shorter);
        for (int s = 0; s < 2; s++)
            y[s][i] = (quadruple)x[i / 3][i % 3] + (s ? -1 : 1) * (quadruple)step * by[i];
    }
    for (int s = 0; s < 2; s++)
        along_solve(&f, y[s], from, at[s]);
    for (int j = 0; j < 3; j++) {
        double sum = 0.0, size = 0.0;
        for (int i = 0; i < all; i++) {
            sum += a->d[j][i] * by[i];
            size += fabs(a->d[j][i]);
        }
        const double truth = (double)((at[0][j] - at[1][j]) / (2 * (quadruple)step));
        if (!(fabs(sum - truth) <= 1e-9 * size))
            fail_msg("%s, row %d: %.17g, not %.17g, of %g", k->name, j, sum, truth, size);
    }
}

/* ---- tests ---- */

static int count(void)
{
    return (int)long_cases(SHORT, LONG);
}

static void ordinary_lines_are_right(void **state)
{
    uint64_t stream = 3;
    (void)state;
    for (int n = 0; n < KINDS * count(); n++) {
        const struct kind *const k = &kind[n % KINDS];
        struct answer a;
        along_vectors x;
        along_draw(&stream, k->nodes, 1.0, 0.5 + along_uniform(&stream), x);
        const int status = k->joined(x, &a);
        assert_true(status == FOOTPOINT_OK || status == 1); /* a point beyond an edge by rounding */
        judge(&stream, k, x, &a);
    }
}

static void hard_lines_are_right_or_refused(void **state)
{
    uint64_t stream = 5;
    int refused = 0;
    (void)state;
    for (int n = 0; n < KINDS * count(); n++) {
        const struct kind *const k = &kind[n % KINDS];
        struct answer a;
        along_vectors x;
        along_draw(&stream, k->nodes, exp(9.0 * along_uniform(&stream)), exp(-7.0 * along_uniform(&stream)), x);
        if (k->joined(x, &a) == FOOTPOINT_OK)
            judge(&stream, k, x, &a);
        else
            refused++;
    }
    assert_true(refused < KINDS * count() / 2);
}

/* Checks that another unit of length or of the direction, a power of 2, changes no bit. */
static void units_do_not_matter(void **state)
{
    uint64_t stream = 7;
    (void)state;
    for (int n = 0; n < KINDS * 20; n++) {
        const struct kind *const k = &kind[n % KINDS];
        const int length = n % 3 * 400 - 400, turn = n % 7 * 100 - 300;
        struct answer a, b;
        along_vectors x;
        along_draw(&stream, k->nodes, 1.0, 1.0, x);
        if (k->joined(x, &a) < FOOTPOINT_OK)
            continue;
        assert_int_equal(k->place(x, &a), FOOTPOINT_OK);
        for (int j = 0; j < k->nodes + 2; j++)
            for (int i = 0; i < 3; i++)
                x[j][i] = ldexp(x[j][i], j <= k->nodes ? length : turn);
        b = a;
        assert_int_equal(k->place(x, &b), FOOTPOINT_OK);
        for (int i = 0; i < 3 * k->nodes + 6; i++) {
            const int slave = i < 3 * k->nodes + 3;
            assert_true(ldexp(b.d[0][i], slave ? length : turn) == a.d[0][i]);
            assert_true(b.d[1][i] == a.d[1][i]); /* a row that is not wanted */
            assert_true(ldexp(b.d[2][i], slave ? 0 : turn - length) == a.d[2][i]);
        }
    }
}

static void statuses(void **state)
{
    (void)state;
    for (int n = 0; n < KINDS; n++) {
        const struct kind *const k = &kind[n];
        uint64_t stream = 9;
        struct answer a;
        along_vectors x;
        along_draw(&stream, k->nodes, 1.0, 1.0, x);
        assert_true(k->joined(x, &a) >= FOOTPOINT_OK);
        double *const along = x[k->nodes + 1];
        along[2] = (double)NAN;
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_NOT_FINITE);
        along[0] = along[1] = along[2] = 0.0;
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_DEGENERATE);
        for (int i = 0; i < 3; i++)
            along[i] = x[1][i] - x[0][i];
        a.loc[0] = k->nodes == 3 || k->nodes == 6 ? 0.5 : 0.0; /* along an edge, there */
        a.loc[1] = k->nodes == 3 || k->nodes == 6 ? 0.0 : -1.0;
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_DEGENERATE);
    }
}

/* Holds lines of a kind, some without an answer, as arrays of a mesh. */
struct lines {
    double xyz[LINES * (MOST_NODES + 1) * 3], along[LINES * 3];
    int seg[LINES * MOST_NODES], slave[LINES];
};

static void draw_lines(const struct kind *k, struct lines *l)
{
    uint64_t stream = 11;
    const int all = k->nodes + 1;
    for (int n = 0; n < LINES; n++) {
        along_vectors x;
        along_draw(&stream, k->nodes, n % 2 ? 1.0 : 1e3, exp(-0.2 * (n % 50)), x);
        x[k->nodes][0] += n % 5 ? 0.0 : 1.0;
        x[k->nodes][1] = n % 17 ? x[k->nodes][1] : (double)NAN;
        memcpy(l->xyz + 3 * all * n, x[0], (size_t)(3 * all) * sizeof **x);
        memcpy(l->along + 3 * n, x[all], sizeof *x);
        for (int i = 0; i < k->nodes; i++)
            l->seg[k->nodes * n + i] = all * n + i;
        l->slave[n] = n == 7 ? -1 : all * n + k->nodes;
    }
}

static void library_matches_headers(void **state)
{
    static struct lines l;
    (void)state;
    for (int j = 0; j < KINDS; j++) {
        const struct kind *const k = &kind[j];
        const int all = k->nodes + 1;
        double loc[2 * LINES], dist[LINES];
        int status[LINES];
        size_t failed = 0;
        draw_lines(k, &l);
        const size_t said = footpoint_face_along_pairs(k->face, LINES, l.xyz, (size_t)(all * LINES), l.seg, l.slave,
                                                       l.along, loc, dist, status);
        for (int n = 0; n < LINES; n++) {
            const double *const x = l.xyz + 3 * all * n;
            double at[2] = {7.0, 7.0}, away = 7.0;
            struct answer a = {{7.0, 7.0}, 7.0, {{0.0}}};
            along_vectors y;
            memcpy(y[0], x, (size_t)(3 * all) * sizeof *x);
            memcpy(y[all], l.along + 3 * n, sizeof *y);
            const int one = footpoint_face_along(k->face, x, l.along + 3 * n, at, &away);
            failed += status[n] != FOOTPOINT_OK;
            assert_int_equal(status[n], n == 7 ? FOOTPOINT_ERR_ARGUMENT : one);
            if (n != 7 && one >= FOOTPOINT_OK)
                assert_true(at[0] == loc[2 * n] && at[1] == loc[2 * n + 1] && away == dist[n]);
            if (k->joined(y, &a) >= FOOTPOINT_OK)
                assert_true(at[0] == a.loc[0] && at[1] == a.loc[1] && fabs(away - a.dist) <= 1e-13 * (1 + fabs(away)));
            if (one >= FOOTPOINT_OK) {
                struct answer b = {{at[0], at[1]}, 7.0, {{0.0}}};
                const int placed = k->place(y, &b);
                assert_int_equal(footpoint_face_differentiate_along(k->face, x, l.along + 3 * n, at, &a.dist, a.d[0],
                                                                    NULL, a.d[2], NULL, NULL, NULL),
                                 placed);
                if (placed == FOOTPOINT_OK)
                    assert_true(a.dist == b.dist && memcmp(a.d[0], b.d[0], sizeof *a.d) == 0 &&
                                memcmp(a.d[2], b.d[2], sizeof *a.d) == 0);
            }
            if (k->nodes == 4) {
                assert_int_equal(footpoint_along(y[0], y[1], y[2], y[3], y[4], y[5], a.loc, &a.dist), one);
                assert_true(one < FOOTPOINT_OK || (at[0] == a.loc[0] && away == a.dist));
            }
        }
        assert_true(failed == said && failed > 0 && failed < LINES);
    }
    assert_int_equal(footpoint_face_along(FOOTPOINT_FACES, l.xyz, l.along, l.xyz, l.xyz), FOOTPOINT_ERR_ARGUMENT);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ordinary_lines_are_right),
                                       cmocka_unit_test(library_matches_headers),
                                       cmocka_unit_test(hard_lines_are_right_or_refused),
                                       cmocka_unit_test(units_do_not_matter), cmocka_unit_test(statuses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
