/* Computes coefficients for a norm other than the squares, by weighted least squares, repeated.  With weights 1/|r| the squares sum
 * to the mean |r|; for the largest |r|, weights are multiplied by |r| each time (C. Lawson, 1961).  The best of all rounds
 * is kept. */
#include "polynomials.h"

#include "../../../codegen/base/base.h"
#include "normal_equations.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS_OF_MEAN = 40, ROUNDS_OF_MAX = 400, ROWS = POLYNOMIALS_ROWS };
static const double floor_of_mean = 1e-3; /* |r| counts as at least this fraction of the mean */

struct refit {
    const struct polynomials *p;
    enum scene_norm norm;
    size_t *at; /* owned, like all arrays here: the terms, then the target's column */
    size_t terms;
    double *residual, *weight; /* by row of the blocks */
};

/* Computes residuals, and the error in the norm. */
static double measure(struct refit *f, const double *coefficient)
{
    const size_t blocks = f->p->blocks;
    double sum = 0, most = 0;
    for (size_t b = 0; b < blocks; b++)
        for (size_t k = 0; k < ROWS; k++) {
            double r = -polynomials_column(f->p, b, f->p->count)[k];
            for (size_t i = 0; i < f->terms; i++)
                r += coefficient[i] * polynomials_column(f->p, b, f->at[i])[k];
            f->residual[b * ROWS + k] = r;
            sum += fabs(r);
            most = fmax(most, fabs(r));
        }
    return f->norm == NORM_MAX ? most : sum / (double)f->p->samples;
}

static void weigh(struct refit *f)
{
    const size_t n = f->p->blocks * ROWS;
    double mean = 0, sum = 0;
    for (size_t i = 0; i < n; i++)
        mean += fabs(f->residual[i]) / (double)f->p->samples;
    for (size_t i = 0; i < n; i++) {
        const double size = fmax(fabs(f->residual[i]), floor_of_mean * mean);
        f->weight[i] = f->norm == NORM_MAX ? f->weight[i] * size : 1 / size;
        sum += f->weight[i];
    }
    for (size_t i = 0; i < n && sum > 0; i++)
        f->weight[i] *= (double)n / sum;
}

/* Returns false if the weighted terms are dependent. */
static bool solve(const struct refit *f, double *coefficient)
{
    const size_t all = f->terms + 1;
    struct products sums = products_new(all, all);
    double *panel = new_array(all * ROWS, sizeof *panel), *gram = new_array(all * all, sizeof *gram);
    double *work = new_array(all * all, sizeof *work);
    size_t *each = new_array(all, sizeof *each);
    for (size_t b = 0; b < f->p->blocks; b++) {
        for (size_t i = 0; i < all; i++)
            for (size_t k = 0; k < ROWS; k++)
                panel[i * ROWS + k] = sqrt(f->weight[b * ROWS + k]) * polynomials_column(f->p, b, f->at[i])[k];
        products_add(&sums, (struct panel){panel, ROWS}, (struct panel){panel, ROWS}, ROWS, true);
    }
    products_sum(&sums, true, gram);
    for (size_t i = 0; i < all; i++)
        each[i] = i;
    const bool good = products_fit(gram, all, each, f->terms, f->terms, coefficient, work) >= 0;
    products_free(&sums);
    free(panel);
    free(gram);
    free(work);
    free(each);
    return good;
}

void polynomials_fit_norm(const struct polynomials *p, const gene_bit *chosen, enum scene_norm norm,
                          double *coefficient)
{
    const size_t rows = p->blocks * ROWS;
    struct refit f = {.p = p,
                      .norm = norm,
                      .at = new_array(p->count + 1, sizeof *f.at),
                      .residual = new_array(rows, sizeof *f.residual),
                      .weight = new_array(rows, sizeof *f.weight)};
    double *trial = new_array(p->count, sizeof *trial);
    f.terms = polynomials_terms(p, chosen, f.at);
    f.at[f.terms] = p->count;
    for (size_t i = 0; i < rows; i++)
        f.weight[i] = 1;
    double best = measure(&f, coefficient);
    for (int left = norm == NORM_MAX ? ROUNDS_OF_MAX : ROUNDS_OF_MEAN; left > 0; left--) {
        weigh(&f);
        if (!solve(&f, trial))
            break;
        const double error = measure(&f, trial);
        if (error < best) {
            best = error;
            memcpy(coefficient, trial, f.terms * sizeof *trial);
        }
    }
    free(trial);
    free(f.at);
    free(f.residual);
    free(f.weight);
}
