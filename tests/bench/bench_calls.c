/* Searches of the bench as callers use them: checked, closest point of the face, along a direction, with derivatives.
 * The generated functions come from calls.inc, the others are hand-written; converged Newton comes first for each
 * question. Compiled like bench_methods.c, once for each instruction set. In calls, a function is called for each
 * sample. Over arrays, a generated loop is called for a block, and hand-written searches are looped over. */
#include "bench_methods.h"

#include "bench_loops.h"

#include "../../runtime/footpoint.h"
#include "../../runtime/footpoint_batch.h"
#include "../../runtime/footpoint_face.h"
#include "../../runtime/geometry/footpoint-quad8-geometry.h"
#include "../../runtime/geometry/footpoint-quad9-geometry.h"
#include "../../runtime/geometry/footpoint-tri3-geometry.h"
#include "../../runtime/geometry/footpoint-tri6-geometry.h"
#include "../rivals/rivals_along.h"
#include "../rivals/rivals_derivatives.h"
#include "../rivals/rivals_from.h"
#include "../support/kind_arguments.h"
#include "calls.h"

#include <string.h>

/* CalculiX's name for its search. */
void attach_2d_(const double pneigh[9][3], double pnode[3], const int *nterms, double ratio[9], double *dist,
                double *xil, double *etl);

/* `call` uses x, the vectors, and writes loc and gap, and s for derivatives. It leaves loc untouched if it has no
 * answer. */
#define DEFINE_ONE(name, call)                                                                                         \
    SCALAR_FN(name)                                                                                                    \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        for (size_t i = 0; i < n; i++) {                                                                               \
            const double(*x)[3] = (const double(*)[3])in[i].x;                                                         \
            double loc[2] = {BENCH_NO_ANSWER, BENCH_NO_ANSWER}, gap = 0;                                               \
            double(*const s)[SEGMENT_INPUTS] = slope[i];                                                               \
            if (!s) /* compilers see that no row is NULL, as with a caller's arrays */                                 \
                __builtin_unreachable();                                                                               \
            call;                                                                                                      \
            found[i][0] = loc[0];                                                                                      \
            found[i][1] = loc[1];                                                                                      \
            found[i][2] = gap;                                                                                         \
            NEXT_SAMPLE(loc[0], loc[1], gap);                                                                          \
        }                                                                                                              \
    }
/* The arguments after the name use x, columns, and block b. */
#define DEFINE_MANY(name, ...)                                                                                         \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        const double *x[BENCH_COLUMNS];                                                                                \
        (void)t;                                                                                                       \
        for (int k = 0; k < BENCH_COLUMNS; k++)                                                                        \
            x[k] = b->x[k];                                                                                            \
        __VA_ARGS__;                                                                                                   \
    }
/* Hand-written searches; `found` is true if there is an answer. */
#define DEFINE_LOOP(name, found, derivatives)                                                                          \
    BATCH_FN(name)                                                                                                     \
    {                                                                                                                  \
        (void)t;                                                                                                       \
        for (int i = 0; i < BENCH_BLOCK; i++) {                                                                        \
            const double x[BENCH_VECTORS][3] = GATHERED_ALL;                                                           \
            double loc[2] = {0, 0}, gap = 0, s[BENCH_FOUND][SEGMENT_INPUTS];                                           \
            b->status[i] = (found) ? FOOTPOINT_OK : FOOTPOINT_ERR_NO_CONVERGENCE;                                      \
            b->xi[i] = loc[0];                                                                                         \
            b->eta[i] = loc[1];                                                                                        \
            b->gap[i] = gap;                                                                                           \
            for (int o = 0; o < BENCH_FOUND && b->status[i] == FOOTPOINT_OK; o++)                                      \
                for (int k = 0; k < (derivatives); k++)                                                                \
                    b->rows->slope[o][k * BENCH_BLOCK + i] = s[o][k];                                                  \
        }                                                                                                              \
    }
#define NO_ANSWER loc[0] = loc[1] = BENCH_NO_ANSWER
#define DEFINE_BY_HAND(name, found, derivatives)                                                                       \
    DEFINE_ONE(name, if (!(found)) NO_ANSWER)                                                                          \
    DEFINE_LOOP(name, found, derivatives)

