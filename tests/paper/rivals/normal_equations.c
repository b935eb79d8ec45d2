/* Sums products of columns; see normal_equations.h.  Tiles of 4 x 2 columns stay in registers over a block of samples. */
#include "normal_equations.h"

#include "../../../codegen/base/base.h"
#include "../../../codegen/base/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TILE_ROWS = 4, TILE_COLUMNS = 2 };

struct products products_new(size_t rows, size_t columns)
{
    struct products p = {.rows = rows, .columns = columns};
    p.lane = new_array(rows * columns * WIDE_LANES, sizeof *p.lane);
    return p;
}

void products_free(struct products *p)
{
    free(p->lane);
    *p = (struct products){0};
}

void products_clear(struct products *p)
{
    memset(p->lane, 0, p->rows * p->columns * WIDE_LANES * sizeof *p->lane);
}

static inline __attribute__((always_inline)) void add_tile(double *lane, size_t columns, const double *const *a,
                                                           size_t rows, const double *const *b, size_t width, size_t n)
{
    wide sum[TILE_ROWS][TILE_COLUMNS];
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < width; j++)
            sum[i][j] = *wide_at(lane + (i * columns + j) * WIDE_LANES);
    for (size_t k = 0; k < n; k += WIDE_LANES)
        for (size_t i = 0; i < rows; i++)
            for (size_t j = 0; j < width; j++)
                sum[i][j] += *wide_at(a[i] + k) * *wide_at(b[j] + k);
    for (size_t i = 0; i < rows; i++)
        for (size_t j = 0; j < width; j++)
            *(wide *)(void *)(lane + (i * columns + j) * WIDE_LANES) = sum[i][j];
}

WIDE void products_add(struct products *p, struct panel a, struct panel b, size_t n, bool lower)
{
    for (size_t i = 0; i < p->rows; i += TILE_ROWS) {
        const size_t rows = p->rows - i < TILE_ROWS ? p->rows - i : TILE_ROWS;
        const double *x[TILE_ROWS];
        for (size_t r = 0; r < rows; r++)
            x[r] = a.first + (i + r) * a.stride;
        for (size_t j = 0; j < p->columns && !(lower && j >= i + rows); j += TILE_COLUMNS) {
            const size_t width = p->columns - j < TILE_COLUMNS ? p->columns - j : TILE_COLUMNS;
            const double *y[TILE_COLUMNS];
            for (size_t c = 0; c < width; c++)
                y[c] = b.first + (j + c) * b.stride;
            double *lane = p->lane + (i * p->columns + j) * WIDE_LANES;
            if (rows == TILE_ROWS && width == TILE_COLUMNS)
                add_tile(lane, p->columns, x, TILE_ROWS, y, TILE_COLUMNS, n);
            else
                for (size_t r = 0; r < rows; r++)
                    for (size_t c = 0; c < width; c++)
                        add_tile(lane + (r * p->columns + c) * WIDE_LANES, p->columns, x + r, 1, y + c, 1, n);
        }
    }
}

void products_sum(const struct products *p, bool lower, double *sum)
{
    for (size_t i = 0; i < p->rows; i++)
        for (size_t j = 0; j < (lower ? i + 1 : p->columns); j++) {
            const double *lane = p->lane + (i * p->columns + j) * WIDE_LANES;
            double s = 0;
            for (size_t k = 0; k < WIDE_LANES; k++)
                s += lane[k];
            sum[i * p->columns + j] = s;
            if (lower)
                sum[j * p->columns + i] = s;
        }
}

/* Computes the lower Cholesky factor of the n x n matrix a in place, without touching the upper triangle.  Returns false if a is not
 * positive definite.  The order is fixed here, because a library's depends on the machine. */
static bool cholesky_factor(double *a, size_t n)
{
    for (size_t j = 0; j < n; j++) {
        const double *rj = a + j * n;
        double d = rj[j];
        for (size_t k = 0; k < j; k++)
            d -= rj[k] * rj[k];
        if (!(d > 0) || !isfinite(d))
            return false;
        const double root = sqrt(d);
        a[j * n + j] = root;
        for (size_t i = j + 1; i < n; i++) {
            double *ri = a + i * n, s = ri[j];
            for (size_t k = 0; k < j; k++)
                s -= ri[k] * rj[k];
            ri[j] = s / root;
        }
    }
    return true;
}

/* Computes x = L^-1 x. */
static void cholesky_forward(const double *l, size_t n, double *x)
{
    for (size_t i = 0; i < n; i++) {
        for (size_t k = 0; k < i; k++)
            x[i] -= l[i * n + k] * x[k];
        x[i] /= l[i * n + i];
    }
}

/* Computes x = L^-T x. */
static void cholesky_backward(const double *l, size_t n, double *x)
{
    for (size_t i = n; i-- > 0;) {
        x[i] /= l[i * n + i];
        for (size_t k = 0; k < i; k++)
            x[k] -= l[i * n + k] * x[i];
    }
}

double products_fit(const double *gram, size_t count, const size_t *chosen, size_t k, size_t goal, double *coefficient,
                    double *work)
{
    static const double independent = 1e-12; /* least part of a column's square */
    for (size_t i = 0; i < k; i++) {
        for (size_t j = 0; j <= i; j++)
            work[i * k + j] = gram[chosen[i] * count + chosen[j]];
        coefficient[i] = gram[chosen[i] * count + goal];
    }
    double left = gram[goal * count + goal];
    if (!cholesky_factor(work, k))
        return -1;
    for (size_t i = 0; i < k; i++)
        if (!(work[i * k + i] * work[i * k + i] > independent * gram[chosen[i] * count + chosen[i]]))
            return -1;
    cholesky_forward(work, k, coefficient);
    for (size_t i = 0; i < k; i++)
        left -= coefficient[i] * coefficient[i];
    cholesky_backward(work, k, coefficient);
    return left > 0 ? left : 0;
}
