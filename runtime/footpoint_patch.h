/* footpoint: four-node segments smoothed by the unit normals at their nodes, as Bezier and Gregory patches.
 *
 * Each call is that of a generated header, compiled: the most accurate search of generated/footpoint_bezier.h and
 * footpoint_gregory.h, whose banners say how accurate they are and on which segments, and what
 * footpoint_bezier_derivatives.h and footpoint_gregory_derivatives.h hold.  Corners are in the order A, B, C, D of
 * footpoint.h, xi and eta in [-1,1]; the gap is the patch's own.  footpoint-node-normals.h makes normals of a mesh.
 *
 * Statuses and the rest as in footpoint.h; nothing is proved. */
#ifndef FOOTPOINT_PATCH_INCLUDED
#define FOOTPOINT_PATCH_INCLUDED

#include "footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

enum footpoint_patch {
    FOOTPOINT_BEZIER, /* bicubic; neighbours meet with a kink along their edge */
    FOOTPOINT_GREGORY /* neighbours have one tangent plane along their edge; about twice as dear */
};

/* In what follows, x are the coordinates of the corners, the unit normals there and the slave node: 27, mesh length but
 * for the normals.  FOOTPOINT_ERR_ARGUMENT: no such patch. */

/** Foot point of a slave node.
 *  @param[out] loc  {xi, eta}, in [-1,1]: of slave nodes beside the patch, which have no foot point, one on its edge
 *  @param[out] gap  mesh length, along the patch's unit normal there; > 0 open
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_ARGUMENT */
int footpoint_patch_locate(enum footpoint_patch patch, const double *x, double loc[2], double *gap);

/** The same for n pairs of a slave node and a segment, to the same bits, with AVX-512 or AVX2 where the machine has them.
 *  @param[in]  xyz, normals  nodes x 3: coordinates, mesh length, and unit normals
 *  @param[in]  seg     n x 4 node indices, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched where the status is not FOOTPOINT_OK
 *  @param[out] gap     n; likewise
 *  @param[out] status  n, or NULL: as footpoint_patch_locate, FOOTPOINT_ERR_ARGUMENT where an index is out of range, too
 *  @return how many pairs have a status other than FOOTPOINT_OK */
size_t footpoint_patch_locate_pairs(enum footpoint_patch patch, size_t n, const double *xyz, const double *normals,
                                    size_t nodes, const int *seg, const int *slave, double *loc, double *gap,
                                    int *status);

/** What there is at given (xi, eta), which need not be a foot point.  Outputs may be NULL.
 *  @param[out] r, r_xi, r_eta, normal  3: point, tangents, unit normal
 *  @param[out] gap                     (xS - r) . normal */
int footpoint_patch_place(enum footpoint_patch patch, const double *x, const double loc[2], double *r, double *r_xi,
                          double *r_eta, double *normal, double *gap);

/** First derivatives at a foot point, and what footpoint_patch_place gives.  Outputs may be NULL.
 *  @param[out] d_xi, d_eta, d_gap        15: by the coordinates of the corners and the slave node
 *  @param[out] d_xi_n, d_eta_n, d_gap_n  12: by those of the normals, which stay unit: 0 along the normal itself
 *  @return FOOTPOINT_ERR_DEGENERATE, too, where the foot point is not unique (the centre of curvature) */
int footpoint_patch_differentiate(enum footpoint_patch patch, const double *x, const double loc[2], double *r,
                                  double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                  double *d_gap, double *d_xi_n, double *d_eta_n, double *d_gap_n);

#ifdef __cplusplus
}
#endif

#endif