/* ---- by hand ---- */

#define NODES(kind) NODES_OF_##kind(x, x[VECTORS_OF_##kind - 1])
#define DIRECTION(kind) x[VECTORS_OF_##kind]

/* Copies xi, eta and distance of a search along a direction. */
static inline int found_along(int found, const double at[3], double loc[2], double *dist)
{
    loc[0] = at[0];
    loc[1] = at[1];
    *dist = at[2];
    return found;
}

static inline int along_quad4(const double (*x)[3], double loc[2], double *dist)
{
    double at[3];
    return found_along(rival_along_newton(x, x[5], RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, at), at, loc, dist);
}

static inline int along_tri3(const double (*x)[3], double loc[2], double *dist)
{
    double at[3];
    return found_along(rival_along_tri3(x, x[4], at), at, loc, dist);
}

static inline int implicit_quad4(const double (*x)[3], double loc[2], double *gap, double (*s)[SEGMENT_INPUTS])
{
    return rival_quad4_search(x, loc) && rival_implicit(x, loc, gap, s);
}

#define DEFINE_IMPLICIT(kind, vectors)                                                                                 \
    static inline int implicit_##kind(const double(*x)[3], double loc[2], double *gap, double(*s)[SEGMENT_INPUTS])     \
    {                                                                                                                  \
        double phi[6 * SEGMENT_VECTORS];                                                                               \
        if (!rival_##kind##_search(x, loc))                                                                            \
            return 0;                                                                                                  \
        footpoint_##kind##_shape(loc[0], loc[1], phi);                                                                 \
        return rival_implicit_face((vectors)-1, phi, x, gap, s);                                                       \
    }
DEFINE_IMPLICIT(tri3, 4)
RIVAL_FACES(DEFINE_IMPLICIT)

#define DEFINE_ALONG(kind, vectors)                                                                                    \
    static inline int along_##kind(const double(*x)[3], double loc[2], double *dist)                                   \
    {                                                                                                                  \
        struct rival_face f;                                                                                           \
        double at[3];                                                                                                  \
        rival_face_##kind(x, 1, &f);                                                                                   \
        return found_along(rival_along_face(&f, x[vectors], RIVAL_STEPS_MAX, RIVAL_NEWTON_TOLERANCE, at), at, loc,     \
                           dist);                                                                                      \
    }
RIVAL_FACES(DEFINE_ALONG)

static inline int attach(const double (*x)[3], int nodes, double loc[2], double *dist)
{
    double xs[3] = {x[nodes][0], x[nodes][1], x[nodes][2]}, ratio[SEGMENT_VECTORS];
    attach_2d_(x, xs, &nodes, ratio, dist, &loc[0], &loc[1]);
    return 1;
}

/* R(kind, name, question, found, number of coordinates for derivatives) */
#define SAME(R, kind, newton)                                                                                          \
    R(kind, newton##_checked, ASK_CHECKED, rival_##kind##_checked(x, loc, &gap), 0)                                    \
    R(kind, newton##_over, ASK_OVER, rival_##kind##_checked(x, loc, &gap), 0)                                          \
    R(kind, newton##_clamped, ASK_CLOSEST, rival_##kind##_clamped(x, loc, &gap), 0)                                    \
    R(kind, newton##_along, ASK_ALONG, along_##kind(x, loc, &gap), 0)                                                  \
    R(kind, newton##_implicit, ASK_DERIVATIVES, implicit_##kind(x, loc, &gap, s), 3 * VECTORS_OF_##kind)               \
    R(kind, newton##_differences, ASK_DERIVATIVES,                                                                     \
      rival_differences(VECTORS_OF_##kind, x, RIVAL_DIFFERENCE, rival_##kind##_checked, loc, &gap, s),                 \
      3 * VECTORS_OF_##kind)
#define BY_HAND(R)                                                                                                     \
    SAME(R, quad4, newton)                                                                                             \
    R(quad4, four_triangles, ASK_CLOSEST, rival_quad4_triangles(x, loc, &gap), 0)                                      \
    R(quad4, newton_forward, ASK_DERIVATIVES, rival_forward(x, loc, &gap, s), 15)                                      \
    SAME(R, tri3, tri3_areas)                                                                                          \
    R(tri3, tri3_regions, ASK_CLOSEST, rival_tri3_regions(x, loc, &gap), 0)                                            \
    SAME(R, tri6, tri6_newton)                                                                                         \
    SAME(R, quad8, quad8_newton)                                                                                       \
    SAME(R, quad9, quad9_newton)                                                                                       \
    R(gregory, patch_newton_checked, ASK_CHECKED, rival_patch_checked(x, 0, loc, &gap), 0)                             \
    R(bezier, bezier_patch_newton_checked, ASK_CHECKED, rival_patch_checked(x, 1, loc, &gap), 0)
#define DEFINE(kind, name, question, found, derivatives) DEFINE_BY_HAND(name, found, derivatives)
BY_HAND(DEFINE)
#undef DEFINE

#define DEFINE_FAIR(name, over)                                                                                        \
    DEFINE_ONE(name, if (!rival_fair_checked(x, loc, &gap)) NO_ANSWER)                                                 \
    DEFINE_MANY(                                                                                                       \
        name, for (int first = 0; first < BENCH_BLOCK; first += NEWTON_LANES) {                                        \
            const double *lane[15];                                                                                    \
            int answered[NEWTON_LANES];                                                                                \
            for (int k = 0; k < 15; k++)                                                                               \
                lane[k] = x[k] + first;                                                                                \
            newton_lanes_fair(lane, over, b->xi + first, b->eta + first, b->gap + first, answered);                    \
            for (int i = 0; i < NEWTON_LANES; i++)                                                                     \
                b->status[first + i] = answered[i] ? FOOTPOINT_OK : FOOTPOINT_ERR_NO_CONVERGENCE;                      \
        })
DEFINE_FAIR(newton_fair_checked, 1)
DEFINE_FAIR(newton_fair_over, BENCH_OVER)

/* ---- by hand, from the last answer ---- */

/* The last answer of a call. */
#define LAST loc[0] = in[i].before[0], loc[1] = in[i].before[1]
#define DEFINE_FROM_CALLS(name, found) DEFINE_ONE(name, LAST; if (!(found)) NO_ANSWER)
#define DEFINE_FROM_LOOP(name, found)                                                                                  \
    DEFINE_FROM_CALLS(name, found)                                                                                     \
    DEFINE_LOOP(name, (loc[0] = b->before[0][i], loc[1] = b->before[1][i], found), 0)
#define DEFINE_FROM_LANES(name, tolerance, fair)                                                                       \
    DEFINE_FROM_CALLS(name, rival_quad4_from(x, tolerance, loc, &gap))                                                 \
    DEFINE_MANY(                                                                                                       \
        name, for (int first = 0; first < BENCH_BLOCK; first += NEWTON_LANES) {                                        \
            const double *lane[15];                                                                                    \
            int answered[NEWTON_LANES];                                                                                \
            for (int k = 0; k < 15; k++)                                                                               \
                lane[k] = x[k] + first;                                                                                \
            newton_lanes_from(lane, tolerance, b->before[0] + first, b->before[1] + first, b->xi + first,              \
                              b->eta + first, b->gap + first, answered);                                               \
            for (int i = 0; i < NEWTON_LANES; i++)                                                                     \
                b->status[first + i] = answered[i] ? FOOTPOINT_OK : FOOTPOINT_ERR_NO_CONVERGENCE;                      \
        })
/* R(name, tolerance, whether fair) and R(kind, name, found, whether fair). Newton to 1e-10 comes first for each
 * kind. */
#define FROM_LANES(R)                                                                                                  \
    R(newton_from, RIVAL_NEWTON_TOLERANCE, 0)                                                                          \
    R(newton_fair_from, RIVAL_FAIR_TOLERANCE, 1)                                                                       \
    R(newton_loose_from, RIVAL_NEWTON_LOOSE, 0)
#define FROM_CURVED(R, kind)                                                                                           \
    R(kind, kind##_newton_from, rival_##kind##_from(x, RIVAL_NEWTON_TOLERANCE, loc, &gap), 0)                          \
    R(kind, kind##_newton_fair_from, rival_##kind##_from(x, RIVAL_FAIR_TOLERANCE, loc, &gap), 1)
#define FROM_PATCH(R, kind, name, bezier)                                                                              \
    R(kind, name##_newton_from, rival_patch_from(x, bezier, RIVAL_NEWTON_TOLERANCE, loc, &gap), 0)                     \
    R(kind, name##_newton_fair_from, rival_patch_from(x, bezier, RIVAL_FAIR_TOLERANCE, loc, &gap), 1)
#define FROM_LOOPS(R)                                                                                                  \
    R(quad4, newton_1_from, rival_quad4_from_fixed(x, RIVAL_FROM_NEWTON, loc, &gap), 0)                                \
    R(quad4, newton_2_from, rival_quad4_from_fixed(x, RIVAL_FROM_NEWTON_TWICE, loc, &gap), 0)                          \
    R(quad4, chebyshev_from, rival_quad4_from_fixed(x, RIVAL_FROM_CHEBYSHEV, loc, &gap), 0)                            \
    FROM_CURVED(R, tri6)                                                                                               \
    FROM_CURVED(R, quad8)                                                                                              \
    FROM_CURVED(R, quad9)                                                                                              \
    FROM_PATCH(R, gregory, patch, 0)                                                                                   \
    FROM_PATCH(R, bezier, bezier_patch, 1)
#define DEFINE(kind, name, found, fair) DEFINE_FROM_LOOP(name, found)
FROM_LANES(DEFINE_FROM_LANES)
FROM_LOOPS(DEFINE)
#undef DEFINE

/* ---- the library ---- */

DEFINE_ONE(footpoint_locate, (void)footpoint_locate(NODES(quad4), loc, &gap))
BATCH_FN(footpoint_locate)
{
    /* In search i, the coordinates of vector k are element i of columns 3 k to 3 k + 2. */
    static int seg[BENCH_BLOCK][4], slave[BENCH_BLOCK];
    for (int i = BENCH_BLOCK - 1; i >= 0 && !slave[0]; i--) {
        for (int k = 0; k < 4; k++)
            seg[i][k] = 3 * BENCH_COLUMN * k + i;
        slave[i] = 3 * BENCH_COLUMN * 4 + i;
    }
    const struct footpoint_pairs pairs = {.n = BENCH_BLOCK,
                                          .nodes = sizeof b->x / sizeof b->x[0][0],
                                          .x = b->x[0],
                                          .y = b->x[1],
                                          .z = b->x[2],
                                          .stride = 1,
                                          .seg = seg[0],
                                          .slave = slave,
                                          .sure = 1};
    double loc[BENCH_BLOCK][2];
    (void)t;
    (void)footpoint_locate_batch(&pairs, FOOTPOINT_ACCURATE, loc[0], b->gap, b->status);
    for (int i = 0; i < BENCH_BLOCK; i++) {
        b->xi[i] = loc[i][0];
        b->eta[i] = loc[i][1];
    }
}
DEFINE_ONE(footpoint_robust, (void)footpoint_robust(NODES(quad4), loc, &gap))
#define FACE_ROBUST(kind, KIND)                                                                                        \
    DEFINE_ONE(kind##_robust, int region; (void)footpoint_face_robust(FOOTPOINT_##KIND, x[0], loc, &gap, &region))
FACE_ROBUST(tri3, TRI3)
FACE_ROBUST(tri6, TRI6)
FACE_ROBUST(quad8, QUAD8)
FACE_ROBUST(quad9, QUAD9)
DEFINE_ONE(tri6_attach_2d, attach(x, 6, loc, &gap))
DEFINE_ONE(quad8_attach_2d, attach(x, 8, loc, &gap))
DEFINE_ONE(footpoint_differentiate, {
    struct footpoint_derivatives d;
    if (footpoint_quad4_accurate(NODES(quad4), loc, &gap) == FOOTPOINT_OK &&
        footpoint_differentiate(NODES(quad4), loc, &d) == FOOTPOINT_OK) {
        memcpy(s[0], d.d_xi, sizeof d.d_xi);
        memcpy(s[1], d.d_eta, sizeof d.d_eta);
        memcpy(s[2], d.d_gap, sizeof d.d_gap);
    } else
        NO_ANSWER;
})

/* ---- generated ---- */

#define CHECKED(scene, kind, name)                                                                                     \
    DEFINE_ONE(name##_checked, (void)name(NODES(kind), loc, &gap))                                                     \
    DEFINE_MANY(name##_checked, name##_checked_n(BENCH_BLOCK, x, b->xi, b->eta, b->gap, b->status))
#define OVER(scene, kind, name)                                                                                        \
    DEFINE_ONE(name##_over, (void)name(NODES(kind), loc, &gap))                                                        \
    DEFINE_MANY(                                                                                                       \
        name##_over, for (int i = 0; i < BENCH_BLOCK; i += BENCH_OVER) {                                               \
            const double node[BENCH_VECTORS][3] = GATHERED_ALL;                                                        \
            const double *nodes[VECTORS_OF_##kind - 1], *slaves[3];                                                    \
            for (int k = 0; k < VECTORS_OF_##kind - 1; k++)                                                            \
                nodes[k] = node[k];                                                                                    \
            for (int k = 0; k < 3; k++)                                                                                \
                slaves[k] = x[3 * (VECTORS_OF_##kind - 1) + k] + i;                                                    \
            name##_over_n(nodes, BENCH_OVER, slaves, b->xi + i, b->eta + i, b->gap + i, b->status + i);                \
        })
/* Answers replace the last answers, so a loop over arrays begins with a copy. */
#define FROM(scene, kind, name)                                                                                        \
    DEFINE_FROM_CALLS(name##_from, name##_from(NODES(kind), loc, &gap) >= 0)                                           \
    DEFINE_MANY(name##_from, memcpy(b->xi, b->before[0], sizeof b->xi); memcpy(b->eta, b->before[1], sizeof b->eta);   \
                name##_from_n(BENCH_BLOCK, x, b->xi, b->eta, b->gap, b->status))
#define CLOSEST(scene, kind, name)                                                                                     \
    DEFINE_ONE(name##_closest, int region; (void)name##_closest(NODES(kind), loc, &gap, &region))                      \
    DEFINE_MANY(name##_closest, name##_closest_n(BENCH_BLOCK, x, b->xi, b->eta, b->gap, b->region, b->status))
#define ALONG(scene, kind, name)                                                                                       \
    DEFINE_ONE(name##_along, (void)name##_along(NODES(kind), DIRECTION(kind), loc, &gap))                              \
    DEFINE_MANY(name##_along,                                                                                          \
                name##_along_n(BENCH_BLOCK, x, x + 3 * VECTORS_OF_##kind, b->xi, b->eta, b->gap, b->status))
#define JOINED_WITH(KIND, name) FOOTPOINT_##KIND##_GRADIENTS_OF(name) FOOTPOINT_##KIND##_HESSIAN_OF(name)
/* The bench discards second derivatives after they are computed. */
#define DERIVATIVES(scene, kind, KIND, name)                                                                           \
    JOINED_WITH(KIND, name)                                                                                            \
    DEFINE_ONE(name##_gradients,                                                                                       \
               (void)name##_gradients(NODES(kind), loc, NULL, NULL, NULL, NULL, &gap, s[0], s[1], s[2]))               \
    DEFINE_MANY(name##_gradients,                                                                                      \
                name##_gradients_n(BENCH_BLOCK, x, b->xi, b->eta, b->rows->rest[0], b->rows->rest[1],                  \
                                   b->rows->rest[2], b->rows->rest[3], b->gap, b->rows->slope[0], b->rows->slope[1],   \
                                   b->rows->slope[2], b->status))                                                      \
    DEFINE_ONE(name##_hessian, static double packed[SEGMENT_INPUTS * (SEGMENT_INPUTS + 1) / 2];                        \
               (void)name##_hessian(NODES(kind), loc, &gap, s[0], s[1], s[2], NULL, packed))
#include "calls.inc"
#undef CHECKED
#undef OVER
#undef FROM
#undef CLOSEST
#undef ALONG
#undef DERIVATIVES

/* ---- the table ---- */

#define OURS(scene_, kind_, name_, question_)                                                                          \
    .name = #name_, .kind = #kind_, .scene = scene_, .ours = 1, .question = question_, .scalar = scalar_##name_
#define ROW(kind_, name_, question_, found, derivatives)                                                               \
    {.name = #name_, .kind = #kind_, .question = question_, .scalar = scalar_##name_, .batch = batch_##name_},
#define FAIR(name_, question_)                                                                                         \
    {.name = #name_,                                                                                                   \
     .kind = "quad4",                                                                                                  \
     .fair = 1,                                                                                                        \
     .question = question_,                                                                                            \
     .scalar = scalar_##name_,                                                                                         \
     .batch = batch_##name_},
#define CHECKED(scene, kind, name) {OURS(scene, kind, name##_checked, ASK_CHECKED), .batch = batch_##name##_checked},
#define OVER(scene, kind, name) {OURS(scene, kind, name##_over, ASK_OVER), .batch = batch_##name##_over},
#define MOVED(name_, kind_, question_, move, ...)                                                                      \
    {.name = #name_ move,                                                                                              \
     .kind = #kind_,                                                                                                   \
     .question = question_,                                                                                            \
     .scalar = scalar_##name_,                                                                                         \
     .batch = batch_##name_,                                                                                           \
     __VA_ARGS__},
#define MOVES(name, kind, ...)                                                                                         \
    MOVED(name, kind, ASK_FROM_NEAR, "_1e-3", __VA_ARGS__)                                                             \
    MOVED(name, kind, ASK_FROM, "_1e-2", __VA_ARGS__)                                                                  \
    MOVED(name, kind, ASK_FROM_FAR, "_1e-1", __VA_ARGS__)
#define FROM(scene_, kind, name) MOVES(name##_from, kind, .scene = scene_, .ours = 1)
#define FROM_LOOPS_ROW(kind, name, found, fair_) MOVES(name, kind, .fair = fair_)
#define FROM_LANES_ROW(name, tolerance, fair_) MOVES(name, quad4, .fair = fair_)
#define CLOSEST(scene, kind, name) {OURS(scene, kind, name##_closest, ASK_CLOSEST), .batch = batch_##name##_closest},
#define ALONG(scene, kind, name) {OURS(scene, kind, name##_along, ASK_ALONG), .batch = batch_##name##_along},
#define DERIVATIVES(scene, kind, KIND, name)                                                                           \
    {OURS(scene, kind, name##_gradients, ASK_DERIVATIVES), .batch = batch_##name##_gradients},                         \
        {OURS(scene, kind, name##_hessian, ASK_DERIVATIVES)},

static const struct bench_method calls[] = {
    BY_HAND(ROW) FAIR(newton_fair_checked, ASK_CHECKED) FAIR(newton_fair_over, ASK_OVER) FROM_LANES(FROM_LANES_ROW)
        FROM_LOOPS(FROM_LOOPS_ROW) //
    {OURS("quad4", quad4, footpoint_locate, ASK_CHECKED), .batch = batch_footpoint_locate},
    {OURS("quad4", quad4, footpoint_robust, ASK_CLOSEST)},
    {OURS("quad4", quad4, footpoint_differentiate, ASK_DERIVATIVES)},
    {OURS("tri3", tri3, tri3_robust, ASK_CLOSEST)},
    {OURS("tri6", tri6, tri6_robust, ASK_CLOSEST)},
    {OURS("quad8", quad8, quad8_robust, ASK_CLOSEST)},
    {OURS("quad9", quad9, quad9_robust, ASK_CLOSEST)},
    {OURS("tri6", tri6, tri6_attach_2d, ASK_CLOSEST)},
    {OURS("quad8", quad8, quad8_attach_2d, ASK_CLOSEST)},
#include "calls.inc"
};

extern const struct bench_list OF_ISA(bench_calls_);
const struct bench_list OF_ISA(bench_calls_) = {calls, (int)(sizeof calls / sizeof *calls)};
