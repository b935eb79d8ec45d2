/* The bare searches of the bench, compiled once for each instruction set BENCH_ISA with the same flags for all methods.
 * Each search is inlined twice: in a loop over structures of one sample, which may not be vectorised across samples
 * (calls, dependent or not), and in a loop over columns, which may (arrays). bench_calls.c has the other questions.
 *
 * To add a rival, write it in its own header with FOOTPOINT_REAL as its scalar, list it there, and name the list in
 * METHODS below and in count_rivals.cpp. */
#include "bench_methods.h"

#include "bench_loops.h"

#include "../rivals/newton_lanes.h"
#include "../rivals/pinball.h"
#include "../rivals/rivals_closed.h"
#include "../rivals/rivals_faces.h"
#include "../rivals/rivals_patches.h"
#include "../rivals/trust_region.h"
#include "../support/kind_arguments.h"
#include "footpoint_perceptron.h"
#include "methods.h"

/* `search` uses xA ... xS, t, &xi and &eta; xi and eta contain the last step's answer. */
#define DEFINE_SCALAR(name, search)                                                                                    \
    SCALAR_FN(name)                                                                                                    \
    {                                                                                                                  \
        (void)t, (void)slope;                                                                                          \
        for (size_t i = 0; i < n; i++) {                                                                               \
            const double *xA = in[i].x[0], *xB = in[i].x[1], *xC = in[i].x[2], *xD = in[i].x[3], *xS = in[i].x[4];     \
            double xi = in[i].before[0], eta = in[i].before[1];                                                        \
            search;                                                                                                    \
            found[i][0] = xi;                                                                                          \
            found[i][1] = eta;                                                                                         \
            NEXT_SAMPLE(xi, eta, 0);                                                                                   \
        }                                                                                                              \
    }
#define DEFINE_BATCH(name, search)                                                                                     \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        for (int i = 0; i < BENCH_BLOCK; i++) {                                                                        \
            const double xA[3] = {b->x[0][i], b->x[1][i], b->x[2][i]}, xB[3] = {b->x[3][i], b->x[4][i], b->x[5][i]};   \
            const double xC[3] = {b->x[6][i], b->x[7][i], b->x[8][i]}, xD[3] = {b->x[9][i], b->x[10][i], b->x[11][i]}; \
            const double xS[3] = {b->x[12][i], b->x[13][i], b->x[14][i]};                                              \
            double xi, eta;                                                                                            \
            search;                                                                                                    \
            b->xi[i] = xi;                                                                                             \
            b->eta[i] = eta;                                                                                           \
        }                                                                                                              \
    }
#define DEFINE_METHOD(name, search) DEFINE_SCALAR(name, search) DEFINE_BATCH(name, search)

/* The same for any kind of segment; `search` uses x, the nodes and S. */
#define DEFINE_SCALAR_OF(name, search)                                                                                 \
    SCALAR_FN(name)                                                                                                    \
    {                                                                                                                  \
        (void)t, (void)slope;                                                                                          \
        for (size_t i = 0; i < n; i++) {                                                                               \
            const double(*x)[3] = (const double(*)[3])in[i].x;                                                         \
            double xi = 0, eta = 0;                                                                                    \
            search;                                                                                                    \
            found[i][0] = xi;                                                                                          \
            found[i][1] = eta;                                                                                         \
            NEXT_SAMPLE(xi, eta, 0);                                                                                   \
        }                                                                                                              \
    }
#define DEFINE_BATCH_OF(name, search)                                                                                  \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        for (int i = 0; i < BENCH_BLOCK; i++) {                                                                        \
            const double x[BENCH_VECTORS][3] = GATHERED_ALL;                                                           \
            double xi, eta;                                                                                            \
            search;                                                                                                    \
            b->xi[i] = xi;                                                                                             \
            b->eta[i] = eta;                                                                                           \
        }                                                                                                              \
    }
#define DEFINE_METHOD_OF(name, search) DEFINE_SCALAR_OF(name, search) DEFINE_BATCH_OF(name, search)

