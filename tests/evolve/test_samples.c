/* Samples of scenes: parts share nothing, labels are foot points, limits are kept. */
#include "../support/long_cases.h"
#include "../support/scene_text.h"

static int by_configuration(const void *a, const void *b)
{
    const struct sample *p = a, *q = b;
    return memcmp(p, q, offsetof(struct sample, xi));
}

static struct sample_set samples_of(const struct scene *s, enum sample_part part)
{
    struct sample_set set = {0};
    struct diag d;
    if (!scene_samples(s, part, &set, &d))
        fail_msg("%s", d.text);
    return set;
}

/* Checks that each call returns the same bytes, and that no configuration is in two parts. */
static void check_parts(const struct scene *s)
{
    const size_t wanted[] = {[PART_TRAINING] = s->training,
                             [PART_HELDOUT] = 0,
                             [PART_HELDOUT_RANDOM] = s->heldout,
                             [PART_HELDOUT_EVEN] = s->heldout,
                             [PART_VALIDATION] = s->training + s->lattice.random,
                             [PART_TRAINING_RANDOM] = s->lattice.random};
    struct sample_set all = {0};
    for (int part = PART_TRAINING; part <= PART_TRAINING_RANDOM; part++) {
        if (!scene_has(s, (enum sample_part)part) || (part != PART_HELDOUT && wanted[part] == 0))
            continue;
        struct sample_set a = samples_of(s, (enum sample_part)part), b = samples_of(s, (enum sample_part)part);
        assert_int_equal(a.n, b.n);
        assert_memory_equal(a.s, b.s, a.n * sizeof *a.s);
        if (part != PART_HELDOUT)
            assert_int_equal(a.n, wanted[part]);
        for (size_t i = 0; i < a.n; i++)
            sample_set_add(&all, &a.s[i]);
        sample_set_free(&a);
        sample_set_free(&b);
    }
    qsort(all.s, all.n, sizeof *all.s, by_configuration);
    for (size_t i = 1; i < all.n; i++)
        assert_true(by_configuration(&all.s[i - 1], &all.s[i]) < 0);
    sample_set_free(&all);
}

static void parts_share_nothing(void **state)
{
    static const char *const text[] = {HEAD SHAPES TAIL, HEAD LATTICE TAIL};
    static const char *const name[] = {
        "quad4", "rectangle-quad4", "bricks-quad4", "punch-quad4", "blocks-quad4", "tri6", "quad8"};
    const size_t heldout = (size_t)long_cases(400, 20000);
    struct diag d;
    (void)state;
    if (heldout == 400)
        puts("# SKIP samples: 400, not 20,000, of each scene that must be in one part alone: make check-long");
    for (int i = 0; i < 2; i++) {
        struct scene *s = read_from_text(text[i], &d);
        assert_non_null(s);
        s->lattice.random = s->source == SOURCE_LATTICE ? 300 : 0;
        check_parts(s);
        scene_free(s);
    }
    for (size_t i = 0; i < sizeof name / sizeof *name; i++) {
        struct scene *s = shipped(name[i]);
        s->training = heldout / 4;
        s->heldout = heldout;
        check_parts(s);
        scene_free(s);
    }
}

/* Labels are right to the last bit, although half of the lattice is copied from its mirror image. */
static void lattice_labels_are_certain(void **state)
{
    const double lo[2] = {-1, -1}, hi[2] = {0, 0};
    struct diag d;
    struct scene *s = read_from_text(HEAD LATTICE TAIL, &d);
    size_t low = 0, high = 0;
    (void)state;
    assert_non_null(s);
    for (int part = PART_TRAINING; part <= PART_HELDOUT; part++) {
        struct sample_set set = samples_of(s, (enum sample_part)part);
        for (size_t i = 0; i < set.n; i++) {
            struct sample fresh = set.s[i];
            fresh.xi = fresh.eta = fresh.gap = 9;
            assert_true(foot_bilinear(&fresh, lo, hi));
            assert_true(fresh.xi == set.s[i].xi && fresh.eta == set.s[i].eta && fresh.gap == set.s[i].gap);
            low += set.s[i].x[2][2] < 0;
            high += set.s[i].x[2][2] > 0;
        }
        sample_set_free(&set);
    }
    assert_true(low > 100 && high > 100);
    scene_free(s);
}

