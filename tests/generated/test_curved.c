/* Closest points of faces of six, eight and nine nodes, NAME_closest and footpoint_face_robust, on faces as scenes draw
 * them, against a certain search that shares no code with them, tests/support/curved_face.h. Slave nodes lie in the
 * scenes' ranges and up to an edge beside the face. 1,000 of each scene, 1e6 with FOOTPOINT_LONG; and
 * footpoint_face_robust on 1,000 strongly curved faces of each kind, or 1e5. */
#include "../../codegen/genome/genome.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/samples/samples.h"
#include "../../generated/footpoint_quad8.h"
#include "../../generated/footpoint_quad9.h"
#include "../../generated/footpoint_tri6.h"
#include "../../runtime/footpoint_face.h"
#include "../support/curved_face.h"
#include "../support/long_cases.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 1000, SAMPLES_LONG = 1000000, STRONG = 1000, STRONG_LONG = 100000 };
enum { SEED = 20131, SEED_STRONG = 20132, VECTORS = SEGMENT_VECTORS + 1 };
#define TIE 1e-6 /* in xi and eta: within this, rounding hides the region */

#define N6(x) x[0], x[1], x[2], x[3], x[4], x[5]
#define N8(x) N6(x), x[6], x[7]
#define N9(x) N8(x), x[8]

typedef int closest(double (*x)[3], const double *xs, double loc[2], double *dist, int *region);

#define CLOSEST(nodes, name)                                                                                           \
    static int closest_##name(double(*x)[3], const double *xs, double loc[2], double *dist, int *region)               \
    {                                                                                                                  \
        return footpoint_##name##_closest(N##nodes(x), xs, loc, dist, region);                                         \
    }
#define FUNCTIONS(F)                                                                                                   \
    F(6, tri6_accurate)                                                                                                \
    F(6, tri6_coarse)                                                                                                  \
    F(8, quad8_full)                                                                                                   \
    F(8, quad8_coarse)                                                                                                 \
    F(9, quad9_full)                                                                                                   \
    F(9, quad9_coarse)
FUNCTIONS(CLOSEST)

static const struct kind {
    const char *scene;
    enum footpoint_face face;
    int nodes, corners;
    closest *exact, *coarse;
} kinds[] = {{"tri6", FOOTPOINT_TRI6, 6, 3, closest_tri6_accurate, closest_tri6_coarse},
             {"quad8", FOOTPOINT_QUAD8, 8, 4, closest_quad8_full, closest_quad8_coarse},
             {"quad9", FOOTPOINT_QUAD9, 9, 4, closest_quad9_full, closest_quad9_coarse}};
enum { KINDS = sizeof kinds / sizeof *kinds };

static long samples(void)
{
    return long_cases(SAMPLES, SAMPLES_LONG);
}

/* ---- samples ---- */

struct question {
    double x[VECTORS][3], xs[3], normal[3], longest;
};

static double clamp(double x, double lo, double hi)
{
    return x < lo ? lo : x > hi ? hi : x;
}

/* Draws a foot point in the scene's ranges and its slave node, or moves the slave node along the tangents, up to the
 * face's length beyond it. */
static void place(const struct kind *k, const struct scene *scene, const struct surface *f, gsl_rng *stream,
                  bool beside, struct question *q)
{
    const double low = k->corners == 3 ? 0 : -1, over = beside ? 1 - low : 0.1 * (1 - low);
    double loc[2], foot[2], r[3][3], point[3], shortest = HUGE_VAL;
    for (int i = 0; i < 2; i++) {
        loc[i] = gsl_ran_flat(stream, low - over, 1 + over);
        foot[i] = clamp(loc[i], low, 1);
    }
    if (k->corners == 3 && foot[0] + foot[1] > 1)
        foot[1] = 1 - foot[0];
    q->longest = 0;
    for (int i = 0; i < k->corners; i++) {
        double square = 0;
        for (int j = 0; j < 3; j++)
            square += pow(q->x[(i + 1) % k->corners][j] - q->x[i][j], 2);
        q->longest = fmax(q->longest, sqrt(square));
        shortest = fmin(shortest, sqrt(square));
    }
    f->point(f, q->x, foot[0], foot[1], r);
    assert_true(surface_normal(f, q->x, foot[0], foot[1], point, q->normal));
    const double gap = gsl_ran_flat(stream, -scene->shapes.gap, scene->shapes.gap) * shortest;
    for (int j = 0; j < 3; j++)
        q->xs[j] = r[0][j] + (loc[0] - foot[0]) * r[1][j] + (loc[1] - foot[1]) * r[2][j] + gap * q->normal[j];
}