/* Patches, whose NAME_n is another search than their NAME_at. */
#define DEFINE_PATCH(name, search, search_n)                                                                           \
    DEFINE_SCALAR_OF(name, search)                                                                                     \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        const double *x[3 * BENCH_VECTORS];                                                                            \
        (void)t;                                                                                                       \
        for (int k = 0; k < 3 * BENCH_VECTORS; k++)                                                                    \
            x[k] = b->x[k];                                                                                            \
        search_n(BENCH_BLOCK, x, b->xi, b->eta);                                                                       \
    }

#define DEFINE_CONVERGED_OF(kind, vectors)                                                                             \
    static inline void found_##kind##_newton(const double(*x)[3], double *xi, double *eta)                             \
    {                                                                                                                  \
        if (rival_##kind##_newton(x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta) == 0)                           \
            *xi = *eta = BENCH_NO_ANSWER;                                                                              \
    }                                                                                                                  \
    static int steps_##kind##_newton(const struct bench_input *in, const struct rival_tuning *t)                       \
    {                                                                                                                  \
        double xi, eta;                                                                                                \
        (void)t;                                                                                                       \
        return rival_##kind##_newton(in->x, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, &xi, &eta);                       \
    }                                                                                                                  \
    DEFINE_METHOD_OF(kind##_newton, found_##kind##_newton(x, &xi, &eta))

/* Iterations until they converge: one sample, and the number of steps. */
#define DEFINE_CONVERGED(name, search)                                                                                 \
    static inline void found_##name(const double xA[3], const double xB[3], const double xC[3], const double xD[3],    \
                                    const double xS[3], const struct rival_tuning *t, double *xi, double *eta)         \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        if ((search) == 0)                                                                                             \
            *xi = *eta = BENCH_NO_ANSWER;                                                                              \
    }                                                                                                                  \
    static int steps_##name(const struct bench_input *in, const struct rival_tuning *t)                                \
    {                                                                                                                  \
        const double *xA = in->x[0], *xB = in->x[1], *xC = in->x[2], *xD = in->x[3], *xS = in->x[4];                   \
        double answer[2] = {in->before[0], in->before[1]}, *xi = &answer[0], *eta = &answer[1];                        \
        (void)t;                                                                                                       \
        return search;                                                                                                 \
    }                                                                                                                  \
    DEFINE_SCALAR(name, found_##name(xA, xB, xC, xD, xS, t, &xi, &eta))

/* The same by columns. */
#define DEFINE_LANES(name, start, tolerance)                                                                           \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        for (int first = 0; first < BENCH_BLOCK; first += NEWTON_LANES) {                                              \
            struct newton_lanes lanes;                                                                                 \
            const double *x[15];                                                                                       \
            for (int k = 0; k < 15; k++)                                                                               \
                x[k] = b->x[k] + first;                                                                                \
            for (int i = 0; start == NEWTON_LANES_GIVEN && i < NEWTON_LANES; i++) {                                    \
                lanes.u[i] = b->before[0][first + i];                                                                  \
                lanes.v[i] = b->before[1][first + i];                                                                  \
            }                                                                                                          \
            newton_lanes_read(&lanes, x, start);                                                                       \
            newton_lanes_run(&lanes, start, tolerance);                                                                \
            for (int i = 0; i < NEWTON_LANES; i++) {                                                                   \
                b->xi[first + i] = lanes.moving[i] > 0 ? BENCH_NO_ANSWER : lanes.u[i];                                 \
                b->eta[first + i] = lanes.moving[i] > 0 ? BENCH_NO_ANSWER : lanes.v[i];                                \
            }                                                                                                          \
        }                                                                                                              \
    }

#define NODES xA, xB, xC, xD, xS
DEFINE_CONVERGED(newton, rival_newton(NODES, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta))
DEFINE_CONVERGED(newton_fair, rival_newton_fair(NODES, RIVAL_FAIR_STEPS_MAX, RIVAL_FAIR_TOLERANCE, xi, eta))
DEFINE_CONVERGED(newton_loose, rival_newton(NODES, RIVAL_STEPS_MAX, RIVAL_NEWTON_LOOSE, xi, eta))
DEFINE_CONVERGED(newton_previous, rival_newton_from(NODES, RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta))
DEFINE_CONVERGED(trust_region, rival_trust_region(NODES, &t->box, RIVAL_STEPS_MAX, TRUST_REGION_TOLERANCE, xi, eta))
DEFINE_BATCH(newton, found_newton(NODES, t, &xi, &eta))
DEFINE_LANES(newton_fair, NEWTON_LANES_TAPER, RIVAL_FAIR_TOLERANCE)
DEFINE_LANES(newton_lanes, NEWTON_LANES_CENTRE, RIVAL_NEWTON_TOLERANCE)
DEFINE_LANES(newton_loose, NEWTON_LANES_CENTRE, RIVAL_NEWTON_LOOSE)
DEFINE_LANES(newton_previous, NEWTON_LANES_GIVEN, RIVAL_NEWTON_TOLERANCE)

