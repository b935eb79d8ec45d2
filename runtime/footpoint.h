/* footpoint: foot points of slave nodes on four-node master segments, without iteration.
 *
 * A master segment is the bilinear surface r(xi,eta) = sum phi_i x_i of four corners
 *     A = (-1,-1)   B = (1,-1)   C = (1,1)   D = (-1,1)        in (xi,eta),
 * counter-clockwise seen from outside, so that normals point towards the slave nodes.  Each node is passed as a pointer to
 * its three coordinates, which may lie anywhere in the caller's arrays.  Coordinates are in any one unit of length ("mesh
 * length"), with edges from 1e-300 to 1e300.
 *
 * Functions return a status.  Outputs are written if it is >= 0 and untouched if it is < 0.  Nothing here allocates, prints
 * or keeps state; every function may be called from several threads.  Only the C library's <math.h> is needed.
 *
 * Equation numbers follow Oishi and Yoshimura, "Genetic approaches to iteration-free local contact search",
 * CMES 2008. */
#ifndef FOOTPOINT_H
#define FOOTPOINT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Signs.  A gap or a distance is < 0 if the slave node xS lies behind the face, and > 0 if it lies in front.  This holds for
 * every function and kind of face, in headers and library, C and Fortran.  Behind means (xS - r) . n < 0, with the face's
 * normal n at the point r.
 * At a collapsed edge, or a corner of about 180 degrees, n is the normal 1/1024 of the way from r to the middle of the face,
 * on the bisector of a collapsed edge.  This rule applies if |r_xi x r_eta| at r is less than 1/1024 of its value there.
 * If r lies on an edge or a corner, xS is behind only if (xS - r) . n is below -1e-12 |xS - r| |n| and below rounding.  So a
 * node beside a flat face, in its plane, is not behind it.  If several faces share the edge or corner, call
 * footpoint_face_select or NAME_closest_of of generated headers with all of them.
 * A negative sign is not yet contact.  A node penetrates a face if the distance is < 0 and r lies inside the face: region 0,
 * or FOOTPOINT_OK from footpoint_robust.  It penetrates a surface if footpoint_face_select, called with all faces at
 * that edge or corner, returns a distance < 0. */

/* Statuses: outputs are written if status >= FOOTPOINT_OK, that is 0.  Generated headers define the same macros. */
#ifndef FOOTPOINT_OK
#define FOOTPOINT_OK 0 /* the answer */
#endif
#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1 /* an answer on an edge of the segment, or beyond it */
#endif
#ifndef FOOTPOINT_NOT_UNIQUE
#define FOOTPOINT_NOT_UNIQUE 2 /* an answer; another is as near, to 1e-10 of the longest edge */
#endif
#ifndef FOOTPOINT_NO_AREA
#define FOOTPOINT_NO_AREA 3 /* the closest point of a segment without area */
#endif
#ifndef FOOTPOINT_UNPROVED
#define FOOTPOINT_UNPROVED 4 /* an answer without proof */
#endif
#ifndef FOOTPOINT_ERR_NOT_FINITE
#define FOOTPOINT_ERR_NOT_FINITE (-1) /* a coordinate is infinite or NaN */
#endif
#ifndef FOOTPOINT_ERR_DEGENERATE
#define FOOTPOINT_ERR_DEGENERATE (-2) /* no area and so no normal, or a denominator is 0 */
#endif
#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3) /* no sufficient answer; see each function */
#endif
#ifndef FOOTPOINT_ERR_NO_CONVERGENCE
#define FOOTPOINT_ERR_NO_CONVERGENCE (-4) /* an iteration did not converge */
#endif
#ifndef FOOTPOINT_ERR_ARGUMENT
#define FOOTPOINT_ERR_ARGUMENT (-5) /* an index, count or parameter is out of range */
#endif
#ifndef FOOTPOINT_ERR_UNPROVED
#define FOOTPOINT_ERR_UNPROVED (-6) /* a proof failed; the statement may still be true */
#endif
/* The least and the greatest status. */
enum { FOOTPOINT_STATUS_LEAST = FOOTPOINT_ERR_UNPROVED, FOOTPOINT_STATUS_MOST = FOOTPOINT_UNPROVED };

