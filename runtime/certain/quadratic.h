/* Faces of degree 2 in each of two coordinates u and v from 0 to 1, for quadratic.c and subdivide.c: faces of eight and nine nodes,
 * with xi = 2 u - 1 and eta = 2 v - 1, and triangles of six, with xi = u and eta = v.
 *     r - xS = sum b_ij B_i(u) B_j(v)
 * with Bernstein's polynomials B of degree 2 and the control points b_ij.  All faces are the square of a and b from 0 to 1.  On a
 * triangle u = a (1 - b) and v = b; it is turned so that the point in question is nearest to its first corner, in u and v,
 * far from the corner at which a is undefined.
 *
 * The unit of length is a power of two for which the largest component of a control point, extrapolated points of a
 * triangle included, is from 1/2 to 1.  In this unit the errors of control points are at most 64 u, u = 2^-53, if differences of
 * nodes from xS are right to u: 60 u for the middle point of eight nodes, 59 u for a triangle's last point, less for all
 * others. */
#ifndef FOOTPOINT_QUADRATIC_H
#define FOOTPOINT_QUADRATIC_H

#include "../footpoint.h"
#include "../geometry/vector.h"

/* Error of distances over the largest difference of a coordinate of xS and a node's. */
#define QUADRATIC_TOLERANCE 0x1.8p-34

struct quadratic {
    double net[9][3]; /* b_ij at 3 i + j */
    double extent[2]; /* largest component of b_i+1,j - b_ij, of b_i,j+1 - b_ij */
    double tolerance; /* of distances, in this unit */
    int triangle, exponent;
};

/* Coefficients [i][j] of s^i t^j of r - xS around a point, with the offsets s and t from it in u and v. */
struct quadratic_taylor {
    double c[3][3][3];
};

enum quadratic_proof { QUADRATIC_PROVED, QUADRATIC_TIED, QUADRATIC_NEARER, QUADRATIC_GIVEN_UP };

static inline double quadratic_larger(double a, double b)
{
    return a > b ? a : b;
}

/* Return u and v of (a,b) = at. */
static inline double quadratic_u(const struct quadratic *f, const double at[2])
{
    return f->triangle ? at[0] * (1.0 - at[1]) : at[0];
}

#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Finds the closest point of the face, with certainty.
 *  @param[in]  nodes          6, 8 or 9
 *  @param[in]  x              coordinates of the nodes and xS
 *  @param[in]  start          {xi, eta} to begin from
 *  @param[out] loc, distance  as in footpoint_face_robust; the distance without its sign
 *  @param[in,out] boxes       limit on the parts of the face to examine; how many are left
 *  @return as footpoint_face_robust, but FOOTPOINT_OK on edges, too */
int footpoint_quadratic_closest(int nodes, const double *x, const double start[2], double loc[2], double *distance,
                                int *boxes);

/** Expands r - xS around a point.  Let U and V be the extents, and W the smaller of them.  Errors, in terms of the largest
 *  component of a control point, are at most 54 u for c00, 70 u U for c10 and c20, 70 u V for c01 and c02, and 256 u W for all
 *  others. */
void footpoint_quadratic_taylor(const struct quadratic *f, double u, double v, struct quadratic_taylor *t);

/** Proves that no point of the face is nearer than the local minimum `at`, with the expansion t, by more than half of the
 *  tolerance, or finds a nearer point.
 *  @param[in,out] boxes  limit on the boxes to examine
 *  @param[out]    start  (a,b) of the nearer point
 *  @return QUADRATIC_PROVED (nor is any other point as near), QUADRATIC_TIED (another may be), QUADRATIC_NEARER,
 *          QUADRATIC_GIVEN_UP */
enum quadratic_proof footpoint_quadratic_prove(const struct quadratic *f, const double at[2],
                                               const struct quadratic_taylor *t, int *boxes, double start[2]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

#endif
