/* Extremes of the samples' coordinates, widened to two decimals; see scene_region.h. */
#include "scene_region.h"

#include <math.h>
#include <stdlib.h>

enum { NODES = 5 };

/* The five nodes in the frame of A, B and D. */
static void similar(const struct sample *s, double x[NODES][3])
{
    double e[3][3], length = 0, along = 0, height = 0;
    for (int i = 0; i < 3; i++) {
        e[0][i] = s->x[1][i] - s->x[0][i];
        e[1][i] = s->x[3][i] - s->x[0][i];
        length += e[0][i] * e[0][i];
        along += e[0][i] * e[1][i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; i++) {
        e[1][i] -= along / (length * length) * e[0][i];
        height += e[1][i] * e[1][i];
        e[0][i] /= length;
    }
    for (int i = 0; i < 3; i++)
        e[1][i] /= sqrt(height);
    for (int i = 0; i < 3; i++)
        e[2][i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
    for (int n = 0; n < NODES; n++)
        for (int k = 0; k < 3; k++) {
            x[n][k] = 0;
            for (int i = 0; i < 3; i++)
                x[n][k] += ((n < 4 ? s->x[n][i] : s->xs[i]) - s->x[0][i]) * e[k][i] / length;
        }
}

/* The input of node n (A, B, C, D, S), direction k (x, y, z). */
static size_t input_of(int n, int k)
{
    return (size_t)(3 * n + k);
}

static void add_range(struct genome_file *f, size_t input, double lo, double hi)
{
    char text[2][32];
    snprintf(text[0], sizeof text[0], "%.2f", floor(lo * 100) / 100);
    snprintf(text[1], sizeof text[1], "%.2f", ceil(hi * 100) / 100);
    genome_add_range(f, input, text[0], text[1]);
}

/* AC x BD > least: twice the area that the segment's projection has. */
static void require_area(struct genome_file *f, double least)
{
    char text[32];
    snprintf(text, sizeof text, "%.4f", floor(least * 5000) / 10000);
    const int xc = GENE_SYMBOL + (int)input_of(2, 0), yc = GENE_SYMBOL + (int)input_of(2, 1);
    const int xd = GENE_SYMBOL + (int)input_of(3, 0), yd = GENE_SYMBOL + (int)input_of(3, 1);
    const int xb = GENE_SYMBOL + (int)input_of(1, 0);
    const int gene[] = {
        GENE_SUB, GENE_SUB, GENE_MUL, xc, yd, GENE_MUL, yc, GENE_SUB, xd, xb, -1 - (int)genome_add_constant(f, text)};
    genome_add_require(f, gene, sizeof gene / sizeof *gene);
}

void scene_region_add(struct genome_file *f, const struct sample_set *set, size_t sets)
{
    double lo[NODES][3], hi[NODES][3], x[NODES][3], area = HUGE_VAL;
    size_t n = 0;
    for (size_t k = 0; k < sets; k++)
        for (size_t i = 0; i < set[k].n; i++, n++) {
            similar(&set[k].s[i], x);
            area = fmin(area, x[2][0] * x[3][1] - x[2][1] * (x[3][0] - 1));
            for (int j = 0; j < 3 * NODES; j++) {
                lo[j / 3][j % 3] = n ? fmin(lo[j / 3][j % 3], x[j / 3][j % 3]) : x[j / 3][j % 3];
                hi[j / 3][j % 3] = n ? fmax(hi[j / 3][j % 3], x[j / 3][j % 3]) : x[j / 3][j % 3];
            }
        }
    if (n == 0 || f->inputs != 3 * NODES)
        return;
    for (int j = 0; j < 3 * NODES; j++) {
        const bool fixed = j < 6 || j == 11; /* A, B, and z of D, but for rounding */
        const double at = j == 3 ? 1 : 0;
        add_range(f, input_of(j / 3, j % 3), fixed ? at : lo[j / 3][j % 3], fixed ? at : hi[j / 3][j % 3]);
    }
    if (area > 0)
        require_area(f, area);
}
