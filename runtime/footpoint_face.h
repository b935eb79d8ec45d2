/* footpoint: faces of every kind, told by a number: the search, closest points, derivatives, arrays of pairs.
 *
 * Each call is that of a generated header, compiled: the most accurate search of generated/footpoint_KIND.h, whose
 * banner says how accurate it is and on which faces, and generated/footpoint_KIND_derivatives.h.  Nodes are in its order:
 * corners counter-clockwise seen from where slave nodes come, then the middles of edges from AB on, then the middle.  A
 * triangle has 0 <= xi, eta and xi + eta <= 1, a quadrilateral xi and eta in [-1,1].
 *
 * Statuses and the rest as in footpoint.h.  footpoint_face_locate proves its foot points, footpoint_face_robust and
 * footpoint_face_robust_pairs their closest points: call these unless you know your faces.  With d_gap, d_normal and
 * hessian, footpoint_element_normal and
 * footpoint_element_friction give force and tangent of a contact element. */
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
    FOOTPOINT_FACES
};

/* In what follows, N is the number of nodes, and x are coordinates of the nodes and, last, of the slave node: 3 (N + 1),
 * mesh length; derivatives by them are in the same order.  FOOTPOINT_ERR_ARGUMENT: no such face. */

/** 3, 6, 4, 8, 9; or 0: no such face. */
int footpoint_face_nodes(enum footpoint_face face);

/** Foot point of a slave node.  FOOTPOINT_OK: a minimum of the distance to the whole surface is proved to lie within 1e-12 (tri6:
 *  1e-10) of xi and eta, or of |xi| or |eta| times that if it is greater than 1.  Of curved faces no point of the face is nearer,
 *  by more than 1e-10 of the largest difference of coordinates, if loc is in the face; if it is not, the closest point lies on an
 *  edge or a corner.  Of tri3 and quad4 it need not be the closest point of the face.
 *  @param[out] loc  {xi, eta}; not clamped to the face
 *  @param[out] gap  mesh length, along the face's unit normal there; > 0 open
 *  @return FOOTPOINT_OK, FOOTPOINT_UNPROVED (outputs are written, nothing is proved), FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_ARGUMENT */
int footpoint_face_locate(enum footpoint_face face, const double *x, double loc[2], double *gap);

/** The same for n pairs of a slave node and a face, to the same bits, with AVX-512 or AVX2 where the machine has them.
 *  @param[in]  xyz     nodes x 3, mesh length
 *  @param[in]  seg     n x N node indices, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched where the status is < FOOTPOINT_OK
 *  @param[out] gap     n; likewise
 *  @param[out] status  n, or NULL: as footpoint_face_locate, FOOTPOINT_ERR_ARGUMENT where an index is out of range, too
 *  @return how many pairs have a status other than FOOTPOINT_OK */
size_t footpoint_face_locate_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *gap, int *status);

/** Foot point from the last answer, as a contact code has it from the step before: footpoint_face_locate, in less time if the
 *  foot point has moved by less than 0.1 of a face.  Where it has moved too far for a proof from there, the search begins
 *  anew in the same call.  FOOTPOINT_OK: proved to 1e-10, of quad8, quad9 and tri3 to 1e-12, as of footpoint_face_locate.  If
 *  several minima lie close together, as on a folded face, the answer is a minimum that the last one leads to.
 *  @param[in,out] loc  {xi, eta}, the last answer, or NaN if there is none; untouched if the status is < FOOTPOINT_OK
 *  @return as footpoint_face_locate */
int footpoint_track(enum footpoint_face face, const double *x, double loc[2], double *gap);

/** The same for n pairs, as footpoint_face_locate_pairs, with last answers in loc; xi and eta may differ from those of
 *  footpoint_track within what both promise.
 *  @param[in,out] loc  n x 2: xi, eta of each pair, or NaN */
size_t footpoint_track_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                             const int *slave, double *loc, double *gap, int *status);

/** Finds the closest point of the face, its edges and corners included, as NAME_closest of generated/.  It is proved, but of
 *  tri3, for which it is exact to rounding.
 *  @param[out] distance  |xS - r|, mesh length; < 0 behind the face, see "Signs" in footpoint.h
 *  @param[out] region    where r lies: 0 inside, 1 to 4 edge AB, BC, CD, DA, 5 to 8 corner A, B, C, D; of a triangle
 *                        1 to 3 and 4 to 6
 *  @return as footpoint_face_locate; FOOTPOINT_ERR_DOMAIN: farther off than the longest edge is long; of all but tri3 with all
 *          written FOOTPOINT_NOT_UNIQUE (another point is as near) and FOOTPOINT_UNPROVED (the nearest point found) */
int footpoint_face_closest(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region);

