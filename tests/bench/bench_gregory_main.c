/* Speed and error of hand-written searches on Gregory patches, on held-out samples of the paper's data set and of
 * smooth bodies; and the distance of facets and smoothed surfaces from those bodies.
 *
 * ns: independent searches, median over rounds in which the methods take turns, from nodes and node normals, and on
 * prepared patches. Errors pool |xi - xi_ref| and |eta - eta_ref|. */
#include "../../codegen/base/base.h"
#include "../../evolve/samples/bodies.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"
#include "../support/error_stats.h"
#include "../support/smooth_bodies.h"
#include "bench_gregory.h"

#include <math.h>
#include <stdlib.h>
#include <time.h>

enum { SAMPLES = 20000, BLOCK = 250, TIMED = 40 * BLOCK, REPEATS = 4, ROUNDS = 15, METHODS = 32 };

static struct gregory_input inputs[SAMPLES];
static struct rival_patch patches[SAMPLES];
static struct footpoint_gregory plain[SAMPLES];
static double answer[SAMPLES][2];

/* Returns processor time, which excludes other processes. */
static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x, size_t n)
{
    qsort(x, n, sizeof *x, ascending);
    return x[n / 2];
}

/* Measures ns per search of each method: [0] from nodes and normals, [1] on prepared patches. */
static void time_methods(enum rival_start start, double ns[METHODS][2])
{
    static double time[METHODS][2][ROUNDS];
    for (int round = 0; round < ROUNDS; round++)
        for (int turn = 0; turn < 2 * gregory_method_count; turn++) {
            const int m = (turn / 2 + round) % gregory_method_count, ready = turn % 2;
            const double from = seconds();
            for (size_t k = 0; k < TIMED / BLOCK * REPEATS;
                 k++) { /* a block is searched repeatedly while it is in the cache */
                const size_t at = k / REPEATS * BLOCK;
                const struct gregory_ready made = {patches + at, plain + at};
                gregory_methods[m].search(inputs + at, ready ? &made : NULL, BLOCK, start, answer);
            }
            time[m][ready][round] = 1e9 * (seconds() - from) / (TIMED * REPEATS);
        }
    for (int m = 0; m < gregory_method_count; m++)
        for (int ready = 0; ready < 2; ready++)
            ns[m][ready] = median(time[m][ready], ROUNDS);
}

static void bench_set(const char *name, const struct sample_set *set, enum rival_start start)
{
    static double error[2 * SAMPLES], ns[METHODS][2];
    const size_t count = set->n < SAMPLES ? set->n : SAMPLES;
    for (size_t i = 0; i < count; i++) {
        for (int k = 0; k < 12; k++) {
            inputs[i].x[k / 3][k % 3] = set->s[i].x[k / 3][k % 3];
            inputs[i].n[k / 3][k % 3] = set->s[i].x[4 + k / 3][k % 3];
            inputs[i].xs[k % 3] = set->s[i].xs[k % 3];
        }
        rival_patch_of((const double(*)[3])inputs[i].x, (const double(*)[3])inputs[i].n, &patches[i]);
        footpoint_gregory_points((const double(*)[3])inputs[i].x, (const double(*)[3])inputs[i].n, &plain[i]);
    }
    time_methods(start, ns);
    for (int m = 0; m < gregory_method_count; m++) {
        gregory_methods[m].search(inputs, NULL, count, start, answer);
        for (size_t i = 0; i < count; i++) {
            const bool none = answer[i][0] == GREGORY_NO_ANSWER;
            error[2 * i] = none ? INFINITY : fabs(answer[i][0] - set->s[i].xi);
            error[2 * i + 1] = none ? INFINITY : fabs(answer[i][1] - set->s[i].eta);
        }
        const struct error_stats e = error_stats_of(error, 2 * count);
        printf("%s,%zu,%s,%.1f,%.1f,%.2e,%.2e,%.2e,%zu\n", name, count, gregory_methods[m].name, ns[m][0], ns[m][1],
               e.mean, e.p99, e.max, e.failures);
    }
}

/* ---- distance from the body ---- */

