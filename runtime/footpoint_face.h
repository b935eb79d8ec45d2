/* footpoint: faces of every kind, chosen by a number: search, closest points, derivatives, arrays of pairs.
 *
 * Each function is compiled from generated headers: the most accurate search of generated/footpoint_KIND.h, whose banner
 * states its accuracy and faces, and generated/footpoint_KIND_derivatives.h.  Nodes are in the order of these headers: corners
 * counter-clockwise seen from the slave nodes, then the middles of edges from AB on, then the middle.  A triangle has
 * 0 <= xi, eta and xi + eta <= 1, a quadrilateral xi and eta in [-1,1].
 *
 * Statuses and conventions follow footpoint.h.  footpoint_face_locate proves foot points, footpoint_face_robust and
 * footpoint_face_robust_pairs closest points: call these unless you know your faces.  With d_gap, d_normal and hessian,
 * footpoint_element_normal and footpoint_element_friction compute force and tangent of a contact element. */
#ifndef FOOTPOINT_FACE_INCLUDED
#define FOOTPOINT_FACE_INCLUDED

#include "footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

enum footpoint_face {
    FOOTPOINT_TRI3,
    FOOTPOINT_TRI6,
    FOOTPOINT_QUAD4,
    FOOTPOINT_QUAD8,
    FOOTPOINT_QUAD9,
    FOOTPOINT_FACES, /* how many kinds of faces */
    FOOTPOINT_EDGE2, /* for contact in the plane: an edge A B, or A B C with C in the middle */
    FOOTPOINT_EDGE3
};

/* On edges xi lies in [-1,1], A at -1, and eta = 0.  All functions take them as faces: x and y of each vector count, z may be
 * any number, such as 0, and derivatives by it are 0.  The body lies to the left of A -> B, so that the normal is
 * (t_y, -t_x, 0) for the tangent r_xi = t; r_eta is (0, 0, 1).  Regions are 0 inside, 1 end A, 2 end B. */

/* Below, N is the number of nodes.  x holds the coordinates of the nodes and, last, of the slave node: 3 (N + 1), mesh length.
 * Derivatives by coordinates are in the same order.  FOOTPOINT_ERR_ARGUMENT: no such face. */

/** Returns the number of nodes, 3, 6, 4, 8, 9, 2 or 3, or 0 if there is no such face. */
int footpoint_face_nodes(enum footpoint_face face);

/** Finds the foot point of a slave node, with proof.  FOOTPOINT_OK: a minimum of the distance to the whole surface lies within
 *  1e-12 (tri6: 1e-10) of xi and eta, or within that times |xi| or |eta| if these exceed 1.  On curved faces, if loc is in the
 *  face, no point of the face is nearer by more than 1e-10 of the largest difference of coordinates; if loc is outside, the
 *  closest point lies on an edge or a corner.  On tri3 and quad4 the foot point need not be the closest point of the face.
 *  @param[out] loc  {xi, eta}; not clamped to the face
 *  @param[out] gap  mesh length, along the face's unit normal there; > 0 open
 *  @return FOOTPOINT_OK, FOOTPOINT_UNPROVED (outputs are written, without proof), FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_ARGUMENT */
int footpoint_face_locate(enum footpoint_face face, const double *x, double loc[2], double *gap);

/** Calls footpoint_face_locate for n pairs of a slave node and a face, using AVX-512 or AVX2 if available: for
 *  FOOTPOINT_TRI3 with the same bits, otherwise within the promise, because pairs side by side take other steps.
 *  @param[in]  xyz     nodes x 3, mesh length
 *  @param[in]  seg     n x N node indices, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched if the status is < FOOTPOINT_OK
 *  @param[out] gap     n; untouched likewise
 *  @param[out] status  n, or NULL: as footpoint_face_locate, also FOOTPOINT_ERR_ARGUMENT if an index is out of range
 *  @return the number of pairs whose status is not FOOTPOINT_OK */
size_t footpoint_face_locate_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *gap, int *status);

/** Finds the foot point from the last answer, which a contact code has from the step before.  It takes less time than
 *  footpoint_face_locate if the foot point has moved by less than 0.1 of a face.  If it has moved too far for a proof, the
 *  same call searches from scratch.  FOOTPOINT_OK: proved to 1e-10, on quad8, quad9 and tri3 to 1e-12, as in
 *  footpoint_face_locate.  If several minima lie close together, as on a folded face, the answer is a minimum to which the
 *  last answer leads.
 *  @param[in,out] loc  {xi, eta}, the last answer; must be NaN if there is no last answer; untouched if the status is
 *                      < FOOTPOINT_OK
 *  @return as footpoint_face_locate */
int footpoint_track(enum footpoint_face face, const double *x, double loc[2], double *gap);

