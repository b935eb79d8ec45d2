/* Batches: every tier, kind of array, size, order and instruction set returns the bits of the generated function for
 * one pair, including statuses and untouched outputs, on ordinary and on bad pairs; so do prepared segments. */
#include "../../generated/footpoint_quad4.h"
#include "../../runtime/batch/batch_block.h"
#include "../support/ordinary_quad.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { PAIRS = 1500, NODES = 5 * PAIRS, STRIDE = 7 };
#define UNTOUCHED 77.25

typedef int search(const double *, const double *, const double *, const double *, const double *, double *, double *);
static search *const single[FOOTPOINT_TIERS] = {
    footpoint_quad4_fast,    footpoint_quad4_coarse,   footpoint_quad4_gauss2,
    footpoint_quad4_medium,  footpoint_quad4_balanced, footpoint_quad4_fine,
    footpoint_quad4_precise, footpoint_quad4_accurate, footpoint_quad4_full};

struct answer {
    double loc[2], gap;
    int status;
};

/* One mesh in all kinds of arrays, and the expected answers of its pairs. */
static struct model {
    double xyz[NODES][3], column[3][NODES], strided[NODES][STRIDE];
    float xyzf[NODES][3];
    int32_t seg[PAIRS][4], slave[PAIRS];
    int64_t seg64[PAIRS][4], slave64[PAIRS];
    struct answer expected[FOOTPOINT_TIERS][PAIRS];
} model;

static struct answers {
    double loc[PAIRS][2], gap[PAIRS];
    float locf[PAIRS][2], gapf[PAIRS];
    int status[PAIRS];
} got;

static void scale(double x[5][3], double by)
{
    for (int i = 0; i < 15; i++)
        x[i / 3][i % 3] *= by;
}

/* Spoils a pair in a way that `kind` selects, from 0. */
static void spoil(double x[5][3], unsigned kind)
{
    static const double bad[4] = {(double)NAN, (double)INFINITY, 1e200, -1e308};
    const unsigned node = kind % 5, c = kind % 3;
    switch (kind % 9) {
    case 0:
        x[node][c] = bad[kind / 9 % 4];
        break;
    case 1:
        memcpy(x[node % 4], x[(node + 1 + kind / 9 % 3) % 4], sizeof x[0]);
        break;
    case 2: /* corners on a line, or nearly on a line */
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++)
                x[i][k] = (i + 1) * (k + 1) + x[i][k] * (kind / 9 % 4 ? pow(10, -1.0 - kind / 9 % 13) : 0);
        break;
    case 3: /* far outside */
        x[4][c] *= 1e4;
        break;
    case 4:
        scale(x, kind & 8 ? 1e-60 : 1e60);
        break;
    case 5:
        scale(x, pow(10, (double)(kind / 9 % 120) - 60));
        break;
    case 6: /* on a corner */
        memcpy(x[4], x[node % 4], sizeof x[0]);
        break;
    case 7: /* finite, but their sum is not */
        for (int i = 0; i < 5; i++)
            x[i][c] = kind / 9 % 2 ? 1e308 : 3e307;
        break;
    default: /* an aspect ratio of up to 1e300 */
        for (int i = 0; i < 5; i++) {
            x[i][0] = (i == 1 || i == 2 ? 1 : 0) * pow(10, (double)(kind / 9 % 16) * 10.5);
            x[i][1] = (i == 2 || i == 3 ? 1 : 0) * pow(10, (double)(kind / 9 % 16) * -10);
            x[i][2] = 0;
        }
    }
}

static int one_pair(enum footpoint_tier tier, size_t i, const double x[NODES][3], struct answer *a)
{
    *a = (struct answer){{UNTOUCHED, UNTOUCHED}, UNTOUCHED, 0};
    const int32_t *const s = model.seg[i];
    for (int k = 0; k < 5; k++)
        if ((k < 4 ? s[k] : model.slave[i]) < 0 || (k < 4 ? s[k] : model.slave[i]) >= NODES)
            return a->status = FOOTPOINT_ERR_ARGUMENT;
    return a->status = single[tier](x[s[0]], x[s[1]], x[s[2]], x[s[3]], x[model.slave[i]], a->loc, &a->gap);
}

