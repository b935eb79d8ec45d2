/* Fits the numbers of programs; see fit_lines.h. The loss of an error e is the square of the residual that GSL gets:
 *
 *   mean   e / sqrt(s + sqrt(e^2 + s^2)), whose square is sqrt(e^2 + s^2) - s, with s small beside the mean error;
 *   max    |e / s|^(p/2) with s the largest error and growing p;
 *   99 %   as max with s the 99 % error; beyond s, where outliers are tolerated, sqrt(1 + p - p s / |e|). */
#include "fit_lines.h"

#include "../../codegen/base/simd.h"
#include "../common/decimal.h"
#include "../eval/errors.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multifit_nlinear.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double hopeless = 1e100, largest = 9e9; /* residual of a value that is not finite; largest decimal
                                                      * number */

struct task {
    struct lines_run *run;
    enum scene_norm norm;
    double scale;
    int power;
};

/* Returns the residual of an error and its derivative, for norms other than the mean. */
static double residual_of(const struct task *t, double e, double *slope)
{
    const double sign = e < 0 ? -1 : 1, size = fabs(e) / t->scale;
    *slope = 0;
    if (!isfinite(e))
        return hopeless;
    if (t->norm == NORM_P99 && size > 1) {
        const double value = sqrt(1 + t->power - t->power / size);
        *slope = 0.5 * t->power / (size * size * value * t->scale);
        return sign * value;
    }
    double below = 1; /* size^(p/2 - 1) without pow(), whose last digit depends on the machine */
    for (int i = 1; i < t->power / 2; i++)
        below *= size;
    *slope = t->power / 2 * below / t->scale;
    return sign * below * size;
}

/* Computes the residuals of n errors in the mean norm. */
WIDE static void residuals_of_mean(double scale, const double *error, size_t n, double *residual, double *slope)
{
    for (size_t k = 0; k < n; k++) {
        const double e = error[k], root = sqrt(e * e + scale * scale), under = sqrt(scale + root);
        const bool good = fabs(e) < INFINITY;
        slope[k] = good ? 1 / under - 0.5 * e * e / (root * under * under * under) : 0;
        residual[k] = good ? e / under : hopeless;
    }
}

static bool set_numbers(const struct task *t, const gsl_vector *x)
{
    const struct lines *c = t->run->code;
    bool good = true;
    for (size_t i = 0; i < c->numbers; i++) {
        c->line[c->number[i]].number = gsl_vector_get(x, i);
        good = good && fabs(gsl_vector_get(x, i)) < largest;
    }
    return good;
}

static double error_at(const struct lines_run *r, size_t row, size_t k, size_t half)
{
    return r->value[r->code->root[half]][k] - columns_at(r->table, r->table->count - 2 + half)[row + k];
}

/* Computes residuals and their derivatives for a block of samples and an answer. */
static void residuals_at(const struct task *t, size_t row, size_t half, double *residual, double *slope)
{
    const size_t n = lines_rows(t->run, row);
    double error[TAPE_BLOCK];
    for (size_t k = 0; k < n; k++)
        error[k] = error_at(t->run, row, k, half);
    if (t->norm == NORM_MEAN)
        residuals_of_mean(t->scale, error, n, residual, slope);
    else
        for (size_t k = 0; k < n; k++)
            residual[k] = residual_of(t, error[k], &slope[k]);
}

static int residuals(const gsl_vector *x, void *context, gsl_vector *f)
{
    const struct task *t = context;
    struct lines_run *r = t->run;
    double slope[TAPE_BLOCK];
    if (!set_numbers(t, x)) {
        gsl_vector_set_all(f, hopeless);
        return GSL_SUCCESS;
    }
    for (size_t row = 0; row < r->table->n; row += TAPE_BLOCK) {
        lines_values(r, row);
        for (size_t half = 0; half < 2; half++)
            residuals_at(t, row, half, f->data + half * r->table->n + row, slope);
    }
    return GSL_SUCCESS;
}