/** Calls footpoint_track for n pairs, as footpoint_face_locate_pairs, with last answers in loc.  xi and eta may differ from
 *  footpoint_track's within the promise of both.
 *  @param[in,out] loc  n x 2: xi, eta of each pair, or NaN */
size_t footpoint_track_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                             const int *slave, double *loc, double *gap, int *status);

/** Projects a slave node along a direction: where the line through xS meets the face, as footpoint_KIND_along of generated/.
 *  FOOTPOINT_OK: the line is proved to meet the surface within 1e-9 of xi and eta, and the face nowhere else.
 *  @param[in]  along  the direction, of any length but 0, such as an averaged normal
 *  @param[out] loc    {xi, eta}
 *  @param[out] dist   xS = r(xi, eta) + dist along / |along|, mesh length
 *  @return FOOTPOINT_OK, FOOTPOINT_OUTSIDE (the line meets the surface beyond the face), FOOTPOINT_NOT_UNIQUE (it meets the
 *          face again; the answer is nearest to xS), FOOTPOINT_UNPROVED, FOOTPOINT_ERR_DOMAIN (no point is found),
 *          FOOTPOINT_ERR_DEGENERATE (no area or direction, or a line in the face), FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_ARGUMENT */
int footpoint_face_along(enum footpoint_face face, const double *x, const double along[3], double loc[2], double *dist);

/** Calls footpoint_face_along for n pairs, with the same bits, using AVX-512 or AVX2 if available.
 *  @param[in]  along  n x 3: a direction for each pair
 *  @param[in]  xyz, seg, slave    as in footpoint_face_locate_pairs
 *  @param[out] loc, dist, status  likewise
 *  @return the number of pairs whose status is not FOOTPOINT_OK */
size_t footpoint_face_along_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                  const int *slave, const double *along, double *loc, double *dist, int *status);

/** Finds the closest point of the face, its edges and corners included, as NAME_closest of generated/.  It is proved.
 *  @param[out] distance  |xS - r|, mesh length; < 0 behind the face, see "Signs" in footpoint.h
 *  @param[out] region    the part that contains r: 0 inside, 1 to 4 edge AB, BC, CD, DA, 5 to 8 corner A, B, C, D; on a
 *                        triangle 1 to 3 and 4 to 6
 *  @return as footpoint_face_locate; FOOTPOINT_ERR_DOMAIN (farther away than the longest edge); with all written
 *          FOOTPOINT_NOT_UNIQUE (another point is as near; never on tri3) and FOOTPOINT_UNPROVED (the nearest point found) */
int footpoint_face_closest(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region);

/** Finds the closest point of any face for any slave node, with certainty: on tri3 in closed form, on quad4 by
 *  footpoint_robust.  On a curved face, the header's foot point or closest point is proved if possible.  Otherwise Newton's
 *  method finds a minimum of the distance, and bounds over the face, or over ever smaller parts of it, prove that no point is
 *  nearer or find a nearer point to continue from.
 *  The distance is right to 1e-10 of the largest difference of a coordinate of xS and a node's, rounding included, with
 *  and without fused operations: loc is a point that far away, and no point of the face is nearer by more.
 *      double loc[2], distance;
 *      int region;
 *      const int status = footpoint_face_robust(FOOTPOINT_QUAD8, &x[0][0], loc, &distance, &region);
 *      if (status == FOOTPOINT_OK && distance < 0)
 *          push(loc, distance);
 *  @param[out] loc, distance, region  as in footpoint_face_closest; distance > 0 if the face has no area
 *  @return FOOTPOINT_OK (region 0: the closest point is strictly inside), FOOTPOINT_OUTSIDE (another region: loc lies on an
 *          edge or corner).  No other point is as near.  With the largest difference L of coordinates, as above, points
 *          within 2e-10 L + 3e-5 sqrt(L distance) of each other count as a single point (for quad4 see footpoint_robust);
 *          with all written: FOOTPOINT_NOT_UNIQUE (another point may be as near; the distance is right, as above; never on
 *          tri3), FOOTPOINT_NO_AREA (nodes on a line, to rounding; the distance is right, as above), FOOTPOINT_UNPROVED
 *          (20,000 parts did not suffice, or rounding hides the answer; only the distance of loc is certain; never on tri3);
 *          with nothing written: FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_ARGUMENT, FOOTPOINT_ERR_DOMAIN (the distance
 *          overflows, or on quad4: xS is farther away than 1e12 edges) */
int footpoint_face_robust(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region);

