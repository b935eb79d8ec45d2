/* Checks second derivatives of projection along a direction, FOOTPOINT_KIND_HESSIAN_ALONG_OF(footpoint_KIND_along),
 * against second differences of three solutions by Newton's method in quadruple precision, and first derivatives
 * against footpoint_KIND_gradients_along. Some hundred lines a kind; FOOTPOINT_LONG=1: 1e5. */
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
#include <string.h>

#include <cmocka.h>

enum { SHORT = 60, LONG = 100000, PACKED = MOST_ALONG * (MOST_ALONG + 1) / 2 };

struct answer {
    double loc[2], dist, d[3][MOST_ALONG], h[3][PACKED];
};

typedef int call(along_vectors x, struct answer *a);

#define KIND(kind, KIND)                                                                                               \
    FOOTPOINT_##KIND##_HESSIAN_ALONG_OF(footpoint_##kind##_along) static int call_##kind(along_vectors x,              \
                                                                                         struct answer *a)             \
    {                                                                                                                  \
        return footpoint_##kind##_along_hessian(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), x[VECTORS_OF_##kind],    \
                                                a->loc, &a->dist, a->d[0], a->d[1], a->d[2], a->h[0], a->h[1],         \
                                                a->h[2]);                                                              \
    }                                                                                                                  \
    static int place_##kind(along_vectors x, struct answer *a)                                                         \
    {                                                                                                                  \
        return footpoint_##kind##_hessian_along(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), x[VECTORS_OF_##kind],    \
                                                a->loc, NULL, NULL, NULL, a->d[2], NULL, a->h[1], NULL);               \
    }                                                                                                                  \
    static int first_##kind(along_vectors x, struct answer *a)                                                         \
    {                                                                                                                  \
        return footpoint_##kind##_gradients_along(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), x[VECTORS_OF_##kind],  \
                                                  a->loc, &a->dist, a->d[0], a->d[1], a->d[2]);                        \
    }
KIND(tri3, TRI3)
KIND(tri6, TRI6)
KIND(quad4, QUAD4)
KIND(quad8, QUAD8)
KIND(quad9, QUAD9)

static const struct kind {
    const char *name;
    int nodes;
    call *joined, *place, *first;
} kind[] = {{"tri3", 3, call_tri3, place_tri3, first_tri3},
            {"tri6", 6, call_tri6, place_tri6, first_tri6},
            {"quad4", 4, call_quad4, place_quad4, first_quad4},
            {"quad8", 8, call_quad8, place_quad8, first_quad8},
            {"quad9", 9, call_quad9, place_quad9, first_quad9}};

enum { KINDS = sizeof kind / sizeof *kind };

/* Compares the second derivative along a random change of all coordinates with the second difference of three
 * solutions. Returns the largest error, over the sum of absolute values. */
static double error_of(uint64_t *stream, const struct kind *k, along_vectors x, const struct answer *a)
{
    const struct exact_face f = exact_face_of(k->nodes);
    const int all = 3 * k->nodes + 6;
    const double step = 1e-10, shorter = along_length(x[k->nodes + 1]), from[3] = {a->loc[0], a->loc[1], a->dist};
    quadruple y[3][MOST_ALONG], at[3][3];
    double by[MOST_ALONG], worst = 0.0;
    for (int i = 0; i < all; i++) {
        by[i] = (2.0 * along_uniform(stream) - 1.0) * (i < all - 3 ? 1.0 : shorter);
        for (int s = 0; s < 3; s++)
            y[s][i] = (quadruple)x[i / 3][i % 3] + (s - 1) * (quadruple)step * by[i];
    }
    for (int s = 0; s < 3; s++)
        along_solve(&f, y[s], from, at[s]);
    for (int j = 0; j < 3; j++) {
        const quadruple bend = (at[0][j] - 2 * at[1][j] + at[2][j]) / ((quadruple)step * step);
        double sum = 0.0, size = 0.0;
        for (int r = 0, e = 0; r < all; r++)
            for (int c = 0; c <= r; c++, e++) {
                sum += a->h[j][e] * by[r] * by[c] * (r == c ? 1.0 : 2.0);
                size += fabs(a->h[j][e] * by[r] * by[c]);
            }
        worst = fmax(worst, fabs(sum - (double)bend) / (size > 0.0 ? size : 1.0));
    }
    return worst;
}

static void first_derivatives_agree(const struct kind *k, along_vectors x, const struct answer *a)
{
    struct answer b = *a;
    if (k->first(x, &b) != FOOTPOINT_OK)
        return; /* by rounding */
    for (int j = 0; j < 3; j++) {
        double size = 0.0;
        for (int i = 0; i < 3 * k->nodes + 6; i++)
            size += fabs(b.d[j][i]);
        for (int i = 0; i < 3 * k->nodes + 6; i++)
            assert_true(fabs(a->d[j][i] - b.d[j][i]) <= 1e-9 * size);
    }
}

