/* The promise of functions of four-node faces. With FOOTPOINT_OK a minimum of the distance lies within NAME_PROMISE of
 * xi and eta, on ordinary faces, on the families of hard cases and on faces swept by moving edges, in calls and in
 * arrays; some of each, many with FOOTPOINT_LONG. Functions that stay on the closed face promise the same of a minimum
 * at its border with FOOTPOINT_OUTSIDE. The judge takes Newton's steps in quadruple precision and shares no code with
 * the judged functions. */
#include "../../runtime/footpoint.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../support/long_cases.h"
#include "../support/ordinary_quad.h"
#include "header_functions.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#ifdef __SSE__
#include <xmmintrin.h>
#endif

__extension__ typedef __float128 wide;

enum {
    CASES = 100,
    CASES_LONG = 20000,
    STEPS = 60,
    SWEPT_LEAST = 80,
    LATTICE_LEAST = 99,
    ORDINARY_LEAST = 99,
    PAIRS = 499,
    ROUNDS_LONG = 100
};

/* Returns true if answers stay on the closed face: the scene assumes an order of its corners. */
static bool is_kept(const struct header_function *f)
{
    return strcmp(f->scene, "paper-quad4") == 0 || strcmp(f->scene, "whole-quad4") == 0;
}

static long cases(const struct header_function *f)
{
    return long_cases(is_kept(f) ? CASES / 5 : CASES, CASES_LONG);
}

static double size_of(wide x)
{
    return fabs((double)x);
}

/* Draws a face spanned by an edge and its position after a step, of another length than the step; the slave node lies
 * beside the first. */
static void draw_swept(uint64_t *stream, struct hard_case *h)
{
    const double step = draw_power(stream, -2, 0);
    for (int i = 0; i < 3; i++) {
        h->x[0][i] = draw_flat(stream, -1, 1);
        h->x[1][i] = draw_flat(stream, -1, 1);
        h->x[3][i] = h->x[0][i] + step * draw_flat(stream, -1, 1);
        h->x[2][i] = h->x[1][i] + step * draw_flat(stream, -1, 1);
    }
    const double along = draw_flat(stream, 0, 1);
    for (int i = 0; i < 3; i++)
        h->x[4][i] = h->x[0][i] + along * (h->x[1][i] - h->x[0][i]) + step * draw_flat(stream, -1, 1);
}

static void draw_ordinary(uint64_t *stream, struct hard_case *h)
{
    const struct quad q = quad_draw(&quad_ordinary, draw_next(stream));
    memcpy(h->x, q.x, sizeof q.x);
    memcpy(h->x[4], q.xs, sizeof q.xs);
}

/* Draws a face of the paper's lattice, strongly distorted, with the foot point inside. */
static void draw_lattice(uint64_t *stream, struct hard_case *h)
{
    const double z[2] = {draw_flat(stream, -0.95, 0), draw_flat(stream, -0.95, 0)},
                 height = draw_flat(stream, -0.2, 0.2);
    double u[3], v[3], n[3], nn = 0;
    memset(h->x, 0, sizeof h->x);
    h->x[1][0] = 1;
    for (int i = 0; i < 3; i++) {
        h->x[2][i] = i < 2 ? draw_flat(stream, i ? 0.2 : -2, 2) : draw_flat(stream, -0.3, 0.3);
        h->x[3][i] = i < 2 ? draw_flat(stream, i ? 0.2 : -1, 1) : 0;
    }
    for (int i = 0; i < 3; i++) {
        const double A = h->x[0][i], B = h->x[1][i], C = h->x[2][i], D = h->x[3][i];
        u[i] = (1 - z[1]) * (B - A) + (1 + z[1]) * (C - D);
        v[i] = (1 - z[0]) * (D - A) + (1 + z[0]) * (C - B);
        h->x[4][i] =
            ((1 - z[1]) * ((1 - z[0]) * A + (1 + z[0]) * B) + (1 + z[1]) * ((1 - z[0]) * D + (1 + z[0]) * C)) / 4;
    }
    for (int i = 0; i < 3; i++) {
        n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
        nn += n[i] * n[i];
    }
    for (int i = 0; i < 3; i++)
        h->x[4][i] += height * n[i] / sqrt(nn);
}

/* ---- the judge ---- */

/* Computes slopes and Hessian of half the squared distance at z. */
static void slopes(const struct hard_case *h, const wide z[2], wide g[2], wide H[3])
{
    g[0] = g[1] = H[0] = H[1] = H[2] = 0;
    for (int i = 0; i < 3; i++) {
        const wide A = h->x[0][i], B = h->x[1][i], C = h->x[2][i], D = h->x[3][i], S = h->x[4][i];
        const wide c = (A - B + C - D) / 4, u = (B - A + C - D) / 4 + z[1] * c, v = (D - A + C - B) / 4 + z[0] * c;
        const wide d = S - (A + B + C + D) / 4 - z[0] * (u - z[1] * c) - z[1] * v;
        g[0] += u * d;
        g[1] += v * d;
        H[0] += u * u;
        H[1] += u * v - c * d;
        H[2] += v * v;
    }
}

