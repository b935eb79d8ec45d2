/* Accuracy regression: every function of every committed header is measured again on the held-out samples of its scene
 * and must reproduce the figures of its banner, for patches also the share of proved answers. With FOOTPOINT_LONG all
 * samples are used, otherwise the random samples of some scenes. Functions must compute their genome. The checked
 * function must agree with the unchecked function for any numbering of the corners, and report nodes on a line. */
#include "../../codegen/base/random.h"
#include "../../evolve/eval/frame.h"
#include "../../evolve/eval/lines_run.h"
#include "../../evolve/samples/samples.h"
#include "../../evolve/surface/surface.h"
#include "../../runtime/footpoint.h"
#include "../support/error_stats.h"
#include "header_functions.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { COMPARED = 500, MEASURED = 40000, COMPARED_LONG = 50000, BLOCK = 1000, COLLINEAR = 1000 };
#define ROUNDING 1e-11 /* of xi and eta; beyond 1, where steps fail, it grows with the square */

static void at_sample(const struct header_function *m, const struct sample *s, double loc[2])
{
    const double *x[SEGMENT_VECTORS];
    for (int k = 0; k < SEGMENT_VECTORS; k++)
        x[k] = s->x[k];
    m->at(x, s->xs, &loc[0], &loc[1]);
}

/* Computes the genome of a method: NAME_at, of patches NAME_n, as NAME_at takes steps of its own there. */
static void genome_at_sample(const struct header_function *m, const struct sample *s, double loc[2])
{
    const struct segment_kind *kind = segment_find(m->kind);
    const double *x[3 * (SEGMENT_VECTORS + 1)];
    const size_t vectors = segment_vectors(kind);
    if (!*kind->normals) {
        at_sample(m, s, loc);
        return;
    }
    for (size_t k = 0; k <= vectors; k++)
        for (size_t i = 0; i < 3; i++)
            x[3 * k + i] = k < vectors ? &s->x[k][i] : &s->xs[i];
    m->n(1, x, &loc[0], &loc[1]);
}

/* Returns the genome of a method of scene file `f`: function footpoint_<scene>_<genome>, with _ for - in the scene's
 * name. */
static const struct genome *find_genome(const struct genome_file *f, const struct header_function *m)
{
    const size_t prefix = strlen("footpoint_") + strlen(m->scene) + 1;
    for (size_t i = 0; i < f->genomes; i++)
        if (strcmp(m->name + prefix, f->genome[i].name) == 0)
            return &f->genome[i];
    return NULL;
}

/* Checks that figures of all samples equal the note's; figures of some samples are near. */
static void check_note(const struct genome *g, const char *key, int k, size_t samples, const struct error_stats *e)
{
    double mean[2], p99[2], max[2];
    size_t n;
    const char *text = genome_find_note(g->note, g->notes, key);
    assert_non_null(text);
    assert_int_equal(sscanf(text, "n %zu mean %lf %lf p99 %lf %lf max %lf %lf", &n, &mean[0], &mean[1], &p99[0],
                            &p99[1], &max[0], &max[1]),
                     7);
    assert_int_equal(e->failures, 0);
    if (samples < n) {
        if (!(e->p99 <= 1.25 * p99[k] + 1e-12 && p99[k] <= 1.25 * e->p99 + 1e-12 && e->max <= 1.001 * max[k] + 1e-12))
            fail_msg("%s %s: the banner says %g, %g, some samples %g, %g", g->name, key, p99[k], max[k], e->p99,
                     e->max);
        return;
    }
    const double stated[3] = {mean[k], p99[k], max[k]}, measured[3] = {e->mean, e->p99, e->max};
    for (int i = 0; i < 3;
         i++) /* the text has three decimals; below 1e-12 rounding errors depend on the order of sums */
        if (!(fabs(measured[i] - stated[i]) <= 1e-3 * stated[i] + 1e-12))
            fail_msg("%s %s: the banner says %g, measured %g", g->name, key, stated[i], measured[i]);
}

/* Computes the errors of xi and eta of a search on all samples. */
static void find_errors(const struct header_function *m,
                        void (*search)(const struct header_function *m, const struct sample *s, double loc[2]),
                        const struct sample_set *set, struct error_stats of[2])
{
    double *error[2];
    for (int k = 0; k < 2; k++)
        error[k] = calloc(set->n, sizeof **error);
    for (size_t i = 0; i < set->n; i++) {
        const struct sample *s = &set->s[i];
        double loc[2];
        search(m, s, loc);
        error[0][i] = fabs(loc[0] - s->xi);
        error[1][i] = fabs(loc[1] - s->eta);
    }
    for (int k = 0; k < 2; k++) {
        of[k] = error_stats_of(error[k], set->n);
        free(error[k]);
    }
}

