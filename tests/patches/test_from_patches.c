/* Checks searches on patches from the last answer. If they return FOOTPOINT_OK or FOOTPOINT_OUTSIDE, a minimum of the
 * distance must lie within NAME_PROMISE; they must return one of these if NAME does. Starts are off by 1e-6 to 10
 * patches, or are no numbers; in calls, in arrays of any length and over one patch. Arrays are searched from scratch,
 * too. With FOOTPOINT_LONG a million calls. */
#include "../../generated/footpoint_bezier.h"
#include "../../generated/footpoint_gregory.h"
#include "../../generated/footpoint_paper_gregory.h"
#include "../hard/draw.h"
#include "../support/kind_arguments.h"
#include "../support/long_cases.h"
#include "drawn_patches.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>

#include <cmocka.h>

enum { CASES = 50, CASES_LONG = 15000, PAIRS = 45, ROWS = 3 * PATCH_VECTORS };

static long cases(void)
{
    return long_cases(CASES, CASES_LONG);
}

#define FUNCTIONS(F)                                                                                                   \
    F(0, bezier_facet, BEZIER_FACET)                                                                                   \
    F(0, bezier_smooth, BEZIER_SMOOTH)                                                                                 \
    F(0, bezier_precise, BEZIER_PRECISE)                                                                               \
    F(0, bezier_full, BEZIER_FULL)                                                                                     \
    F(1, gregory_facet, GREGORY_FACET)                                                                                 \
    F(1, gregory_normals, GREGORY_NORMALS)                                                                             \
    F(1, gregory_smooth, GREGORY_SMOOTH)                                                                               \
    F(1, gregory_corrected, GREGORY_CORRECTED)                                                                         \
    F(1, gregory_exact, GREGORY_EXACT)                                                                                 \
    F(1, gregory_full, GREGORY_FULL)                                                                                   \
    F(1, paper_gregory_smooth, PAPER_GREGORY_SMOOTH)                                                                   \
    F(1, paper_gregory_precise, PAPER_GREGORY_PRECISE)

#define WRAP(kind, name, capitals)                                                                                     \
    static int scratch_##name(const double *const *x, double loc[2], double *gap)                                      \
    {                                                                                                                  \
        return footpoint_##name(NODES_OF_gregory(x, x[8]), loc, gap);                                                  \
    }                                                                                                                  \
    static int from_##name(const double *const *x, double loc[2], double *gap)                                         \
    {                                                                                                                  \
        return footpoint_##name##_from(NODES_OF_gregory(x, x[8]), loc, gap);                                           \
    }
FUNCTIONS(WRAP)

typedef int search(const double *const *x, double loc[2], double *gap);
typedef void pairs(size_t n, const double *const *x, double *xi, double *eta, double *gap, int *status);
typedef void slaves(const double *const *nodes, size_t n, const double *const *x, double *xi, double *eta, double *gap,
                    int *status);
static const struct function {
    int kind;
    const char *name;
    double promise;
    search *scratch, *from;
    pairs *checked_n, *from_n;
    slaves *over_n, *from_over_n;
} functions[] = {
#define ROW(kind, name, capitals)                                                                                      \
    {kind,                                                                                                             \
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

/* Holds a patch and the judge's view of it. */
struct subject {
    struct patch_case f, unit;
    struct patch_net net;
    const double *x[PATCH_VECTORS];
    patch_wide known[2];
    bool is_known;
};

static void view(struct subject *s)
{
    s->unit = patch_unit(&s->f);
    patch_net_make(&s->unit, &s->net);
    s->is_known = false;
    for (int v = 0; v < PATCH_VECTORS; v++)
        s->x[v] = s->f.x[v];
}

/* Draws a last answer: the foot point moved by 1e-6 to 10 patches of width 2, or sometimes no number. */
static void draw_start(uint64_t *stream, const double loc[2], double start[2])
{
    const double moved = draw_power(stream, -6, 1.3);
    const int odd = draw_choose(stream, 30);
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
    for (int v = 0; v < PATCH_VECTORS; v++)
        print_error("{%a, %a, %a},\n", s->f.x[v][0], s->f.x[v][1], s->f.x[v][2]);
    fail_msg("%s, %s: from (%a, %a) to (%a, %a)", f->name, what, start[0], start[1], loc[0], loc[1]);
}

static bool is_proof(int status)
{
    return status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE;
}

/* Judges an answer with its `status`; `scratch` is the status of the search from scratch. */
static void judge(struct subject *s, const struct function *f, const double start[2], int scratch, int status,
                  const double loc[2])
{
    if (is_proof(scratch) && !is_proof(status))
        fail_on(s, f, "lost", start, loc);
    if (status < 0 && (memcmp(start, loc, 2 * sizeof *loc) != 0 || scratch != status))
        fail_on(s, f, "an error of its own", start, loc);
    if (is_proof(status) && !patch_answer_holds(&s->unit, &s->net, status, loc, f->promise, s->known, &s->is_known))
        fail_on(s, f, "wrong", start, loc);
}

static void test_moves(void **state)
{
    uint64_t stream = 6401;
    (void)state;
    for (int kind = 0; kind < 2; kind++)
        for (long i = 0; i < PATCH_GROUPS * cases(); i++) {
            struct subject s = {.f.kind = kind};
            patch_draw(&stream, (enum patch_group)(i % PATCH_GROUPS), &s.f);
            view(&s);
            for (int j = COUNT; j-- > 0;) {
                const struct function *const f = &functions[j];
                double loc[2] = {0, 0}, start[2], gap = 0;
                if (f->kind != kind)
                    continue;
                const int scratch = f->scratch(s.x, loc, &gap);
                draw_start(&stream, loc, start);
                memcpy(loc, start, sizeof loc);
                const int status = f->from(s.x, loc, &gap);
                judge(&s, f, start, scratch, status, loc);
            }
        }
}

/* Searches some of these pairs, or their slave nodes over the first patch, from the last answers or from scratch, and
 * judges the answers. Nothing else is written. */
static void arrays(const struct function *f, bool over, bool from, uint64_t *stream)
{
    static double column[ROWS][PAIRS], start[2][PAIRS], loc[2][PAIRS], gap[PAIRS];
    static struct subject s[PAIRS];
    static int scratch[PAIRS], status[PAIRS];
    const int n = 1 + draw_choose(stream, PAIRS);
    const double *x[ROWS];
    for (int i = 0; i < PAIRS; i++) {
        double at[2] = {0, 0}, last[2];
        s[i].f.kind = f->kind;
        patch_draw(stream, (enum patch_group)(i % PATCH_GROUPS), &s[i].f);
        if (over)
            memcpy(s[i].f.x, s[0].f.x, 8 * sizeof *s[i].f.x);
        view(&s[i]);
        scratch[i] = f->scratch(s[i].x, at, &gap[i]);
        draw_start(stream, at, last);
        for (int k = 0; k < 2; k++)
            start[k][i] = loc[k][i] = last[k];
        status[i] = 77;
        for (int row = 0; row < ROWS; row++) {
            column[row][i] = s[i].f.x[row / 3][row % 3];
            x[row] = column[row];
        }
    }
    if (over)
        (from ? f->from_over_n : f->over_n)(s[0].x, (size_t)n, x + 24, loc[0], loc[1], gap, status);
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
    uint64_t stream = 6402;
    (void)state;
    for (int j = 0; j < COUNT; j++)
        for (long i = 0; i < (cases() + CASES - 1) / CASES; i++)
            for (int way = 0; way < 4; way++)
                arrays(&functions[j], way / 2, way % 2, &stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_moves),
        cmocka_unit_test(test_arrays),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