/** Returns the meaning of a status as a short English phrase in lower case, or "unknown status". */
const char *footpoint_strerror(int status);

/** Finds the foot point of a slave node on a segment, with proof.  The search is footpoint_quad4_accurate of
 *  generated/footpoint_quad4.h.  A foot point lies within 1.1e-7 of xi and eta, 1e-10 on ordinary segments, and no point of
 *  the segment is nearer.  On the segments named in that header, every foot point inside the segment is found.
 *      double loc[2], gap;
 *      if (footpoint_locate(xA, xB, xC, xD, xS, loc, &gap) == FOOTPOINT_OK && fabs(loc[0]) <= 1 &&
 *          fabs(loc[1]) <= 1 && gap < 0)
 *          push(loc, gap);
 *  @param[out] loc  {xi, eta}, dimensionless; in [-1,1] if the foot point lies on the segment, not clamped to it
 *  @param[out] gap  (xS - r(xi,eta)) . n with the segment's unit normal n = r_xi x r_eta / |r_xi x r_eta| at the foot
 *                   point; mesh length, > 0 open, < 0 penetrating.  For (9) with the normal (6), call footpoint_gap.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_DOMAIN (the accuracy is not
 *          proved; footpoint_robust has an answer) */
int footpoint_locate(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *gap);

/** Calls footpoint_locate for n pairs of a slave node and a segment in one array of coordinates.
 *  @param[in]  xyz     nodes x 3, mesh length
 *  @param[in]  seg     n x 4 node indices A, B, C, D, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched if the status is not FOOTPOINT_OK
 *  @param[out] gap     n, as in footpoint_locate; untouched likewise
 *  @param[out] status  n, or NULL: as footpoint_locate, or FOOTPOINT_ERR_ARGUMENT if an index is out of range
 *  @return the number of pairs whose status is not FOOTPOINT_OK */
size_t footpoint_locate_pairs(size_t n, const double *xyz, size_t nodes, const int *seg, const int *slave, double *loc,
                              double *gap, int *status);

/** Projects a slave node along a direction: footpoint_face_along of a four-node segment. */
int footpoint_along(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                    const double along[3], double loc[2], double *dist);

/** Finds a foot point by iteration, for comparison and for cases outside the iteration-free search: from the centre, up to
 *  three Gauss-Newton steps, then Newton's method on (7), (8) with the full Hessian.  It finds a stationary point of the
 *  distance, usually the nearest; far from the segment or near its centre of curvature it may be another.
 *  @param[in]  max_iterations  at least 1; 20 is plenty
 *  @param[in]  tolerance       > 0, finite; the iteration ends when neither xi nor eta moves by more.  1e-12 suits most
 *                              segments
 *  @param[out] loc, gap        as in footpoint_locate
 *  @param[out] iterations      number of steps, or NULL
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (the segment has no area),
 *          FOOTPOINT_ERR_NO_CONVERGENCE (also if a step or the normal fails on a segment with an area),
 *          FOOTPOINT_ERR_ARGUMENT */
int footpoint_newton(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     int max_iterations, double tolerance, double loc[2], double *gap, int *iterations);

/** Chooses the segment that a slave node hits, among the segments at its nearest master node P_m, by (3), (4) with (5), (6).
 *  c1 and c2 are the edges from P_m to the next and to the previous corner, and (4) reads (c1 x r) . (r x c2) > 0: seen
 *  along the corner's normal, the slave node lies between the two edges.  A slave node over an edge, to rounding, or over
 *  P_m itself belongs to all segments there.  If no segment contains it strictly inside, the first of these in the caller's
 *  order is chosen.  Segments without area at P_m are skipped.
 *  @param[in]  xyz         coordinates by node index, mesh length
 *  @param[in]  master      index of P_m
 *  @param[in]  candidates  number of segments
 *  @param[in]  seg         candidates x 4 node indices A, B, C, D; each segment must contain `master`
 *  @param[out] chosen      index of the chosen candidate, from 0
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_ARGUMENT, FOOTPOINT_ERR_DOMAIN (no candidate is hit) */
int footpoint_select_segment(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen);

