/* The functions of each kind of patch; x points to its corners and normals, s to the slave node.  Other arguments are as in
 * footpoint_patch.h. */
#ifndef FOOTPOINT_PATCH_TABLE_H
#define FOOTPOINT_PATCH_TABLE_H

#include "pairs.h"

struct patch {
    struct pairs_kind pairs;
    int (*place)(const double *const *x, const double *s, const double *loc, double *r, double *r_xi, double *r_eta,
                 double *normal, double *gap);
    int (*differentiate)(const double *const *x, const double *s, const double *loc, double *r, double *r_xi,
                         double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap,
                         double *d_xi_n, double *d_eta_n, double *d_gap_n);
};

/* Only for files of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
extern const struct patch footpoint_patch_bezier, footpoint_patch_gregory;
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
