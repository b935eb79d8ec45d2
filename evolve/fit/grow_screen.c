/* Screening; see grow_screen.h.  Adding x at a point of the tree changes its value by (slope at the point) times x, to
 * first order: a column of samples.  What it takes from the residual beyond what the constants that are there can take
 * is one projection: with the normal equations A of the constants' slopes J and their Cholesky factor L,
 * (c'r - (L^-1 J'c)'(L^-1 J'r))^2 / (c'c - |L^-1 J'c|^2). */
#include "grow_screen.h"

#include "../common/simd.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double independent = 1e-6, ridge = 1e-10;

/* What is gathered over the samples: products of the constants' slopes and the residual among themselves and with all
 * candidate columns, and the candidates' squares. */
struct screen {
    struct fitter *f;
    const double *goal;
    double scale;
    const int *symbol;
    size_t symbols, constants, basis, points, candidates;
    size_t *point;
    struct products own, other;
    double *panel, *column, *basis_column, *square;
};

static bool bounds(int gene)
{
    return gene == GENE_MIN || gene == GENE_MAX;
}

/* Where sums may begin: the root and the operands of all but sums.  What is clamped remains so: no sums with minima and
 * maxima at the root, nor with bounds, constants that are the first operands. */
static size_t find_points(const struct tape *t, size_t *point)
{
    size_t n = 0;
    if (!bounds(t->gene[0]))
        point[n++] = 0;
    for (size_t i = 0; i < t->length; i++) {
        const int gene = t->gene[i], arity = gene_arity(gene);
        if (gene == GENE_ADD || gene == GENE_SUB || gene == GENE_NEG)
            continue;
        for (int k = 0; k < arity; k++) {
            const size_t at = k == 0 ? i + 1 : t->operand[i];
            if (!(bounds(gene) && (bounds(t->gene[at]) || (k == 0 && t->gene[at] < 0))))
                point[n++] = at;
        }
    }
    return n;
}

static struct screen screen_new(struct fitter *f, size_t target, double scale, const int *symbol, size_t symbols)
{
    struct screen s = {.f = f, .goal = columns_at(f->table, target), .scale = scale, .symbol = symbol};
    s.symbols = symbols;
    s.constants = f->tape->constants;
    s.point = new_array(f->tape->length + 1, sizeof *s.point);
    s.points = find_points(f->tape, s.point);
    s.basis = 1 + symbols + symbols * (symbols + 1) / 2;
    s.candidates = s.basis * s.points;
    s.own = products_new(s.constants + 1, s.constants + 1);
    s.other = products_new(s.constants + 1, s.candidates);
    s.panel = new_array((s.constants + 1) * TAPE_BLOCK, sizeof *s.panel);
    s.column = new_array(s.candidates * TAPE_BLOCK, sizeof *s.column);
    s.basis_column = new_array(s.basis * TAPE_BLOCK, sizeof *s.basis_column);
    s.square = new_array(s.candidates * WIDE_LANES, sizeof *s.square);
    return s;
}

static void screen_free(struct screen *s)
{
    free(s->point);
    products_free(&s->own);
    products_free(&s->other);
    free(s->panel);
    free(s->column);
    free(s->basis_column);
    free(s->square);
}

/* The basis: 1, the symbols, their products. */
static void fill_basis(struct screen *s, size_t row)
{
    double *basis = s->basis_column;
    size_t n = 1;
    for (size_t k = 0; k < TAPE_BLOCK; k++)
        basis[k] = 1;
    for (size_t i = 0; i < s->symbols; i++)
        memcpy(basis + n++ * TAPE_BLOCK, columns_at(s->f->table, (size_t)(s->symbol[i] - GENE_SYMBOL)) + row,
               TAPE_BLOCK * sizeof *basis);
    for (size_t i = 1; i <= s->symbols; i++)
        for (size_t j = 1; j <= i; j++, n++)
            for (size_t k = 0; k < TAPE_BLOCK; k++)
                basis[n * TAPE_BLOCK + k] = basis[i * TAPE_BLOCK + k] * basis[j * TAPE_BLOCK + k];
}

static struct term basis_term(const struct screen *s, size_t k, size_t at)
{
    struct term x = {.at = at, .symbols = k == 0 ? 0 : k <= s->symbols ? 1 : 2};
    if (x.symbols == 0)
        return x;
    k--;
    if (x.symbols == 1) {
        x.symbol[0] = s->symbol[k];
        return x;
    }
    size_t i = 0;
    for (k -= s->symbols; k > i; i++)
        k -= i + 1;
    x.symbol[0] = s->symbol[i];
    x.symbol[1] = s->symbol[k];
    return x;
}