/** Chooses the segment closest to a slave node, among the segments at a master node, for cases in which (3), (4) fail: over
 *  a ridge no segment is hit, in a valley or around a reflex node several are, and an edge or a corner belongs to all
 *  segments there.  Distances are to whole closed segments, also collapsed ones.  Among equal distances, to rounding, a
 *  segment chosen by (3), (4) comes first, then the first in the caller's order.  Takes about a microsecond a candidate.
 *  @param[out] distance  to the chosen segment, mesh length, >= 0; or NULL
 *  @return as footpoint_select_segment, but FOOTPOINT_ERR_DOMAIN only if there are no candidates; and FOOTPOINT_UNPROVED,
 *          with chosen and distance written, if footpoint_robust returns it for a candidate */
int footpoint_select_closest(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen, double *distance);

/** Computes the unit normal (6) at a corner: m = c1 x c2 / |c1 x c2| with the edges c1 to the next corner and c2 to the
 *  previous corner.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (edges parallel or of no length) */
int footpoint_normal(const double corner[3], const double next[3], const double previous[3], double m[3]);

/** Computes the gap (9) along a given unit normal: g = m . (xS - r(xi,eta)); mesh length, > 0 open, < 0 penetrating.
 *  @param[in] loc  {xi, eta}
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE */
int footpoint_gap(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                  const double loc[2], const double m[3], double *gap);

/** Computes contact forces (10), (11): fs = -gap k m on the slave node and its reaction fm[i] = -phi_i(xi,eta) fs on corner
 *  i.  The paper prints (11) without the minus.  With it, the five forces add up to zero to rounding, and so do their
 *  moments if m is the segment's normal at the exact foot point; see footpoint_force_balanced.  All forces are zero if
 *  gap >= 0.
 *  @param[in]  gap        mesh length
 *  @param[in]  stiffness  k >= 0, force per mesh length
 *  @param[in]  m          unit normal
 *  @param[in]  loc        {xi, eta}
 *  @param[out] fs         force on the slave node
 *  @param[out] fm         fm[4][3], forces on A, B, C, D
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (also for a force), FOOTPOINT_ERR_ARGUMENT (k < 0) */
int footpoint_force(double gap, double stiffness, const double m[3], const double loc[2], double fs[3],
                    double fm[4][3]);

/** Computes contact forces that balance for any (xi,eta), along the offset d = xS - r(xi,eta): fs = -k d on the slave node if
 *  it lies behind the segment there, and fm[i] = -phi_i(xi,eta) fs.  To rounding, the five forces and their moments about any
 *  point add up to zero, also at approximate foot points and at points clamped to an edge.  (The moments of footpoint_force
 *  add up to zero only if m is parallel to d.)  At the exact foot point d = gap n, and the forces are (10), (11) with that
 *  normal and the gradients of the energy k gap^2/2.
 *  The slave node lies behind the segment if d . n < -1e-12 |d| with the segment's unit normal n there; otherwise all forces
 *  are zero.  So a node beside a flat segment, in its plane, gets no forces.
 *  @param[in]  loc        {xi, eta}
 *  @param[in]  stiffness  k >= 0, force per mesh length
 *  @param[out] fs, fm     as in footpoint_force
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (also for a force), FOOTPOINT_ERR_DEGENERATE (no normal),
 *          FOOTPOINT_ERR_ARGUMENT (k < 0) */
int footpoint_force_balanced(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                             const double xS[3], const double loc[2], double stiffness, double fs[3], double fm[4][3]);

