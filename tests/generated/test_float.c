/* Code in float: the committed header reproduces the figures of its banner on its scene's held-out samples, whose
 * coordinates are floats; results depend neither on place nor on size; nearly all of these samples are proved. Hard
 * cases are in tests/hard/ and test_promise_float.c. */
#include "../../codegen/genome/genome.h"
#include "../../evolve/samples/samples.h"
#include "../../generated/footpoint_quad4_float.h"
#include "../../runtime/footpoint.h"
#include "../support/error_stats.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Fused operations are equally accurate, but not equal. */
#ifdef __FP_FAST_FMAF
#define AGREE 0.5
#else
#define AGREE 1e-3
#endif

typedef void straight(const float *xA, const float *xB, const float *xC, const float *xD, const float *xS, float *xi,
                      float *eta);
typedef int checked(const float *xA, const float *xB, const float *xC, const float *xD, const float *xS, float loc[2],
                    float *gap);

#define FUNCTION(name, NAME, unproved)                                                                                 \
    {                                                                                                                  \
#name, footpoint_quad4_float_##name##_at, footpoint_quad4_float_##name, footpoint_quad4_float_##name##_sure,   \
            (double)FOOTPOINT_QUAD4_FLOAT_##NAME##_PROMISE, unproved                                                   \
    }
static const struct function {
    const char *name;
    straight *at;
    checked *bare, *sure;
    double promise;
    double unproved; /* largest unproved share of the scene's samples */
} functions[] = {FUNCTION(fast, FAST, 0),          FUNCTION(coarse, COARSE, 0),       FUNCTION(gauss2, GAUSS2, 0),
                 FUNCTION(medium, MEDIUM, 0),      FUNCTION(balanced, BALANCED, 0),   FUNCTION(fine, FINE, 2e-3),
                 FUNCTION(precise, PRECISE, 2e-3), FUNCTION(accurate, ACCURATE, 2e-3)};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

enum { PARTS = 2, TOLD = 1 /* parts in banners */ };
static struct sample_set set[PARTS];
static const char *const part_name[TOLD] = {"heldout"};

/* Copies the nodes and the slave node, which comes last. */
static void set_single(const struct sample *s, float x[5][3])
{
    for (int i = 0; i < 5; i++)
        for (int k = 0; k < 3; k++)
            x[i][k] = (float)(i < 4 ? s->x[i][k] : s->xs[k]);
}

static int draw(void **state)
{
    struct diag d;
    struct scene *scene = scene_read(".", "quad4-float", &d);
    (void)state;
    if (!scene || !scene_samples(scene, PART_HELDOUT, &set[0], &d) ||
        !scene_samples(scene, PART_HELDOUT_RANDOM, &set[1], &d))
        fail_msg("%s", d.text);
    scene_free(scene);
    return 0;
}

static int forget(void **state)
{
    (void)state;
    sample_set_free(&set[0]);
    sample_set_free(&set[1]);
    return 0;
}

static void coordinates_are_floats(void **state)
{
    (void)state;
    for (int part = 0; part < 2; part++)
        for (size_t i = 0; i < set[part].n; i++) {
            float x[5][3];
            set_single(&set[part].s[i], x);
            for (int k = 0; k < 15; k++)
                assert_true((double)x[k / 3][k % 3] ==
                            (k < 12 ? set[part].s[i].x[k / 3][k % 3] : set[part].s[i].xs[k % 3]));
        }
}

/* Reads a function's line of the banner: "KEY: xi MEAN P99 WORST, eta MEAN P99 WORST, of N samples", with or without
 * "and climbing". */
static void read_banner(const char *text, const char *function, const char *part, struct error_stats e[2], size_t *n,
                        bool *climbed)
{
    char name[80], line[80];
    snprintf(name, sizeof name, "\n/* footpoint_quad4_float_%s\n", function);
    snprintf(line, sizeof line, " *   %s:", part);
    const char *at = strstr(text, name);
    assert_non_null(at);
    at = strstr(at, line);
    assert_non_null(at);
    assert_int_equal(sscanf(at + strlen(line), " xi %lf %lf %lf, eta %lf %lf %lf, of %zu samples", &e[0].mean,
                            &e[0].p99, &e[0].max, &e[1].mean, &e[1].p99, &e[1].max, n),
                     7);
    *climbed = strncmp(strstr(at, " samples"), " samples and", strlen(" samples and")) == 0;
}

