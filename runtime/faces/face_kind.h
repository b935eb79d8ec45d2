/* Defines the functions of a kind of face, from its generated headers, in a table from which faces.c chooses.  A file of each kind
 * must include its headers and this file, then expand TRACK, and then KIND(quad8, full, 8, locate), with the kind, its most
 * accurate search, the number of nodes and the search with which footpoint_face_robust begins, or
 * CURVED_KIND(quad8, full, 8, FOOTPOINT_QUAD8_FULL_PROMISE). */
#ifndef FOOTPOINT_FACE_KIND_H
#define FOOTPOINT_FACE_KIND_H

#include "curved.h"
#include "face_table.h"
#include "pair_blocks.h"

#define X3 x[0], x[1], x[2]
#define X4 X3, x[3]
#define X6 X4, x[4], x[5]
#define X8 X6, x[6], x[7]
#define X9 X8, x[8]

/* See face_table.h. */
#ifndef PROMISE
#define PROMISE 0.0
#endif

#ifndef IS_CLOSEST
#define IS_CLOSEST NULL
#endif

#define KIND(kind, tier, count, start)                                                                                 \
    SEARCH(locate, kind, tier, count)                                                                                  \
    REST(kind, tier, count, start)

/* On a curved face, PROMISE belongs to its search. */
#define CURVED_KIND(kind, tier, count, promise)                                                                        \
    SEARCH(search, kind, tier, count)                                                                                  \
    static int closest(const double *const *x, const double *s, double *loc, double *distance, int *region);           \
    static int is_closest(const double *const *x, const double *s, const double *loc)                                  \
    {                                                                                                                  \
        const double *const all[] = {X##count, s};                                                                     \
        return !(footpoint_detail_##kind##_closest_at(all, promise, loc) >> 63);                                       \
    }                                                                                                                  \
    static const struct curved curved = {count, search, closest, is_closest};                                          \
    static int locate(const double *const *x, const double *s, double *loc, double *gap)                               \
    {                                                                                                                  \
        return footpoint_curved_locate(&curved, x, s, loc, gap);                                                       \
    }                                                                                                                  \
    static void locate_block(const double *const *columns, double *xi, double *eta, double *gap, int *status)          \
    {                                                                                                                  \
        search_block(columns, xi, eta, gap, status);                                                                   \
        footpoint_curved_check(&curved, columns, xi, eta, status);                                                     \
    }                                                                                                                  \
    REST(kind, tier, count, search)

#define REST(kind, tier, count, start)                                                                                 \
    static int closest(const double *const *x, const double *s, double *loc, double *distance, int *region)            \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest(X##count, s, loc, distance, region);                                \
    }                                                                                                                  \
    static int nearest(size_t n, const double *const *x, const double *s, double *loc, double *distance, int *region,  \
                       size_t *which)                                                                                  \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest_of(n, x, s, loc, distance, region, which);                          \
    }                                                                                                                  \
    static int behind(const double *const *x, const double *s, const double *loc, int edge, const double *fan)         \
    {                                                                                                                  \
        const double *const all[] = {X##count, s};                                                                     \
        return footpoint_detail_##kind##_behind(all, loc, edge, fan);                                                  \
    }                                                                                                                  \
    static void add_face(const double *const *x, const double *s, const double *const *end, double t, double *fan)     \
    {                                                                                                                  \
        const double *const all[] = {X##count, s};                                                                     \
        footpoint_detail_##kind##_add_face(all, end, t, fan);                                                          \
    }                                                                                                                  \
    static int place(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,            \
                     double *r_eta, double *normal, double *gap)                                                       \
    {                                                                                                                  \
        return footpoint_##kind##_place(X##count, s, loc, phi, r_xi, r_eta, normal, gap);                              \
    }                                                                                                                  \
    static int differentiate(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,    \
                             double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap)   \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(X##count, s, loc, phi, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap);      \
    }                                                                                                                  \
    static int hessian(const double *const *x, const double *s, const double *loc, double *gap, double *d_xi,          \
                       double *d_eta, double *d_gap, double *d_normal, double *second)                                 \
    {                                                                                                                  \
        return footpoint_##kind##_hessian(X##count, s, loc, gap, d_xi, d_eta, d_gap, d_normal, second);                \
    }                                                                                                                  \
    ALONG_BLOCKS(footpoint_##kind##_along_n, count)                                                                    \
    static int along(const double *const *x, const double *s, double *loc, double *dist)                               \
    {                                                                                                                  \
        return footpoint_##kind##_along(X##count, s, x[count + 1], loc, dist);                                         \
    }                                                                                                                  \
    static int differentiate_along(const double *const *x, const double *s, const double *along, const double *loc,    \
                                   double *dist, double *const *d, double *const *h)                                   \
    {                                                                                                                  \
        return h[0] || h[1] || h[2]                                                                                    \
                   ? footpoint_##kind##_hessian_along(X##count, s, along, loc, dist, d[0], d[1], d[2], h[0], h[1],     \
                                                      h[2])                                                            \
                   : footpoint_##kind##_gradients_along(X##count, s, along, loc, dist, d[0], d[1], d[2]);              \
    }                                                                                                                  \
    const struct face footpoint_face_##kind = {{count, 0, locate, locate_block, 0, 0},                                 \
                                               {count, 0, start, start##_block, 0, 0},                                 \
                                               {count, 0, track, track_block, 1, 0},                                   \
                                               {count, 0, along, along_block, 0, 1},                                   \
                                               PROMISE,                                                                \
                                               IS_CLOSEST,                                                             \
                                               closest,                                                                \
                                               nearest,                                                                \
                                               behind,                                                                 \
                                               footpoint_detail_##kind##_feature,                                      \
                                               add_face,                                                               \
                                               place,                                                                  \
                                               differentiate,                                                          \
                                               hessian,                                                                \
                                               differentiate_along,                                                    \
                                               NULL};

#endif