static int derivatives(const gsl_vector *x, void *context, gsl_matrix *J)
{
    const struct task *t = context;
    struct lines_run *r = t->run;
    double residual[TAPE_BLOCK], slope[TAPE_BLOCK];
    set_numbers(t, x);
    for (size_t row = 0; row < r->table->n; row += TAPE_BLOCK) {
        lines_values(r, row);
        for (size_t half = 0; half < 2; half++) {
            double *to = J->data + (half * r->table->n + row) * J->tda;
            lines_slopes(r, (int)half);
            residuals_at(t, row, half, residual, slope);
            for (size_t i = 0; i < r->code->numbers; i++) {
                const double *by = r->slope[r->code->number[i]];
                for (size_t k = 0; k < lines_rows(r, row); k++) {
                    const double d = by ? slope[k] * by[k] : 0;
                    to[k * J->tda + i] = fabs(d) < INFINITY ? d : 0;
                }
            }
        }
    }
    return GSL_SUCCESS;
}

/* Writes absolute errors to error[0..2n-1] and returns their mean. */
static double measure(struct lines_run *r, double *error)
{
    const size_t n = r->table->n;
    double sum = 0;
    for (size_t row = 0; row < n; row += TAPE_BLOCK) {
        lines_values(r, row);
        for (size_t half = 0; half < 2; half++)
            for (size_t k = 0; k < lines_rows(r, row); k++)
                sum += error[half * n + row + k] = fabs(error_at(r, row, k, half));
    }
    return sum / (double)(2 * n);
}

/* Sets the k-th loss in the sequence that approaches a norm. Returns false if the error is already 0. */
static bool choose_loss(struct task *t, int k, double *error)
{
    static const double nearness[] = {1, 0.3, 0.1};
    static const int most[] = {4, 8, 16}, power[] = {4, 16, 64};
    const size_t n = 2 * t->run->table->n;
    const double mean = measure(t->run, error);
    t->power = t->norm == NORM_P99 ? most[k] : power[k];
    t->scale = t->norm == NORM_MEAN  ? mean * nearness[k]
               : t->norm == NORM_P99 ? errors_p99(error, n)
                                     : errors_max(error, n);
    return isfinite(mean) && isfinite(t->scale) && t->scale > 0;
}

static void descend(struct task *t, gsl_multifit_nlinear_workspace *w, gsl_vector *x, int iterations)
{
    gsl_multifit_nlinear_fdf fdf = {
        .f = residuals, .df = derivatives, .n = 2 * t->run->table->n, .p = t->run->code->numbers, .params = t};
    gsl_multifit_nlinear_init(x, &fdf, w);
    while (iterations-- > 0 && gsl_multifit_nlinear_iterate(w) == GSL_SUCCESS)
        ;
    gsl_vector_memcpy(x, gsl_multifit_nlinear_position(w));
    set_numbers(t, x);
}

bool lines_fit(struct lines_run *r, const struct genes *in, int last, enum scene_norm norm, int iterations,
               struct genes *out)
{
    struct task t = {r, norm, 1, 2};
    lines_run_load(r, in, last, -1);
    const size_t numbers = r->code->numbers, n = 2 * r->table->n;
    if (numbers == 0 || numbers > n)
        return false;
    gsl_multifit_nlinear_parameters how = gsl_multifit_nlinear_default_parameters();
    how.solver = gsl_multifit_nlinear_solver_cholesky;
    gsl_multifit_nlinear_workspace *w = gsl_multifit_nlinear_alloc(gsl_multifit_nlinear_trust, &how, n, numbers);
    gsl_vector *x = gsl_vector_alloc(numbers);
    double *error = new_array(n, sizeof *error);
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* a last step without progress is not an error */
    bool good = false;
    for (size_t i = 0; i < numbers; i++)
        gsl_vector_set(x, i, r->code->line[r->code->number[i]].number);
    for (int k = 0; k < 3 && choose_loss(&t, k, error); k++) {
        descend(&t, w, x, iterations);
        good = true;
    }
    gsl_set_error_handler(handler);
    genes_copy(in, out);
    for (size_t i = 0; i < numbers; i++)
        out->gene[r->code->place[i]] = decimal_gene(gsl_vector_get(x, i));
    free(error);
    gsl_vector_free(x);
    gsl_multifit_nlinear_free(w);
    return good;
}
