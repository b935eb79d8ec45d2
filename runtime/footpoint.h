/* footpoint: where a slave node meets a four-node master segment, without iteration.
 *
 * A master segment is the bilinear surface r(xi,eta) = sum phi_i x_i of four corners
 *     A = (-1,-1)   B = (1,-1)   C = (1,1)   D = (-1,1)        in (xi,eta),
 * counter-clockwise seen from outside, so that normals point to where slave nodes come from.  Each node is passed as a
 * pointer to its three coordinates, which may lie anywhere in the caller's arrays.  Coordinates are in any one unit of
 * length ("mesh length"): edges from 1e-300 to 1e300 long.
 *
 * Functions return a status.  If it is >= 0 there is an answer, and FOOTPOINT_OK, which is 0, one as usual; if it is < 0
 * there is none, and outputs are untouched.
 * Nothing here allocates, prints, keeps state or takes anything but a C library's <math.h>; every function may be
 * called from several threads.
 *
 * Equation numbers are those of Oishi and Yoshimura, "Genetic approaches to iteration-free local contact search",
 * CMES 2008. */
#ifndef FOOTPOINT_H
#define FOOTPOINT_H

#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

/* Signs.  A gap or a distance is < 0 if the slave node xS lies behind the face, and > 0 in front of it: in every function, of
 * every kind of face, of headers and library, C and Fortran.  Behind means (xS - r) . n < 0, n being the face's normal at the
 * point r.  Where r_xi x r_eta at r is shorter than 1/1024 of what it is 1/1024 of the way to the middle of the face, because
 * an edge is collapsed, or almost, or the angle of a corner is about 180 degrees, n is the normal there, on the bisector of a
 * collapsed edge.  If r lies on an edge or a corner, xS is behind only if (xS - r) . n is below
 * -1e-12 |xS - r| |n| and below rounding: a node beside a flat face, in its plane, is not behind it.  Where several faces
 * share an edge or a corner, footpoint_face_select and NAME_closest_of of generated headers ask all of them.
 * A sign is no contact.  A node penetrates a face if the distance is < 0 and r lies inside the face: region 0, or
 * FOOTPOINT_OK of footpoint_robust, which says FOOTPOINT_OUTSIDE of edges; or if the distance is < 0 that
 * footpoint_face_select gives for all faces there. */

/* Statuses: an answer is written where status >= FOOTPOINT_OK, that is 0, and nothing where it is less.  Generated headers
 * define the same macros. */
#ifndef FOOTPOINT_OK
#define FOOTPOINT_OK 0 /* the answer */
#endif
#ifndef FOOTPOINT_OUTSIDE
#define FOOTPOINT_OUTSIDE 1 /* the answer, which lies on the edge of the segment, or beyond it */
#endif
#ifndef FOOTPOINT_NOT_UNIQUE
#define FOOTPOINT_NOT_UNIQUE 2 /* an answer; another is as near, to 1e-10 of the longest edge, or in the segment, too */
#endif
#ifndef FOOTPOINT_NO_AREA
#define FOOTPOINT_NO_AREA 3 /* the closest point of a segment that has no area */
#endif
#ifndef FOOTPOINT_UNPROVED
#define FOOTPOINT_UNPROVED 4 /* an answer that is not proved */
#endif
#ifndef FOOTPOINT_ERR_NOT_FINITE
#define FOOTPOINT_ERR_NOT_FINITE (-1) /* a coordinate is an infinity or not a number */
#endif
#ifndef FOOTPOINT_ERR_DEGENERATE
#define FOOTPOINT_ERR_DEGENERATE (-2) /* no area to take a normal from, or no number: a denominator vanishes */
#endif
#ifndef FOOTPOINT_ERR_DOMAIN
#define FOOTPOINT_ERR_DOMAIN (-3) /* no such segment or point; the point lies outside what the answer holds for */
#endif
#ifndef FOOTPOINT_ERR_NO_CONVERGENCE
#define FOOTPOINT_ERR_NO_CONVERGENCE (-4) /* an iteration did not settle */
#endif
#ifndef FOOTPOINT_ERR_ARGUMENT
#define FOOTPOINT_ERR_ARGUMENT (-5) /* an index, count or parameter is out of range */
#endif
#ifndef FOOTPOINT_ERR_UNPROVED
#define FOOTPOINT_ERR_UNPROVED (-6) /* a proof failed; what was to be proved may hold all the same */
#endif
/* The least and the greatest of them. */
enum { FOOTPOINT_STATUS_LEAST = FOOTPOINT_ERR_UNPROVED, FOOTPOINT_STATUS_MOST = FOOTPOINT_UNPROVED };

