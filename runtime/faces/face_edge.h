/* The functions of one kind of edge: vectors of three coordinates, of which x and y count, and places {xi, 0}.  An edge is a face
 * one unit thick along z, so that r_eta is (0, 0, 1) and normals are r_xi x r_eta.  A file of each kind includes its header
 * and this one, and says EDGE_KIND(edge3, accurate, 3). */
#ifndef FOOTPOINT_FACE_EDGE_H
#define FOOTPOINT_FACE_EDGE_H

#include "face_table.h"
#include "pair_blocks.h"

#include <math.h>
#include <string.h>

#define X2 x[0], x[1]
#define X3 X2, x[2]

/* An answer, {xi, 0}. */
static int placed(int status, double xi, double *loc)
{
    if (status >= FOOTPOINT_OK) {
        loc[0] = xi;
        loc[1] = 0.0;
    }
    return status;
}

/* From vectors of two coordinates to those of three. */
static void spread(const double *from, int vectors, double *to)
{
    for (int i = 0; to && i < 3 * vectors; i++)
        to[i] = i % 3 < 2 ? from[2 * (i / 3) + i % 3] : 0.0;
}

/* Packed second derivatives likewise. */
static void spread_packed(const double *from, int vectors, double *to)
{
    for (int r = 0; to && r < 3 * vectors; r++)
        for (int c = 0; c <= r; c++) {
            const int row = 2 * (r / 3) + r % 3, column = 2 * (c / 3) + c % 3;
            to[r * (r + 1) / 2 + c] = r % 3 < 2 && c % 3 < 2 ? from[row * (row + 1) / 2 + column] : 0.0;
        }
}

/* Loops over arrays of blocks take columns x and y of vectors. */
#define FLAT_LOOP(name, vectors, loop)                                                                                 \
    static void name(size_t n, const double *const *columns, double *xi, double *eta, double *gap, int *status)        \
    {                                                                                                                  \
        const double *flat[2 * (vectors)];                                                                             \
        for (int k = 0; k < 2 * (vectors); k++)                                                                        \
            flat[k] = columns[3 * (k / 2) + k % 2];                                                                    \
        loop(n, flat, xi, gap, status);                                                                                \
        for (size_t i = 0; i < n; i++)                                                                                 \
            eta[i] = 0.0;                                                                                              \
    }

#define FLAT_ALONG(loop, vectors)                                                                                      \
    static void along_flat(size_t n, const double *const *columns, double *xi, double *eta, double *dist, int *status) \
    {                                                                                                                  \
        const double *flat[2 * (vectors)], *const along[2] = {columns[3 * (vectors)], columns[3 * (vectors) + 1]};     \
        for (int k = 0; k < 2 * (vectors); k++)                                                                        \
            flat[k] = columns[3 * (k / 2) + k % 2];                                                                    \
        loop(n, flat, along, xi, dist, status);                                                                        \
        for (size_t i = 0; i < n; i++)                                                                                 \
            eta[i] = 0.0;                                                                                              \
    }

/* The closest point with certainty, as footpoint_face_robust: of an edge all of whose nodes are one point that point; where
 * the header proves no place, the distance if IS_NEAREST proves that. */