static void seeds_draw_other_samples(void **state)
{
    struct diag d;
    struct scene *s = read_from_text(HEAD LATTICE TAIL, &d);
    (void)state;
    assert_non_null(s);
    struct sample_set one = samples_of(s, PART_TRAINING);
    s->seed++;
    struct sample_set two = samples_of(s, PART_TRAINING);
    assert_memory_not_equal(one.s, two.s, one.n * sizeof *one.s);
    sample_set_free(&one);
    sample_set_free(&two);
    scene_free(s);
}

/* Checks that xs - r(xi,eta) is gap n and that the foot point lies in the box. */
static void check_label(const struct sample *s, double lo, double hi)
{
    double t1[3], t2[3], v[3], size = 0, along1 = 0, along2 = 0, distance = 0;
    for (int k = 0; k < 3; k++) {
        const double a = s->x[0][k], b = s->x[1][k], c = s->x[2][k], d = s->x[3][k];
        t1[k] = ((b - a) * (1 - s->eta) + (c - d) * (1 + s->eta)) / 4;
        t2[k] = ((d - a) * (1 - s->xi) + (c - b) * (1 + s->xi)) / 4;
        v[k] = s->xs[k] - (a * (1 - s->xi) * (1 - s->eta) + b * (1 + s->xi) * (1 - s->eta) +
                           c * (1 + s->xi) * (1 + s->eta) + d * (1 - s->xi) * (1 + s->eta)) /
                              4;
        size += fabs(a) + fabs(b) + fabs(c) + fabs(d);
        along1 += t1[k] * v[k];
        along2 += t2[k] * v[k];
        distance += v[k] * v[k];
    }
    const double n[3] = {t1[1] * t2[2] - t1[2] * t2[1], t1[2] * t2[0] - t1[0] * t2[2], t1[0] * t2[1] - t1[1] * t2[0]};
    const double side = n[0] * v[0] + n[1] * v[1] + n[2] * v[2];
    if (fabs(along1) + fabs(along2) > 1e-13 * size * size || fabs(sqrt(distance) - fabs(s->gap)) > 1e-13 * size ||
        (fabs(s->gap) > 1e-12 * size && (side > 0) != (s->gap > 0)) || fmin(s->xi, s->eta) < lo ||
        fmax(s->xi, s->eta) > hi)
        fail_msg("xi %a eta %a gap %a: not the foot point", s->xi, s->eta, s->gap);
}

static void labels_are_foot_points(void **state)
{
    static const struct {
        const char *name;
        double lo, hi;
    } scene[] = {
        {"quad4", -1.2, 1.2}, {"bricks-quad4", -1.2, 1.2}, {"punch-quad4", -1.2, 1.2}, {"blocks-quad4", -1.2, 1.2}};
    (void)state;
    for (size_t i = 0; i < sizeof scene / sizeof *scene; i++) {
        struct scene *s = shipped(scene[i].name);
        s->heldout = 20000;
        for (int part = PART_TRAINING; part <= PART_HELDOUT; part++) {
            struct sample_set set = samples_of(s, (enum sample_part)part);
            for (size_t k = 0; k < set.n; k++)
                check_label(&set.s[k], scene[i].lo - 1e-6, scene[i].hi + 1e-6);
            sample_set_free(&set);
        }
        scene_free(s);
    }
}

static double distance(const double a[3], const double b[3])
{
    return hypot(hypot(a[0] - b[0], a[1] - b[1]), a[2] - b[2]);
}