enum smooth_surface { FACET, BEZIER, GREGORY, GREGORY_EXACT, SURFACES };
static const char *const surface_name[SURFACES] = {"facets", "bezier (44)", "gregory (44)", "gregory"};

static void point_of(enum smooth_surface surface, const struct smooth_mesh *m, size_t segment, double xi, double eta,
                     double r[3])
{
    struct footpoint_gregory patch;
    struct footpoint_jet jet;
    double x[4][3], n[4][3];
    smooth_segment(m, segment, surface == GREGORY_EXACT ? m->exact : m->mean, x, n);
    footpoint_gregory_points((const double(*)[3])x, (const double(*)[3])n, &patch);
    if (surface == FACET)
        footpoint_quad4_position(x[0], x[1], x[2], x[3], xi, eta, r);
    else if (surface != BEZIER)
        footpoint_gregory_position(&patch, xi, eta, r);
    else {
        struct footpoint_bezier bezier;
        footpoint_bezier_points((const double(*)[3])x, (const double(*)[3])n, &bezier);
        footpoint_bezier_jet(&bezier, xi, eta, &jet);
        for (int k = 0; k < 3; k++)
            r[k] = bezier.origin[k] + jet.r[k];
    }
}

static void compare_surfaces(enum smooth_kind kind, int n, double jitter)
{
    enum { GRID = 8, POINTS = (GRID + 1) * (GRID + 1) };
    struct smooth_mesh *m = smooth_mesh_new(kind, n, jitter, 1);
    double *error = new_array(POINTS * m->segments, sizeof *error);
    for (int surface = 0; surface < SURFACES; surface++) {
        for (size_t i = 0; i < m->segments; i++)
            for (size_t k = 0; k < POINTS; k++) {
                double r[3], foot[3], normal[3];
                point_of((enum smooth_surface)surface, m, i, 2.0 * (double)(k / (GRID + 1)) / GRID - 1,
                         2.0 * (double)(k % (GRID + 1)) / GRID - 1, r);
                error[i * POINTS + k] = fabs(smooth_project(kind, r, foot, normal));
            }
        const struct error_stats e = error_stats_of(error, POINTS * m->segments);
        printf("%s,%zu,%.1f,%s,%.2e,%.2e,%.2e\n", smooth_name[kind], m->segments, jitter, surface_name[surface], e.mean,
               e.p99, e.max);
    }
    free(error);
    smooth_mesh_free(m);
}

int main(void)
{
    static const int size[SMOOTH_KINDS] = {8, 16, 8, 16};
    struct sample_set paper = {0}, bodies = {0};
    struct diag d;
    puts("body,segments,jitter,surface,mean_distance,p99_distance,max_distance");
    for (int kind = 0; kind < SMOOTH_KINDS; kind++) {
        compare_surfaces((enum smooth_kind)kind, size[kind], 0);
        compare_surfaces((enum smooth_kind)kind, 2 * size[kind], 0);
        compare_surfaces((enum smooth_kind)kind, size[kind], 0.2);
    }
    struct scene *scene = scene_read(".", "paper-quad4", &d);
    const struct scene smooth = smooth_bodies("gregory", 1, SAMPLES);
    if (scene) {
        enum { SETS = 20 };
        scene->segment = segment_find("gregory");
        scene->lattice.normal_sets = SETS;
        scene->lattice.tilt = 0.2;
        scene->training *= SETS;
        scene->heldout = SAMPLES / 16 * SETS;
    }
    if (!scene || !scene_samples(scene, PART_HELDOUT, &paper, &d) ||
        !scene_samples(&smooth, PART_HELDOUT, &bodies, &d)) {
        fprintf(stderr, "%s\n", d.text);
        return (int)d.code;
    }
    puts("set,samples,method,ns,ns_ready,mean,p99,max,failures");
    bench_set("paper", &paper, RIVAL_QUARTER);
    bench_set("bodies", &bodies, RIVAL_CENTRE);
    sample_set_free(&paper);
    sample_set_free(&bodies);
    scene_free(scene);
    return EXIT_DONE;
}