/** Computes force and consistent tangent of a contact element along the normal, for any kind of face: pressure = multiplier -
 *  stiffness gap if that is > 0, otherwise 0, and force = pressure d gap / dx.  With multiplier = 0 these are the penalty
 *  forces (10), (11) along the segment's own normal, at the exact foot point equal to footpoint_force_balanced.  Otherwise
 *  they belong to an augmented Lagrangian, whose next multiplier is `pressure`.
 *  @param[in]  nodes       of the face, 2 to 9; coordinate 3 k + i is component i of node k, the slave node last
 *  @param[in]  gap, d_gap, hessian  from footpoint_KIND_hessian of generated/
 *  @param[in]  stiffness   >= 0, force per mesh length
 *  @param[in]  multiplier  force; >= 0 pressing
 *  @param[out] pressure    force, >= 0
 *  @param[out] force       3 (nodes + 1): on all nodes
 *  @param[out] tangent     -d force / dx, symmetric: element (r, c), r >= c, is [r (r + 1) / 2 + c]
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (also for a force or its tangent), FOOTPOINT_ERR_ARGUMENT */
int footpoint_element_normal(int nodes, double gap, const double *d_gap, const double *hessian, double stiffness,
                             double multiplier, double *pressure, double *force, double *tangent);

/** Computes force and consistent tangent of Coulomb friction by return mapping.  A spring holds the slave node to the place
 *  (xi0, eta0) of the face at which it sticks, which moves with the face.  s is the vector from there to the slave node,
 *  less its part along the normal at the foot point.  The force on the slave node is -tangential s, limited to friction
 *  times pressure; its reaction on node k is -phi_k times that force.
 *  @param[in]  nodes       as above
 *  @param[in]  x           3 (nodes + 1): coordinates of the nodes and the slave node
 *  @param[in]  phi         shape functions at (xi0, eta0)
 *  @param[in]  r_xi, r_eta, normal  from footpoint_KIND_place of generated/ at the foot point
 *  @param[in]  d_gap, d_normal      from footpoint_KIND_hessian
 *  @param[in]  pressure, stiffness  of footpoint_element_normal
 *  @param[in]  friction    Coulomb's coefficient, >= 0
 *  @param[in]  tangential  > 0, force per mesh length
 *  @param[out] slip        {xi, eta}, 0 if it sticks; to first order, the caller must add it to (xi0, eta0) after the step
 *  @param[out] force       3 (nodes + 1): on all nodes
 *  @param[out] tangent     -d force / dx, not symmetric during slip: element (r, c) is [3 (nodes + 1) r + c]
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (also for a result), FOOTPOINT_ERR_DEGENERATE (no area),
 *          FOOTPOINT_ERR_ARGUMENT */
int footpoint_element_friction(int nodes, const double *x, const double *phi, const double r_xi[3],
                               const double r_eta[3], const double normal[3], const double *d_gap,
                               const double *d_normal, double pressure, double stiffness, double friction,
                               double tangential, double slip[2], double *force, double *tangent);

/* Proved answers for any four corners: warped, folded, crossing, with collapsed edges, of any size from denormal numbers to
 * 1e308. */

/** Proves that a foot point is near: exactly one solution of (7), (8), for the coordinates as they are to the last bit, has
 *  |xi - loc[0]| <= rho[0] and |eta - loc[1]| <= rho[1].  loc may be any point.  The nearer it is to a foot point, the smaller
 *  is rho, down to a few rounding errors.  The proof (Krawczyk's test, with bounds on all rounding errors) holds with and
 *  without fused operations, but not under -ffast-math.
 *  @param[in]  loc  {xi, eta}
 *  @param[out] rho  half-widths in xi and in eta, dimensionless
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_UNPROVED (too far from any solution, or too near the centre of curvature),
 *          FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (all corners coincide),
 *          FOOTPOINT_ERR_DOMAIN (xS is farther away than 1e12 edges) */