/* Aspect ratio of the mid-lines and gap over the shortest edge reach the scene's limits, but do not exceed them. */
static void shapes_keep_their_limits(void **state)
{
    struct scene *s = shipped("quad4");
    struct sample_set set = samples_of(s, PART_TRAINING);
    double aspect = 1, gap = 0, xi = 0;
    (void)state;
    for (size_t i = 0; i < set.n; i++) {
        const struct sample *p = &set.s[i];
        double c[2][3], shortest = INFINITY, origin[3] = {0};
        for (int k = 0; k < 3; k++) {
            c[0][k] = -p->x[0][k] + p->x[1][k] + p->x[2][k] - p->x[3][k];
            c[1][k] = -p->x[0][k] - p->x[1][k] + p->x[2][k] + p->x[3][k];
        }
        for (int k = 0; k < 4; k++)
            shortest = fmin(shortest, distance(p->x[k], p->x[(k + 1) % 4]));
        const double ratio = distance(c[0], origin) / distance(c[1], origin);
        aspect = fmax(aspect, fmax(ratio, 1 / ratio));
        gap = fmax(gap, fabs(p->gap) / shortest);
        xi = fmax(xi, fabs(p->xi));
    }
    assert_true(aspect > 4.99 && aspect < 5 + 1e-9);
    assert_true(gap > 0.199 && gap < 0.2 + 1e-9);
    assert_true(xi > 1.199 && xi < 1.2 + 1e-6);
    sample_set_free(&set);
    scene_free(s);
}

/* Returns the angle between the normals at opposite corners, the larger of the two. */
static double warp_of(const struct sample *s)
{
    double n[4][3], least = 1;
    for (int c = 0; c < 4; c++) {
        const double *o = s->x[c], *p = s->x[(c + 1) % 4], *q = s->x[(c + 3) % 4];
        for (int k = 0; k < 3; k++) {
            const int i = (k + 1) % 3, j = (k + 2) % 3;
            n[c][k] = (p[i] - o[i]) * (q[j] - o[j]) - (p[j] - o[j]) * (q[i] - o[i]);
        }
        const double size = sqrt(n[c][0] * n[c][0] + n[c][1] * n[c][1] + n[c][2] * n[c][2]);
        for (int k = 0; k < 3; k++)
            n[c][k] /= size;
    }
    for (int c = 0; c < 2; c++)
        least = fmin(least, n[c][0] * n[c + 2][0] + n[c][1] * n[c + 2][1] + n[c][2] * n[c + 2][2]);
    return acos(least);
}

/* Each quarter of the limits of warp and aspect contains a quarter of the even part; in no other part is that so for
 * the aspect. Scenes of other sources have no even part. */
static void even_parts_are_even(void **state)
{
    enum { QUARTERS = 4 };
    struct scene *s = shipped("quad4"), *mesh = shipped("punch-quad4"), *smooth = shipped("gregory");
    (void)state;
    s->heldout = 20000;
    for (int even = 0; even < 2; even++) {
        struct sample_set set = samples_of(s, even ? PART_HELDOUT_EVEN : PART_HELDOUT);
        double most[2] = {0}; /* largest deviation of the shares from a quarter: warp, aspect */
        size_t count[2][QUARTERS] = {{0}};
        for (size_t i = 0; i < set.n; i++) {
            const struct sample *p = &set.s[i];
            double c[2][3], origin[3] = {0};
            for (int k = 0; k < 3; k++) {
                c[0][k] = -p->x[0][k] + p->x[1][k] + p->x[2][k] - p->x[3][k];
                c[1][k] = -p->x[0][k] - p->x[1][k] + p->x[2][k] + p->x[3][k];
            }
            const double ratio = distance(c[0], origin) / distance(c[1], origin), warp = warp_of(p) / s->shapes.warp;
            const double aspect = (fmax(ratio, 1 / ratio) - 1) / (s->shapes.aspect - 1);
            assert_true(warp < 1 + 1e-9 && aspect < 1 + 1e-9);
            count[0][(int)fmin(QUARTERS - 1, QUARTERS * warp)]++;
            count[1][(int)fmin(QUARTERS - 1, QUARTERS * aspect)]++;
            check_label(p, -1.2 - 1e-6, 1.2 + 1e-6);
        }
        for (int k = 0; k < 2; k++)
            for (int q = 0; q < QUARTERS; q++)
                most[k] = fmax(most[k], fabs((double)count[k][q] / (double)set.n - 1.0 / QUARTERS));
        for (int k = 0; k < 2; k++)
            if (even ? most[k] > 0.01 : k == 1 && most[k] < 0.1)
                fail_msg("%s is off a quarter by %g, even %d", k ? "aspect" : "warp", most[k], even);
        sample_set_free(&set);
    }
    assert_true(scene_has(s, PART_HELDOUT_EVEN));
    assert_false(scene_has(mesh, PART_HELDOUT_RANDOM) || scene_has(s, PART_HELDOUT_RANDOM) ||
                 scene_has(smooth, PART_HELDOUT_RANDOM));
    assert_false(scene_has(mesh, PART_HELDOUT_EVEN) || scene_has(smooth, PART_HELDOUT_EVEN));
    scene_free(s);
    scene_free(mesh);
    scene_free(smooth);
}

