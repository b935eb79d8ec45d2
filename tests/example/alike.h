/* A fair comparison: Newton and footpoint for one pair at a time, and both over columns of pairs, where a whole block
 * takes Newton's steps together until all its pairs converge. penalty.h is the part to copy. */
#ifndef ALIKE_H
#define ALIKE_H

#include "penalty.h"

static void newton_block(size_t n, const double *const x[15], double *restrict xi, double *restrict eta)
{
    double c0[3][BLOCK], c1[3][BLOCK], c2[3][BLOCK], c3[3][BLOCK];
    long moving = 1;
    for (int i = 0; i < 3; i++)
        for (size_t p = 0; p < n; p++) {
            const double A = x[i][p], B = x[3 + i][p], C = x[6 + i][p], D = x[9 + i][p];
            c0[i][p] = x[12 + i][p] - 0.25 * (A + B + C + D);
            c1[i][p] = 0.25 * (B - A + C - D);
            c2[i][p] = 0.25 * (D - A + C - B);
            c3[i][p] = 0.25 * (A - B + C - D);
        }
    for (size_t p = 0; p < n; p++)
        xi[p] = eta[p] = 0.0;
    for (int step = 0; step < 20 && moving > 0; step++) {
        moving = 0;
        for (size_t p = 0; p < n; p++) {
            double aa = 0.0, bb = 0.0, ab = 0.0, ad = 0.0, bd = 0.0;
            for (int i = 0; i < 3; i++) {
                const double a = c1[i][p] + c3[i][p] * eta[p], b = c2[i][p] + c3[i][p] * xi[p];
                const double d = c0[i][p] - c1[i][p] * xi[p] - b * eta[p];
                aa += a * a;
                bb += b * b;
                ab += a * b - c3[i][p] * d;
                ad += a * d;
                bd += b * d;
            }
            const double inverse = 1.0 / (aa * bb - ab * ab);
            const double u = (bb * ad - ab * bd) * inverse, v = (aa * bd - ab * ad) * inverse;
            xi[p] += u;
            eta[p] += v;
            moving += u * u + v * v > 1e-16;
        }
    }
}

static void search_newton_block(const struct model *m, struct world *w)
{
    search_columns(m, w, newton_block);
}

static void search_footpoint_one(const struct model *m, struct world *w)
{
    for (int p = 0; p < w->pairs; p++) {
        const int *const node = m->seg[w->pair_seg[p]];
        double loc[2] = {0.0, 0.0}, gap;
        LOCATE(w->x[node[0]], w->x[node[1]], w->x[node[2]], w->x[node[3]], w->x[m->slave[w->pair_slave[p]]], loc, &gap);
        w->xi[p] = loc[0];
        w->eta[p] = loc[1];
    }
}

/* The ways to search, each first with Newton. */
enum { ONE_AT_A_TIME, OVER_ARRAYS, WAYS };
static void (*const alike[WAYS][2])(const struct model *, struct world *) = {{search_newton, search_footpoint_one},
                                                                             {search_newton_block, search_footpoint}};

#endif