/* Builds the model; every bad-th pair is spoilt, 0: no pair. */
static void build(unsigned bad)
{
    const struct quad_limits wide = {0.3, 0.2, 0.5, 1.5};
    for (unsigned i = 0; i < PAIRS; i++) {
        struct quad q = quad_draw(i % 2 ? &quad_ordinary : &wide, i);
        double x[5][3];
        memcpy(x, q.x, sizeof q.x);
        memcpy(x[4], q.xs, sizeof q.xs);
        if (bad && i % bad == bad - 1)
            spoil(x, i / bad);
        for (unsigned k = 0; k < 5; k++) {
            const unsigned node = (5 * i + k) * 7 % NODES; /* 7 and NODES have no common factor */
            for (int c = 0; c < 3; c++) {
                model.xyz[node][c] = model.column[c][node] = model.strided[node][2 * c] = x[k][c];
                model.xyzf[node][c] = (float)(fabs(x[k][c]) > 1e30 ? (double)INFINITY : x[k][c]);
            }
            *(k < 4 ? &model.seg[i][k] : &model.slave[i]) = (int32_t)node;
        }
        if (bad && i % (3 * bad) == 0)
            *(i % 5 < 4 ? &model.seg[i][i % 5] : &model.slave[i]) = (int32_t[]){-1, NODES, INT32_MAX, INT32_MIN}[i % 4];
        for (int k = 0; k < 4; k++)
            model.seg64[i][k] = model.seg[i][k];
        model.slave64[i] = model.slave[i];
    }
    for (int tier = 0; tier < FOOTPOINT_TIERS; tier++)
        for (size_t i = 0; i < PAIRS; i++)
            one_pair((enum footpoint_tier)tier, i, (const double(*)[3])model.xyz, &model.expected[tier][i]);
}

static void clear(void)
{
    for (int i = 0; i < PAIRS; i++) {
        got.loc[i][0] = got.loc[i][1] = got.gap[i] = UNTOUCHED;
        got.locf[i][0] = got.locf[i][1] = got.gapf[i] = (float)UNTOUCHED;
        got.status[i] = -9;
    }
}

/* Tolerance of the answers if the compiler contracts to fused operations, differently in each loop; otherwise bits
 * agree. */
#ifdef __FMA__
#define ROUNDING 1e-9
#else
#define ROUNDING 0.0
#endif

static int same(const double *a, const double *b, size_t n)
{
    if (memcmp(a, b, n * sizeof *a) == 0)
        return 1;
    for (size_t k = 0; k < n; k++)
        if (!(fabs(a[k] - b[k]) <= ROUNDING * (1 + fabs(b[k]))))
            return 0;
    return ROUNDING > 0.0;
}

static int same_rounded(float a, double b)
{
    return a == (float)b || fabs((double)a - b) <= 1e7 * FLT_EPSILON * ROUNDING * (1 + fabs(b));
}

/* Checks the answers at `at` against those expected for pairs from..from+n-1. */
static void check(const char *what, int tier, size_t from, size_t n, size_t failed, int gap, int status)
{
    size_t bad = 0;
    for (size_t i = 0; i < n; i++) {
        const struct answer *const e = &model.expected[tier][from + i];
        const double untouched = UNTOUCHED;
        bad += e->status != FOOTPOINT_OK;
        if (same(got.loc[i], e->loc, 2) && same(&got.gap[i], gap ? &e->gap : &untouched, 1) &&
            got.status[i] == (status ? e->status : -9))
            continue;
        print_error("%s, tier %d, pair %zu: %a %a %a status %d instead of %a %a %a status %d\n", what, tier, from + i,
                    got.loc[i][0], got.loc[i][1], got.gap[i], got.status[i], e->loc[0], e->loc[1], e->gap, e->status);
        fail();
    }
    assert_int_equal(failed, bad);
}