static void measure(const struct header_function *m, const struct genome *g, const struct sample_set *set,
                    const char *part)
{
    struct error_stats e[2];
    char key[60];
    find_errors(m, genome_at_sample, set, e);
    for (int k = 0; k < 2; k++) {
        snprintf(key, sizeof key, "%s_both", part);
        check_note(g, key, k, set->n, &e[k]);
    }
}

/* Checks the figures of NAME_at of a patch, which are a note of their own where it takes steps. */
static void check_steps(const struct header_function *m, const struct genome *g, const struct sample_set *set)
{
    const char *text = genome_find_note(g->note, g->notes, "at_heldout");
    struct error_stats e[2];
    double mean[2], p99[2], max[2];
    size_t n = set->n;
    find_errors(m, at_sample, set, e);
    const bool reads = text && sscanf(text, "xi %lf %lf %lf, eta %lf %lf %lf, of %zu samples", &mean[0], &p99[0],
                                      &max[0], &mean[1], &p99[1], &max[1], &n) == 7;
    for (int k = 0; k < 2; k++)
        if (!reads ||
            (n == set->n &&
             !(fabs(e[k].mean - mean[k]) <= 2e-3 * mean[k] + 1e-14 &&
               fabs(e[k].p99 - p99[k]) <= 2e-3 * p99[k] + 1e-14 && fabs(e[k].max - max[k]) <= 1e-2 * max[k] + 1e-14)) ||
            !(e[k].max <= 1.01 * max[k] + 1e-14 && e[k].p99 <= 1.25 * p99[k] + 1e-14))
            fail_msg("%s, note of steps: at_heldout xi %.3e %.3e %.3e, eta %.3e %.3e %.3e, of %zu samples", m->name,
                     e[0].mean, e[0].p99, e[0].max, e[1].mean, e[1].p99, e[1].max, set->n);
}

/* Returns true if NAME_at takes steps: its answer is not the genome's. */
static bool takes_steps(const struct header_function *m, const struct sample_set *set)
{
    double loc[2], bred[2], most = 0;
    for (size_t i = 0; i < set->n && i < COMPARED; i++) {
        at_sample(m, &set->s[i], loc);
        genome_at_sample(m, &set->s[i], bred);
        most = fmax(most, fmax(fabs(loc[0] - bred[0]), fabs(loc[1] - bred[1])));
    }
    return most > ROUNDING;
}

/* Checks the share of samples that the checked function of a patch proves against its genome's note; roughly, if not
 * all samples are used. */
static void check_share(const struct header_function *m, const struct genome *g, const struct sample_set *set,
                        const char *part)
{
    const char *text = genome_find_note(g->note, g->notes, "statuses");
    double share = 0, proved = 0;
    size_t n = 0;
    for (size_t i = 0; i < set->n; i++) {
        const double *x[SEGMENT_VECTORS];
        double loc[2], gap;
        for (int k = 0; k < SEGMENT_VECTORS; k++)
            x[k] = set->s[i].x[k];
        const int status = m->locate(x, set->s[i].xs, loc, &gap);
        proved += status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE;
    }
    proved *= 100 / (double)set->n;
    if (!text || sscanf(text, "proved on %lf %% of %zu samples", &share, &n) != 2)
        fail_msg("%s lacks: note statuses proved on %.2f %% of %zu samples of %s, FOOTPOINT_UNPROVED on the others",
                 g->name, proved, set->n, part);
    const double chance = set->n < n ? 5 * sqrt(fmax(1, share * (100 - share)) / (double)set->n) : 0;
    if (!(fabs(share - proved) <= chance + 0.02))
        fail_msg("%s: the banner says %g %% are proved, measured %g %%", m->name, share, proved);
}

/* Compares the code in double with the genome in double, gene by gene, which differ only by rounding. Works by blocks,
 * whose columns stay in the cache. */
