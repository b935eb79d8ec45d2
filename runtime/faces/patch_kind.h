/* Defines the functions of a kind of patch, from its generated headers, in a table from which patches.c chooses.  A file of each
 * kind must include its headers and this file, and expand PATCH(gregory, full), with the kind and its most accurate search. */
#ifndef FOOTPOINT_PATCH_KIND_H
#define FOOTPOINT_PATCH_KIND_H

#include "pair_blocks.h"
#include "patch_table.h"

#define X8 x[0], x[1], x[2], x[3], x[4], x[5], x[6], x[7]

#define PATCH(kind, tier)                                                                                              \
    SEARCH(locate, kind, tier, 8)                                                                                      \
    static int place(const double *const *x, const double *s, const double *loc, double *r, double *r_xi,              \
                     double *r_eta, double *normal, double *gap)                                                       \
    {                                                                                                                  \
        return footpoint_##kind##_place(X8, s, loc, r, r_xi, r_eta, normal, gap);                                      \
    }                                                                                                                  \
    static int differentiate(const double *const *x, const double *s, const double *loc, double *r, double *r_xi,      \
                             double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap,   \
                             double *d_xi_n, double *d_eta_n, double *d_gap_n)                                         \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(X8, s, loc, r, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap, d_xi_n,       \
                                            d_eta_n, d_gap_n);                                                         \
    }                                                                                                                  \
    const struct patch footpoint_patch_##kind = {{4, 4, locate, locate_block, 0, 0}, place, differentiate};

#endif
