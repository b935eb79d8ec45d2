/* Arrays of _place, _shapes and _hessian are those of calls, for each kind of face; test_place.c judges the calls, and
 * arrays of gradients. */
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../../generated/footpoint_quad8_derivatives.h"
#include "../../generated/footpoint_quad9_derivatives.h"
#include "../../generated/footpoint_tri3_derivatives.h"
#include "../../generated/footpoint_tri6_derivatives.h"
#include "../support/kind_arguments.h"
#include "along_judge.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

enum { ROWS = 40, C = MOST_COORDINATES, MOST_ROWS = 1 + 6 * C + C * (C + 1) / 2 };

/* Rows of N nodes and V vectors, each element at o + s times its number. */
#define ROWS_OF_place(N, V, o, s) o, (o) + (N) * (s), (o) + (N + 3) * (s), (o) + (N + 6) * (s), (o) + (N + 9) * (s)
#define ROWS_OF_shapes(N, V, o, s)                                                                                     \
    o, (o) + (N) * (s), (o) + 2 * (N) * (s), (o) + 3 * (N) * (s), (o) + (3 * (N) + 3) * (s),                           \
        (o) + (3 * (N) + 6) * (s), (o) + (3 * (N) + 9) * (s), (o) + (3 * (N) + 12) * (s)
#define ROWS_OF_hessian(N, V, o, s)                                                                                    \
    o, (o) + (s), (o) + (1 + 3 * (V)) * (s), (o) + (1 + 6 * (V)) * (s), (o) + (1 + 9 * (V)) * (s),                     \
        (o) + (1 + 18 * (V)) * (s)

/* Compares NAME_n with NAME on ROWS pairs of a kind. */
#define CHECK(kind, what, elements)                                                                                    \
    {                                                                                                                  \
        enum { V = VECTORS_OF_##kind };                                                                                \
        draw_rows(V - 1, x, column, xi, eta);                                                                          \
        footpoint_##kind##_##what##_n(ROWS, columns, xi, eta, ROWS_OF_##what((V - 1), V, all, ROWS), status);          \
        for (int p = 0; p < ROWS; p++) {                                                                               \
            const double loc[2] = {xi[p], eta[p]};                                                                     \
            const int called = footpoint_##kind##_##what(NODES_OF_##kind(x[p], x[p][V - 1]), loc,                      \
                                                         ROWS_OF_##what((V - 1), V, one, 1));                          \
            assert_true(called == FOOTPOINT_OK && status[p] == FOOTPOINT_OK);                                          \
            for (int e = 0; e < (elements); e++)                                                                       \
                assert_true(fabs(all[e * ROWS + p] - one[e]) <= 1e-9 * (1 + fabs(one[e])));                            \
        }                                                                                                              \
    }
#define CHECKS(kind)                                                                                                   \
    CHECK(kind, place, V + 9)                                                                                          \
    CHECK(kind, shapes, 3 * V + 12) CHECK(kind, hessian, 1 + 18 * V + 3 * V * (3 * V + 1) / 2)

static void draw_rows(int nodes, along_vectors *x, double (*column)[ROWS], double *xi, double *eta)
{
    uint64_t stream = 21;
    for (int p = 0; p < ROWS; p++) {
        along_draw(&stream, nodes, 1.0, 1.2, x[p]);
        xi[p] = 0.5 * along_uniform(&stream);
        eta[p] = 0.5 * along_uniform(&stream);
        for (int i = 0; i < 3 * (nodes + 1); i++)
            column[i][p] = x[p][i / 3][i % 3];
    }
}

static void arrays_match_calls(void **state)
{
    static along_vectors x[ROWS];
    static double column[C][ROWS], xi[ROWS], eta[ROWS], all[MOST_ROWS * ROWS], one[MOST_ROWS];
    const double *columns[C];
    int status[ROWS];
    (void)state;
    for (int i = 0; i < C; i++)
        columns[i] = column[i];
    CHECKS(tri3)
    CHECKS(tri6)
    CHECKS(quad4)
    CHECKS(quad8)
    CHECKS(quad9)
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(arrays_match_calls)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