static void compare_with_genome(const struct header_function *m, const struct genome_file *f, const struct genome *g,
                                const struct sample_set *set)
{
    const size_t most = getenv("FOOTPOINT_LONG") ? COMPARED_LONG : COMPARED, n = set->n < most ? set->n : most;
    for (size_t from = 0; from < n; from += BLOCK) {
        const size_t rows = n - from < BLOCK ? n - from : BLOCK;
        struct columns table = frame_columns(f, &set->s[from], rows);
        double value[2][BLOCK];
        for (int k = 0; k < 2; k++)
            table_values(&table, f->constant, g->out[k].gene, g->out[k].length, value[k]);
        for (size_t i = 0; i < rows; i++) {
            double loc[2];
            genome_at_sample(m, &set->s[from + i], loc);
            for (int k = 0; k < 2; k++)
                if (!(fabs(loc[k] - value[k][i]) <= ROUNDING * fmax(1, value[k][i] * value[k][i])))
                    fail_msg("%s, sample %zu: code %a, genome %a", m->name, from + i, loc[k], value[k][i]);
        }
        columns_free(&table);
    }
}

/* Checks that the gap belongs to the surface at the xi and eta found. */
static void check_gap(const struct header_function *m, const struct segment_kind *kind, const struct sample *s,
                      const double loc[2], double gap, double size)
{
    double x[SEGMENT_VECTORS][3], r[3], n[3], there = 0;
    memcpy(x, s->x, sizeof x);
    assert_true(surface_normal(surface_find(kind), x, loc[0], loc[1], r, n));
    for (int k = 0; k < 3; k++)
        there += (s->xs[k] - r[k]) * n[k];
    if (!(fabs(gap - there) <= size * 1e-11))
        fail_msg("%s: gap %a, on the surface %a", m->name, gap, there);
}

/* Checks that the checked function keeps its promise, or agrees with the unchecked function, and that its gap is right
 * at first order. Returns true for FOOTPOINT_UNPROVED, which must be rare. */
static int check(const struct header_function *m, const struct segment_kind *kind, const struct sample *s)
{
    const double *x[SEGMENT_VECTORS];
    double loc[2], first[2], gap, size = 0;
    for (int k = 0; k < SEGMENT_VECTORS; k++)
        x[k] = s->x[k];
    at_sample(m, s, first);
    const int status = m->locate(x, s->xs, loc, &gap);
    if (m->promise > 0 && status == FOOTPOINT_UNPROVED)
        return 1;
    assert_int_equal(status, FOOTPOINT_OK);
    for (int k = 0; k < 3; k++)
        size += fabs(s->x[1][k] - s->x[0][k]) + fabs(s->x[2][k] - s->x[0][k]);
    const double off = fabs(loc[0] - s->xi) + fabs(loc[1] - s->eta);
    if (m->promise > 0)
        assert_true(fmax(fabs(loc[0] - s->xi), fabs(loc[1] - s->eta)) <= m->promise + 1e-12); /* of the sample itself */
    else
#ifdef __FMA__ /* compilers fuse operations, differently in each place */
        assert_true(fabs(loc[0] - first[0]) + fabs(loc[1] - first[1]) <= 1e-12);
#else
        assert_true(loc[0] == first[0] && loc[1] == first[1]);
#endif
    if (!(fabs(gap - s->gap) <= size * (1e-12 + 20 * off)))
        fail_msg("%s: gap %a, certain %a, with xi, eta off by %g", m->name, gap, s->gap, off);
    check_gap(m, kind, s, loc, gap, size);
    return 0;
}

/* Checks the checked function on every 500th sample. At most 1 % may be unproved for the finest and for coarse
 * promises, 0.1 % for others; on patches the share that the banner states. */
static void check_some(const struct header_function *m, const struct segment_kind *kind, const struct sample_set *set)
{
    size_t unproved = 0, checked = 0;
    for (size_t k = 0; k < set->n; k += 1 + set->n / 500, checked++)
        unproved += (size_t)check(m, kind, &set->s[k]);
    if (!*kind->normals && unproved > (m->promise > 1e-11 && m->promise < 1e-2 ? checked / 1000 : checked / 100))
        fail_msg("%s: %zu of %zu unproved", m->name, unproved, checked);
}

/* Checks that rotated and reflected numberings have the same status and point of the segment. */
static void renumber(const struct header_function *m, const struct sample *s)
{
    const double *const first_x[4] = {s->x[0], s->x[1], s->x[2], s->x[3]};
    double loc[2], gap, first[2];
    const int status = m->locate(first_x, s->xs, first, &gap);
    assert_true(status == FOOTPOINT_OK || (m->promise > 0 && status > FOOTPOINT_OK));
    for (int turn = 0; turn < 4; turn++) {
        const double *const x[4] = {s->x[turn], s->x[(turn + 1) % 4], s->x[(turn + 2) % 4], s->x[(turn + 3) % 4]};
        double g;
        assert_int_equal(m->locate(x, s->xs, loc, &g), status);
        const double xi = turn == 0 ? loc[0] : turn == 1 ? -loc[1] : turn == 2 ? -loc[0] : loc[1];
        const double eta = turn == 0 ? loc[1] : turn == 1 ? loc[0] : turn == 2 ? -loc[1] : -loc[0];
        if (!(fabs(xi - first[0]) <= 1e-9 && fabs(eta - first[1]) <= 1e-9 && fabs(g - gap) <= 1e-9 * (1 + fabs(gap))))
            fail_msg("%s turn %d: (%a,%a) not (%a,%a)", m->name, turn, xi, eta, first[0], first[1]);
    }
}

