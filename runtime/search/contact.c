/* Computes normal, gap and forces of a contact pair, (6), (9), (10), (11); see footpoint.h. */
#include "../footpoint.h"
#include "../geometry/footpoint-quad4-geometry.h"
#include "../geometry/vector.h"

int footpoint_normal(const double corner[3], const double next[3], const double previous[3], double m[3])
{
    double c1[3], c2[3];
    if (!vector_finite(corner) || !vector_finite(next) || !vector_finite(previous))
        return FOOTPOINT_ERR_NOT_FINITE;
    vector_sub(next, corner, c1);
    vector_sub(previous, corner, c2);
    return vector_normal(c1, c2, m);
}

int footpoint_gap(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                  const double loc[2], const double m[3], double *gap)
{
    double d[3];
    footpoint_quad4_offset(xA, xB, xC, xD, xS, loc[0], loc[1], d);
    const double g = vector_dot(m, d);
    if (!number_finite(g))
        return FOOTPOINT_ERR_NOT_FINITE;
    *gap = g;
    return FOOTPOINT_OK;
}

/* Writes fs = factor d and fm[i] = -phi_i fs, unless a component overflows. */
static int act(double factor, const double d[3], const double loc[2], double fs[3], double fm[4][3])
{
    double phi[4], f[5][3];
    int finite = 1;
    footpoint_quad4_shape(loc[0], loc[1], phi);
    for (int i = 4; i >= 0; i--)
        for (int k = 0; k < 3; k++) {
            f[i][k] = i < 4 ? -phi[i] * f[4][k] : factor * d[k];
            finite = finite && number_finite(f[i][k]);
        }
    if (!finite)
        return FOOTPOINT_ERR_NOT_FINITE;
    memcpy(fs, f[4], sizeof f[4]);
    memcpy(fm, f, 4 * sizeof f[0]);
    return FOOTPOINT_OK;
}

int footpoint_force(double gap, double stiffness, const double m[3], const double loc[2], double fs[3], double fm[4][3])
{
    if (!number_finite(gap) || !number_finite(stiffness) || !vector_finite(m) || !number_finite(loc[0]) ||
        !number_finite(loc[1]))
        return FOOTPOINT_ERR_NOT_FINITE;
    if (stiffness < 0.0)
        return FOOTPOINT_ERR_ARGUMENT;
    return act(gap < 0.0 ? -gap * stiffness : 0.0, m, loc, fs, fm);
}

/* Returns 1 if d points behind the plane with the unit normal n by more than rounding, which is all of d . n for a vector in
 * the plane. */
static int is_behind(const double d[3], const double n[3])
{
    return vector_dot(d, n) < -1e-12 * hypot(hypot(d[0], d[1]), d[2]);
}

int footpoint_force_balanced(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                             const double xS[3], const double loc[2], double stiffness, double fs[3], double fm[4][3])
{
    double n[3], d[3];
    if (!vector_finite(xA) || !vector_finite(xB) || !vector_finite(xC) || !vector_finite(xD) || !vector_finite(xS) ||
        !number_finite(loc[0]) || !number_finite(loc[1]) || !number_finite(stiffness))
        return FOOTPOINT_ERR_NOT_FINITE;
    if (stiffness < 0.0)
        return FOOTPOINT_ERR_ARGUMENT;
    const int status = footpoint_quad4_normal(xA, xB, xC, xD, loc[0], loc[1], n);
    if (status != FOOTPOINT_OK)
        return status;
    footpoint_quad4_offset(xA, xB, xC, xD, xS, loc[0], loc[1], d);
    return act(is_behind(d, n) ? -stiffness : 0.0, d, loc, fs, fm);
}
