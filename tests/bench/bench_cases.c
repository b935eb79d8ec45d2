/* Questions and their answers; see bench_cases.h. */
#include "bench_cases.h"

#include "../../codegen/base/base.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/surface/surface.h"
#include "../rivals/rivals_derivatives.h"
#include "../support/curved_face.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { SEED = 20271 };
static const double turn = 2.399963229728653; /* the golden angle */

/* Returns how far the last step's answer lies from the foot point, in sizes of the segment. */
static double move_of(enum bench_question question)
{
    return question == ASK_FROM_NEAR ? 1e-3 : question == ASK_FROM_FAR ? 1e-1 : 1e-2;
}

static void ask_from(const struct segment_kind *kind, double move, size_t i, struct bench_case *c)
{
    const double way = move * (kind->triangle ? 1 : 2); /* in xi and eta */
    c->in.before[0] = c->xi + way * cos(turn * (double)i);
    c->in.before[1] = c->eta + way * sin(turn * (double)i);
}

struct bench_input bench_input_of(const struct segment_kind *kind, const struct sample *s)
{
    struct bench_input in = {.before = {0, 0}};
    for (int k = 0; k < 3; k++) {
        for (size_t n = 0; n < segment_vectors(kind); n++)
            in.x[n][k] = s->x[n][k];
        in.x[segment_vectors(kind)][k] = s->xs[k];
    }
    return in;
}

/* ---- several slave nodes over one segment ---- */

static void ask_over(const struct surface *f, const struct bench_case *first, struct bench_case *c)
{
    double(*const x)[3] = c->in.x, r[3], n[3];
    memcpy(x, first->in.x, f->nodes * sizeof *x);
    c->gap *= first->size / c->size;
    c->size = first->size;
    if (surface_normal(f, x, c->xi, c->eta, r, n))
        for (int k = 0; k < 3; k++)
            x[f->nodes][k] = r[k] + c->gap * n[k];
}

/* ---- closest points ---- */

/* Copies three or four nodes as the six or nine of the same face. */
static void curved_of(const struct segment_kind *kind, double (*x)[3], struct curved_face *f)
{
    const size_t n = segment_vectors(kind);
    double y[SEGMENT_VECTORS][3];
    if (n > 4) {
        curved_face_of(f, (int)n, x, x[n]);
        return;
    }
    for (int k = 0; k < 3; k++) {
        double sum = 0;
        for (size_t i = 0; i < n; i++) {
            y[i][k] = x[i][k];
            y[n + i][k] = 0.5 * (x[i][k] + x[(i + 1) % n][k]);
            sum += x[i][k];
        }
        if (n == 4)
            y[8][k] = 0.25 * sum;
    }
    curved_face_of(f, n == 4 ? 9 : 6, y, x[n]);
}

static double longest_edge(const struct segment_kind *kind, double (*x)[3])
{
    double longest = 0;
    for (size_t i = 0; i < kind->corners; i++) {
        double d[3];
        for (int k = 0; k < 3; k++)
            d[k] = x[(i + 1) % kind->corners][k] - x[i][k];
        longest = fmax(longest, sqrt(rival_dot(d, d)));
    }
    return longest;
}

static void ask_closest(const struct surface *f, const struct segment_kind *kind, gsl_rng *stream, bool beside,
                        struct bench_case *c)
{
    double(*const x)[3] = c->in.x, *const xs = x[f->nodes], here[3], r[3][3], loc[2];
    const double edge = kind->triangle ? 1 : 2, longest = longest_edge(kind, x);
    memcpy(here, xs, sizeof here);
    f->point(f, x, c->xi, c->eta, r);
    do {
        const double u = beside ? gsl_ran_flat(stream, -edge, edge) : 0,
                     v = beside ? gsl_ran_flat(stream, -edge, edge) : 0;
        struct curved_face face;
        for (int k = 0; k < 3; k++)
            xs[k] = here[k] + u * r[1][k] + v * r[2][k];
        curved_of(kind, x, &face);
        c->gap = curved_face_closest(&face, loc);
    } while (beside && c->gap > 0.9 * longest);
    c->xi = loc[0];
    c->eta = loc[1];
}

/* ---- along a direction ---- */

static void ask_along(const struct surface *f, gsl_rng *stream, struct bench_case *c)
{
    double(*const x)[3] = c->in.x, *const xs = x[f->nodes], *const p = x[f->nodes + 1], r[3], n[3];
    if (!surface_normal(f, x, c->xi, c->eta, r, n))
        return;
    for (int k = 0; k < 3; k++)
        p[k] = n[k] + gsl_ran_flat(stream, -0.3, 0.3);
    const double length = sqrt(rival_dot(p, p));
    for (int k = 0; k < 3; k++) {
        p[k] /= length;
        xs[k] = r[k] + c->gap * p[k];
    }
}

