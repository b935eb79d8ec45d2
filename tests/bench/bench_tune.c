/* Fits rivals to a scene; see bench_tune.h. */
#include "bench_tune.h"

#include "../../codegen/base/base.h"
#include "bench_cases.h"

#include <gsl/gsl_multilarge.h>
#include <gsl/gsl_multimin.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { POINT_SAMPLES = 2000, POINT_STEPS = 60, COEFFICIENT_SAMPLES = 8000 };
static const double point_tolerance = 1e-4;

/* Training samples as inputs of a method, and its answers. */
struct fit {
    const struct bench_method *method;
    struct rival_tuning *tuning;
    const struct sample **s;
    struct bench_input *in;
    double (*found)[BENCH_FOUND];
    size_t n;
};

static struct fit fit_new(const struct bench_method *m, const struct sample_set *training, size_t most,
                          struct rival_tuning *t)
{
    struct fit f = {.method = m, .tuning = t, .n = training->n < most ? training->n : most};
    f.s = new_array(f.n, sizeof *f.s);
    f.in = new_array(f.n, sizeof *f.in);
    f.found = new_array(f.n, sizeof *f.found);
    for (size_t i = 0; i < f.n; i++) {
        f.s[i] = &training->s[i * training->n / f.n];
        f.in[i] = bench_input_of(segment_find(m->kind), f.s[i]);
    }
    return f;
}

static void fit_free(struct fit *f)
{
    free(f->s);
    free(f->in);
    free(f->found);
}

/* Sets the start to (xi0, eta0); steps stay in the scene's box. */
static void set_point(struct rival_tuning *t, double xi0, double eta0)
{
    const double start[2] = {xi0, eta0};
    t->xi0 = xi0;
    t->eta0 = eta0;
    t->s = 0.5 * (1 + xi0);
    t->t = 0.5 * (1 + eta0);
    for (int k = 0; k < 2; k++) {
        t->clamp.scaled.low[k] = t->box.low[k] - start[k];
        t->clamp.scaled.high[k] = t->box.high[k] - start[k];
        t->clamp.plain.low[k] = 0.5 * t->clamp.scaled.low[k];
        t->clamp.plain.high[k] = 0.5 * t->clamp.scaled.high[k];
    }
}

static double mean_error(const gsl_vector *point, void *data)
{
    const struct fit *f = data;
    double sum = 0;
    set_point(f->tuning, gsl_vector_get(point, 0), gsl_vector_get(point, 1));
    f->method->scalar(f->in, f->n, NULL, f->tuning, f->found, NULL);
    for (size_t i = 0; i < f->n; i++)
        sum += fabs(f->found[i][0] - f->s[i]->xi) + fabs(f->found[i][1] - f->s[i]->eta);
    return isfinite(sum) ? sum / (2 * (double)f->n) : GSL_DBL_MAX;
}

/* Minimises the mean error over the starting point, from the middle of the box, by the simplex method. */
static void tune_point(struct fit *f)
{
    const struct rival_box *box = &f->tuning->box;
    gsl_multimin_function error = {mean_error, 2, f};
    gsl_multimin_fminimizer *search = gsl_multimin_fminimizer_alloc(gsl_multimin_fminimizer_nmsimplex2, 2);
    gsl_vector *middle = gsl_vector_alloc(2), *step = gsl_vector_alloc(2);
    for (size_t k = 0; k < 2; k++) {
        gsl_vector_set(middle, k, 0.5 * (box->low[k] + box->high[k]));
        gsl_vector_set(step, k, 0.1 * (box->high[k] - box->low[k]));
    }
    const double there = mean_error(middle, f);
    gsl_multimin_fminimizer_set(search, &error, middle, step);
    for (int i = 0; i < POINT_STEPS && gsl_multimin_fminimizer_size(search) > point_tolerance; i++)
        if (gsl_multimin_fminimizer_iterate(search))
            break;
    const gsl_vector *best = search->fval < there ? search->x : middle;
    set_point(f->tuning, gsl_vector_get(best, 0), gsl_vector_get(best, 1));
    gsl_vector_free(middle);
    gsl_vector_free(step);
    gsl_multimin_fminimizer_free(search);
}

/* Fills the matrix of a method that is linear in its coefficients: each column is its answer with one coefficient 1 and
 * the others 0. */
static void fill_columns(const struct fit *f, int output, gsl_matrix *columns, gsl_vector *wanted)
{
    double *coefficient = output ? f->tuning->eta : f->tuning->xi;
    for (int k = 0; k < f->method->coefficients; k++) {
        memset(coefficient, 0, RIVAL_TERMS * sizeof *coefficient);
        coefficient[k] = 1;
        f->method->scalar(f->in, f->n, NULL, f->tuning, f->found, NULL);
        for (size_t i = 0; i < f->n; i++)
            gsl_matrix_set(columns, i, (size_t)k, f->found[i][output]);
    }
    for (size_t i = 0; i < f->n; i++)
        gsl_vector_set(wanted, i, output ? f->s[i]->eta : f->s[i]->xi);
}

static void tune_coefficients(struct fit *f)
{
    const size_t p = (size_t)f->method->coefficients;
    for (int output = 0; output < 2; output++) {
        gsl_matrix *columns = gsl_matrix_alloc(f->n, p);
        gsl_vector *wanted = gsl_vector_alloc(f->n), *c = gsl_vector_calloc(p);
        gsl_multilarge_linear_workspace *squares = gsl_multilarge_linear_alloc(gsl_multilarge_linear_tsqr, p);
        double residual, length;
        fill_columns(f, output, columns, wanted);
        gsl_multilarge_linear_accumulate(columns, wanted, squares);
        gsl_multilarge_linear_solve(0, c, &residual, &length, squares);
        for (size_t k = 0; k < p; k++)
            (output ? f->tuning->eta : f->tuning->xi)[k] = gsl_vector_get(c, k);
        gsl_multilarge_linear_free(squares);
        gsl_vector_free(c);
        gsl_vector_free(wanted);
        gsl_matrix_free(columns);
    }
}

void bench_tune(const struct bench_method *m, const struct scene *scene, const struct sample_set *training,
                struct rival_tuning *t)
{
    *t = (struct rival_tuning){.s = 0.5};
    scene_box(scene, t->box.low, t->box.high);
    set_point(t, 0.5 * (t->box.low[0] + t->box.high[0]), 0.5 * (t->box.low[1] + t->box.high[1]));
    if (m->tune == TUNE_NOTHING)
        return;
    struct fit f = fit_new(m, training, m->tune == TUNE_POINT ? POINT_SAMPLES : COEFFICIENT_SAMPLES, t);
    if (m->tune == TUNE_POINT)
        tune_point(&f);
    else
        tune_coefficients(&f);
    fit_free(&f);
}