/* Calls `ask` with samples of a kind. */
static void each_sample(const struct kind *k,
                        void (*ask)(const struct kind *k, struct question *q, gsl_rng *s, void *to), void *to)
{
    struct diag d = {0};
    struct scene *scene = scene_read(".", k->scene, &d);
    if (!scene)
        fail_msg("%s", d.text);
    const struct surface *surface = surface_find(scene->segment);
    gsl_rng *stream = stream_new();
    for (long i = 0; i < samples(); i++) {
        struct question q = {0};
        stream_key(stream, SEED, (uint64_t)(k - kinds), (uint64_t)i, 0);
        while (!draw_face(surface, stream, &scene->shapes, q.x))
            continue;
        place(k, scene, surface, stream, i % 2, &q);
        ask(k, &q, stream, to);
    }
    gsl_rng_free(stream);
    scene_free(scene);
}

/* ---- closest points ---- */

/* Returns the region of (xi,eta) and its distance from the border of the region, by its distances from the edges. */
static int region_of(int corners, double xi, double eta, double *margin)
{
    static const int square[3][3] = {{5, 1, 6}, {4, 0, 2}, {8, 3, 7}}, on[8] = {0, 1, 3, 4, 2, 5, 6, 7};
    const double away[4] = {corners == 3 ? eta : 1 + eta, corners == 3 ? xi : 1 + xi,
                            corners == 3 ? 1 - xi - eta : 1 - xi, 1 - eta};
    *margin = 1;
    for (int i = 0; i < 4; i++)
        if (away[i] > 1e-8)
            *margin = fmin(*margin, away[i]);
    if (corners == 4)
        return square[away[3] < 1e-8 ? 2 : away[0] > 1e-8][away[2] < 1e-8 ? 2 : away[1] > 1e-8];
    const int edges = (away[0] < 1e-8) + 2 * (away[1] < 1e-8) + 4 * (away[2] < 1e-8);
    return on[edges];
}

/* footpoint_face_robust: answers by status; footpoint_face_closest and footpoint_face_locate: answers with OK that are
 * longer. */
struct robust {
    long status[FOOTPOINT_STATUS_MOST + 1], wrong, apart, closest, located;
    double longer;
};

struct tally {
    struct robust robust;
    long answers, far, wrong, regions, sides;
    double off, longer, coarse;
};

static bool is_in(int corners, const double loc[2])
{
    return corners == 3 ? loc[0] >= 0 && loc[1] >= 0 && loc[0] + loc[1] <= 1 : fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1;
}

/* Checks that the distance is that of loc, exceeds the certain distance by at most 1e-10 of the largest difference of
 * coordinates, and that an answer with FOOTPOINT_OK is the only closest point. */
static void ask_robust(const struct kind *k, double (*x)[3], const double *xs, const struct curved_face *f,
                       const double certain[2], double least, struct robust *t)
{
    double all[3 * VECTORS], loc[2], dist, at[3], nearest[3], span = 0, apart = 0, off = 0, margin;
    int region;
    for (int i = 0; i < 3 * k->nodes + 3; i++) {
        all[i] = i < 3 * k->nodes ? x[i / 3][i % 3] : xs[i % 3];
        span = fmax(span, fabs(all[i] - xs[i % 3]));
    }
    const int status = footpoint_face_robust(k->face, all, loc, &dist, &region);
    assert_in_range(status, 0, FOOTPOINT_STATUS_MOST);
    t->status[status]++;
    curved_face_point(f, loc[0], loc[1], at);
    curved_face_point(f, certain[0], certain[1], nearest);
    for (int j = 0; j < 3; j++) {
        off += at[j] * at[j];
        apart = fmax(apart, fabs(at[j] - nearest[j]));
    }
    const double longer = (fabs(dist) - least) / span;
    const int claims = region_of(k->corners, loc[0], loc[1], &margin);
    double there[2], other;
    int part;
    t->closest += footpoint_face_closest(k->face, all, there, &other, &part) == FOOTPOINT_OK &&
                  fabs(other) - least > 1e-10 * span;
    t->located += footpoint_face_locate(k->face, all, there, &other) == FOOTPOINT_OK && is_in(k->corners, there) &&
                  fabs(other) - least > 2e-10 * span;
    t->apart += status <= FOOTPOINT_OUTSIDE && apart > 1e-4 * span;
    t->longer = status == FOOTPOINT_UNPROVED ? t->longer : fmax(t->longer, longer);
    if ((status == FOOTPOINT_UNPROVED || longer <= 1e-10) && fabs(sqrt(off) - fabs(dist)) <= 1e-12 * span &&
        (margin < TIE || claims == region) &&
        (status > FOOTPOINT_OUTSIDE || (status == FOOTPOINT_OUTSIDE) == (region > 0)))
        return;
    if (t->wrong++ < 5)
        printf("# %s: robust, status %d, %.12g %.12g %.17g, certain %.12g %.12g %.17g\n", k->scene, status, loc[0],
               loc[1], dist, certain[0], certain[1], least);
}