/** Finds the closest point of the face with certainty, whatever the face and the slave node: of tri3 in closed form, of
 *  quad4 by footpoint_robust.  Of a curved face, the header proves its foot point, or its closest point.  If it does not,
 *  Newton's method leads to a minimum of the distance.  Bounds over the whole face, or over ever smaller parts of it, then prove that no point is nearer, or
 *  find one to go on from.
 *  The distance is right to 1e-10 of the largest difference of a coordinate of xS and a node's, rounding included, with
 *  and without fused operations: loc is a point that far away, and no point of the face is nearer by more.
 *  @param[out] loc, distance, region  as of footpoint_face_closest; distance > 0 if the face has no area
 *  @return FOOTPOINT_OK (region 0: the closest point is strictly inside), FOOTPOINT_OUTSIDE (another region: loc lies on an
 *          edge or corner).  No other point is as near.  With the largest difference L of coordinates, as above,
 *          points within 2e-10 L + 3e-5 sqrt(L distance) of each other count as one (of quad4 see footpoint_robust);
 *          with all written: FOOTPOINT_NOT_UNIQUE (another may be as near: the distance is right, as above; never of tri3),
 *          FOOTPOINT_NO_AREA (nodes on a line, to rounding: the distance is right, as above), FOOTPOINT_UNPROVED (20,000
 *          parts did not suffice, or rounding hides the answer: loc is that far away, no more is certain; never of tri3);
 *          with none: FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_ARGUMENT, FOOTPOINT_ERR_DOMAIN (the distance is no
 *          number, or of quad4: xS is farther away than 1e12 edges) */
int footpoint_face_robust(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region);

/** The same for n pairs of a slave node and a face, to the same bits, with AVX-512 or AVX2 where the machine has them.
 *  @param[in]  xyz, seg, slave  as of footpoint_face_locate_pairs
 *  @param[out] loc       n x 2: xi, eta of each pair; untouched where the status is < FOOTPOINT_OK
 *  @param[out] distance  n; likewise
 *  @param[out] region    n, or NULL; likewise
 *  @param[out] status    n, or NULL: as footpoint_face_robust, FOOTPOINT_ERR_ARGUMENT where an index is out of range, too
 *  @return how many pairs have a status other than FOOTPOINT_OK and FOOTPOINT_OUTSIDE */
size_t footpoint_face_robust_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *distance, int *region, int *status);

/** The face that a slave node is closest to, of any number of them.
 *  @param[in]  xyz     coordinates by node index, mesh length
 *  @param[in]  seg     candidates x N node indices, from 0
 *  @param[out] chosen  which of the candidates, from 0
 *  @param[out] loc, region  as of footpoint_face_closest, on the chosen face
 *  @param[out] distance     mesh length; < 0 behind the surface that the candidates make: at an edge or a corner that of
 *                      the sum of the unit normals of all candidates there, each times its angle.  That is the side of a
 *                      closed surface if all faces at that edge or corner are candidates.  One call takes one kind of
 *                      face: in a mesh of several kinds a corner may have more faces, and then the side is that of
 *                      the candidates'.  Nodes are the same if their coordinates are.
 *  @return as footpoint_face_closest.  Faces without an answer are passed over; if all are, the status is that of the
 *          last one, and FOOTPOINT_ERR_DOMAIN if there are no candidates */
int footpoint_face_select(enum footpoint_face face, const double *xyz, size_t candidates, const int *seg,
                          const double xS[3], size_t *chosen, double loc[2], double *distance, int *region);

/** What there is at given (xi, eta), which need not be a foot point.  Outputs may be NULL.
 *  @param[out] phi     N: shape functions
 *  @param[out] r_xi, r_eta, normal  3: tangents, unit normal
 *  @param[out] gap     (xS - r) . normal */
int footpoint_face_place(enum footpoint_face face, const double *x, const double loc[2], double *phi, double *r_xi,
                         double *r_eta, double *normal, double *gap);

/** First derivatives at a foot point, and what footpoint_face_place gives.  Outputs may be NULL.
 *  @param[out] d_xi, d_eta, d_gap  3 (N + 1): by all coordinates
 *  @return FOOTPOINT_ERR_DEGENERATE, too, where the foot point is not unique (the centre of curvature) */
int footpoint_face_differentiate(enum footpoint_face face, const double *x, const double loc[2], double *phi,
                                 double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                 double *d_gap);

/** Second derivatives of the gap, first ones of the normal.  Outputs may be NULL.
 *  @param[out] d_normal  3 x 3 (N + 1): of each component by all coordinates
 *  @param[out] hessian   packed: by coordinates r and c, r >= c, at [r (r + 1) / 2 + c] */
int footpoint_face_hessian(enum footpoint_face face, const double *x, const double loc[2], double *gap, double *d_xi,
                           double *d_eta, double *d_gap, double *d_normal, double *hessian);

#ifdef __cplusplus
}
#endif

#endif