static bool is_among(const char *name, const char *const *names, size_t n)
{
    bool among = false;
    for (size_t i = 0; i < n; i++)
        among = among || strcmp(name, names[i]) == 0;
    return among;
}

static double uniform(uint64_t *stream)
{
    return (double)(random_next(stream) >> 11) * 0x1p-52 - 1;
}

/* Checks that nodes on a line have no area, however regular they are: mid-side nodes in the middle, alternately with
 * corners of a degenerate parallelogram. Searches diverge there, to where rounding makes a normal. */
static void check_collinear(const struct header_function *m, const struct segment_kind *kind)
{
    const size_t nodes = strlen(kind->nodes), corners = kind->corners;
    uint64_t stream = 1;
    for (int n = 0; n < COLLINEAR && !*kind->normals; n++) {
        double x[SEGMENT_VECTORS][3], xs[3], along[3], origin[3], at[SEGMENT_VECTORS] = {0}, loc[2], gap;
        const double *row[SEGMENT_VECTORS];
        for (size_t k = 0; k < corners; k++)
            at[k] = uniform(&stream);
        if (n % 2 && corners == 4)
            at[2] = at[1] + at[3] - at[0];
        for (size_t k = 0; k < corners && corners < nodes; k++) {
            at[corners + k] = (at[k] + at[(k + 1) % corners]) / 2;
            at[8] += nodes == 9 ? at[k] / 4 : 0;
        }
        for (int j = 0; j < 3; j++) {
            along[j] = uniform(&stream);
            origin[j] = uniform(&stream);
            xs[j] = uniform(&stream);
        }
        for (size_t k = 0; k < SEGMENT_VECTORS; k++) {
            row[k] = x[k];
            for (int j = 0; j < 3; j++)
                x[k][j] = origin[j] + at[k] * along[j];
        }
        const int status = m->locate(row, xs, loc, &gap);
        if (status != FOOTPOINT_ERR_DEGENERATE)
            fail_msg("%s, nodes on line %d: status %d, (%g,%g), gap %g", m->name, n, status, loc[0], loc[1], gap);
    }
}

/* Returns true for parts to skip: lattices and meshes, and samples off the paper's lattices, take long; meshes have the
 * segments of quad4. */
static bool is_left(const char *scene, enum sample_part part)
{
    static const char *const scenes[] = {"paper-quad4",  "whole-quad4", "paper-gregory",
                                         "blocks-quad4", "punch-quad4", "bricks-quad4"};
    return (part == PART_HELDOUT_EVEN || is_among(scene, scenes, sizeof scenes / sizeof *scenes)) &&
           !getenv("FOOTPOINT_LONG");
}

/* Returns true if the figures of the banner use all samples of a part. */
static bool is_measured(const char *scene)
{
    static const char *const scenes[] = {"quad4", "tri6", "gregory"};
    return is_among(scene, scenes, sizeof scenes / sizeof *scenes) || getenv("FOOTPOINT_LONG");
}