/* Takes Newton's steps from z until they converge; returns true if they end at a minimum. */
static bool minimum_near(const struct hard_case *h, wide z[2])
{
    for (int k = 0; k < STEPS; k++) {
        wide g[2], H[3];
        slopes(h, z, g, H);
        const wide det = H[0] * H[2] - H[1] * H[1];
        const wide s = (H[2] * g[0] - H[1] * g[1]) / det, t = (H[0] * g[1] - H[1] * g[0]) / det;
        if (!(size_of(s) + size_of(t) < 1e3)) /* NaN, too */
            return false;
        z[0] += s;
        z[1] += t;
        if (k > 2 && size_of(s) + size_of(t) < 1e-22 * (1 + size_of(z[0]) + size_of(z[1])))
            return det > 0 && H[0] > 0;
    }
    return false;
}

static bool is_near(const wide z[2], const double loc[2], double within)
{
    return size_of(z[0] - loc[0]) <= within && size_of(z[1] - loc[1]) <= within;
}

/* Returns true if an answer with status OK is as near to a minimum as promised. From an answer that was moved to the
 * border, steps may lead elsewhere. They do not from near the minimum, or from the lowest point of a nearby line of
 * constant eta or xi, as valleys may be narrow. */
static bool holds(const struct header_function *f, const struct hard_case *h, const double loc[2])
{
    const double unit = fmax(1, fmax(fabs(loc[0]), fabs(loc[1])));
    for (int k = 0; k < (is_kept(f) ? 27 : 1); k++) {
        const int i = k % 3, j = k / 3 % 3, line = k / 9;
        wide z[2] = {loc[0] + (i ? i - 1.5 : 0) * f->promise, loc[1] + (j ? j - 1.5 : 0) * f->promise}, g[2], H[3];
        slopes(h, z, g, H);
        if (line && H[2 * line - 2] > 0)
            z[line - 1] += g[line - 1] / H[2 * line - 2];
        if (minimum_near(h, z) && is_near(z, loc, f->promise * unit))
            return !is_kept(f) || unit == 1;
    }
    return false;
}

/* Returns true if a minimum on the closed face is at the border, as near as promised: on an edge, along which the slope
 * is linear, or in a corner. */
static bool holds_at_border(const struct header_function *f, const struct hard_case *h, const double loc[2])
{
    for (int j = 0; j < 2; j++) {
        const int free = 1 - j;
        wide z[2] = {loc[0], loc[1]}, g[2], H[3];
        if (fabs(loc[j]) != 1 || !(fabs(loc[free]) <= 1))
            continue;
        slopes(h, z, g, H);
        if (H[2 * free] > 0)
            z[free] += g[free] / H[2 * free];
        z[free] = z[free] < -1 ? -1 : z[free] > 1 ? 1 : z[free];
        slopes(h, z, g, H);
        if (is_near(z, loc, f->promise) && g[j] * loc[j] > 0)
            return true;
    }
    return false;
}

/* ---- tests ---- */

static bool is_judged(const struct header_function *f)
{
    return f->promise > 0 && strcmp(f->kind, "quad4") == 0;
}

/* Returns true if an answer is as good as its status. */
static bool is_true(const struct header_function *f, const struct hard_case *h, int status, const double loc[2])
{
    if (status == FOOTPOINT_OUTSIDE)
        return is_kept(f) && holds_at_border(f, h, loc);
    return status == FOOTPOINT_OK ? holds(f, h, loc) : status == FOOTPOINT_UNPROVED || status < FOOTPOINT_OK;
}

/* Judges one function on one case; returns 1 if the answer is proved. */
static int judge(const struct header_function *f, const char *family, const struct hard_case *h)
{
    const double *const x[4] = {h->x[0], h->x[1], h->x[2], h->x[3]};
    double loc[2] = {9, 9}, gap;
    const int status = f->locate(x, h->x[4], loc, &gap);
    if (!is_true(f, h, status, loc)) {
        for (int k = 0; k < 5; k++)
            print_error("{%a, %a, %a}\n", h->x[k][0], h->x[k][1], h->x[k][2]);
        fail_msg("%s, %s: status %d at (%.17g, %.17g)", f->name, family, status, loc[0], loc[1]);
    }
    return status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE;
}

static void test_hard(void **state)
{
    (void)state;
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        for (int family = 0; family < hard_family_count && is_judged(&header_functions[i]); family++)
            for (long k = 0; k < cases(&header_functions[i]); k++) {
                struct hard_case h;
                hard_draw(family, 1, (uint64_t)k, &h);
                (void)judge(&header_functions[i], hard_families[family].name, &h);
            }
}

/* Judges n faces of a family, of which a least percentage must be proved. */
static void judge_drawn(const struct header_function *f, const char *family,
                        void (*draw)(uint64_t *, struct hard_case *), long n, int least)
{
    uint64_t stream = 61;
    long proved = 0;
    for (long k = 0; k < n; k++) {
        struct hard_case h;
        draw(&stream, &h);
        proved += judge(f, family, &h);
    }
    if (f->promise > 1e-11 && 100 * proved < least * n)
        fail_msg("%s, %s: %ld proved", f->name, family, proved);
}

