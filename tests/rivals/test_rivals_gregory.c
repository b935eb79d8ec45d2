/* The hand-written searches on Gregory patches use the same surface as the runtime and find the reference's foot
 * points. */
#include "../../codegen/base/base.h"
#include "rivals_gregory.h"

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../support/smooth_bodies.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static struct sample_set samples;

static int setup(void **state)
{
    (void)state;
    const struct scene scene = smooth_bodies("gregory", 5, 2000);
    struct diag d;
    return scene_samples(&scene, PART_TRAINING, &samples, &d) ? 0 : -1;
}

static int teardown(void **state)
{
    (void)state;
    sample_set_free(&samples);
    return 0;
}

static void compare(rival_lanes ours, const double theirs[3], double factor, double tolerance)
{
    for (int k = 0; k < 3; k++)
        assert_true(fabs(ours[k] - factor * theirs[k]) <= tolerance);
}

static void jets_match_the_runtime(void **state)
{
    (void)state;
    for (size_t i = 0; i < samples.n; i++) {
        const double(*x)[3] = (const double(*)[3])samples.s[i].x, (*n)[3] = x + 4;
        /* corners, too, except for second derivatives, which are 0/0 there */
        const int corner = i % 100 == 0;
        const double xi = corner ? -1 : samples.s[i].xi, eta = corner ? 1 : samples.s[i].eta;
        struct footpoint_gregory g;
        struct footpoint_jet jet;
        struct rival_patch patch;
        struct rival_jet fast;
        assert_int_equal(footpoint_gregory_points(x, n, &g), FOOTPOINT_OK);
        footpoint_gregory_jet(&g, xi, eta, &jet);
        rival_patch_of(x, n, &patch);
        rival_patch_jet(&patch, 0.5 + 0.5 * xi, 0.5 + 0.5 * eta, 1, &fast);
        assert_memory_equal(patch.origin, g.net.origin, sizeof patch.origin);
        compare(fast.r, jet.r, 1, 1e-14);
        compare(fast.u, jet.r_xi, 2, 1e-13);
        compare(fast.v, jet.r_eta, 2, 1e-13);
        if (corner)
            continue;
        compare(fast.uu, jet.r_xixi, 4, 1e-12);
        compare(fast.uv, jet.r_xieta, 4, 1e-12);
        compare(fast.vv, jet.r_etaeta, 4, 1e-12);
    }
}

/* Jets of Bezier patches are right, and Newton's iteration ends at the certain foot point. */
static void bezier_patches_match_the_runtime(void **state)
{
    const struct scene scene = smooth_bodies("bezier", 6, 1000);
    struct diag d;
    struct sample_set set = {0};
    size_t converged = 0;
    (void)state;
    assert_true(scene_samples(&scene, PART_TRAINING, &set, &d));
    for (size_t i = 0; i < set.n; i++) {
        const struct sample *s = &set.s[i];
        const double(*x)[3] = (const double(*)[3])s->x, (*n)[3] = x + 4;
        struct footpoint_bezier b;
        struct footpoint_jet jet;
        struct rival_patch patch;
        struct rival_jet fast;
        struct rival_point p = rival_facet_foot(x, n, s->xs, RIVAL_CENTRE);
        assert_int_equal(footpoint_bezier_points(x, n, &b), FOOTPOINT_OK);
        footpoint_bezier_jet(&b, s->xi, s->eta, &jet);
        rival_bezier_of(x, n, &patch);
        rival_patch_jet(&patch, 0.5 + 0.5 * s->xi, 0.5 + 0.5 * s->eta, 1, &fast);
        compare(fast.r, jet.r, 1, 1e-14);
        compare(fast.u, jet.r_xi, 2, 1e-13);
        compare(fast.v, jet.r_eta, 2, 1e-13);
        compare(fast.uu, jet.r_xixi, 4, 1e-12);
        compare(fast.uv, jet.r_xieta, 4, 1e-12);
        compare(fast.vv, jet.r_etaeta, 4, 1e-12);
        if (rival_patch_converge(&patch, s->xs, 0, 50, 1e-10, &p) &&
            fabs(2 * p.u - 1 - s->xi) + fabs(2 * p.v - 1 - s->eta) < 1e-12)
            converged++;
    }
    assert_true(converged >= set.n - 2);
    sample_set_free(&set);
}

static void searches_match_the_reference(void **state)
{
    (void)state;
    double miss[3] = {0}, along_normals = 0;
    size_t converged = 0, near = 0;
    for (size_t i = 0; i < samples.n; i++) {
        const struct sample *s = &samples.s[i];
        const double u = 0.5 + 0.5 * s->xi, v = 0.5 + 0.5 * s->eta;
        struct rival_patch patch;
        struct rival_point p = rival_facet_foot((const double(*)[3])s->x, (const double(*)[3])s->x + 4, s->xs,
                                                RIVAL_CENTRE),
                           q;
        rival_patch_of((const double(*)[3])s->x, (const double(*)[3])s->x + 4, &patch);
        miss[0] += fabs(p.u - u) + fabs(p.v - v);
        q = rival_patch_steps(&patch, s->xs, 1, 0, p);
        miss[1] += fabs(q.u - u) + fabs(q.v - v);
        q = rival_patch_steps(&patch, s->xs, 2, 0, p);
        miss[2] += fabs(q.u - u) + fabs(q.v - v);
        q = rival_patch_steps(&patch, s->xs, 0, 3, p);
        near += fabs(q.u - u) + fabs(q.v - v) < 1e-5;
        q = rival_normal_foot((const double(*)[3])s->x, (const double(*)[3])s->x + 4, s->xs, RIVAL_CENTRE);
        along_normals += fabs(q.u - u) + fabs(q.v - v);
        if (rival_patch_converge(&patch, s->xs, 0, 50, 1e-10, &p) && fabs(p.u - u) + fabs(p.v - v) < 1e-12)
            converged++;
    }
    assert_true(converged >= samples.n - 2);
    assert_true(near >= samples.n * 99 / 100);
    assert_true(along_normals < 0.5 * miss[0]);
    assert_true(miss[1] < 0.2 * miss[0] && miss[2] < 0.2 * miss[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(jets_match_the_runtime),
                                       cmocka_unit_test(bezier_patches_match_the_runtime),
                                       cmocka_unit_test(searches_match_the_reference)};
    return cmocka_run_group_tests_name("rivals_gregory", tests, setup, teardown);
}