/* Returns the pairs from number `from` in one kind of arrays: 0 nodes x 3, 1 columns, 2 with a stride. */
static struct footpoint_pairs pairs_of(size_t from, size_t n, int layout, int wide)
{
    struct footpoint_pairs p = {.n = n, .nodes = NODES};
    p.x = layout == 0 ? model.xyz[0] : layout == 1 ? model.column[0] : model.strided[0];
    p.y = layout == 0 ? model.xyz[0] + 1 : layout == 1 ? model.column[1] : model.strided[0] + 2;
    p.z = layout == 0 ? model.xyz[0] + 2 : layout == 1 ? model.column[2] : model.strided[0] + 4;
    p.stride = layout == 0 ? 3 : layout == 1 ? 1 : STRIDE;
    if (wide) {
        p.seg64 = model.seg64[from];
        p.slave64 = model.slave64 + from;
    } else {
        p.seg = model.seg[from];
        p.slave = model.slave + from;
    }
    return p;
}

static void kinds_of_arrays_have_equal_bits(void **state)
{
    static const unsigned bad[4] = {0, 97, 33, 3};
    (void)state;
    for (int b = 0; b < 4; b++) {
        build(bad[b]);
        for (int tier = 0; tier < FOOTPOINT_TIERS; tier++)
            for (int kind = 0; kind < 24; kind++) {
                const int layout = kind % 3, wide = kind / 3 % 2, gap = kind / 6 % 2, status = kind / 12;
                const struct footpoint_pairs p = pairs_of(0, PAIRS, layout, wide);
                clear();
                check("kinds", tier, 0, PAIRS,
                      footpoint_locate_batch(&p, (enum footpoint_tier)tier, got.loc[0], gap ? got.gap : NULL,
                                             status ? got.status : NULL),
                      gap, status);
            }
    }
}

static void batch_sizes_have_equal_bits(void **state)
{
    (void)state;
    build(50);
    for (size_t n = 0; n < 300; n++) {
        const size_t from = n * 37 % (PAIRS - 300);
        const struct footpoint_pairs p = pairs_of(from, n, 0, n % 2);
        clear();
        check("sizes", FOOTPOINT_FINE, from, n,
              footpoint_locate_batch(&p, FOOTPOINT_FINE, got.loc[0], got.gap, got.status), 1, 1);
        assert_true(got.loc[n][0] == UNTOUCHED && got.gap[n] == UNTOUCHED && got.status[n] == -9);
    }
}

/* Coordinates in float have the answer of the same coordinates in double, rounded on request. */
static void float_coordinates_match_double(void **state)
{
    static double widened[NODES][3];
    (void)state;
    build(40);
    for (int i = 0; i < 3 * NODES; i++)
        widened[i / 3][i % 3] = (double)model.xyzf[i / 3][i % 3];
    for (int tier = 0; tier < FOOTPOINT_TIERS; tier++)
        for (int wide = 0; wide < 2; wide++) {
            struct footpoint_pairs p = pairs_of(0, PAIRS, 0, wide);
            p.x = p.y = p.z = NULL;
            p.xf = model.xyzf[0];
            p.yf = p.xf + 1;
            p.zf = p.xf + 2;
            clear();
            size_t failed = 0;
            const size_t a = footpoint_locate_batch(&p, (enum footpoint_tier)tier, got.loc[0], got.gap, NULL);
            const size_t b =
                footpoint_locate_batch_float(&p, (enum footpoint_tier)tier, got.locf[0], got.gapf, got.status);
            for (size_t i = 0; i < PAIRS; i++) {
                struct answer e;
                failed += one_pair((enum footpoint_tier)tier, i, (const double(*)[3])widened, &e) != FOOTPOINT_OK;
                assert_true(same(got.loc[i], e.loc, 2) && same(&got.gap[i], &e.gap, 1) && got.status[i] == e.status);
                assert_true(same_rounded(got.locf[i][0], e.loc[0]) && same_rounded(got.locf[i][1], e.loc[1]) &&
                            same_rounded(got.gapf[i], e.gap));
            }
            assert_true(a == failed && b == failed);
        }
}

/* Only pairs with status FOOTPOINT_OK take the short way; ordinary pairs always do. */
static void only_sure_pairs_take_the_short_way(void **state)
{
    static struct block b;
    const struct lanes *const lanes = footpoint_batch_lanes();
    (void)state;
    for (unsigned i = 0; i < 6000; i++)
        for (unsigned tier = 0; tier < FOOTPOINT_TIERS; tier += 3) {
            struct quad q = quad_draw(&quad_ordinary, i / 9);
            double x[5][3], loc[2], gap;
            memcpy(x, q.x, sizeof q.x);
            memcpy(x[4], q.xs, sizeof q.xs);
            if (i % 10)
                spoil(x, i);
            for (int k = 0; k < 15; k++)
                for (int lane = 0; lane < LANES; lane++)
                    b.x[k][lane] = x[k / 3][k % 3];
            const int good = lanes->search[tier](&b, LANES);
            const int status = single[tier](x[0], x[1], x[2], x[3], x[4], loc, &gap);
            assert_true(!good || status == FOOTPOINT_OK);
            assert_true(good || i % 10);
        }
}

