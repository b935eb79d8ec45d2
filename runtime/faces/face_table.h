/* What there is of each kind of face; x points to its nodes, s to the slave node.  The rest as in footpoint_face.h. */
#ifndef FOOTPOINT_FACE_TABLE_H
#define FOOTPOINT_FACE_TABLE_H

#include "pairs.h"

struct face {
    struct pairs_kind pairs;
    struct pairs_kind start; /* the search that footpoint_face_robust begins with */
    struct pairs_kind track; /* from last answers */
    double promise;          /* of a plane face: NAME_PROMISE of that search, or 0: it proves nothing */
    int (*is_closest)(const double *const *x, const double *s,
                      const double *loc); /* see curved.h; NULL: it is not curved */
    int (*closest)(const double *const *x, const double *s, double *loc, double *distance, int *region);
    /* Of n faces, the nodes of which x has one face after the other. */
    int (*nearest)(size_t n, const double *const *x, const double *s, double *loc, double *distance, int *region,
                   size_t *which);
    /* As footpoint_detail_KIND_behind, _feature and _add_face of generated/. */
    int (*behind)(const double *const *x, const double *s, const double *loc, int edge, const double *fan);
    double (*feature)(const double *const *x, const double *loc, int region, const double **end);
    void (*add_face)(const double *const *x, const double *s, const double *const *end, double t, double *fan);
    int (*place)(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi, double *r_eta,
                 double *normal, double *gap);
    int (*differentiate)(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,
                         double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap);
    int (*hessian)(const double *const *x, const double *s, const double *loc, double *gap, double *d_xi, double *d_eta,
                   double *d_gap, double *d_normal, double *hessian);
};

/* Not for callers of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
extern const struct face footpoint_face_tri3, footpoint_face_tri6, footpoint_face_quad4, footpoint_face_quad8,
    footpoint_face_quad9;
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
