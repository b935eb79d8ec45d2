/* Digits far from the origin: segments move by a hundred, ten thousand and a million edges. The rounding errors of
 * every function, and of the gap, stay as for the same rounded coordinates relative to a node. The reference is the
 * function itself in long double. */
#include "../../evolve/samples/samples.h"
#include "../../evolve/surface/surface.h"
#include "../../runtime/footpoint.h"
#include "../support/error_stats.h"
#include "../support/long_cases.h"
#include "header_functions.h"
#include "headers_long.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MOVES = 3 };

/* Distances in edges; every coordinate moves. */
static const double far[MOVES] = {1e2, 1e4, 1e6}, way[3] = {0.61, -0.53, 0.59};

#define FACTOR 1.1   /* largest ratio of the errors far from the origin and at it, mean and 99 % */
#define OF_GAP 1e-15 /* over the length of an edge */

/* A moved sample; and the same relative to its first node, which is exact far from the origin. Normals stay. */
struct moved {
    double x[SEGMENT_VECTORS + 1][3], near[SEGMENT_VECTORS + 1][3], edge;
    const double *at[SEGMENT_VECTORS + 1], *near_at[SEGMENT_VECTORS + 1]; /* the slave node last */
};

/* Returns the number of held-out samples. The scene whole-quad4, whose errors vary most, needs the larger number and is
 * skipped with the smaller. */
static size_t samples(void)
{
    return (size_t)long_cases(500, 20000);
}

static void move(const struct segment_kind *kind, const struct sample *s, double edges, struct moved *m)
{
    const size_t vectors = segment_vectors(kind), nodes = strlen(kind->nodes);
    m->edge = 0;
    for (int k = 0; k < 3; k++)
        m->edge = hypot(m->edge, s->x[1][k] - s->x[0][k]);
    for (size_t i = 0; i <= vectors; i++)
        for (int k = 0; k < 3; k++) {
            const double here = i < vectors ? s->x[i][k] : s->xs[k];
            const bool point = i < nodes || i == vectors;
            m->x[i][k] = point ? here - s->x[0][k] + edges * m->edge * way[k] : here;
            m->near[i][k] = point ? m->x[i][k] - m->x[0][k] : here;
        }
    for (size_t i = 0; i <= vectors; i++) {
        m->at[i] = m->x[i];
        m->near_at[i] = m->near[i];
    }
}

/* Returns the larger error of xi and eta, far from the origin or at it. */
static double error_of(size_t method, size_t vectors, const struct moved *m, bool away)
{
    const double *const *x = away ? m->at : m->near_at;
    long double near[SEGMENT_VECTORS + 1][3], loc[2];
    const long double *at[SEGMENT_VECTORS + 1];
    double xi, eta;
    for (size_t i = 0; i <= vectors; i++) {
        for (int k = 0; k < 3; k++)
            near[i][k] = (long double)m->near[i][k];
        at[i] = near[i];
    }
    header_functions[method].at(x, x[vectors], &xi, &eta);
    headers_long[method](at, at[vectors], &loc[0], &loc[1]);
    return fmax(fabs(xi - (double)loc[0]), fabs(eta - (double)loc[1]));
}

static bool is_of_patch(size_t method)
{
    return strstr(header_functions[method].name, "gregory") || strstr(header_functions[method].name, "bezier");
}

/* Returns the number of answers that are not proved. */
static int check_gap(size_t method, size_t vectors, const struct moved *m, double edges)
{
    double loc[2], gap, near_loc[2], near_gap;
    const int status[2] = {header_functions[method].locate(m->at, m->at[vectors], loc, &gap),
                           header_functions[method].locate(m->near_at, m->near_at[vectors], near_loc, &near_gap)};
    for (int k = 0; k < 2; k++)
        assert_true(status[k] == FOOTPOINT_OK || status[k] == FOOTPOINT_UNPROVED ||
                    (is_of_patch(method) && status[k] >= FOOTPOINT_OK));
    if (!(fabs(gap - near_gap) <= OF_GAP * m->edge))
        fail_msg("%s, %g edges away: gap %a, near %a, edge %g", header_functions[method].name, edges, gap, near_gap,
                 m->edge);
    return (status[0] != FOOTPOINT_OK) + (status[1] != FOOTPOINT_OK);
}

static void check_method(size_t method, const struct scene *scene, const struct sample_set *set)
{
    const size_t n = set->n < samples() ? set->n : samples(), vectors = segment_vectors(scene->segment);
    double *error[2] = {new_array(n, sizeof **error), new_array(n, sizeof **error)};
    size_t unproved = 0;
    for (int k = 0; k < MOVES; k++) {
        for (size_t i = 0; i < n; i++) {
            struct moved m;
            move(scene->segment, &set->s[i], far[k], &m);
            for (int away = 0; away < 2; away++)
                error[away][i] = error_of(method, vectors, &m, away);
            if (scene->order == CORNERS_ANY && i % 16 == 0)
                unproved += (size_t)check_gap(method, vectors, &m, far[k]);
        }
        const struct error_stats near = error_stats_of(error[0], n), e = error_stats_of(error[1], n);
        if (!(e.mean <= FACTOR * near.mean && e.p99 <= FACTOR * near.p99))
            fail_msg("%s, %g edges away: mean %.1e, 99 %% %.1e; at the origin %.1e, %.1e",
                     header_functions[method].name, far[k], e.mean, e.p99, near.mean, near.p99);
    }
    if (!is_of_patch(method) && unproved > n / 1000) /* of about n / 4 */
        fail_msg("%s: %zu answers are not proved", header_functions[method].name, unproved);
    free(error[0]);
    free(error[1]);
}

static void test_scene(void **state)
{
    struct diag d = {0};
    struct scene *scene = scene_read(".", *state, &d);
    struct sample_set set = {0};
    if (scene && scene->heldout > 2 * samples()) /* some samples may be skipped */
        scene->heldout = 2 * samples();
    if (!scene || !scene_samples(scene, PART_HELDOUT_RANDOM, &set, &d))
        fail_msg("%s", d.text);
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (strcmp(header_functions[i].scene, scene->name) == 0)
            check_method(i, scene, &set);
    sample_set_free(&set);
    scene_free(scene);
}

int main(void)
{
    struct CMUnitTest tests[HEADER_FUNCTIONS];
    size_t n = 0;
    if (!getenv("FOOTPOINT_LONG"))
        puts("# SKIP digits: whole-quad4, and 20,000 samples, not 500: make check-long");
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (i == 0 || strcmp(header_functions[i].scene, header_functions[i - 1].scene) != 0) {
            if (strcmp(header_functions[i].scene, "whole-quad4") == 0 && !getenv("FOOTPOINT_LONG"))
                continue;
            tests[n++] = (struct CMUnitTest){header_functions[i].scene, test_scene, NULL, NULL,
                                             (void *)(uintptr_t)header_functions[i].scene};
        }
    return _cmocka_run_group_tests("digits", tests, n, NULL, NULL);
}