/** What a status means, as a short English phrase in lower case; "unknown status" for a number that is none. */
const char *footpoint_strerror(int status);

/** Foot point of one slave node on one segment: footpoint_quad4_accurate of generated/footpoint_quad4.h, with proof that a
 *  foot point is within 1.1e-7 of xi and eta, 1e-10 on ordinary segments, and that no point of the segment is nearer.  On the
 *  segments named there this loses no answer that lies on the segment.
 *  @param[out] loc  {xi, eta}, dimensionless; in [-1,1] if the foot point lies on the segment, not clamped to it
 *  @param[out] gap  (xS - r(xi,eta)) . n with n the segment's own unit normal r_xi x r_eta / |r_xi x r_eta| at the foot
 *                   point; mesh length, > 0 open, < 0 penetrating.  For (9) with the normal (6), call footpoint_gap.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE, FOOTPOINT_ERR_DOMAIN (the answer is not as
 *          good, or that is not certain; footpoint_robust has one) */
int footpoint_locate(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *gap);

/** footpoint_locate for n pairs of a slave node and a segment, out of one array of coordinates.
 *  @param[in]  xyz     nodes x 3, mesh length
 *  @param[in]  seg     n x 4 node indices A, B, C, D, from 0
 *  @param[in]  slave   n node indices
 *  @param[out] loc     n x 2: xi, eta of each pair; untouched where the status is not FOOTPOINT_OK
 *  @param[out] gap     n, as in footpoint_locate; likewise
 *  @param[out] status  n, or NULL: as footpoint_locate, or FOOTPOINT_ERR_ARGUMENT where an index is out of range
 *  @return how many pairs have a status other than FOOTPOINT_OK */
size_t footpoint_locate_pairs(size_t n, const double *xyz, size_t nodes, const int *seg, const int *slave, double *loc,
                              double *gap, int *status);

/** Foot point by iteration, as a reference and for what the iteration-free search is not made for: from the centre, up
 *  to three Gauss-Newton steps, then Newton's method on (7), (8) with the full Hessian.  It finds a stationary point of
 *  the distance, as a rule the nearest; far from the segment or near its centre of curvature it may be another.
 *  @param[in]  max_iterations  at least 1; 20 is plenty
 *  @param[in]  tolerance       > 0, finite: done when neither xi nor eta moves by more; 1e-12 suits most segments
 *  @param[out] loc, gap        as in footpoint_locate
 *  @param[out] iterations      steps taken, or NULL
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (the segment has no area),
 *          FOOTPOINT_ERR_NO_CONVERGENCE (as well if a step or the normal fails on a segment with an area),
 *          FOOTPOINT_ERR_ARGUMENT */
int footpoint_newton(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     int max_iterations, double tolerance, double loc[2], double *gap, int *iterations);

/** The segment that a slave node hits, among those that share its nearest master node P_m: criterion (3), (4) with (5),
 *  (6), where c1 and c2 are the edges from P_m to the next and to the previous corner, and (4) reads
 *  (c1 x r) . (r x c2) > 0.  In words: seen along the corner's normal, the slave node lies between the two edges.
 *  A slave node over an edge, where a product vanishes to rounding, or over P_m itself, belongs to all segments there:
 *  the first of them in the caller's order is chosen, if none holds it strictly inside.  A segment without area at P_m
 *  is passed over.
 *  @param[in]  xyz         coordinates by node index, mesh length
 *  @param[in]  master      index of P_m
 *  @param[in]  candidates  how many segments
 *  @param[in]  seg         candidates x 4 node indices A, B, C, D; each must contain `master`
 *  @param[out] chosen      which of the candidates, from 0
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_ARGUMENT, FOOTPOINT_ERR_DOMAIN (none of them) */
int footpoint_select_segment(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen);

