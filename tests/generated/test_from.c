/* Searches from the last answer: with FOOTPOINT_OK a minimum of the distance lies within NAME_PROMISE, and they return
 * FOOTPOINT_OK whenever NAME does. Faces of four to nine nodes: ordinary, strongly curved, slivers and wild. Starts are
 * off by 1e-6 to 10 faces, or NaN; calls, arrays of any length and one face. The same for searches from scratch over
 * arrays. With FOOTPOINT_LONG ten million calls. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri6.h"
#include "../hard/draw.h"
#include "../support/kind_arguments.h"
#include "../support/long_cases.h"
#include "judged_faces.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 600, CASES_LONG = 105000, PAIRS = 60, MOST_ROWS = 3 * (CURVED_NODES + 1) };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

#define FUNCTIONS(F)                                                                                                   \
    F(quad4, quad4_fast, QUAD4_FAST)                                                                                   \
    F(quad4, quad4_coarse, QUAD4_COARSE)                                                                               \
    F(quad4, quad4_gauss2, QUAD4_GAUSS2)                                                                               \
    F(quad4, quad4_medium, QUAD4_MEDIUM)                                                                               \
    F(quad4, quad4_balanced, QUAD4_BALANCED)                                                                           \
    F(quad4, quad4_fine, QUAD4_FINE)                                                                                   \
    F(quad4, quad4_precise, QUAD4_PRECISE)                                                                             \
    F(quad4, quad4_accurate, QUAD4_ACCURATE)                                                                           \
    F(quad4, quad4_full, QUAD4_FULL)                                                                                   \
    F(tri6, tri6_medium, TRI6_MEDIUM)                                                                                  \
    F(tri6, tri6_fine, TRI6_FINE)                                                                                      \
    F(tri6, tri6_accurate, TRI6_ACCURATE)                                                                              \
    F(quad8, quad8_full, QUAD8_FULL)                                                                                   \
    F(quad8, quad8_fine, QUAD8_FINE)                                                                                   \
    F(quad8, quad8_accurate, QUAD8_ACCURATE)                                                                           \
    F(quad9, quad9_full, QUAD9_FULL)                                                                                   \
    F(quad9, quad9_coarse, QUAD9_COARSE)                                                                               \
    F(quad9, quad9_accurate, QUAD9_ACCURATE)

#define WRAP(kind, name, capitals)                                                                                     \
    static int scratch_##name(const double *const *x, const double *xs, double loc[2], double *gap)                    \
    {                                                                                                                  \
        return footpoint_##name(NODES_OF_##kind(x, xs), loc, gap);                                                     \
    }                                                                                                                  \
    static int from_##name(const double *const *x, const double *xs, double loc[2], double *gap)                       \
    {                                                                                                                  \
        return footpoint_##name##_from(NODES_OF_##kind(x, xs), loc, gap);                                              \
    }
FUNCTIONS(WRAP)

typedef int search(const double *const *x, const double *xs, double loc[2], double *gap);
typedef void pairs(size_t n, const double *const *x, double *xi, double *eta, double *gap, int *status);
typedef void slaves(const double *const *nodes, size_t n, const double *const *x, double *xi, double *eta, double *gap,
                    int *status);
static const struct function {
    const char *kind, *name;
    double promise;
    search *scratch, *from;
    pairs *checked_n, *from_n;
    slaves *over_n, *from_over_n;
} functions[] = {
#define ROW(kind, name, capitals)                                                                                      \
    {#kind,                                                                                                            \
     #name,                                                                                                            \
     FOOTPOINT_##capitals##_PROMISE,                                                                                   \
     scratch_##name,                                                                                                   \
     from_##name,                                                                                                      \
     footpoint_##name##_checked_n,                                                                                     \
     footpoint_##name##_from_n,                                                                                        \
     footpoint_##name##_over_n,                                                                                        \
     footpoint_##name##_from_over_n},
    FUNCTIONS(ROW)};
enum { COUNT = sizeof functions / sizeof *functions };

/* A face and the judge's view of it. */
struct subject {
    struct curved_case face, unit;
    const double *x[CURVED_NODES];
    const double *xs;
    wide known[2];
    bool is_known;
};

static void draw_subject(uint64_t *stream, const struct curved_kind *kind, enum curved_group group, struct subject *s)
{
    memset(s, 0, sizeof *s);
    s->face.kind = kind;
    curved_draw(stream, group, &s->face);
    s->unit = judged_unit(&s->face);
    for (int k = 0; k < kind->nodes; k++)
        s->x[k] = s->face.x[k];
    s->xs = s->face.x[kind->nodes];
}

/* Draws a last answer: the foot point moved by 1e-6 to 10 faces of width 2, sometimes NaN. */
static void draw_start(uint64_t *stream, const double loc[2], double start[2])
{
    const double moved = draw_power(stream, -6, 1.3);
    const int odd = draw_choose(stream, 40);
    for (int i = 0; i < 2; i++)
        start[i] = loc[i] + moved * draw_flat(stream, -1, 1);
    if (odd < 2)
        start[odd] = NAN;
    else if (odd < 4)
        start[odd - 2] = INFINITY;
    else if (odd == 4)
        start[0] = 1e200;
}

