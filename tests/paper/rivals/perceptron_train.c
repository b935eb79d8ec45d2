/* Trains perceptrons; see perceptron_train.h.  GSL takes the damped steps.  normal_equations.h sums the normal equations block by
 * block, so the derivatives are never stored for all samples. */
#include "perceptron_train.h"

#include "normal_equations.h"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_multilarge_nlinear.h>
#include <math.h>
#include <stdlib.h>

enum { ROWS = 512 }; /* rows of derivatives held at once: two for each sample */
static const double settled = 1e-9;

struct task {
    const struct perceptron *p;
    const struct lesson *lesson;
    struct products products; /* products of the weights' columns and the residual's */
    double *panel, *sum;      /* a block of J and of the residual beside it; their products */
};

static void row_inputs(const struct task *t, size_t row, double *in)
{
    for (size_t i = 0; i < t->p->size[0]; i++)
        in[i] = columns_at(t->lesson->table, t->lesson->input[i])[row];
}

/* Computes residuals: those for sample i are elements 2 i and 2 i + 1. */
static int residuals(const gsl_vector *weight, void *context, gsl_vector *f)
{
    const struct task *t = context;
    struct perceptron_state s;
    double in[PERCEPTRON_WIDTH];
    for (size_t i = 0; i < t->lesson->n; i++) {
        row_inputs(t, i, in);
        perceptron_forward(t->p, weight->data, in, &s);
        for (size_t k = 0; k < 2; k++)
            gsl_vector_set(f, 2 * i + k,
                           s.value[t->p->layers - 1][k] - columns_at(t->lesson->table, t->lesson->target[k])[i]);
    }
    return GSL_SUCCESS;
}

/* Fills two rows of the panel: the derivatives of a sample's outputs, and u beside them.  Beyond the last sample, zeros. */
static void fill_rows(const struct task *t, const double *weight, const gsl_vector *u, size_t sample, double *row)
{
    const size_t count = perceptron_weights(t->p);
    struct perceptron_state s;
    double in[PERCEPTRON_WIDTH];
    if (sample >= t->lesson->n) {
        for (size_t j = 0; j <= count; j++)
            row[j * ROWS] = row[j * ROWS + 1] = 0;
        return;
    }
    row_inputs(t, sample, in);
    perceptron_forward(t->p, weight, in, &s);
    for (size_t k = 0; k < 2; k++) {
        perceptron_backward(t->p, weight, &s, k, row + k, ROWS);
        row[count * ROWS + k] = gsl_vector_get(u, 2 * sample + k);
    }
}

/* Computes v = J'u and JTJ = J'J for GSL's Levenberg-Marquardt method. */
static int derivatives(CBLAS_TRANSPOSE_t transposed, const gsl_vector *weight, const gsl_vector *u, void *context,
                       gsl_vector *v, gsl_matrix *JTJ)
{
    struct task *t = context;
    const size_t count = weight->size;
    const struct panel panel = {t->panel, ROWS};
    if (transposed != CblasTrans)
        return GSL_EUNSUP;
    products_clear(&t->products);
    for (size_t first = 0; first < t->lesson->n; first += ROWS / 2) {
        for (size_t i = 0; i < ROWS / 2; i++)
            fill_rows(t, weight->data, u, first + i, t->panel + 2 * i);
        products_add(&t->products, panel, panel, ROWS, true);
    }
    products_sum(&t->products, true, t->sum);
    for (size_t i = 0; i < count; i++) {
        gsl_vector_set(v, i, t->sum[count * (count + 1) + i]);
        for (size_t j = 0; JTJ && j <= i; j++)
            gsl_matrix_set(JTJ, i, j, t->sum[i * (count + 1) + j]);
    }
    return GSL_SUCCESS;
}

double perceptron_train(const struct perceptron *p, const struct lesson *lesson, size_t iterations, double *weight)
{
    const size_t count = perceptron_weights(p), residual_count = 2 * lesson->n;
    struct task t = {.p = p,
                     .lesson = lesson,
                     .products = products_new(count + 1, count + 1),
                     .panel = new_array((count + 1) * ROWS, sizeof *t.panel),
                     .sum = new_array((count + 1) * (count + 1), sizeof *t.sum)};
    gsl_multilarge_nlinear_parameters how = gsl_multilarge_nlinear_default_parameters();
    gsl_multilarge_nlinear_fdf fdf = {.f = residuals, .df = derivatives, .n = residual_count, .p = count, .params = &t};
    gsl_vector_view start = gsl_vector_view_array(weight, count);
    int why;
    how.trs = gsl_multilarge_nlinear_trs_lm;
    gsl_multilarge_nlinear_workspace *w =
        gsl_multilarge_nlinear_alloc(gsl_multilarge_nlinear_trust, &how, residual_count, count);
    gsl_error_handler_t *handler = gsl_set_error_handler_off(); /* a last step without progress is not an error here */
    gsl_multilarge_nlinear_init(&start.vector, &fdf, w);
    if (iterations > 0)
        gsl_multilarge_nlinear_driver(iterations, settled, settled, settled, NULL, NULL, &why, w);
    gsl_vector_memcpy(&start.vector, gsl_multilarge_nlinear_position(w));
    const gsl_vector *f = gsl_multilarge_nlinear_residual(w);
    double square = 0;
    for (size_t i = 0; i < residual_count; i++)
        square += gsl_vector_get(f, i) * gsl_vector_get(f, i);
    gsl_multilarge_nlinear_free(w);
    gsl_set_error_handler(handler);
    products_free(&t.products);
    free(t.panel);
    free(t.sum);
    return sqrt(square / (double)residual_count);
}