static void bad_arguments_are_refused(void **state)
{
    (void)state;
    build(0);
    const struct footpoint_pairs good = pairs_of(0, 100, 0, 0);
    enum { CASES = 7 };
    struct footpoint_pairs p[CASES] = {good, good, good, good, good, good, good};
    p[0].x = NULL;
    p[1].stride = 0;
    p[2].slave = NULL;
    p[4].y = NULL, p[4].xf = p[4].yf = p[4].zf = model.xyzf[0]; /* one array of one kind, the others of another */
    p[5].seg64 = pairs_of(0, 100, 0, 1).seg64;
    p[6].nodes = 0, p[6].x = p[6].y = p[6].z = NULL;
    for (int i = 0; i < CASES; i++) {
        const enum footpoint_tier tier = i == 3 ? FOOTPOINT_TIERS : FOOTPOINT_FAST;
        clear();
        assert_int_equal(footpoint_locate_batch(&p[i], tier, got.loc[0], NULL, NULL), 100);
        assert_int_equal(footpoint_locate_batch(&p[i], tier, got.loc[0], got.gap, got.status), 100);
        for (int k = 0; k < 100; k++)
            assert_true(got.status[k] == FOOTPOINT_ERR_ARGUMENT && got.loc[k][0] == UNTOUCHED &&
                        got.gap[k] == UNTOUCHED);
    }
}

/* All instruction sets return the same answers for all kinds of arrays; a block with the last node is not a block of
 * triples. */
static void instruction_sets_have_equal_bits(void **state)
{
    static struct block blocks[LANE_SETS];
    size_t taken[KINDS] = {0};
    (void)state;
    build(0);
    for (size_t first = 0; first + BLOCK <= PAIRS; first += BLOCK)
        for (int tier = 0; tier < 2 * FOOTPOINT_TIERS; tier++)
            for (int kind = 0; kind < KINDS; kind++) {
                struct footpoint_pairs p = pairs_of(first, BLOCK, kind & KIND_TRIPLES ? 0 : 1, kind & KIND_WIDE);
                if (kind & KIND_FLOAT)
                    p.xf = model.xyzf[0], p.yf = p.xf + 1, p.zf = p.xf + 2, p.stride = 3;
                for (int set = 0; set < LANE_SETS; set++) {
                    const struct lanes *const lanes = footpoint_batch_lanes_of(set);
                    if (!lanes || !lanes->gather[kind](&blocks[set], &p, 0))
                        continue;
                    (void)(tier % 2 ? lanes->prepared : lanes->search)[tier / 2](&blocks[set], BLOCK);
                    assert_memory_equal(&blocks[set], &blocks[0], sizeof blocks[0]);
                    taken[kind]++;
                }
            }
    for (int kind = 0; kind < KINDS; kind++)
        assert_true(taken[kind] > 0 && taken[kind] <= taken[0]);
}