static void print_robust(const struct kind *k, const char *of, const struct robust *t)
{
    printf("# %s, robust%s: %ld inside, %ld outside, %ld not unique, %ld unproved; %ld wrong, %ld not the only one; "
           "distance longer by %.1e; %ld of footpoint_face_closest, %ld of footpoint_face_locate are OK and longer\n",
           k->scene, of, t->status[FOOTPOINT_OK], t->status[FOOTPOINT_OUTSIDE], t->status[FOOTPOINT_NOT_UNIQUE],
           t->status[FOOTPOINT_UNPROVED], t->wrong, t->apart, t->longer, t->closest, t->located);
}

static void ask_closest(const struct kind *k, struct question *q, gsl_rng *stream, void *to)
{
    struct tally *t = to;
    struct curved_face f;
    double certain[2], loc[2] = {7, 7}, dist = 7, margin, other;
    int region = 77;
    (void)stream;
    curved_face_of(&f, k->nodes, q->x, q->xs);
    const double least = curved_face_closest(&f, certain);
    ask_robust(k, q->x, q->xs, &f, certain, least, &t->robust);
    const int status = k->exact(q->x, q->xs, loc, &dist, &region);
    if (status == FOOTPOINT_ERR_DOMAIN) {
        t->far++;
        assert_true(least > q->longest * (1 - 1e-9) && loc[0] == 7 && dist == 7 && region == 77);
        return;
    }
    if (status == FOOTPOINT_UNPROVED)
        return;
    assert_int_equal(status, FOOTPOINT_OK);
    t->answers++;
    const double longer = (fabs(dist) - least) / q->longest;
    const double off = fmax(fabs(loc[0] - certain[0]), fabs(loc[1] - certain[1]));
    assert_true(longer > -1e-9);
    t->longer = fmax(t->longer, longer);
    const int right = region_of(k->corners, certain[0], certain[1], &margin);
    const int claims = region_of(k->corners, loc[0], loc[1], &other);
    const bool clear = margin > TIE && longer < 1e-9 && off < 1e-4;
    if (longer > 1e-8 && t->wrong++ < 5)
        printf("# %s: status %d, %.12g %.12g %.17g, certain %.12g %.12g %.17g\n", k->scene, status, loc[0], loc[1],
               dist, certain[0], certain[1], least);
    t->off = clear ? fmax(t->off, off) : t->off;
    t->regions += (clear && region != right) || (other > TIE && region != claims);
    double ahead = 0, r[3];
    curved_face_point(&f, loc[0], loc[1], r);
    for (int j = 0; j < 3; j++)
        ahead -= r[j] * q->normal[j];
    t->sides += region == 0 && fabs(ahead) > 1e-3 * q->longest && ahead * dist < 0;
    if (k->coarse(q->x, q->xs, loc, &dist, &region) == FOOTPOINT_OK)
        t->coarse = fmax(t->coarse, (fabs(dist) - least) / q->longest);
}

static void closest_points_are_right(void **state)
{
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct tally t = {0};
        each_sample(&kinds[k], ask_closest, &t);
        printf("# %s: %ld answers, %ld far, %ld wrong, %ld regions, %ld sides; off by %.1e, distance by %.1e, coarse "
               "%.1e\n",
               kinds[k].scene, t.answers, t.far, t.wrong, t.regions, t.sides, t.off, t.longer, t.coarse);
        print_robust(&kinds[k], "", &t.robust);
        assert_true(t.wrong == 0 && t.regions == 0 && t.sides == 0 && t.answers > samples() * 9 / 10);
        assert_true(t.robust.closest == 0 && t.robust.located == 0);
        assert_true(t.robust.wrong == 0 && t.robust.apart == 0 && t.robust.status[FOOTPOINT_UNPROVED] == 0);
    }
}

/* ---- strongly curved faces ---- */

enum bend { LOOSE, ROUND, TUBE, FOLDED, BENDS };

/* Draws nodes at places p from -1/2 to 1/2: moved, middles of edges by up to half an edge; on arcs of up to half a
 * circle in one direction or both; with C near A. */