static void fail_on(const struct subject *s, const struct function *f, const char *what, const double start[2],
                    const double loc[2])
{
    for (int k = 0; k <= s->face.kind->nodes; k++)
        print_error("{%a, %a, %a},\n", s->face.x[k][0], s->face.x[k][1], s->face.x[k][2]);
    fail_msg("%s, %s: from (%a, %a) to (%a, %a)", f->name, what, start[0], start[1], loc[0], loc[1]);
}

/* Judges one answer with its `status`; `scratch` is the status of NAME. */
static void judge(struct subject *s, const struct function *f, const double start[2], int scratch, int status,
                  const double loc[2])
{
    if (scratch == FOOTPOINT_OK && status != FOOTPOINT_OK)
        fail_on(s, f, "lost", start, loc);
    if (status < 0 && (memcmp(start, loc, 2 * sizeof *loc) != 0 || scratch != status))
        fail_on(s, f, "an error of its own", start, loc);
    if (status == FOOTPOINT_OK && !judged_holds(&s->unit, loc, f->promise, s->known, &s->is_known))
        fail_on(s, f, "wrong", start, loc);
}

static bool is_of(const struct function *f, const struct curved_kind *kind)
{
    return strcmp(f->kind, kind->name) == 0;
}

static void test_moves(void **state)
{
    uint64_t stream = 6301;
    (void)state;
    for (int k = 0; k < CASE_KINDS; k++)
        for (long i = 0; i < CURVED_GROUPS * cases(); i++) {
            struct subject s;
            draw_subject(&stream, &curved_kinds[k], (enum curved_group)(i % CURVED_GROUPS), &s);
            for (int j = COUNT; j-- > 0;) {
                const struct function *const f = &functions[j];
                double loc[2] = {0, 0}, start[2], gap = 0;
                if (!is_of(f, s.face.kind))
                    continue;
                const int scratch = f->scratch(s.x, s.xs, loc, &gap);
                draw_start(&stream, loc, start);
                memcpy(loc, start, sizeof loc);
                const int status = f->from(s.x, s.xs, loc, &gap);
                judge(&s, f, start, scratch, status, loc);
            }
        }
}

/* Searches some of these pairs, or their slave nodes over the first face, from the last answers or from scratch, and
 * judges the answers. Nothing else is written. */
static void arrays(const struct function *f, const struct curved_kind *kind, bool over, bool from, uint64_t *stream)
{
    static double column[MOST_ROWS][PAIRS], start[2][PAIRS], loc[2][PAIRS], gap[PAIRS];
    static struct subject s[PAIRS];
    static int scratch[PAIRS], status[PAIRS];
    const int n = 1 + draw_choose(stream, PAIRS);
    const double *x[MOST_ROWS];
    for (int i = 0; i < PAIRS; i++) {
        double at[2] = {0, 0}, last[2];
        draw_subject(stream, kind, (enum curved_group)(i % CURVED_GROUPS), &s[i]);
        for (int k = 0; over && k < kind->nodes; k++)
            memcpy(s[i].face.x[k], s[0].face.x[k], sizeof s[i].face.x[k]);
        s[i].unit = judged_unit(&s[i].face);
        scratch[i] = f->scratch(s[i].x, s[i].xs, at, &gap[i]);
        draw_start(stream, at, last);
        for (int k = 0; k < 2; k++)
            start[k][i] = loc[k][i] = last[k];
        status[i] = 77;
        for (int row = 0; row < 3 * (kind->nodes + 1); row++) {
            column[row][i] = s[i].face.x[row / 3][row % 3];
            x[row] = column[row];
        }
    }
    if (over)
        (from ? f->from_over_n : f->over_n)(s[0].x, (size_t)n, x + 3 * kind->nodes, loc[0], loc[1], gap, status);
    else
        (from ? f->from_n : f->checked_n)((size_t)n, x, loc[0], loc[1], gap, status);
    for (int i = 0; i < PAIRS; i++) {
        const double last[2] = {start[0][i], start[1][i]}, found[2] = {loc[0][i], loc[1][i]};
        if (i < n)
            judge(&s[i], f, from ? last : found, scratch[i], status[i], found);
        else
            assert_true(status[i] == 77 && memcmp(last, found, sizeof last) == 0);
    }
}

static void test_arrays(void **state)
{
    uint64_t stream = 6302;
    (void)state;
    for (int j = 0; j < COUNT; j++)
        for (int k = 0; k < CASE_KINDS; k++)
            if (is_of(&functions[j], &curved_kinds[k]))
                for (long i = 0; i < (cases() + CASES - 1) / CASES; i += 10)
                    for (int way = 0; way < 4; way++)
                        arrays(&functions[j], &curved_kinds[k], way / 2, way % 2, &stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moves),
        cmocka_unit_test(test_arrays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
