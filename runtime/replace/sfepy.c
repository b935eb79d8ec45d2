/* Replaces evaluateContactConstraints of sfepy 2021.4, sfepy/mechanics/extmods/contres.c. As in sfepy, cells and
 * triangles about a segment's middle determine which segment a Gauss point meets. The headers find the place on the
 * segment without a guess and without iteration, for segments of 4, 6 and 8 nodes. */
#include "footpoint_quad4.h"
#include "footpoint_quad8.h"
#include "footpoint_tri6.h"
#include <float.h>
#include <math.h>
#include <stdint.h>

#define AT(column, row) ((size_t)(column) * (size_t)rows + (size_t)(row))

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

static void minus(const double a[3], const double b[3], double c[3])
{
    for (int i = 0; i < 3; i++)
        c[i] = a[i] - b[i];
}

/* Searches the line through two nodes in the plane. */
static int on_line(double x[8][3], const double at[3], double loc[2], double *gap)
{
    double side[3], from[3];
    minus(x[1], x[0], side);
    minus(at, x[0], from);
    const double length = sqrt(dot(side, side));
    if (!(length > 0))
        return -1;
    loc[0] = 2 * dot(from, side) / (length * length) - 1;
    *gap = (side[1] * from[0] - side[0] * from[1]) / length;
    return 0;
}

/* Finds the foot point of `at` on a segment and its distance; returns < 0 if there is none. */
static int search(int nodes, double x[8][3], const double at[3], double loc[2], double *gap)
{
    switch (nodes) {
    case 2:
        return on_line(x, at, loc, gap);
    case 4:
        return footpoint_quad4_accurate(x[0], x[1], x[2], x[3], at, loc, gap);
    case 6:
        return footpoint_tri6_accurate(x[0], x[1], x[2], x[3], x[4], x[5], at, loc, gap);
    case 8:
        return footpoint_quad8_accurate(x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7], at, loc, gap);
    default:
        return -1;
    }
}

/* Returns true if a triangle, or in the plane a line, lies below or above a point; *height: the position of the point
 * along the normal, from the plane. */
static int meets(int dimensions, double corner[3][3], const double normal[3], const double at[3], double *height)
{
    double side[3], from[3], c[3], area[3];
    minus(at, corner[0], from);
    *height = dot(from, normal);
    if (dimensions == 2) {
        minus(corner[1], corner[0], side);
        const double along = dot(from, side);
        return along >= 0 && along <= dot(side, side);
    }
    for (int i = 0; i < 3; i++) {
        minus(corner[(i + 1) % 3], corner[i], side);
        minus(at, corner[i], from);
        cross(from, side, c);
        area[i] = dot(c, normal);
    }
    return area[0] * area[1] >= 0 && area[0] * area[2] >= 0;
}

static double cut(double x, double most)
{
    return x < 0 ? 0 : x > most ? most : x;
}

/* The parameters are sfepy's. GPs has a row for each Gauss point, with columns for its place (nsd), element, segment,
 * gap, local coordinates (nsd), contact flag, and the element and segment that it meets. X contains coordinates by
 * columns, ISN the nodes of an element's segments, by columns, IEN the nodes of elements. head and next are the lists
 * of Gauss points in N[0] x N[1] x N[2] cells of the box. */
void evaluateContactConstraints(double *GPs, int32_t *ISN, int32_t *IEN, int32_t *N, double *AABBmin, double *AABBmax,
                                int32_t *head, int32_t *next, double *X, uint32_t *elementID, uint32_t *segmentID,
                                int n, int nsn, int nsd, int npd, int ngp, int nen, int nes, int neq,
                                double longestEdge)
{
    const int rows = n * ngp, gap = nsd + 2, place = nsd + 3, active = 2 * nsd + 3;
    const int pieces = nsd == 3 && nsn != 6 ? 4 : 1, corners = nsd;

    for (int v = 0; v < rows; v++)
        GPs[AT(gap, v)] = FLT_MAX;
    for (int e = 0; e < n; e++) {
        const int element = (int)elementID[e], segment = (int)segmentID[e];
        double node[8][3] = {{0}}, middle[3] = {0};
        for (int j = 0; j < nsn; j++)
            for (int k = 0; k < nsd; k++) {
                node[j][k] = X[k * (neq / nsd) + IEN[nen * element + ISN[nes * j + segment]]];
                middle[k] += node[j][k] / nsn;
            }
        for (int piece = 0; piece < pieces; piece++) {
            double corner[3][3] = {{0}}, side[2][3], normal[3] = {0};
            int least[3] = {0}, most[3] = {0};
            for (int k = 0; k < nsd; k++) {
                corner[0][k] = node[piece][k];
                corner[1][k] = node[pieces == 4 ? (piece + 1) % 4 : 1][k];
                corner[2][k] = pieces == 4 ? middle[k] : node[2][k];
                double low = corner[0][k], high = low;
                for (int j = 1; j < corners; j++) {
                    low = fmin(low, corner[j][k]);
                    high = fmax(high, corner[j][k]);
                }
                const double cells = N[k] / (AABBmax[k] - AABBmin[k]);
                least[k] = (int)cut((low - 0.5 * longestEdge - AABBmin[k]) * cells, N[k] - 1);
                most[k] = (int)cut((high + 0.5 * longestEdge - AABBmin[k]) * cells, N[k] - 1);
            }
            minus(corner[1], corner[0], side[0]);
            minus(corner[2], corner[1], side[1]);
            if (nsd == 2)
                side[1][0] = side[1][1] = 0, side[1][2] = 1;
            cross(side[0], side[1], normal);
            const double length = sqrt(dot(normal, normal));
            for (int k = 0; k < 3; k++)
                normal[k] /= length;

            for (int i2 = least[2]; i2 <= most[2]; i2++)
                for (int i1 = least[1]; i1 <= most[1]; i1++)
                    for (int i0 = least[0]; i0 <= most[0]; i0++)
                        for (int v = head[(i2 * N[1] + i1) * N[0] + i0]; v != -1; v = next[v]) {
                            double at[3] = {0}, height, loc[2] = {0}, distance = 0;
                            for (int k = 0; k < nsd; k++)
                                at[k] = GPs[AT(k, v)];
                            if ((GPs[AT(nsd, v)] == element && GPs[AT(nsd + 1, v)] == segment) ||
                                !meets(nsd, corner, normal, at, &height) || !(height < GPs[AT(gap, v)]) ||
                                search(nsn, node, at, loc, &distance) < 0)
                                continue;
                            GPs[AT(gap, v)] = copysign(distance, height);
                            if (!(height < 0))
                                continue;
                            GPs[AT(active, v)] = 1;
                            GPs[AT(active + 1, v)] = element;
                            GPs[AT(active + 2, v)] = segment;
                            for (int k = 0; k < npd; k++)
                                GPs[AT(place + k, v)] = loc[k];
                        }
        }
    }
}
