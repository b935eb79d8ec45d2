/* Fits polynomials over samples; see polynomials.h. */
#include "polynomials.h"

#include "../../../codegen/base/simd.h"
#include "normal_equations.h"

#include <gsl/gsl_eigen.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { ROWS = POLYNOMIALS_ROWS, VECTORS = ROWS / WIDE_LANES };

static void fill_block(struct polynomials *p, const struct columns *table, size_t target, size_t block)
{
    const size_t first = block * ROWS, left = table->n - first, n = left < ROWS ? left : ROWS;
    for (size_t j = 0; j < p->count; j++) {
        double *to = polynomials_column(p, block, j);
        for (size_t k = 0; k < n; k++)
            to[k] = 1;
        for (size_t i = 0; i < p->term[j].degree; i++) {
            const double *x = columns_at(table, (size_t)(p->term[j].symbol[i] - GENE_SYMBOL)) + first;
            for (size_t k = 0; k < n; k++)
                to[k] *= x[k];
        }
    }
    memcpy(polynomials_column(p, block, p->count), columns_at(table, target) + first, n * sizeof *p->value);
}

struct polynomials *polynomials_new(const int *symbol, size_t symbols, size_t degree, const struct columns *table,
                                    size_t target)
{
    struct polynomials *p = new_array(1, sizeof *p);
    p->term = monomials_new(symbol, symbols, degree, &p->count);
    p->samples = table->n;
    p->blocks = (table->n + ROWS - 1) / ROWS;
    p->value = new_array(p->blocks * (p->count + 1) * ROWS, sizeof *p->value);
    const size_t all = p->count + 1;
    struct products sums = products_new(all, all);
    for (size_t b = 0; b < p->blocks; b++) {
        fill_block(p, table, target, b);
        const struct panel panel = {polynomials_column(p, b, 0), ROWS};
        products_add(&sums, panel, panel, ROWS, true);
    }
    p->gram = new_array(all * all, sizeof *p->gram);
    products_sum(&sums, true, p->gram);
    products_free(&sums);
    return p;
}

void polynomials_free(struct polynomials *p)
{
    if (!p)
        return;
    free(p->term);
    free(p->gram);
    free(p->value);
    free(p);
}

size_t polynomials_terms(const struct polynomials *p, const gene_bit *chosen, size_t *at)
{
    size_t n = 0;
    for (size_t i = 0; i < p->count; i++)
        if (chosen[i]) {
            if (at)
                at[n] = i;
            n++;
        }
    return n;
}

double polynomials_fit(const struct polynomials *p, const gene_bit *chosen, double *coefficient)
{
    size_t *at = new_array(p->count, sizeof *at);
    const size_t k = polynomials_terms(p, chosen, at);
    double *work = new_array(k * k + 1, sizeof *work);
    const double left = k > 0 ? products_fit(p->gram, p->count + 1, at, k, p->count, coefficient, work) : -1;
    free(at);
    free(work);
    return left;
}

/* A fitted polynomial and its sum of |error| in lanes. */
struct fitted {
    size_t *at; /* owned; NULL: no polynomial */
    size_t terms;
    double *coefficient; /* owned */
    double lane[WIDE_LANES];
};

static void fit(const struct polynomials *p, const gene_bit *chosen, struct fitted *f)
{
    f->at = new_array(p->count, sizeof *f->at);
    f->coefficient = new_array(p->count, sizeof *f->coefficient);
    f->terms = polynomials_terms(p, chosen, f->at);
    if (polynomials_fit(p, chosen, f->coefficient) < 0) {
        free(f->at);
        f->at = NULL;
    }
}

typedef int64_t bits __attribute__((vector_size(WIDE_LANES * sizeof(int64_t))));

/* Adds the |error| of a block of samples, which stays in the cache for all polynomials. */
WIDE static void add_block(const double *block, size_t count, struct fitted *f)
{
    wide sum[VECTORS], total = *wide_at(f->lane);
    for (size_t v = 0; v < VECTORS; v++)
        sum[v] = -*wide_at(block + count * ROWS + v * WIDE_LANES);
    for (size_t i = 0; i < f->terms; i++) {
        const double c = f->coefficient[i];
        const double *x = block + f->at[i] * ROWS;
        for (size_t v = 0; v < VECTORS; v++)
            sum[v] += c * *wide_at(x + v * WIDE_LANES);
    }
    for (size_t v = 0; v < VECTORS; v++)
        total += (wide)((bits)sum[v] & INT64_MAX);
    memcpy(f->lane, &total, sizeof f->lane);
}

void polynomials_errors(const struct polynomials *p, const gene_bit *chosen, size_t n, double *error)
{
    struct fitted *f = new_array(n, sizeof *f);
    for (size_t i = 0; i < n; i++)
        fit(p, chosen + i * p->count, &f[i]);
    for (size_t b = 0; b < p->blocks; b++)
        for (size_t i = 0; i < n; i++)
            if (f[i].at)
                add_block(polynomials_column(p, b, 0), p->count, &f[i]);
    for (size_t i = 0; i < n; i++) {
        double sum = 0;
        for (size_t k = 0; k < WIDE_LANES; k++)
            sum += f[i].lane[k];
        error[i] = f[i].at ? sum / (double)p->samples : INFINITY;
        free(f[i].at);
        free(f[i].coefficient);
    }
    free(f);
}

double polynomials_condition(const struct polynomials *p, const gene_bit *chosen)
{
    size_t *at = new_array(p->count, sizeof *at);
    const size_t k = polynomials_terms(p, chosen, at), all = p->count + 1;
    double low = 0, high = 0;
    if (k > 0) {
        gsl_matrix *a = gsl_matrix_alloc(k, k);
        gsl_vector *value = gsl_vector_alloc(k);
        gsl_eigen_symm_workspace *w = gsl_eigen_symm_alloc(k);
        for (size_t i = 0; i < k; i++)
            for (size_t j = 0; j < k; j++)
                gsl_matrix_set(a, i, j,
                               p->gram[at[i] * all + at[j]] /
                                   sqrt(p->gram[at[i] * all + at[i]] * p->gram[at[j] * all + at[j]]));
        gsl_eigen_symm(a, value, w);
        gsl_vector_minmax(value, &low, &high);
        gsl_eigen_symm_free(w);
        gsl_vector_free(value);
        gsl_matrix_free(a);
    }
    free(at);
    return low > 0 ? high / low : INFINITY;
}