int footpoint_certify(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      const double xS[3], const double loc[2], double rho[2]);

/** Finds the closest point of any segment, -1 <= xi, eta <= 1, for any slave node.  Begin with this function.  First,
 *  footpoint_quad4_accurate_closest of generated/footpoint_quad4.h searches and proves.  If that fails, all stationary points,
 *  listed with proof, and the nearest points of the edges are compared with twice the digits.  The point r(xi,eta) is right
 *  to 1e-10 of the longest edge.
 *      double loc[2], dist;
 *      const int status = footpoint_robust(xA, xB, xC, xD, xS, loc, &dist);
 *      if (status == FOOTPOINT_OK && dist < 0)
 *          push(loc, dist);
 *  @param[out] loc   {xi, eta}, in [-1,1]
 *  @param[out] dist  |xS - r|, mesh length; < 0 behind the segment, see "Signs" above; > 0 if the segment has no area.  At
 *                    a foot point inside the segment this is the gap.
 *  @return FOOTPOINT_OK (the foot point lies strictly inside: |xi| < 1 and |eta| < 1);
 *          with loc and dist written: FOOTPOINT_OUTSIDE (the closest point lies on an edge, xi or eta being -1 or 1; it may
 *          still be a foot point), FOOTPOINT_NOT_UNIQUE (another point, elsewhere in space, is as near to 1e-10 of the
 *          longest edge; dist is right to that), FOOTPOINT_NO_AREA (the closest point of a segment without area, with
 *          dist > 0), FOOTPOINT_UNPROVED (the nearest point found; rounding hides whether another is nearer);
 *          with neither: FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DOMAIN (xS is farther away than 1e12 edges) */
int footpoint_robust(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *dist);

enum { FOOTPOINT_STATIONARY_MOST = 5 };

/** Finds all points of the segment that satisfy (7), (8), minima of the distance and others, -1 <= xi, eta <= 1, each to
 *  rounding.  Eliminating xi or eta from (7), (8) leaves quintics, whose roots are isolated with proof.  There are at most
 *  five points.
 *  @param[out] loc    up to FOOTPOINT_STATIONARY_MOST x 2: xi, eta, in no particular order
 *  @param[out] count  number of points
 *  @return FOOTPOINT_OK; FOOTPOINT_NOT_UNIQUE (some points are too close together to be separated, or form a line; one point
 *          stands for them, and they may not exist); FOOTPOINT_ERR_DEGENERATE (no area), FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_DOMAIN as footpoint_certify */
int footpoint_stationary(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double loc[FOOTPOINT_STATIONARY_MOST][2], int *count);

/** A foot point and its derivatives, for implicit codes.  Coordinate 3 k + i is component i of node k, in the order A, B, C,
 *  D, S. */
struct footpoint_derivatives {
    double phi[4];              /* shape functions of A, B, C, D */
    double r_xi[3], r_eta[3];   /* tangents; mesh length */
    double normal[3];           /* r_xi x r_eta / |r_xi x r_eta| */
    double gap;                 /* (xS - r) . normal; mesh length */
    double d_xi[15], d_eta[15]; /* derivatives of xi and eta by the coordinates; 1 over mesh length */
    double d_gap[15];           /* derivatives of the gap: +normal for S, -phi_k normal for corner k */
};

/** Differentiates a foot point by all fifteen coordinates, from (7), (8) by the implicit function theorem.  Derivatives are
 *  exact, to rounding, if loc is a foot point.  If loc is off by e, their error is of the order of e.
 *  @param[in]  loc  {xi, eta} of a foot point inside or outside the segment; must not be a closest point on an edge
 *  @param[out] out  all members
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (also for a result),
 *          FOOTPOINT_ERR_DEGENERATE (no normal beyond rounding, as far outside; or no derivative, because xS lies at a centre
 *          of curvature) */
int footpoint_differentiate(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], const double loc[2], struct footpoint_derivatives *out);

#ifdef __cplusplus
}
#endif

#endif