/** Does footpoint_face_robust for n pairs of a slave node and a face, using AVX-512 or AVX2 if available. Foot points of tri6,
 *  quad8 and quad9 come from footpoint_face_locate_pairs, so xi and eta may differ within its promise.
 *  @param[in]  xyz, seg, slave  as in footpoint_face_locate_pairs
 *  @param[out] loc       n x 2: xi, eta of each pair; untouched if the status is < FOOTPOINT_OK
 *  @param[out] distance  n; untouched likewise
 *  @param[out] region    n, or NULL; untouched likewise
 *  @param[out] status    n, or NULL: as footpoint_face_robust, also FOOTPOINT_ERR_ARGUMENT if an index is out of range
 *  @return the number of pairs whose status is neither FOOTPOINT_OK nor FOOTPOINT_OUTSIDE */
size_t footpoint_face_robust_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *distance, int *region, int *status);

/** Finds the closest of any number of faces, at any distance.  Faces whose bounding spheres are farther away than an answer are
 *  skipped.  Beyond a face's longest edge, and if footpoint_face_closest proves nothing, the closest point is that of
 *  footpoint_face_robust.
 *  @param[in]  xyz     coordinates by node index, mesh length
 *  @param[in]  seg     candidates x N node indices, from 0
 *  @param[out] chosen  index of the chosen candidate, from 0
 *  @param[out] loc, region  as in footpoint_face_closest, on the chosen face
 *  @param[out] distance     mesh length; < 0 behind the surface of the candidates.  At an edge or a corner, the surface's
 *                      normal is the sum of the unit normals of all candidates there, each times its angle.  This is the
 *                      side of a closed surface if all faces at that edge or corner are candidates.  A call takes a single
 *                      kind of face; in a mesh of several kinds the side is the candidates'.  Nodes with equal coordinates
 *                      are the same node.
 *  @return FOOTPOINT_OK; with all written FOOTPOINT_NOT_UNIQUE (another point of the chosen face is as near, as in
 *          footpoint_face_robust) and FOOTPOINT_UNPROVED (the nearest point found; a nearer one is not excluded).  Faces without
 *          an answer or an area are skipped.  If no face has an answer, the status is the last face's, or FOOTPOINT_ERR_DOMAIN
 *          if there are no candidates */
int footpoint_face_select(enum footpoint_face face, const double *xyz, size_t candidates, const int *seg,
                          const double xS[3], size_t *chosen, double loc[2], double *distance, int *region);

/** Evaluates a face at given (xi, eta), which need not be a foot point.  Outputs may be NULL.
 *  @param[out] phi     N: shape functions
 *  @param[out] r_xi, r_eta, normal  3: tangents, unit normal
 *  @param[out] gap     (xS - r) . normal */
int footpoint_face_place(enum footpoint_face face, const double *x, const double loc[2], double *phi, double *r_xi,
                         double *r_eta, double *normal, double *gap);

/** Computes first derivatives at a foot point, and the outputs of footpoint_face_place.  Outputs may be NULL.
 *  @param[out] d_xi, d_eta, d_gap  3 (N + 1): by all coordinates
 *  @return also FOOTPOINT_ERR_DEGENERATE if the foot point is not unique (the centre of curvature) */
int footpoint_face_differentiate(enum footpoint_face face, const double *x, const double loc[2], double *phi,
                                 double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                 double *d_gap);

/** Computes second derivatives of the gap and first derivatives of the normal.  Outputs may be NULL.
 *  @param[out] d_normal  3 x 3 (N + 1): each component by all coordinates
 *  @param[out] hessian   packed: by coordinates r and c, r >= c, at [r (r + 1) / 2 + c] */
int footpoint_face_hessian(enum footpoint_face face, const double *x, const double loc[2], double *gap, double *d_xi,
                           double *d_eta, double *d_gap, double *d_normal, double *hessian);

/** Differentiates a projection along a direction by the coordinates of nodes and slave node and, last, of the direction:
 *  3 (N + 2).  Outputs may be NULL; first derivatives alone take less time.
 *  @param[in]  loc  {xi, eta} from footpoint_face_along
 *  @param[out] dist                 as in footpoint_face_along
 *  @param[out] d_xi, d_eta, d_dist  first derivatives
 *  @param[out] h_xi, h_eta, h_dist  second derivatives, packed as in footpoint_face_hessian
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_DEGENERATE (no area or direction, or the line is so nearly parallel to the face that
 *          rounding may cost more than about 1e-9), FOOTPOINT_ERR_DOMAIN (edges: xS is too far away),
 *          FOOTPOINT_ERR_NOT_FINITE (also for a result), FOOTPOINT_ERR_ARGUMENT */
int footpoint_face_differentiate_along(enum footpoint_face face, const double *x, const double along[3],
                                       const double loc[2], double *dist, double *d_xi, double *d_eta, double *d_dist,
                                       double *h_xi, double *h_eta, double *h_dist);

#ifdef __cplusplus
}
#endif

#endif
