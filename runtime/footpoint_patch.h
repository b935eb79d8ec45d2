/* footpoint: four-node segments smoothed by the unit normals at their nodes, as Bezier and Gregory patches.
 *
 * Each function is compiled from generated headers: the most accurate search of generated/footpoint_bezier.h and
 * footpoint_gregory.h, whose banners state accuracy and segments, and footpoint_bezier_derivatives.h and
 * footpoint_gregory_derivatives.h.  Corners are in the order A, B, C, D of footpoint.h, with xi and eta in [-1,1]; the gap is
 * measured from the patch.  footpoint-node-normals.h computes normals of a mesh.
 *
 * Statuses and conventions follow footpoint.h. */
#ifndef FOOTPOINT_PATCH_INCLUDED
#define FOOTPOINT_PATCH_INCLUDED

#include "footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

enum footpoint_patch {
    FOOTPOINT_BEZIER, /* bicubic; neighbours meet with a kink along their edge */
    FOOTPOINT_GREGORY /* neighbours share tangent planes along their edge; takes about twice as long */
};

/* Below, x holds the coordinates of the corners, the unit normals there and the slave node: 27, in mesh length except the
 * normals.  FOOTPOINT_ERR_ARGUMENT: no such patch. */

/** Finds the foot point of a slave node.  FOOTPOINT_OK: a minimum of the distance is proved within 1e-12 of xi and eta.
 *  FOOTPOINT_OUTSIDE: the slave node lies beside the patch, and a minimum on the closed patch is proved on the edge or in the
 *  corner of the answer.
 *  @param[out] loc  {xi, eta}, in [-1,1]
 *  @param[out] gap  mesh length, along the patch's unit normal there; > 0 open
 *  @return FOOTPOINT_OK; with outputs written FOOTPOINT_OUTSIDE, FOOTPOINT_UNPROVED (no proof); FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_ARGUMENT */
int footpoint_patch_locate(enum footpoint_patch patch, const double *x, double loc[2], double *gap);

/** Does the same for n pairs of a slave node and a segment, using AVX-512 or AVX2 if available.  Answers differ from
 *  footpoint_patch_locate's within the promises, and may be proved where those are not.
 *  @param[in]  xyz, normals  nodes x 3: coordinates, mesh length, and unit normals
 *  @param[in]  seg     n x 4 node indices, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched if the status is < FOOTPOINT_OK
 *  @param[out] gap     n; untouched likewise
 *  @param[out] status  n, or NULL: as footpoint_patch_locate, also FOOTPOINT_ERR_ARGUMENT if an index is out of range
 *  @return the number of pairs whose status is not FOOTPOINT_OK */
size_t footpoint_patch_locate_pairs(enum footpoint_patch patch, size_t n, const double *xyz, const double *normals,
                                    size_t nodes, const int *seg, const int *slave, double *loc, double *gap,
                                    int *status);

/** Evaluates a patch at given (xi, eta), which need not be a foot point.  Outputs may be NULL.
 *  @param[out] r, r_xi, r_eta, normal  3: point, tangents, unit normal
 *  @param[out] gap                     (xS - r) . normal */
int footpoint_patch_place(enum footpoint_patch patch, const double *x, const double loc[2], double *r, double *r_xi,
                          double *r_eta, double *normal, double *gap);

/** Computes first derivatives at a foot point, and the outputs of footpoint_patch_place.  Outputs may be NULL.
 *  @param[out] d_xi, d_eta, d_gap        15: by the coordinates of the corners and the slave node
 *  @param[out] d_xi_n, d_eta_n, d_gap_n  12: by the components of the normals, which stay unit: 0 along the normal itself
 *  @return also FOOTPOINT_ERR_DEGENERATE if the foot point is not unique (the centre of curvature) */
int footpoint_patch_differentiate(enum footpoint_patch patch, const double *x, const double loc[2], double *r,
                                  double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                  double *d_gap, double *d_xi_n, double *d_eta_n, double *d_gap_n);

#ifdef __cplusplus
}
#endif

#endif
