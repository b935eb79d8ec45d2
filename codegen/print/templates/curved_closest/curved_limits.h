/* Constants and functions for closest points of all curved faces. */

/* Results of a proof of the whole face: FAR, or another point from which to continue. */
#define FOOTPOINT_DETAIL_FAR 0
#define FOOTPOINT_DETAIL_NEARER 1
#define FOOTPOINT_DETAIL_DOUBT 2
#define FOOTPOINT_DETAIL_PARTS 400 /* most parts that are examined */
#define FOOTPOINT_DETAIL_DEPTH 60

/* Returns the quadratic -2 f.k + k.M k, M = [m11 m12; m12 m22], at k, and computes its slopes. */
FOOTPOINT_COLD REAL footpoint_detail_bowl(const REAL f[2], const REAL m[3], const REAL k[2],
                                          REAL slope[2])
{
    const REAL p = m[0] * k[0] + m[1] * k[1] - f[0], q = m[1] * k[0] + m[2] * k[1] - f[1];
    slope[0] = 2.0 * p;
    slope[1] = 2.0 * q;
    return k[0] * (p - f[0]) + k[1] * (q - f[1]);
}

/* Makes M positive semidefinite; returns by how much k.M k may have grown for |k| <= (a,b). */
FOOTPOINT_COLD REAL footpoint_detail_convex(REAL m[3], REAL a, REAL b)
{
    const REAL p = footpoint_detail_greater(-m[0], 0.0), q = footpoint_detail_greater(-m[2], 0.0);
    REAL most, over;
    m[0] += p;
    m[2] += q;
    most = (1.0 - 16.0 * REAL_UNIT) * sqrt(m[0] * m[2]);
    over = footpoint_detail_greater(fabs(m[1]) - most, 0.0);
    m[1] = fabs(m[1]) > most ? copysign(most, m[1]) : m[1];
    return p * (a * a) + q * (b * b) + 2.0 * over * (a * b);
}