static void order_renumbers_the_corners(void **state)
{
    struct diag d;
    (void)state;
    for (int shorter = 0; shorter < 2; shorter++) {
        char *text = replaced(HEAD SHAPES TAIL, "\"any\"", shorter ? "\"nearest-shorter\"" : "\"nearest\"");
        struct scene *s = read_from_text(text, &d);
        assert_non_null(s);
        struct sample_set set = samples_of(s, PART_TRAINING);
        for (size_t i = 0; i < set.n; i++) {
            const struct sample *p = &set.s[i];
            for (int k = 1; k < 4; k++)
                assert_true(distance(p->xs, p->x[0]) <= distance(p->xs, p->x[k]) * (1 + 1e-15));
            if (shorter)
                assert_true(distance(p->x[0], p->x[3]) <= distance(p->x[0], p->x[1]) * (1 + 1e-15));
            check_label(p, -1.2 - 1e-6, 1.2 + 1e-6);
        }
        sample_set_free(&set);
        scene_free(s);
        free(text);
    }
}

static void refuse_samples(const char *text, enum sample_part part, const char *expected)
{
    struct sample_set set = {0};
    struct diag d = {0};
    struct scene *s = read_from_text(text, &d);
    if (!s)
        fail_msg("%s", d.text);
    assert_false(scene_samples(s, part, &set, &d));
    if (!strstr(d.text, expected))
        fail_msg("'%s' lacks '%s'", d.text, expected);
    sample_set_free(&set);
    scene_free(s);
}

static void empty_sets_are_refused(void **state)
{
    char *text = replaced(HEAD LATTICE TAIL, "60", "60000000"), here[600];
    char *near = NULL;
    struct diag d = {0};
    (void)state;
    refuse_samples(text, PART_TRAINING, "configurations; training takes 60000000 and leaves none");
    free(text);
    assert_non_null(getcwd(here, sizeof here));
    strcat(here, "/tests/meshes/punch.inp");
    text = replaced(HEAD MESH TAIL, "MESH", here);
    near = replaced(text, "0.5", "1e-9");
    struct scene *s = read_from_text(near, &d);
    assert_non_null(s);
    struct sample_set set = samples_of(s, PART_HELDOUT);
    assert_true(set.n == 40 && set.real == 0 && fabs(set.s[39].gap) < 2e-9);
    sample_set_free(&set);
    scene_free(s);
    free(near);
    free(text);
    here[strlen(here) - strlen("punch.inp")] = '\0';
    strcat(here, "tetra10.inp");
    text = replaced(HEAD MESH TAIL, "MESH", here);
    assert_null(read_from_text(text, &d));
    assert_non_null(strstr(d.text, ".scene:9: error: no master face has segment 'quad4'; there are 1 of tri6"));
    free(text);
}