#define ITERATION(name, start, gauss_newton, newton, clamped) DEFINE_METHOD(name, rival_##name(NODES, &xi, &eta))
#define CLOSED_FORM(name) DEFINE_METHOD(name, rival_##name(NODES, &xi, &eta))
#define TUNED_ITERATION(name, gauss_newton, newton, clamped) DEFINE_METHOD(name, rival_##name(NODES, t, &xi, &eta))
#define POLYNOMIAL(name, coefficients) DEFINE_METHOD(name, rival_##name(NODES, t, &xi, &eta))
#define FACE_ITERATION(name, kind, gauss_newton, newton) DEFINE_METHOD_OF(name, rival_##name(x, &xi, &eta))
#define METHOD(scene, kind, name, mul, div, add, sqrt, promise) METHOD_##kind(kind, name)
#define METHOD_OF(kind, name) DEFINE_METHOD_OF(name, name##_at(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), &xi, &eta))
#define METHOD_quad4(kind, name) DEFINE_METHOD(name, name##_at(NODES, &xi, &eta))
#define METHOD_tri3 METHOD_OF
#define METHOD_tri6 METHOD_OF
#define METHOD_quad8 METHOD_OF
#define METHOD_quad9 METHOD_OF
#define METHOD_PATCH(kind, name)                                                                                       \
    DEFINE_PATCH(name, name##_at(NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1]), &xi, &eta), name##_n)
#define METHOD_gregory METHOD_PATCH
#define METHOD_bezier METHOD_PATCH
#define PATCH_FIXED(kind, name, from, start, gauss_newton, newton) DEFINE_METHOD_OF(name, rival_##name(x, &xi, &eta))
#define PATCH_CONVERGED(kind, name, search) DEFINE_METHOD_OF(name, if ((search) == 0) xi = eta = BENCH_NO_ANSWER)
#define PATCH_CONVERGING_OF(R, kind, P, is)                                                                            \
    R(kind, P##patch_newton, rival_patch_newton(x, is, RIVAL_CENTRE, RIVAL_NEWTON_TOLERANCE, &xi, &eta))               \
    R(kind, P##patch_newton_plain, rival_patch_newton_plain(x, is, RIVAL_NEWTON_TOLERANCE, &xi, &eta))                 \
    R(kind, P##patch_newton_loose, rival_patch_newton(x, is, RIVAL_CENTRE, RIVAL_NEWTON_LOOSE, &xi, &eta))             \
    R(kind, P##quarter_newton, rival_patch_newton(x, is, RIVAL_QUARTER, RIVAL_NEWTON_TOLERANCE, &xi, &eta))            \
    R(kind, P##quarter_newton_loose, rival_patch_newton(x, is, RIVAL_QUARTER, RIVAL_NEWTON_LOOSE, &xi, &eta))
#define PATCH_CONVERGING(R) PATCH_CONVERGING_OF(R, gregory, , 0) PATCH_CONVERGING_OF(R, bezier, bezier_, 1)
RIVAL_ITERATIONS(ITERATION)
RIVAL_TUNED_ITERATIONS(TUNED_ITERATION)
RIVAL_KEPT(TUNED_ITERATION)
RIVAL_CLOSED_FORMS(CLOSED_FORM)
RIVAL_POLYNOMIALS(POLYNOMIAL)
CLOSED_FORM(pinball)
RIVAL_FACES(DEFINE_CONVERGED_OF)
RIVAL_FACE_ITERATIONS(FACE_ITERATION)
FACE_ITERATION(tri3_areas, tri3, 0, 0)
PATCH_CONVERGING(PATCH_CONVERGED)
RIVAL_PATCHES(PATCH_FIXED)
#include "footpoint_perceptron.inc"
#include "methods.inc"
#undef ITERATION
#undef FACE_ITERATION
#undef CLOSED_FORM
#undef TUNED_ITERATION
#undef POLYNOMIAL
#undef PATCH_FIXED
#undef PATCH_CONVERGED
#undef METHOD

/* defines ops_NAME and step_NAME of the rivals */
#include "rival_counts.inc"

#define LOOPS(name) .scalar = scalar_##name, .batch = batch_##name
#define RIVAL(name_) .name = #name_, .kind = "quad4", .ops = OPS_##name_, LOOPS(name_)
#define ITERATION(name, start_, gauss_newton, newton, clamped) {RIVAL(name), .start = start_},
#define CLOSED_FORM(name) {RIVAL(name)},
#define TUNED_ITERATION(name, gauss_newton, newton, clamped) {RIVAL(name), .tune = TUNE_POINT},
#define POLYNOMIAL(name, coefficients_) {RIVAL(name), .tune = TUNE_COEFFICIENTS, .coefficients = coefficients_},
#define CONVERGED(name) {RIVAL(name), .step = STEP_##name, .steps = steps_##name},
#define FACE(name_, kind_) .name = #name_, .kind = #kind_, .ops = OPS_##name_, LOOPS(name_)
#define FACE_CONVERGED(kind, vectors)                                                                                  \
    {FACE(kind##_newton, kind), .step = STEP_##kind##_newton, .steps = steps_##kind##_newton},
#define FACE_ITERATION(name, kind, gauss_newton, newton) {FACE(name, kind)},
#define PATCH(kind_, name_) {.name = #name_, .kind = #kind_, LOOPS(name_)},
#define PATCH_FIXED(kind, name, from, start, gauss_newton, newton) PATCH(kind, name)
#define PATCH_CONVERGED(kind, name, search) PATCH(kind, name)
#define METHOD(scene_, kind_, name_, mul, div, add, sqrt, promise)                                                     \
    {.name = #name_, .kind = #kind_, .scene = scene_, .ours = 1, .ops = {mul, div, add, sqrt}, LOOPS(name_)},
#define batch_trust_region NULL
/* In batches "newton", the usual iteration, is a loop of searches; the others step a batch together. */
#define scalar_newton_lanes scalar_newton
#define steps_newton_lanes steps_newton
#define OPS_newton_lanes OPS_newton
#define STEP_newton_lanes STEP_newton

static const struct bench_method methods[] = {
    CONVERGED(newton){RIVAL(newton_fair), .fair = 1, .step = STEP_newton_fair, .steps = steps_newton_fair},
    CONVERGED(newton_lanes) CONVERGED(newton_loose) CONVERGED(newton_previous) CONVERGED(trust_region)
        RIVAL_ITERATIONS(ITERATION) RIVAL_TUNED_ITERATIONS(TUNED_ITERATION) RIVAL_KEPT(TUNED_ITERATION)
            RIVAL_CLOSED_FORMS(CLOSED_FORM) RIVAL_POLYNOMIALS(POLYNOMIAL){RIVAL(pinball), .depth_only = 1},
    FACE_ITERATION(tri3_areas, tri3, 0, 0) RIVAL_FACES(FACE_CONVERGED) RIVAL_FACE_ITERATIONS(FACE_ITERATION)
        PATCH_CONVERGING(PATCH_CONVERGED) RIVAL_PATCHES(PATCH_FIXED)
#include "methods.inc"
#undef METHOD
/* Networks are named perceptron_hidden_8 and so on. */
#define METHOD(scene_, kind_, name_, mul, div, add, sqrt, promise)                                                     \
    {.name = &#name_[sizeof "footpoint"], .kind = #kind_, .scene = scene_, .ops = {mul, div, add, sqrt}, LOOPS(name_)},
#include "footpoint_perceptron.inc"
};

static const struct bench_list bare = {methods, (int)(sizeof methods / sizeof *methods)};
extern const struct bench_table OF_ISA(bench_table_);
#ifdef BENCH_BARE /* make front times only searches */
static const struct bench_list OF_ISA(bench_calls_);
#else
extern const struct bench_list OF_ISA(bench_calls_);
#endif
const struct bench_table OF_ISA(bench_table_) = {BENCH_ISA_NAME, BENCH_FLAGS, {&bare, &OF_ISA(bench_calls_)}};