/* Returns the square root of the area: half the product of the diagonals, or the parallelogram of the tangents in the
 * middle. */
static double size_of(const struct segment_kind *kind, double (*x)[3])
{
    const struct surface *f = surface_find(kind);
    const double middle = kind->triangle ? 1.0 / 3 : 0;
    double at[3][3], a[3], b[3], area = kind->triangle ? 0.5 : 4;
    f->point(f, x, middle, middle, at);
    for (int k = 0; k < 3; k++) {
        a[k] = kind->bilinear ? x[2][k] - x[0][k] : at[1][k];
        b[k] = kind->bilinear ? x[3][k] - x[1][k] : at[2][k];
    }
    if (kind->bilinear)
        area = 0.5;
    const double ab = rival_dot(a, b);
    return sqrt(area * sqrt(rival_dot(a, a) * rival_dot(b, b) - ab * ab));
}

struct bench_cases bench_cases_new(const struct scene *scene, enum bench_question question,
                                   const struct sample_set *set, size_t most)
{
    const size_t n = set->n < most ? set->n : most;
    const struct surface *f = surface_find(scene->segment);
    struct bench_cases cases = {new_array(n, sizeof *cases.of), n};
    gsl_rng *stream = stream_new();
    for (size_t i = 0; i < n; i++) {
        const struct sample *s = &set->s[i * set->n / n];
        cases.of[i] = (struct bench_case){bench_input_of(scene->segment, s), s->xi, s->eta, s->gap, 0};
        ask_from(scene->segment, move_of(question), i, &cases.of[i]);
        cases.of[i].size = size_of(scene->segment, cases.of[i].in.x);
        stream_key(stream, SEED, question, i, 0);
        if (question == ASK_OVER)
            ask_over(f, &cases.of[i - i % BENCH_OVER], &cases.of[i]);
        else if (question == ASK_CLOSEST)
            ask_closest(f, scene->segment, stream, i % 2, &cases.of[i]);
        else if (question == ASK_ALONG)
            ask_along(f, stream, &cases.of[i]);
    }
    gsl_rng_free(stream);
    return cases;
}

void bench_cases_free(struct bench_cases *cases)
{
    free(cases->of);
}

/* ---- errors ---- */

/* Returns the gap (9) at (xi, eta). */
static double gap_at(const struct segment_kind *kind, double (*x)[3], const double at[2])
{
    const double *const xs = x[segment_vectors(kind)];
    double r[3], n[3], d[3];
    if (!surface_normal(surface_find(kind), x, at[0], at[1], r, n))
        return (double)NAN;
    for (int k = 0; k < 3; k++)
        d[k] = xs[k] - r[k];
    return rival_dot(d, n);
}

/* Computes the errors of derivatives at the certain foot point, by the implicit function theorem. */
static void slope_errors(const struct segment_kind *kind, const struct bench_case *c, bench_slopes slope,
                         double error[BENCH_FOUND])
{
    const struct surface *f = surface_find(kind);
    const double loc[2] = {c->xi, c->eta};
    double phi[6 * SEGMENT_VECTORS], gap, most = 0;
    bench_slopes right;
    if (kind->bilinear)
        rival_implicit((const double(*)[3])c->in.x, loc, &gap, right);
    else {
        f->shape(c->xi, c->eta, phi);
        rival_implicit_face((int)f->nodes, phi, (const double(*)[3])c->in.x, &gap, right);
    }
    for (size_t k = 0; k < segment_inputs(kind); k++)
        most = fmax(most, fmax(fabs(right[0][k]), fabs(right[1][k])));
    for (int o = 0; o < BENCH_FOUND; o++) {
        error[o] = 0;
        for (size_t k = 0; k < segment_inputs(kind); k++)
            error[o] = fmax(error[o], fabs(slope[o][k] - right[o][k]) / (o < 2 ? most : 1));
    }
}

void bench_errors(const struct segment_kind *kind, enum bench_question question, const struct bench_case *c,
                  const double found[BENCH_FOUND], bench_slopes slope, double error[BENCH_FOUND])
{
    double x[BENCH_VECTORS][3];
    if (!(fabs(found[0]) < BENCH_NO_ANSWER && fabs(found[1]) < BENCH_NO_ANSWER)) {
        error[0] = error[1] = error[2] = (double)NAN;
        return;
    }
    if (question == ASK_DERIVATIVES) {
        slope_errors(kind, c, slope, error);
        return;
    }
    memcpy(x, c->in.x, sizeof x);
    error[0] = fabs(found[0] - c->xi);
    error[1] = fabs(found[1] - c->eta);
    error[2] = question == ASK_BARE      ? fabs(gap_at(kind, x, found) - c->gap)
               : question == ASK_CLOSEST ? fabs(fabs(found[2]) - c->gap)
                                         : fabs(found[2] - c->gap);
    error[2] /= c->size;
}