/* Returns the edge of the segment whose middle is nearest to x. */
static size_t nearest_edge(const struct segment_kind *kind, const struct sample *s, const double x[3])
{
    size_t nearest = 0;
    double least = INFINITY;
    for (size_t e = 0; e < kind->corners; e++) {
        double middle[3];
        for (int k = 0; k < 3; k++)
            middle[k] = (s->x[e][k] + s->x[(e + 1) % kind->corners][k]) / 2;
        if (distance(middle, x) < least) {
            least = distance(middle, x);
            nearest = e;
        }
    }
    return nearest;
}

/* Curved faces of a mesh are masters, with each node in its place, so foot points lie on the face. */
static void meshes_of_other_kinds_are_read(void **state)
{
    static const struct {
        const char *segment, *file;
    } expected[] = {{"tri6", "tetra10.inp"}, {"quad8", "hexa20.inp"}, {"quad9", "hexa27.inp"}};
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        char here[600], segment[20];
        struct diag d;
        assert_non_null(getcwd(here, sizeof here));
        snprintf(here + strlen(here), sizeof here - strlen(here), "/tests/meshes/%s", expected[i].file);
        snprintf(segment, sizeof segment, "\"%s\"", expected[i].segment);
        char *file = replaced(HEAD MESH TAIL, "MESH", here), *text = replaced(file, "\"quad4\"", segment);
        struct scene *s = read_from_text(text, &d);
        if (!s)
            fail_msg("%s", d.text);
        struct sample_set set = samples_of(s, PART_HELDOUT);
        assert_int_equal(set.n, 40);
        for (size_t k = 0; k < set.n; k++) {
            assert_true(fabs(set.s[k].gap) <= 0.5);
            for (size_t n = s->segment->corners; n < 2 * s->segment->corners; n++)
                assert_int_equal(nearest_edge(s->segment, &set.s[k], set.s[k].x[n]), n - s->segment->corners);
        }
        sample_set_free(&set);
        scene_free(s);
        free(text);
        free(file);
    }
}

/* Gaps of random nodes over the faces of a mesh are equally many in each decade, on either side. */
static void gaps_of_meshes_are_dense_near_contact(void **state)
{
    struct scene *s = shipped("punch-quad4");
    size_t count[GAP_BANDS] = {0}, open = 0;
    (void)state;
    s->heldout = 20000;
    struct sample_set set = samples_of(s, PART_HELDOUT);
    assert_true(set.real > 500 && set.n == s->heldout);
    for (size_t i = set.real; i < set.n; i++) {
        const double edge = sample_shortest_edge(&set.s[i], 4);
        assert_true(fabs(set.s[i].gap) > 0.99e-4 * edge && fabs(set.s[i].gap) < 1.000001 * s->mesh.distance);
        count[sample_gap_band(&set.s[i], 4)]++;
        open += set.s[i].gap > 0;
    }
    const size_t drawn = set.n - set.real;
    for (int b = 0; b < GAP_BANDS - 1; b++) /* decades, of about 3.3 */
        assert_true(count[b] > drawn / 5 && count[b] < 2 * drawn / 5);
    assert_true(open > 0.48 * (double)drawn && open < 0.52 * (double)drawn);
    sample_set_free(&set);
    scene_free(s);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_share_nothing),
        cmocka_unit_test(seeds_draw_other_samples),
        cmocka_unit_test(labels_are_foot_points),
        cmocka_unit_test(shapes_keep_their_limits),
        cmocka_unit_test(even_parts_are_even),
        cmocka_unit_test(order_renumbers_the_corners),
        cmocka_unit_test(lattice_labels_are_certain),
        cmocka_unit_test(empty_sets_are_refused),
        cmocka_unit_test(meshes_of_other_kinds_are_read),
        cmocka_unit_test(gaps_of_meshes_are_dense_near_contact),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