/** The segment that a slave node is closest to, among those that share a master node: for where (3), (4) fail.  Outside
 *  of a ridge no segment holds the slave node, in a valley or around a reflex node several do, and what hits an edge or
 *  a corner belongs to all segments there.  Distances are to each whole segment, its edges and corners included, of any
 *  number of segments; collapsed ones too.  Where they are equal but for rounding, a segment that (3), (4) give comes
 *  first, then the first in the caller's order.  About a microsecond a candidate.
 *  @param[out] distance  to the chosen segment, mesh length, >= 0; or NULL
 *  @return as footpoint_select_segment, FOOTPOINT_ERR_DOMAIN only if there are no candidates; and FOOTPOINT_UNPROVED, with
 *          chosen and distance written, where footpoint_robust says so of a candidate */
int footpoint_select_closest(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen, double *distance);

/** Unit normal (6) at a corner: m = c1 x c2 / |c1 x c2|, c1 the edge to the next corner, c2 to the previous one.
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (edges parallel or of no length) */
int footpoint_normal(const double corner[3], const double next[3], const double previous[3], double m[3]);

/** Gap (9) along a given unit normal: g = m . (xS - r(xi,eta)); mesh length, > 0 open, < 0 penetrating.
 *  @param[in] loc  {xi, eta}
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE */
int footpoint_gap(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                  const double loc[2], const double m[3], double *gap);

/** Contact forces (10), (11): fs = -gap k m on the slave node, and its reaction fm[i] = -phi_i(xi,eta) fs on corner i.
 *  (11) is printed without the minus; with it the five forces add up to zero to rounding, and so do their moments if m
 *  is the segment's normal at the exact foot point: see footpoint_force_balanced.  All forces are zero when gap >= 0.
 *  @param[in]  gap        mesh length
 *  @param[in]  stiffness  k >= 0, force per mesh length
 *  @param[in]  m          unit normal
 *  @param[in]  loc        {xi, eta}
 *  @param[out] fs         force on the slave node
 *  @param[out] fm         fm[4][3], forces on A, B, C, D
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (a force, too), FOOTPOINT_ERR_ARGUMENT (k < 0) */
int footpoint_force(double gap, double stiffness, const double m[3], const double loc[2], double fs[3],
                    double fm[4][3]);

/** Contact forces that balance whatever (xi,eta) is: along the offset d = xS - r(xi,eta) itself, fs = -k d on the slave
 *  node if it is behind the segment there, and fm[i] = -phi_i(xi,eta) fs.  To rounding, the five forces
 *  add up to zero and so do their moments about any point, at an approximate foot point as at the exact one, and at a
 *  point clamped to an edge.  (With footpoint_force the moments add up to zero only if m is parallel to d, as the
 *  segment's normal at the exact foot point is, but not (6).)  At the exact foot point d = gap n, and these are (10),
 *  (11) with that normal, and the gradients of the energy k gap^2/2.
 *  The slave node is behind the segment if d . n < -1e-12 |d|, with the segment's unit normal n there; otherwise all forces
 *  are zero.  So a node in the plane of a flat segment, but beside it, gives no forces.
 *  @param[in]  loc        {xi, eta}
 *  @param[in]  stiffness  k >= 0, force per mesh length
 *  @param[out] fs, fm     as in footpoint_force
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (a force, too), FOOTPOINT_ERR_DEGENERATE (no normal),
 *          FOOTPOINT_ERR_ARGUMENT (k < 0) */
int footpoint_force_balanced(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                             const double xS[3], const double loc[2], double stiffness, double fs[3], double fm[4][3]);

