/* The functions of each kind of face; x points to its nodes, s to the slave node.  Other arguments are as in
 * footpoint_face.h. */
#ifndef FOOTPOINT_FACE_TABLE_H
#define FOOTPOINT_FACE_TABLE_H

#include "../footpoint_face.h"
#include "pairs.h"

struct face {
    struct pairs_kind pairs;
    struct pairs_kind start; /* with which footpoint_face_robust begins */
    struct pairs_kind track; /* from last answers */
    struct pairs_kind along; /* projection along a direction, which follows the slave node in x */
    double promise;          /* on a plane face: NAME_PROMISE of that search, or 0 if it proves nothing */
    int (*is_closest)(const double *const *x, const double *s,
                      const double *loc); /* see curved.h; NULL on plane faces */
    int (*closest)(const double *const *x, const double *s, double *loc, double *distance, int *region);
    /* Finds the nearest of n faces; x has the nodes of each face in turn. */
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
    int (*differentiate_along)(const double *const *x, const double *s, const double *along, const double *loc,
                               double *dist, double *const *d, double *const *h);
    /* footpoint_face_robust of an edge; NULL: it is a face. */
    int (*robust)(const double *const *x, const double *s, double *loc, double *distance, int *region);
};

/* Pointers to the nodes and the slave node. */
struct rows {
    const double *x[PAIRS_MOST_VECTORS], *s;
};

/* Only for files of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif
extern const struct face footpoint_face_tri3, footpoint_face_tri6, footpoint_face_quad4, footpoint_face_quad8,
    footpoint_face_quad9, footpoint_face_edge2, footpoint_face_edge3;

/* Returns the functions of a kind, or NULL if there is no such face. */
const struct face *footpoint_face_of(enum footpoint_face face);
#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