static void bend(const struct kind *k, enum bend how, gsl_rng *stream, double (*x)[3], double angle[2])
{
    static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double three[6][2] = {{-1, -1}, {1, -1}, {-1, 1}, {0, -1}, {0, 0}, {-1, 0}};
    const double middle =
        how == FOLDED || how == LOOSE ? gsl_ran_flat(stream, 0.3, 0.5) : 0.1 * (double)gsl_rng_uniform_int(stream, 2);
    angle[0] = gsl_ran_flat(stream, 0.5, M_PI);
    angle[1] = how == ROUND ? gsl_ran_flat(stream, 0.5, M_PI) : 1e-6;
    for (int n = 0; n < k->nodes; n++) {
        const double *const p = k->corners == 3 ? three[n] : square[n], move = n < k->corners ? 0.4 * middle : middle;
        for (int j = 0; j < 2; j++)
            x[n][j] = how == ROUND || how == TUBE ? sin(0.5 * angle[j] * p[j]) / angle[j] : 0.5 * p[j];
        x[n][2] = 0;
        for (int j = 0; j < 2 && how != LOOSE && how != FOLDED; j++)
            x[n][2] += (cos(0.5 * angle[j] * p[j]) - 1) / angle[j];
        for (int j = 0; j < 3; j++)
            x[n][j] = (how == FOLDED && n == 2 ? x[0][j] : x[n][j]) + gsl_ran_flat(stream, -move, move);
    }
}

/* Draws a slave node up to two edges away, on the face or near it, equally near to two nodes, or near an axis of the
 * arcs. */
static void put(const struct kind *k, enum bend how, gsl_rng *stream, double (*x)[3], const double angle[2], double *xs)
{
    const double none[3] = {0, 0, 0}, near = pow(10, gsl_ran_flat(stream, -10, 0));
    const int where = (int)gsl_rng_uniform_int(stream, 4);
    struct curved_face f;
    for (int j = 0; j < 3; j++)
        xs[j] = gsl_ran_flat(stream, -2, 2);
    if (where == 1) {
        const double u = gsl_rng_uniform(stream), v = gsl_rng_uniform(stream);
        double r[3];
        curved_face_of(&f, k->nodes, x, none);
        curved_face_point(&f, k->corners == 3 ? u * (1 - v) : 2 * u - 1, k->corners == 3 ? v : 2 * v - 1, r);
        for (int j = 0; j < 3; j++)
            xs[j] = near < 1e-9 ? r[j] : r[j] + near * xs[j];
    } else if (where == 2) {
        const int a = (int)gsl_rng_uniform_int(stream, (unsigned long)k->nodes), b = (a + 2) % k->nodes;
        double across = 0, length = 0;
        for (int j = 0; j < 3; j++) {
            across += (x[b][j] - x[a][j]) * (xs[j] - 0.5 * (x[a][j] + x[b][j]));
            length += pow(x[b][j] - x[a][j], 2);
        }
        for (int j = 0; j < 3; j++)
            xs[j] -= across / length * (x[b][j] - x[a][j]);
    } else if (where == 3 && (how == ROUND || how == TUBE)) {
        xs[0] = near * xs[0];
        xs[1] = how == TUBE ? 0.5 * xs[1] : near * xs[1];
        xs[2] = -1 / angle[0] + near * xs[2];
    }
}

static void strongly_curved_faces(void **state)
{
    const long count = long_cases(STRONG, STRONG_LONG);
    gsl_rng *stream = stream_new();
    (void)state;
    for (int k = 0; k < KINDS; k++) {
        struct robust t = {0};
        for (long i = 0; i < count; i++) {
            const enum bend how = (enum bend)(i % BENDS);
            double x[VECTORS][3], xs[3], angle[2], certain[2];
            struct curved_face f;
            stream_key(stream, SEED_STRONG, (uint64_t)k, (uint64_t)i, 0);
            bend(&kinds[k], how, stream, x, angle);
            put(&kinds[k], how, stream, x, angle, xs);
            curved_face_of(&f, kinds[k].nodes, x, xs);
            const double least = curved_face_closest(&f, certain);
            ask_robust(&kinds[k], x, xs, &f, certain, least, &t);
        }
        print_robust(&kinds[k], ", strongly curved", &t);
        assert_true(t.wrong == 0 && t.apart == 0 && t.closest == 0 && t.located == 0 &&
                    t.status[FOOTPOINT_UNPROVED] <= count / 100);
    }
    gsl_rng_free(stream);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(closest_points_are_right),
        cmocka_unit_test(strongly_curved_faces),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