/** Force and consistent tangent of a contact element along the normal, for any kind of face: pressure = multiplier -
 *  stiffness gap where that is > 0, else 0, force = pressure d gap / dx.  With multiplier = 0 the penalty forces (10), (11)
 *  along the segment's own normal, and, at the exact foot point, those of footpoint_force_balanced, whose tangent it so
 *  is, too; otherwise those of an augmented Lagrangian, whose next multiplier is `pressure`.
 *  @param[in]  nodes       of the face, 3 to 9; coordinate 3 k + i is component i of node k, the slave node last
 *  @param[in]  gap, d_gap, hessian  as footpoint_KIND_hessian of generated/ gives them
 *  @param[in]  stiffness   >= 0, force per mesh length
 *  @param[in]  multiplier  force; >= 0 pressing
 *  @param[out] pressure    force, >= 0
 *  @param[out] force       3 (nodes + 1): on all nodes
 *  @param[out] tangent     -d force / dx, symmetric: element (r, c), r >= c, is [r (r + 1) / 2 + c]
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (a force or its tangent, too), FOOTPOINT_ERR_ARGUMENT */
int footpoint_element_normal(int nodes, double gap, const double *d_gap, const double *hessian, double stiffness,
                             double multiplier, double *pressure, double *force, double *tangent);

/** Force and consistent tangent of Coulomb friction by return mapping.  The slave node is held by a spring to the point of
 *  the face where it sticks, a place (xi0, eta0) that moves with the face; s is the way from there to the slave node, less
 *  its part along the normal at the foot point.  The force on the slave node is -tangential s, cut down to friction times
 *  pressure, and its reaction on node k is -phi_k times that.
 *  @param[in]  nodes       as above
 *  @param[in]  x           3 (nodes + 1): coordinates of the nodes and the slave node
 *  @param[in]  phi         shape functions at (xi0, eta0)
 *  @param[in]  r_xi, r_eta, normal  as footpoint_KIND_place of generated/ gives them at the foot point
 *  @param[in]  d_gap, d_normal      as footpoint_KIND_hessian does
 *  @param[in]  pressure, stiffness  of footpoint_element_normal
 *  @param[in]  friction    Coulomb's coefficient, >= 0
 *  @param[in]  tangential  > 0, force per mesh length
 *  @param[out] slip        {xi, eta}: to be added to (xi0, eta0) when the step is done, to first order; 0 where it sticks
 *  @param[out] force       3 (nodes + 1): on all nodes
 *  @param[out] tangent     -d force / dx, not symmetric where it slides: element (r, c) is [3 (nodes + 1) r + c]
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (a result, too), FOOTPOINT_ERR_DEGENERATE (no area),
 *          FOOTPOINT_ERR_ARGUMENT */
int footpoint_element_friction(int nodes, const double *x, const double *phi, const double r_xi[3],
                               const double r_eta[3], const double normal[3], const double *d_gap,
                               const double *d_normal, double pressure, double stiffness, double friction,
                               double tangential, double slip[2], double *force, double *tangent);

/* Answers with a proof.  These are for any four corners: warped, folded, crossing, with collapsed edges, of any size
 * from denormal numbers to 1e308. */

/** Proves that a foot point is near: exactly one solution of (7), (8), for the coordinates as they are to the last bit,
 *  has |xi - loc[0]| <= rho[0] and |eta - loc[1]| <= rho[1].  Any point may be asked for, wherever it came from; the
 *  nearer it is to a foot point, the smaller is rho, down to a few rounding errors.  The proof (Krawczyk's test, with
 *  bounds on all rounding errors) holds with and without fused operations, but not under -ffast-math.
 *  @param[in]  loc  {xi, eta}
 *  @param[out] rho  half-widths in xi and in eta, dimensionless
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_UNPROVED (too far from any solution, or too near the centre of curvature),
 *          FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DEGENERATE (all corners coincide),
 *          FOOTPOINT_ERR_DOMAIN (xS is farther away than 1e12 edges) */