static void banner_states_errors_of_the_float_code(void **state)
{
    size_t size;
    struct diag d;
    char *text = read_text("generated/footpoint_quad4_float.h", &size, &d);
    (void)state;
    assert_non_null(text);
    for (int f = 0; f < FUNCTIONS; f++)
        for (int part = 0; part < TOLD; part++) {
            const size_t n = set[part].n;
            double *error[2] = {new_array(n, sizeof(double)), new_array(n, sizeof(double))};
            for (size_t i = 0; i < n; i++) {
                const struct sample *s = &set[part].s[i];
                float x[5][3], loc[2];
                set_single(s, x);
                functions[f].at(x[0], x[1], x[2], x[3], x[4], &loc[0], &loc[1]);
                error[0][i] = fabs((double)loc[0] - s->xi);
                error[1][i] = fabs((double)loc[1] - s->eta);
            }
            struct error_stats told[2];
            size_t count;
            bool climbed;
            read_banner(text, functions[f].name, part_name[part], told, &count, &climbed);
            assert_int_equal(count, n);
            for (int k = 0; k < 2; k++) {
                const struct error_stats e = error_stats_of(error[k], n), stated = told[k];
                assert_int_equal(e.failures, 0);
                if (!(fabs(e.mean - stated.mean) <= AGREE * stated.mean &&
                      fabs(e.p99 - stated.p99) <= AGREE * stated.p99 && e.max - stated.max <= 2 * AGREE * stated.max &&
                      (climbed || stated.max - e.max <= 2 * AGREE * stated.max)))
                    fail_msg("%s %s: measured mean %g p99 %g max %g, the banner says %g %g %g", functions[f].name,
                             part_name[part], e.mean, e.p99, e.max, stated.mean, stated.p99, stated.max);
                free(error[k]);
            }
        }
    free(text);
}

static void samples_are_proved(void **state)
{
    (void)state;
    for (int f = 0; f < FUNCTIONS; f++) {
        size_t asked = 0, unproved = 0;
        for (int part = 0; part < 2; part++)
            for (size_t i = 0; i < set[part].n; i += 4, asked++) {
                const struct sample *s = &set[part].s[i];
                float x[5][3], loc[2], gap, again[2], other;
                set_single(s, x);
                const int status = functions[f].bare(x[0], x[1], x[2], x[3], x[4], loc, &gap);
                assert_int_equal(functions[f].sure(x[0], x[1], x[2], x[3], x[4], again, &other), status);
                assert_true(loc[0] == again[0] && loc[1] == again[1] && gap == other);
                assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_UNPROVED);
                unproved += status == FOOTPOINT_UNPROVED;
                assert_true(status == FOOTPOINT_UNPROVED ||
                            fmax(fabs((double)loc[0] - s->xi), fabs((double)loc[1] - s->eta)) <=
                                functions[f].promise * fmax(1, fmax(fabs(s->xi), fabs(s->eta))));
            }
        print_message("%s: %zu of %zu unproved\n", functions[f].name, unproved, asked);
        assert_true((double)unproved <= functions[f].unproved * (double)asked);
    }
}

/* The same segment, 2^-13 to 2^13 times as large (1e-4 to 1e4), has the same numbers to the bit. */
static void size_does_not_matter(void **state)
{
    (void)state;
    for (size_t i = 0; i < set[0].n; i += 997)
        for (int f = 0; f < FUNCTIONS; f++) {
            float x[5][3], first[2], loc[2], gap, g;
            set_single(&set[0].s[i], x);
            const int status = functions[f].bare(x[0], x[1], x[2], x[3], x[4], first, &gap);
            assert_true(status >= FOOTPOINT_OK);
            for (int power = -13; power <= 13; power += 13) {
                float y[5][3];
                for (int k = 0; k < 15; k++)
                    y[k / 3][k % 3] = ldexpf(x[k / 3][k % 3], power);
                assert_int_equal(functions[f].bare(y[0], y[1], y[2], y[3], y[4], loc, &g), status);
                assert_true(loc[0] == first[0] && loc[1] == first[1] && g == ldexpf(gap, power));
            }
        }
}

static void loops_agree_with_single_calls(void **state)
{
    enum { N = 1000 };
    static float column[15][N], xi[N], eta[N];
    const float *x[15];
    (void)state;
    for (int k = 0; k < 15; k++)
        x[k] = column[k];
    for (size_t i = 0; i < N; i++) {
        float one[5][3];
        set_single(&set[1].s[i], one);
        for (int k = 0; k < 15; k++)
            column[k][i] = one[k / 3][k % 3];
    }
    footpoint_quad4_float_accurate_n(N, x, xi, eta);
    for (size_t i = 0; i < N; i++) {
        const struct sample *s = &set[1].s[i];
        const double off = fmax(fabs((double)xi[i] - s->xi), fabs((double)eta[i] - s->eta));
        assert_true(off <= 1e-4);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(coordinates_are_floats),
        cmocka_unit_test(banner_states_errors_of_the_float_code),
        cmocka_unit_test(samples_are_proved),
        cmocka_unit_test(size_does_not_matter),
        cmocka_unit_test(loops_agree_with_single_calls),
    };
    return cmocka_run_group_tests_name("float", tests, draw, forget);
}