/* Columns of one point: slope times basis. */
WIDE static void fill_columns(struct screen *s, size_t point, const double slope[TAPE_BLOCK])
{
    for (size_t b = 0; b < s->basis; b++) {
        double *to = s->column + (point * s->basis + b) * TAPE_BLOCK;
        double *square = s->square + (point * s->basis + b) * WIDE_LANES;
        const double *basis = s->basis_column + b * TAPE_BLOCK;
        for (size_t k = 0; k < TAPE_BLOCK; k++)
            to[k] = slope[k] * basis[k];
        wide sum = *wide_at(square);
        for (size_t k = 0; k < TAPE_BLOCK; k += WIDE_LANES)
            sum += *wide_at(to + k) * *wide_at(to + k);
        memcpy(square, &sum, sizeof sum);
    }
}

static void screen_block(struct screen *s, size_t row)
{
    struct tape *t = s->f->tape;
    const size_t left = s->f->table->n - row, n = left < TAPE_BLOCK ? left : TAPE_BLOCK;
    double root[TAPE_BLOCK] = {0}, slope[TAPE_BLOCK] = {0}, *residual = s->panel + s->constants * TAPE_BLOCK;
    tape_values(t, row);
    tape_slopes(t, true);
    fill_basis(s, row);
    memset(s->panel, 0, (s->constants + 1) * TAPE_BLOCK * sizeof *s->panel);
    for (size_t k = 0; k < n; k++) {
        const double r = s->goal[row + k] - t->value[0][k];
        root[k] = sqrt(1 / sqrt(r * r + s->scale * s->scale));
        residual[k] = r * root[k];
    }
    for (size_t j = 0; j < s->constants; j++)
        for (size_t k = 0; k < n; k++)
            s->panel[j * TAPE_BLOCK + k] = t->slope[t->constant[j]][k] * root[k];
    for (size_t p = 0; p < s->points; p++) {
        for (size_t k = 0; k < n; k++)
            slope[k] = t->slope[s->point[p]][k] * root[k];
        fill_columns(s, p, slope);
    }
    const struct panel panel = {s->panel, TAPE_BLOCK}, column = {s->column, TAPE_BLOCK};
    products_add(&s->own, panel, panel, TAPE_BLOCK, true);
    products_add(&s->other, panel, column, TAPE_BLOCK, false);
}

static void append(struct term_list *l, struct term x)
{
    if (!(x.gain > 0 && isfinite(x.gain)))
        return;
    grow_array(&l->term, l->n, &l->room, sizeof *l->term);
    l->term[l->n++] = x;
}

/* Project candidate c; `own` holds the Cholesky factor, residual[] its forward solution. */
static void project(const struct screen *s, size_t c, const double *own, const double *other, const double *residual,
                    double *work, struct term_list *found)
{
    const size_t k = s->constants;
    double square = 0, left, with = other[k * s->candidates + c];
    for (size_t lane = 0; lane < WIDE_LANES; lane++)
        square += s->square[c * WIDE_LANES + lane];
    left = square;
    for (size_t i = 0; i < k; i++)
        work[i] = other[i * s->candidates + c];
    cholesky_forward(own, k, k + 1, work);
    for (size_t i = 0; i < k; i++) {
        left -= work[i] * work[i];
        with -= work[i] * residual[i];
    }
    if (!(left > independent * square))
        return;
    struct term x = basis_term(s, c % s->basis, s->point[c / s->basis]);
    x.coefficient = with / left;
    x.gain = with * with / left;
    append(found, x);
    x.unit = true;
    x.coefficient = with < 0 ? -1 : 1;
    x.gain = 2 * fabs(with) - left;
    if (x.symbols > 0)
        append(found, x);
}

void screen_terms(struct fitter *f, size_t target, double scale, const int *symbol, size_t symbols,
                  struct term_list *found)
{
    struct screen s = screen_new(f, target, scale, symbol, symbols);
    const size_t k = s.constants, count = k + 1;
    double *own = new_array(count * count, sizeof *own), *other = new_array(count * s.candidates, sizeof *other);
    double *residual = new_array(2 * count, sizeof *residual);
    for (size_t row = 0; row < f->table->n; row += TAPE_BLOCK)
        screen_block(&s, row);
    products_sum(&s.own, true, own);
    products_sum(&s.other, false, other);
    for (size_t i = 0; i < k; i++) {
        own[i * count + i] = own[i * count + i] > 0 ? own[i * count + i] * (1 + ridge) : 1;
        residual[i] = own[k * count + i];
    }
    found->n = 0;
    if (cholesky_factor(own, k, count)) {
        cholesky_forward(own, k, count, residual);
        for (size_t c = 0; c < s.candidates; c++)
            project(&s, c, own, other, residual, residual + count, found);
    }
    free(own);
    free(other);
    free(residual);
    screen_free(&s);
}