int footpoint_certify(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      const double xS[3], const double loc[2], double rho[2]);

/** Closest point of the segment, -1 <= xi, eta <= 1, whatever segment and slave node: the call to begin with.  It is
 *  footpoint_quad4_accurate of generated/footpoint_quad4.h, which proves its foot point, and a
 *  proof that no point of the segment is nearer; where either fails, a comparison, with
 *  twice the digits, of the nearest points of the edges and all stationary points, the list of which is proved to be
 *  complete.  The point r(xi,eta) is right to 1e-10 of the longest edge.
 *  @param[out] loc   {xi, eta}, in [-1,1]
 *  @param[out] dist  |xS - r|, mesh length; < 0 behind the segment, see "Signs" above; > 0 if the segment has no area.  At
 *                    a foot point inside the segment this is the gap.
 *  @return FOOTPOINT_OK (the foot point, strictly inside: |xi| < 1 and |eta| < 1);
 *          with loc and dist written: FOOTPOINT_OUTSIDE (the closest point lies on the edge of the segment, xi or eta
 *          being -1 or 1; it may be a foot point all the same),
 *          FOOTPOINT_NOT_UNIQUE (another point, elsewhere in space, is as near to 1e-10 of the longest edge; dist is
 *          right to that), FOOTPOINT_NO_AREA (the segment has none: its closest point, with dist > 0),
 *          FOOTPOINT_UNPROVED (the nearest point found: rounding hides whether it is the nearest of all);
 *          with neither: FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DOMAIN (xS is farther away than 1e12 edges) */
int footpoint_robust(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *dist);

enum { FOOTPOINT_STATIONARY_MOST = 5 };

/** All points of the segment where (7), (8) hold, minima of the distance and others, -1 <= xi, eta <= 1, each to
 *  rounding: from the quintics that are left of (7), (8) when xi or eta is eliminated, whose roots are isolated with
 *  proof.  There are five at most.
 *  @param[out] loc    up to FOOTPOINT_STATIONARY_MOST x 2: xi, eta, in no particular order
 *  @param[out] count  how many
 *  @return FOOTPOINT_OK; FOOTPOINT_NOT_UNIQUE (some are too close together to be told apart, or there is a line of them:
 *          one stands for them; perhaps there is none);
 *          FOOTPOINT_ERR_DEGENERATE (no area), FOOTPOINT_ERR_NOT_FINITE, FOOTPOINT_ERR_DOMAIN as footpoint_certify */
int footpoint_stationary(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double loc[FOOTPOINT_STATIONARY_MOST][2], int *count);

/** What an implicit code needs of a foot point.  Coordinate number 3 k + i is component i of node k, in the order A, B,
 *  C, D, S. */
struct footpoint_derivatives {
    double phi[4];              /* shape functions of A, B, C, D */
    double r_xi[3], r_eta[3];   /* tangents; mesh length */
    double normal[3];           /* r_xi x r_eta / |r_xi x r_eta| */
    double gap;                 /* (xS - r) . normal; mesh length */
    double d_xi[15], d_eta[15]; /* derivatives of xi and eta by the coordinates; 1 over mesh length */
    double d_gap[15];           /* derivatives of the gap: +normal for S, -phi_k normal for corner k */
};

/** Derivatives of a foot point by all fifteen coordinates, from (7), (8) by the implicit function theorem: exact, to
 *  rounding, if loc is a foot point; if it is off by e, so are they, to first order.
 *  @param[in]  loc  {xi, eta} as a search returned them, inside the segment or not, but no closest point on its edge
 *  @param[out] out  all of it
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE (a result, too),
 *          FOOTPOINT_ERR_DEGENERATE (no normal, or none beyond rounding, as far outside; or no derivative, as xS lies at a
 *          centre of curvature) */
int footpoint_differentiate(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                            const double xS[3], const double loc[2], struct footpoint_derivatives *out);

#ifdef __cplusplus
}
#endif

#endif
