/* The methods of the bench of Gregory patches, all compiled with the same flags; see rivals_gregory.h. newton_plain is
 * Newton's iteration as usually written; the others avoid redundant operations. */
#include "bench_gregory.h"

#include <math.h>

#define TOLERANCE 1e-10

enum { MOST_STEPS = 50 };

/* Compilers must assume that memory changes between samples, so they cannot join searches. */
#define NEXT_SAMPLE __asm__ volatile("" ::: "memory")

/* `steps` moves p, a point of `patch`, from the facet's foot point or the foot point along the normals. The result
 * counts if `steps` is not 0. */
#define DEFINE_SEARCH(name, from, steps)                                                                               \
    __attribute__((noinline, flatten)) static void search_##name(const struct gregory_input *restrict in,              \
                                                                 const struct gregory_ready *ready, size_t count,      \
                                                                 enum rival_start start, double(*restrict found)[2])   \
    {                                                                                                                  \
        for (size_t i = 0; i < count; i++) {                                                                           \
            struct rival_patch made;                                                                                   \
            const struct rival_patch *patch = ready ? &ready->patch[i] : &made;                                        \
            struct rival_point p = start == RIVAL_CENTRE                                                               \
                                       ? rival_##from##_foot(in[i].x, in[i].n, in[i].xs, RIVAL_CENTRE)                 \
                                       : rival_##from##_foot(in[i].x, in[i].n, in[i].xs, RIVAL_QUARTER);               \
            if (!ready)                                                                                                \
                rival_patch_of(in[i].x, in[i].n, &made);                                                               \
            const int stands = (steps);                                                                                \
            found[i][0] = stands ? 2 * p.u - 1 : GREGORY_NO_ANSWER;                                                    \
            found[i][1] = stands ? 2 * p.v - 1 : GREGORY_NO_ANSWER;                                                    \
            NEXT_SAMPLE;                                                                                               \
        }                                                                                                              \
    }

/* Runs Newton's iteration as usually written, on the runtime's own evaluation. Returns true if it converges. */
static int newton_plain(const struct footpoint_gregory *patch, const double xs[3], struct rival_point *p)
{
    for (int i = 0; i < MOST_STEPS; i++) {
        struct footpoint_jet jet;
        double f1 = 0, f2 = 0, k11 = 0, k12 = 0, k22 = 0;
        footpoint_gregory_jet(patch, 2 * p->u - 1, 2 * p->v - 1, &jet);
        for (int k = 0; k < 3; k++) {
            const double d = xs[k] - patch->net.origin[k] - jet.r[k];
            f1 += jet.r_xi[k] * d;
            f2 += jet.r_eta[k] * d;
            k11 += jet.r_xi[k] * jet.r_xi[k] - jet.r_xixi[k] * d;
            k12 += jet.r_xi[k] * jet.r_eta[k] - jet.r_xieta[k] * d;
            k22 += jet.r_eta[k] * jet.r_eta[k] - jet.r_etaeta[k] * d;
        }
        const struct rival_point move = rival_solve(k11, k12, k22, f1, f2, 0.5), before = *p;
        p->u = rival_between(0, p->u + move.u, 1);
        p->v = rival_between(0, p->v + move.v, 1);
        if (fabs(p->u - before.u) <= TOLERANCE && fabs(p->v - before.v) <= TOLERANCE)
            return 1;
    }
    return 0;
}

static int newton_plain_of(const struct gregory_input *in, const struct footpoint_gregory *ready, struct rival_point *p)
{
    struct footpoint_gregory made;
    if (!ready && footpoint_gregory_points((const double(*)[3])in->x, (const double(*)[3])in->n, &made) != FOOTPOINT_OK)
        return 0;
    return newton_plain(ready ? ready : &made, in->xs, p);
}

#define FIXED(gauss_newton, newton) (p = rival_patch_steps(patch, in[i].xs, gauss_newton, newton, p), 1)
#define CONVERGED(gauss_newton, tolerance)                                                                             \
    rival_patch_converge(patch, in[i].xs, gauss_newton, MOST_STEPS, tolerance, &p)

#define METHODS(M)                                                                                                     \
    M(facet_foot, facet, ((void)patch, 1))                                                                             \
    M(normal_foot, normal, ((void)patch, 1))                                                                           \
    M(gn1, facet, FIXED(1, 0))                                                                                         \
    M(gn2, facet, FIXED(2, 0))                                                                                         \
    M(gn3, facet, FIXED(3, 0))                                                                                         \
    M(n1, facet, FIXED(0, 1))                                                                                          \
    M(n2, facet, FIXED(0, 2))                                                                                          \
    M(n3, facet, FIXED(0, 3))                                                                                          \
    M(normal_gn1, normal, FIXED(1, 0))                                                                                 \
    M(normal_gn2, normal, FIXED(2, 0))                                                                                 \
    M(normal_n1, normal, FIXED(0, 1))                                                                                  \
    M(normal_n2, normal, FIXED(0, 2))                                                                                  \
    M(newton, facet, CONVERGED(0, TOLERANCE))                                                                          \
    M(newton_loose, facet, CONVERGED(0, 1e-5))                                                                         \
    M(normal_newton, normal, CONVERGED(0, TOLERANCE))                                                                  \
    M(normal_newton_loose, normal, CONVERGED(0, 1e-5))                                                                 \
    M(gn_newton, facet, CONVERGED(2, TOLERANCE))                                                                       \
    M(gauss_newton, facet, CONVERGED(MOST_STEPS, TOLERANCE))                                                           \
    M(newton_plain, facet, ((void)patch, newton_plain_of(&in[i], ready ? &ready->plain[i] : NULL, &p)))

METHODS(DEFINE_SEARCH)

#define LIST_SEARCH(name, from, steps) {#name, search_##name},
const struct gregory_method gregory_methods[] = {METHODS(LIST_SEARCH)};
const int gregory_method_count = sizeof gregory_methods / sizeof *gregory_methods;