static void test_swept(void **state)
{
    (void)state;
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (is_judged(&header_functions[i]))
            judge_drawn(&header_functions[i], "swept", draw_swept, 10 * cases(&header_functions[i]), SWEPT_LEAST);
}

static void test_ordinary(void **state)
{
    const long n = long_cases(CASES, 10 * CASES_LONG);
    (void)state;
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (is_judged(&header_functions[i]) && !is_kept(&header_functions[i]))
            judge_drawn(&header_functions[i], "ordinary", draw_ordinary, n, ORDINARY_LEAST);
}

static void test_lattice(void **state)
{
    (void)state;
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (is_judged(&header_functions[i]) && is_kept(&header_functions[i]))
            judge_drawn(&header_functions[i], "lattice", draw_lattice, 10 * cases(&header_functions[i]), LATTICE_LEAST);
}

/* Judges one function over an array, which proves at least as much as calls do; its other statuses are those of calls. */
static void judge_array(const struct header_function *f, size_t n, const struct hard_case *h)
{
    static double column[15][PAIRS], xi[PAIRS], eta[PAIRS], gap[PAIRS];
    static int status[PAIRS];
    const double *x[15];
    for (int k = 0; k < 15; k++) {
        x[k] = column[k];
        for (size_t i = 0; i < n; i++)
            column[k][i] = h[i].x[k / 3][k % 3];
    }
    f->checked_n(n, x, xi, eta, gap, status);
    for (size_t i = 0; i < n; i++) {
        const double *const y[4] = {h[i].x[0], h[i].x[1], h[i].x[2], h[i].x[3]}, found[2] = {xi[i], eta[i]};
        double loc[2], g;
        assert_true(is_true(f, &h[i], status[i], found));
        assert_true(status[i] < FOOTPOINT_OK || isfinite(gap[i]));
        if (status[i] != FOOTPOINT_OK)
            assert_int_equal(status[i], f->locate(y, h[i].x[4], loc, &g));
    }
}

/* Whole blocks and parts of one. */
static void test_arrays(void **state)
{
    static struct hard_case h[PAIRS];
    uint64_t stream = 62;
    (void)state;
    for (long round = 0; round < long_cases(1, ROUNDS_LONG); round++) {
        for (int i = 0; i < PAIRS; i++)
            if (i % 3 == 0)
                hard_draw(i / 3 % hard_family_count, 2, (uint64_t)(PAIRS * round + i), &h[i]);
            else
                (i % 3 == 1 ? draw_swept : draw_ordinary)(&stream, &h[i]);
        for (size_t f = 0; f < HEADER_FUNCTIONS; f++)
            if (is_judged(&header_functions[f]))
                judge_array(&header_functions[f], PAIRS - 15 * (f % 2), h);
    }
}

/* Faces over which rounding in single precision hides what single calls see: folded, so that differences of corners are
 * 1e9 times as long as the mid-lines, and as small as single precision allows beside numbers that are flushed to zero. */
static void test_arrays_of_extreme_faces(void **state)
{
    static const double folded[5][3] = {{698913931.83791173, -1317703366.5601363, 341504156.23630917},
                                        {683943629.00075984, -1109358906.9484844, -934287369.11740255},
                                        {698913931.85532558, -1317703365.9990678, 341504156.94270694},
                                        {683943629.52890325, -1109358906.5433369, -934287369.38509989},
                                        {691428780.5557251, -1213531136.5127563, -296391606.33087146}};
    static const double tiny[5][3] = {{-2.8267411951318804e-31, -5.8445506634912637e-35, -1.339497482707483e-39},
                                      {2.8267411951318804e-31, -5.8445506634912637e-35, -1.339497482707483e-39},
                                      {2.8267411951318804e-31, 5.8445506634912637e-35, 1.339497482707483e-39},
                                      {-2.8267411951318804e-31, 5.8445506634912637e-35, 1.339497482707483e-39},
                                      {5.5068143712147671e-34, 4.1345210456551321e-35, 3.2188119568787095e-32}};
    static struct hard_case h[PAIRS];
    (void)state;
    for (int i = 0; i < PAIRS; i++)
        memcpy(h[i].x, i % 2 ? folded : tiny, sizeof folded);
    for (size_t f = 0; f < HEADER_FUNCTIONS; f++)
        if (is_judged(&header_functions[f])) {
#ifdef __SSE__
            const unsigned int control = _mm_getcsr();
            _mm_setcsr(control | 0x8040); /* flush to zero, denormals are zero */
            judge_array(&header_functions[f], PAIRS, h);
            _mm_setcsr(control);
#endif
            judge_array(&header_functions[f], PAIRS, h);
        }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_hard),    cmocka_unit_test(test_ordinary), cmocka_unit_test(test_swept),
        cmocka_unit_test(test_lattice), cmocka_unit_test(test_arrays),   cmocka_unit_test(test_arrays_of_extreme_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