static void check_scene(const char *name)
{
    struct diag d = {0};
    char path[300];
    snprintf(path, sizeof path, "evolve/genomes/%s.gen", name);
    struct genome_file *f = genome_read(path, &d);
    struct scene *scene = f ? scene_read(".", name, &d) : NULL;
    const bool measured = is_measured(name);
    if (scene && !getenv("FOOTPOINT_LONG"))
        scene->heldout = measured ? MEASURED : 2 * COMPARED;
    for (size_t i = 0; scene && i < HEADER_FUNCTIONS; i++)
        if (strcmp(header_functions[i].scene, name) == 0)
            check_collinear(&header_functions[i], scene->segment);
    for (int p = 0; scene && p < HELDOUT_PARTS; p++) {
        struct sample_set set = {0};
        const bool off = scene->source == SOURCE_RANDOM ? p == 0 : p == 1; /* random, off any grid */
        if (!scene_has(scene, heldout_part[p].part) || is_left(name, heldout_part[p].part))
            continue;
        if (!scene_samples(scene, heldout_part[p].part, &set, &d))
            fail_msg("%s", d.text);
        for (size_t i = 0; i < HEADER_FUNCTIONS; i++) {
            if (strcmp(header_functions[i].scene, name) != 0)
                continue;
            const struct genome *g = find_genome(f, &header_functions[i]);
            assert_non_null(g);
            if (measured)
                measure(&header_functions[i], g, &set, heldout_part[p].name);
            if (off && *scene->segment->normals)
                check_share(&header_functions[i], g, &set, heldout_part[p].name);
            if (off && measured && takes_steps(&header_functions[i], &set))
                check_steps(&header_functions[i], g, &set);
            compare_with_genome(&header_functions[i], f, g, &set);
            if (off && scene->order == CORNERS_ANY)
                check_some(&header_functions[i], scene->segment, &set);
            for (size_t k = 0; off && scene->order != CORNERS_ANY && k < set.n; k += 1 + set.n / 500)
                renumber(&header_functions[i], &set.s[k]); /* off the grid, because corners tie on it */
        }
        sample_set_free(&set);
    }
    if (!scene)
        fail_msg("%s", d.text);
    scene_free(scene);
    genome_file_free(f);
}

static void test_scene(void **state)
{
    check_scene(*state);
}

/* Faces with an edge of length 0, its mid-side node at its ends, have an area elsewhere. The most accurate function of
 * each kind finds the foot points inside. */
static void test_collapsed(void **state)
{
    static const char *const best[][2] = {
        {"quad4", "footpoint_quad4_full"}, {"quad8", "footpoint_quad8_full"}, {"quad9", "footpoint_quad9_full"}};
    static const double place[4][3] = {{0, 0, 0}, {1, 0, 0.0625}, {1.125, 0.875, 0}, {0.0625, 1, 0.0625}};
    (void)state;
    for (size_t b = 0; b < sizeof best / sizeof *best; b++)
        for (int edge = 0; edge < 4; edge++) {
            const struct segment_kind *kind = segment_find(best[b][0]);
            const struct header_function *m = header_functions;
            double x[SEGMENT_VECTORS][3] = {{0}};
            const double *at[SEGMENT_VECTORS];
            while (strcmp(m->name, best[b][1]) != 0)
                m++;
            for (int i = 0; i < SEGMENT_VECTORS; i++)
                at[i] = x[i];
            memcpy(x, place, sizeof place);
            memcpy(x[edge], x[(edge + 1) % 4], sizeof x[0]);
            for (int i = 0; i < 4; i++)
                for (int k = 0; k < 3; k++) {
                    x[4 + i][k] = (x[i][k] + x[(i + 1) % 4][k]) / 2 + (k == 2 && i != edge ? 0.03125 : 0);
                    x[8][k] += x[i][k] / 4;
                }
            for (double xi = -0.5; xi <= 0.5; xi += 0.25)
                for (double eta = -0.5; eta <= 0.5; eta += 0.25) {
                    double r[3], n[3], xs[3], loc[2], gap;
                    assert_true(surface_normal(surface_find(kind), x, xi, eta, r, n));
                    for (int k = 0; k < 3; k++)
                        xs[k] = r[k] + 0.03125 * n[k];
                    const int status = m->locate(at, xs, loc, &gap);
                    if (status != FOOTPOINT_OK ||
                        !(fabs(loc[0] - xi) <= 1e-9 && fabs(loc[1] - eta) <= 1e-9 && fabs(gap - 0.03125) <= 1e-9))
                        fail_msg("%s, edge %d, (%g,%g): status %d, (%g,%g), gap %g", m->name, edge, xi, eta, status,
                                 loc[0], loc[1], gap);
                }
        }
}

int main(void)
{
    struct CMUnitTest tests[HEADER_FUNCTIONS + 1];
    size_t n = 0;
    if (!getenv("FOOTPOINT_LONG"))
        puts("# SKIP headers: the paper's, whole-quad4, blocks-quad4, punch-quad4, samples on lattices and meshes, "
             "figures of banners but those of quad4, tri6 and gregory: make check-long");
    tests[n++] = (struct CMUnitTest)cmocka_unit_test(test_collapsed);
    for (size_t i = 0; i < HEADER_FUNCTIONS; i++)
        if (i == 0 || strcmp(header_functions[i].scene, header_functions[i - 1].scene) != 0)
            tests[n++] = (struct CMUnitTest){header_functions[i].scene, test_scene, NULL, NULL,
                                             (void *)(uintptr_t)header_functions[i].scene};
    return _cmocka_run_group_tests("headers", tests, n, NULL, NULL);
}