/* The last node may lie at the very end of an array: nothing after it is read. */
static void nothing_is_read_after_the_last_node(void **state)
{
    enum { LAST = 40 };
    (void)state;
    for (size_t bits = 0; bits < 2; bits++) {
        double *const x = malloc(3 * LAST * sizeof *x);
        float *const xf = malloc(3 * LAST * sizeof *xf);
        int32_t seg[BLOCK][4], slave[BLOCK];
        double loc[BLOCK][2];
        float locf[BLOCK][2];
        assert_true(x && xf);
        for (int i = 0; i < 3 * LAST; i++)
            xf[i] = (float)(x[i] = (double)(i * i % 17));
        for (int i = 0; i < BLOCK; i++) {
            const int32_t corner[4] = {0, 1, 3, 2};
            memcpy(seg[i], corner, sizeof seg[i]);
            slave[i] = LAST - 1 - (bits ? i : 0);
        }
        const struct footpoint_pairs p = {
            .n = BLOCK, .nodes = LAST, .x = x, .y = x + 1, .z = x + 2, .stride = 3, .seg = seg[0], .slave = slave};
        const struct footpoint_pairs pf = {.n = BLOCK,
                                           .nodes = LAST,
                                           .xf = xf,
                                           .yf = xf + 1,
                                           .zf = xf + 2,
                                           .stride = 3,
                                           .seg = seg[0],
                                           .slave = slave};
        const size_t bad = footpoint_locate_batch(&p, FOOTPOINT_FINE, loc[0], NULL, NULL);
        assert_int_equal(footpoint_locate_batch_float(&pf, FOOTPOINT_FINE, locf[0], NULL, NULL), bad);
        for (int i = 0; i < BLOCK && bad == 0; i++)
            assert_true(locf[i][0] == (float)loc[i][0] && locf[i][1] == (float)loc[i][1]);
        free(x);
        free(xf);
    }
}

/* Each segment is searched with the slave nodes of its neighbours in the list. */
static void prepared_segments_have_equal_bits(void **state)
{
    enum { MOST = 70 };
    static double xs[MOST][3];
    static int32_t seg[MOST][4], slave[MOST];
    static struct answers batch;
    (void)state;
    build(30);
    for (size_t i = 0; i + MOST <= PAIRS; i += 7) {
        const size_t n = i % (MOST + 1);
        const enum footpoint_tier tier = (enum footpoint_tier)(i % FOOTPOINT_TIERS);
        struct footpoint_segment s;
        const double(*const x)[3] = (const double(*)[3])model.xyz;
        int valid = 1;
        for (size_t k = 0; k < 4; k++)
            valid &= model.seg[i][k] >= 0 && model.seg[i][k] < NODES;
        if (!valid)
            continue;
        const int32_t *const c = model.seg[i];
        const int status = footpoint_prepare(x[c[0]], x[c[1]], x[c[2]], x[c[3]], &s);
        for (size_t k = 0; k < n; k++) {
            slave[k] = model.slave[i + k] < 0 || model.slave[i + k] >= NODES ? 0 : model.slave[i + k];
            memcpy(xs[k], x[slave[k]], sizeof xs[k]);
            memcpy(seg[k], c, sizeof seg[k]);
        }
        const struct footpoint_pairs p = {.n = n,
                                          .nodes = NODES,
                                          .x = x[0],
                                          .y = x[0] + 1,
                                          .z = x[0] + 2,
                                          .stride = 3,
                                          .seg = seg[0],
                                          .slave = slave};
        clear();
        batch = got;
        const size_t failed = footpoint_locate_batch(&p, tier, batch.loc[0], batch.gap, batch.status);
        if (status != FOOTPOINT_OK) {
            assert_int_equal(failed, n);
            continue;
        }
        assert_int_equal(footpoint_locate_prepared(&s, tier, n, xs[0], got.loc[0], got.gap, got.status), failed);
        assert_true(same(got.loc[0], batch.loc[0], 2 * PAIRS) && (ROUNDING > 0.0 || same(got.gap, batch.gap, PAIRS)));
        assert_memory_equal(got.status, batch.status, sizeof got.status);
        for (int k = 0; k < 3; k++) {
            const double corner = s.c1[k] + s.c2[k] + s.c3[k], other = -s.c1[k] - s.c2[k] + s.c3[k];
            assert_true(fabs((corner - other) - (s.x[2][k] - s.x[0][k])) <= 1e-13 * (fabs(corner) + fabs(other)));
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(kinds_of_arrays_have_equal_bits),     cmocka_unit_test(batch_sizes_have_equal_bits),
        cmocka_unit_test(float_coordinates_match_double),      cmocka_unit_test(instruction_sets_have_equal_bits),
        cmocka_unit_test(nothing_is_read_after_the_last_node), cmocka_unit_test(bad_arguments_are_refused),
        cmocka_unit_test(only_sure_pairs_take_the_short_way),  cmocka_unit_test(prepared_segments_have_equal_bits)};
    return cmocka_run_group_tests_name("batch", tests, NULL, NULL);
}
