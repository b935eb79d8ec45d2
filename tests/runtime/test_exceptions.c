/* Floating-point exceptions, traps, flush-to-zero: each statement of the sections "Floating-point exceptions" of
 * generated/README.md and runtime/README.md, on faces of all kinds, with random shapes, slave nodes and sizes. */
#define _GNU_SOURCE /* feenableexcept */

#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri3.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint_face.h"
#include "../support/kind_arguments.h"

#include <fenv.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>
#if defined(__x86_64__)
#include <xmmintrin.h>
#endif

#include <cmocka.h>

enum { ALIKE = 9 }; /* pairs of an array, more than loops search one by one */
enum { SAMPLES = 200, TRAPPED = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW, MOST_NODES = 9, FTZ_DAZ = 0x8040 };

/* All outputs of the functions. */
static struct {
    double loc[2], gap, rows[9 * 30 + 90 + 465];
    int region;
    size_t which;
} out;

typedef int function(int kind, double (*x)[3]);

/* ---- the functions ---- */

#define FUNCTIONS(kind, tier)                                                                                          \
    static int search_##kind(double(*x)[3])                                                                            \
    {                                                                                                                  \
        return footpoint_##kind##_##tier(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), out.loc, &out.gap);             \
    }                                                                                                                  \
    static int checked_##kind(double(*x)[3])                                                                           \
    {                                                                                                                  \
        double many[3 * VECTORS_OF_##kind][ALIKE], xi[ALIKE], eta[ALIKE], gap[ALIKE];                                  \
        const double *column[3 * VECTORS_OF_##kind];                                                                   \
        int status[ALIKE];                                                                                             \
        for (int i = 0; i < 3 * VECTORS_OF_##kind; i++) {                                                              \
            column[i] = many[i];                                                                                       \
            for (int k = 0; k < ALIKE; k++)                                                                            \
                many[i][k] = x[i / 3][i % 3];                                                                          \
        }                                                                                                              \
        footpoint_##kind##_##tier##_checked_n(ALIKE, column, xi, eta, gap, status);                                    \
        out.loc[0] = xi[0];                                                                                            \
        out.loc[1] = eta[0];                                                                                           \
        out.gap = gap[0];                                                                                              \
        return status[0];                                                                                              \
    }                                                                                                                  \
    static int closest_##kind(double(*x)[3])                                                                           \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), out.loc, &out.gap,    \
                                                   &out.region);                                                       \
    }                                                                                                                  \
    static int nearest_##kind(double(*x)[3])                                                                           \
    {                                                                                                                  \
        const double *node[2 * VECTORS_OF_##kind];                                                                     \
        for (int i = 0; i < VECTORS_OF_##kind - 1; i++)                                                                \
            node[i] = node[i + VECTORS_OF_##kind - 1] = x[i];                                                          \
        return footpoint_##kind##_##tier##_closest_of(2, node, x[VECTORS_OF_##kind - 1], out.loc, &out.gap,            \
                                                      &out.region, &out.which);                                        \
    }                                                                                                                  \
    static int along_##kind(double(*x)[3])                                                                             \
    {                                                                                                                  \
        const double direction[3] = {0.1, 0.2, 1};                                                                     \
        return footpoint_##kind##_along(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), direction, out.loc, &out.gap);   \
    }
FUNCTIONS(tri3, exact)
FUNCTIONS(tri6, accurate)
FUNCTIONS(quad4, full)
FUNCTIONS(quad8, full)
FUNCTIONS(quad9, full)

#define OF_KINDS(name)                                                                                                 \
    static int name(int kind, double(*x)[3])                                                                           \
    {                                                                                                                  \
        static int (*const of[])(double(*)[3]) = {name##_tri3, name##_tri6, name##_quad4, name##_quad8, name##_quad9}; \
        return of[kind](x);                                                                                            \
    }
OF_KINDS(search)
OF_KINDS(checked)
OF_KINDS(closest)
OF_KINDS(nearest)
OF_KINDS(along)

static const double place[2] = {0.2, 0.3};
#define FACE (enum footpoint_face) kind, x[0]

static int face_locate(int kind, double (*x)[3])
{
    return footpoint_face_locate(FACE, out.loc, &out.gap);
}

static int face_closest(int kind, double (*x)[3])
{
    return footpoint_face_closest(FACE, out.loc, &out.gap, &out.region);
}

static int face_robust(int kind, double (*x)[3])
{
    return footpoint_face_robust(FACE, out.loc, &out.gap, &out.region);
}

static int face_place(int kind, double (*x)[3])
{
    double *o = out.rows;
    return footpoint_face_place(FACE, place, o, o + 9, o + 12, o + 15, &out.gap);
}

static int face_differentiate(int kind, double (*x)[3])
{
    double *o = out.rows;
    return footpoint_face_differentiate(FACE, place, o, o + 9, o + 12, o + 15, &out.gap, o + 18, o + 48, o + 78);
}

static int face_hessian(int kind, double (*x)[3])
{
    double *o = out.rows;
    return footpoint_face_hessian(FACE, place, &out.gap, o, o + 30, o + 60, o + 90, o + 180);
}

#define CORNERS x[0], x[1], x[2], x[3], x[4]

static int locate(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_locate(CORNERS, out.loc, &out.gap) : 0;
}

static int robust(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_robust(CORNERS, out.loc, &out.gap) : 0;
}

static int stationary(int kind, double (*x)[3])
{
    double loc[FOOTPOINT_STATIONARY_MOST][2];
    return kind == FOOTPOINT_QUAD4 ? footpoint_stationary(CORNERS, loc, &out.region) : 0;
}

static int certify(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_certify(CORNERS, place, out.rows) : 0;
}

static int newton(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_newton(CORNERS, 20, 1e-12, out.loc, &out.gap, NULL) : 0;
}

static int balanced(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_force_balanced(CORNERS, place, 1, out.rows, (double(*)[3])(out.rows + 3))
                                   : 0;
}

static int normal(int kind, double (*x)[3])
{
    return kind == FOOTPOINT_QUAD4 ? footpoint_normal(x[0], x[1], x[3], out.rows) : 0;
}

static int select_closest(int kind, double (*x)[3])
{
    static const int seg[8] = {0, 1, 2, 3, 0, 1, 2, 3};
    return kind == FOOTPOINT_QUAD4 ? footpoint_select_closest(x[0], 0, 2, seg, x[4], &out.region, &out.gap) : 0;
}

/* SOUND: no exceptions on collapsed quads and NaN, either. PROVED: nor at any size. */
enum { SOUND = 1, PROVED = 2 };

static const struct {
    const char *name;
    function *call;
    int promise;
} functions[] = {{"NAME", search, SOUND},
                 {"NAME_checked_n", checked, SOUND},
                 {"NAME_closest", closest, 0},
                 {"NAME_closest_of", nearest, 0},
                 {"along", along, 0},
                 {"face_locate", face_locate, SOUND},
                 {"face_closest", face_closest, 0},
                 {"face_robust", face_robust, 0},
                 {"place", face_place, SOUND},
                 {"gradients", face_differentiate, SOUND},
                 {"hessian", face_hessian, SOUND},
                 {"locate", locate, SOUND},
                 {"robust", robust, PROVED},
                 {"stationary", stationary, PROVED},
                 {"certify", certify, PROVED},
                 {"newton", newton, SOUND},
                 {"force_balanced", balanced, SOUND},
                 {"normal", normal, SOUND},
                 {"select_closest", select_closest, 0}};
enum { FUNCTIONS_IN_ALL = sizeof functions / sizeof *functions };

/* ---- faces ---- */

enum family { ORDINARY, FAR, ON_NODE, COLLAPSED, NOT_A_NUMBER, LINE, INFINITE, FAMILIES };

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

static void draw(uint64_t *stream, int kind, enum family family, double size, double (*x)[3])
{
    static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    const int nodes = footpoint_face_nodes((enum footpoint_face)kind);
    const double along[3] = {uniform(stream), uniform(stream), uniform(stream)};
    for (int i = 0; i < nodes; i++) {
        const double *at = kind < FOOTPOINT_QUAD4 ? triangle[i] : square[i], t = uniform(stream);
        for (int k = 0; k < 3; k++)
            x[i][k] = family == LINE ? t * along[k] : (k < 2 ? at[k] : 0) + 0.15 * (uniform(stream) - 0.5);
    }
    for (int k = 0; k < 3; k++)
        x[nodes][k] = family == FAR ? 10 * (uniform(stream) - 0.5) : (k < 2 ? 0.1 : -0.15) + 0.3 * uniform(stream);
    const int some = (int)((nodes + 1) * uniform(stream));
    if (family == ON_NODE)
        memcpy(x[nodes], x[some % nodes], sizeof x[nodes]);
    if (family == COLLAPSED && kind >= FOOTPOINT_QUAD4) {
        memcpy(x[3], x[2], sizeof x[3]);
        if (nodes > 4)
            memcpy(x[6], x[2], sizeof x[6]);
    }
    for (int i = 0; i < 3 * (nodes + 1); i++)
        x[i / 3][i % 3] *= size;
    if (family == NOT_A_NUMBER || family == INFINITE)
        x[some][1] = family == INFINITE ? INFINITY : NAN;
}

/* ---- tests ---- */

static void expect_quiet(int f, enum family family, double size)
{
    uint64_t stream = 20248;
    for (int kind = 0; kind < FOOTPOINT_FACES; kind++)
        for (int sample = 0; sample < SAMPLES; sample++) {
            double x[MOST_NODES + 1][3];
            draw(&stream, kind, family, size, x);
            feclearexcept(FE_ALL_EXCEPT);
            (void)functions[f].call(kind, x);
            if (fetestexcept(TRAPPED))
                fail_msg("%s, kind %d, family %d, size %g: exceptions %x", functions[f].name, kind, (int)family, size,
                         (unsigned)fetestexcept(TRAPPED));
        }
}

static void ordinary_faces_raise_nothing(void **state)
{
    static const double sizes[] = {1, 1e-20, 1e5};
    (void)state;
    for (int f = 0; f < FUNCTIONS_IN_ALL; f++)
        for (int i = 0; i < 3; i++)
            for (int family = ORDINARY; family <= ON_NODE; family++)
                expect_quiet(f, (enum family)family, sizes[i]);
}

static void sound_functions_raise_nothing(void **state)
{
    static const double sizes[] = {1, 1e-300, 1e-150, 1e150, 1e300};
    (void)state;
    for (int f = 0; f < FUNCTIONS_IN_ALL; f++)
        for (int family = ORDINARY; functions[f].promise && family <= NOT_A_NUMBER; family++)
            for (int i = 0; i < (functions[f].promise == PROVED ? 5 : 1); i++)
                expect_quiet(f, (enum family)family, sizes[i]);
}

/* Over arrays, steps from last answers that run away raise nothing: on two warped faces, from a point of the face and
 * from NaN. */
static void last_answers_raise_nothing(void **state)
{
    static const double warped[2][17] = {
        {0.61635044592138599, 4.3748542843299445, 4.6130996984559118, 1.0998162459293561, -1.5047118771638119,
         -3.3631382500045728, -0.57794707030576742, -1.220655428417518, -1.9287885551246127, -1.1382196215449747,
         2.056841226383324, 3.4652950349735088, 0.66342213832624874, -1.4021416899856056, -2.5815582430470672,
         -0.84581624489737983, -0.49077827863309609},
        {-1.6843962103265309, -0.0099976965614381186, 1.5885060021463753, 2.7577978290447596, 0.293227634540141,
         1.5606357993207451, 1.4080593024407004, 1.6775475517009861, 1.5885060021463753, -2.4814609211589289,
         1.9807728828025652, 1.5606357993207451, 0.54258311219177124, 0.27405972998712824, 1.6258046279763025, NAN,
         0.45499641649098232}};
    (void)state;
    for (int f = 0; f < 2; f++) {
        double many[17][ALIKE - 1], gap[ALIKE - 1];
        const double *column[15];
        int status[ALIKE - 1];
        for (int i = 0; i < 17; i++)
            for (int k = 0; k < ALIKE - 1; k++)
                many[i][k] = warped[f][i];
        for (int i = 0; i < 15; i++)
            column[i] = many[i];
        feclearexcept(FE_ALL_EXCEPT);
        (f ? footpoint_quad4_full_from_n : footpoint_quad4_precise_from_n)(ALIKE - 1, column, many[15], many[16], gap,
                                                                           status);
        assert_false(fetestexcept(TRAPPED));
        assert_int_equal(status[0], FOOTPOINT_OK);
    }
}

/* With traps on, calls between held environments do not stop the program, and flags stay unchanged. */
static void held_environments_keep_traps_off(void **state)
{
    static const double sizes[] = {1, 1e-300, 1e-150, 1e150, 1e300};
    uint64_t stream = 20249;
    (void)state;
#if defined(__GLIBC__) && defined(__x86_64__)
    feclearexcept(FE_ALL_EXCEPT);
    feenableexcept(TRAPPED);
    for (int f = 0; f < FUNCTIONS_IN_ALL; f++)
        for (int kind = 0; kind < FOOTPOINT_FACES; kind++)
            for (int sample = 0; sample < SAMPLES; sample++) {
                double x[MOST_NODES + 1][3];
                fenv_t mine;
                draw(&stream, kind, (enum family)(sample % FAMILIES), sizes[sample / FAMILIES % 5], x);
                feholdexcept(&mine);
                (void)functions[f].call(kind, x);
                fesetenv(&mine);
                assert_int_equal(fetestexcept(TRAPPED), 0);
            }
    fedisableexcept(TRAPPED);
#else
    (void)stream;
    (void)sizes;
    skip();
#endif
}

#if defined(__x86_64__)
static int call_to(int f, int kind, double (*x)[3], unsigned mode)
{
    const unsigned control = _mm_getcsr();
    memset(&out, 0, sizeof out);
    _mm_setcsr(control | mode);
    const int status = functions[f].call(kind, x);
    _mm_setcsr(control);
    return status;
}
#endif

/* Flush-to-zero and denormals-are-zero change no bit of ordinary faces, and no status from 1e-250 to 1e300. */
static void denormal_numbers_do_not_matter(void **state)
{
    static const double sizes[] = {1, 1e-20, 1e5, 1e-100, 1e-250, 1e150, 1e300};
    (void)state;
#if defined(__x86_64__)
    for (int f = 0; f < FUNCTIONS_IN_ALL; f++)
        for (int i = 0; i < 7; i++) {
            uint64_t stream = 20250;
            for (int sample = 0; sample < SAMPLES; sample++) {
                const int kind = sample % FOOTPOINT_FACES;
                double x[MOST_NODES + 1][3];
                draw(&stream, kind, (enum family)(sample / FOOTPOINT_FACES % (ON_NODE + 1)), sizes[i], x);
                const int status = call_to(f, kind, x, 0);
                static char bytes[sizeof out];
                memcpy(bytes, &out, sizeof out);
                assert_int_equal(call_to(f, kind, x, FTZ_DAZ), status);
                assert_true(i > 2 || memcmp(bytes, &out, sizeof out) == 0);
            }
        }
#else
    (void)sizes;
    skip();
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ordinary_faces_raise_nothing),   cmocka_unit_test(sound_functions_raise_nothing),
        cmocka_unit_test(last_answers_raise_nothing),     cmocka_unit_test(held_environments_keep_traps_off),
        cmocka_unit_test(denormal_numbers_do_not_matter),
    };
    return cmocka_run_group_tests_name("exceptions", tests, NULL, NULL);
}