#define EDGE_KIND(kind, tier, count)                                                                                   \
    FLAT_LOOP(locate_flat, count + 1, footpoint_##kind##_##tier##_checked_n)                                           \
    FLAT_LOOP(track_flat, count + 1, footpoint_##kind##_##tier##_from_n)                                               \
    BLOCKS_OF(locate, locate_flat)                                                                                     \
    BLOCKS_OF(track, track_flat)                                                                                       \
    static int locate(const double *const *x, const double *s, double *loc, double *gap)                               \
    {                                                                                                                  \
        double xi = 0.0;                                                                                               \
        const int status = footpoint_##kind##_##tier(X##count, s, &xi, gap);                                           \
        return placed(status, xi, loc);                                                                                \
    }                                                                                                                  \
    static int track(const double *const *x, const double *s, double *loc, double *gap)                                \
    {                                                                                                                  \
        double xi = loc[0];                                                                                            \
        const int status = footpoint_##kind##_##tier##_from(X##count, s, &xi, gap);                                    \
        return placed(status, xi, loc);                                                                                \
    }                                                                                                                  \
    static int closest(const double *const *x, const double *s, double *loc, double *distance, int *region)            \
    {                                                                                                                  \
        double xi = 0.0;                                                                                               \
        const int status = footpoint_##kind##_##tier##_closest(X##count, s, &xi, distance, region);                    \
        return placed(status, xi, loc);                                                                                \
    }                                                                                                                  \
    static int nearest(size_t n, const double *const *x, const double *s, double *loc, double *distance, int *region,  \
                       size_t *which)                                                                                  \
    {                                                                                                                  \
        double xi = 0.0;                                                                                               \
        const int status = footpoint_##kind##_##tier##_closest_of(n, x, s, &xi, distance, region, which);              \
        return placed(status, xi, loc);                                                                                \
    }                                                                                                                  \
    static int robust(const double *const *x, const double *s, double *loc, double *distance, int *region)             \
    {                                                                                                                  \
        const double *const all[] = {X##count, s};                                                                     \
        const int status = closest(x, s, loc, distance, region);                                                       \
        if (status == FOOTPOINT_ERR_DEGENERATE)                                                                        \
            return at_point(x[0], s, loc, distance, region);                                                           \
        if (status == FOOTPOINT_UNPROVED && footpoint_detail_##kind##_is_nearest(all, fabs(*distance)))                \
            return FOOTPOINT_NOT_UNIQUE;                                                                               \
        return status == FOOTPOINT_OK && *region ? FOOTPOINT_OUTSIDE : status;                                         \
    }                                                                                                                  \
    static double feature(const double *const *x, const double *loc, int region, const double **end)                   \
    {                                                                                                                  \
        (void)loc;                                                                                                     \
        end[0] = end[1] = x[region - 1];                                                                               \
        return 0.0;                                                                                                    \
    }                                                                                                                  \
    static void add_face(const double *const *x, const double *s, const double *const *end, double t, double *fan)     \
    {                                                                                                                  \
        (void)s;                                                                                                       \
        (void)t;                                                                                                       \
        footpoint_detail_##kind##_add_tangents(x, end[0], fan);                                                        \
    }                                                                                                                  \
    static int behind(const double *const *x, const double *s, const double *loc, int edge, const double *fan)         \
    {                                                                                                                  \
        const double *const r = x[loc[0] > 0.0];                                                                       \
        const double d[2] = {s[0] - r[0], s[1] - r[1]};                                                                \
        (void)edge;                                                                                                    \
        return footpoint_detail_plane_behind(d, fan, 4.0);                                                             \
    }                                                                                                                  \
    static int place(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,            \
                     double *r_eta, double *normal, double *gap)                                                       \
    {                                                                                                                  \
        static const double across[3] = {0.0, 0.0, 1.0};                                                               \
        double t[2], n[2];                                                                                             \
        const int status = footpoint_##kind##_place(X##count, s, loc[0], phi, t, n, gap);                              \
        if (status != FOOTPOINT_OK)                                                                                    \
            return status;                                                                                             \
        spread(t, 1, r_xi);                                                                                            \
        spread(n, 1, normal);                                                                                          \
        if (r_eta)                                                                                                     \
            memcpy(r_eta, across, sizeof across);                                                                      \
        return status;                                                                                                 \
    }                                                                                                                  \
    static int differentiate(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,    \
                             double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap)   \
    {                                                                                                                  \
        double by_xi[2 * (count) + 2], by_gap[2 * (count) + 2];                                                        \
        const int status = footpoint_##kind##_gradients(X##count, s, loc[0], by_xi, by_gap);                           \
        if (status != FOOTPOINT_OK)                                                                                    \
            return status;                                                                                             \
        spread(by_xi, count + 1, d_xi);                                                                                \
        spread(by_gap, count + 1, d_gap);                                                                              \
        for (int i = 0; d_eta && i < 3 * (count) + 3; i++)                                                             \
            d_eta[i] = 0.0;                                                                                            \
        return place(x, s, loc, phi, r_xi, r_eta, normal, gap);                                                        \
    }                                                                                                                  \
    static int hessian(const double *const *x, const double *s, const double *loc, double *gap, double *d_xi,          \
                       double *d_eta, double *d_gap, double *d_normal, double *second)                                 \
    {                                                                                                                  \
        enum { N = 2 * (count) + 2 };                                                                                  \
        double by_normal[2 * N], by_two[N * (N + 1) / 2];                                                              \
        const int status = footpoint_##kind##_hessian(X##count, s, loc[0], by_normal, by_two);                         \
        if (status != FOOTPOINT_OK)                                                                                    \
            return status;                                                                                             \
        spread_packed(by_two, count + 1, second);                                                                      \
        for (int j = 0; d_normal && j < 2; j++)                                                                        \
            spread(by_normal + j * N, count + 1, d_normal + j * 3 * (count + 1));                                      \
        for (int i = 0; d_normal && i < 3 * (count + 1); i++)                                                          \
            d_normal[6 * (count + 1) + i] = 0.0;                                                                       \
        return differentiate(x, s, loc, NULL, NULL, NULL, NULL, gap, d_xi, d_eta, d_gap);                              \
    }                                                                                                                  \
    FLAT_ALONG(footpoint_##kind##_along_n, count + 1)                                                                  \
    BLOCKS_OF(along, along_flat)                                                                                       \
    static int along(const double *const *x, const double *s, double *loc, double *dist)                               \
    {                                                                                                                  \
        double xi = 0.0;                                                                                               \
        const int status = footpoint_##kind##_along(X##count, s, x[count + 1], &xi, dist);                             \
        return placed(status, xi, loc);                                                                                \
    }                                                                                                                  \
    static int differentiate_along(const double *const *x, const double *s, const double *along, const double *loc,    \
                                   double *dist, double *const *d, double *const *h)                                   \
    {                                                                                                                  \
        enum { N = 2 * (count) + 4, ALL = 3 * (count) + 6 };                                                           \
        double first[2][N], second[2][N * (N + 1) / 2];                                                                \
        const int wanted = h[0] || h[2],                                                                               \
                  status = footpoint_##kind##_hessian_along(X##count, s, along, loc[0], dist, first[0], first[1],      \
                                                            wanted ? second[0] : NULL, wanted ? second[1] : NULL);     \
        for (int j = 0; j < 2 && status == FOOTPOINT_OK; j++) {                                                        \
            spread(first[j], count + 2, d[2 * j]);                                                                     \
            spread_packed(second[j], count + 2, h[2 * j]);                                                             \
        }                                                                                                              \
        for (int i = 0; d[1] && status == FOOTPOINT_OK && i < ALL; i++)                                                \
            d[1][i] = 0.0;                                                                                             \
        for (int i = 0; h[1] && status == FOOTPOINT_OK && i < ALL * (ALL + 1) / 2; i++)                                \
            h[1][i] = 0.0;                                                                                             \
        return status;                                                                                                 \
    }                                                                                                                  \
    const struct face footpoint_face_##kind = {{count, 0, locate, locate_block, 0, 0},                                 \
                                               {count, 0, locate, locate_block, 0, 0},                                 \
                                               {count, 0, track, track_block, 1, 0},                                   \
                                               {count, 0, along, along_block, 0, 1},                                   \
                                               0.0,                                                                    \
                                               NULL,                                                                   \
                                               closest,                                                                \
                                               nearest,                                                                \
                                               behind,                                                                 \
                                               feature,                                                                \
                                               add_face,                                                               \
                                               place,                                                                  \
                                               differentiate,                                                          \
                                               hessian,                                                                \
                                               differentiate_along,                                                    \
                                               robust};

/* All nodes are one point. */
static int at_point(const double *r, const double *s, double *loc, double *distance, int *region)
{
    const double away = hypot(s[0] - r[0], s[1] - r[1]);
    if (!isfinite(away))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = -1.0;
    loc[1] = 0.0;
    *distance = away;
    *region = 1;
    return FOOTPOINT_NO_AREA;
}

#endif