static void library_agrees(const struct kind *k, along_vectors x, const struct answer *a)
{
    static const enum footpoint_face face[] = {FOOTPOINT_TRI3, FOOTPOINT_TRI6, FOOTPOINT_QUAD4, FOOTPOINT_QUAD8,
                                               FOOTPOINT_QUAD9};
    static struct answer b;
    const int all = 3 * k->nodes + 6, packed = all * (all + 1) / 2;
    assert_int_equal(footpoint_face_differentiate_along(face[k - kind], x[0], x[k->nodes + 1], a->loc, NULL, b.d[0],
                                                        NULL, NULL, b.h[0], b.h[1], b.h[2]),
                     FOOTPOINT_OK);
    assert_memory_equal(a->d[0], b.d[0], (size_t)all * sizeof(double));
    for (int j = 0; j < 3; j++)
        assert_memory_equal(a->h[j], b.h[j], (size_t)packed * sizeof(double));
}

static int count(void)
{
    return (int)long_cases(SHORT, LONG);
}

/* Judges lines of a family; returns the number of refused lines. */
static int judge(uint64_t stream, double slim, double flat, double allowed)
{
    double worst[KINDS] = {0.0};
    int refused = 0;
    for (int n = 0; n < KINDS * count(); n++) {
        const struct kind *const k = &kind[n % KINDS];
        struct answer a;
        along_vectors x;
        along_draw(&stream, k->nodes, exp(slim * along_uniform(&stream)),
                   flat > 0.0 ? exp(-flat * along_uniform(&stream)) : 0.5 + along_uniform(&stream), x);
        const int status = k->joined(x, &a);
        if (status != FOOTPOINT_OK && status != FOOTPOINT_OUTSIDE) {
            refused++;
            continue;
        }
        const double error = error_of(&stream, k, x, &a);
        worst[n % KINDS] = fmax(worst[n % KINDS], error);
        first_derivatives_agree(k, x, &a);
        library_agrees(k, x, &a);
        if (!(error <= allowed))
            fail_msg("%s: %g", k->name, error);
    }
    for (int i = 0; i < KINDS; i++)
        print_message("# %s: %.1e\n", kind[i].name, worst[i]);
    return refused;
}

static void ordinary_lines_are_right(void **state)
{
    (void)state;
    assert_int_equal(judge(3, 0.0, 0.0, 1e-9), 0);
}

static void hard_lines_are_right_or_refused(void **state)
{
    (void)state;
    assert_in_range(judge(5, 9.0, 7.0, 1e-9), 1, KINDS * count() / 2);
}

/* Checks that another unit of length or of the direction, a power of 2, changes no bit. */
static void units_do_not_matter(void **state)
{
    uint64_t stream = 7;
    (void)state;
    for (int n = 0; n < KINDS * 20; n++) {
        const struct kind *const k = &kind[n % KINDS];
        const int length = n % 3 * 200 - 200, turn = n % 7 * 50 - 150, slave = 3 * k->nodes + 3;
        static struct answer a, b;
        along_vectors x;
        along_draw(&stream, k->nodes, 1.0, 1.0, x);
        if (k->joined(x, &a) < FOOTPOINT_OK)
            continue;
        for (int j = 0; j < k->nodes + 2; j++)
            for (int i = 0; i < 3; i++)
                x[j][i] = ldexp(x[j][i], j <= k->nodes ? length : turn);
        b = a;
        assert_int_equal(k->place(x, &b), FOOTPOINT_OK);
        for (int r = 0, e = 0; r < slave + 3; r++) {
            const int by = r < slave ? length : turn;
            assert_true(b.d[0][r] == a.d[0][r] && ldexp(b.d[2][r], by - length) == a.d[2][r]);
            for (int c = 0; c <= r; c++, e++) {
                assert_true(b.h[0][e] == a.h[0][e] && b.h[2][e] == a.h[2][e]); /* rows that are not wanted */
                assert_true(ldexp(b.h[1][e], by + (c < slave ? length : turn)) == a.h[1][e]);
            }
        }
    }
}

static void statuses(void **state)
{
    (void)state;
    for (int n = 0; n < KINDS; n++) {
        const struct kind *const k = &kind[n];
        uint64_t stream = 9;
        static struct answer a, b;
        along_vectors x;
        along_draw(&stream, k->nodes, 1.0, 1.0, x);
        assert_true(k->joined(x, &a) >= FOOTPOINT_OK);
        b = a;
        double *const along = x[k->nodes + 1];
        along[2] = (double)NAN;
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_NOT_FINITE);
        along[0] = along[1] = along[2] = 0.0;
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_DEGENERATE);
        for (int i = 0; i < 3; i++)
            along[i] = ldexp(x[0][i] - x[1][i] + i, -600); /* second derivatives beyond all numbers */
        assert_int_equal(k->place(x, &a), FOOTPOINT_ERR_NOT_FINITE);
        assert_memory_equal(&a, &b, sizeof a);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ordinary_lines_are_right),
                                       cmocka_unit_test(hard_lines_are_right_or_refused),
                                       cmocka_unit_test(units_do_not_matter), cmocka_unit_test(statuses)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
