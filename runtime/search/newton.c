/* Finds the foot point (7), (8) by Newton's iteration.  With d = xS - r the equations are r_xi . d = r_eta . d = 0.  Since
 * r_xixi = r_etaeta = 0 and r_xieta = c3, the Hessian of |d|^2/2 is
 *     [ r_xi . r_xi             r_xi . r_eta - c3 . d ]
 *     [ r_xi . r_eta - c3 . d   r_eta . r_eta         ].
 * The first steps are Gauss-Newton steps, which drop c3 . d and therefore always descend. */
#include "../footpoint.h"
#include "../geometry/footpoint-quad4-geometry.h"
#include "../geometry/vector.h"

#include <float.h>

enum { GAUSS_NEWTON_STEPS = 3 };

/* r = c0 + c1 xi + c2 eta + c3 xi eta, and d0 = xS - c0, in a unit of length in which c1 and c2 are about 1 long. */
struct surface {
    double c1[3], c2[3], c3[3], d0[3];
};

static struct surface surface_of(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                                 const double xS[3])
{
    struct surface f;
    for (int i = 0; i < 3; i++) {
        const double ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], bc = xC[i] - xB[i];
        f.c1[i] = ab + dc;
        f.c2[i] = ad + bc;
        f.c3[i] = dc - ab;
    }
    const int exponent = vector_exponent(f.c1) > vector_exponent(f.c2) ? vector_exponent(f.c1) : vector_exponent(f.c2);
    for (int i = 0; i < 3; i++) {
        f.c1[i] = 0.25 * ldexp(f.c1[i], -exponent);
        f.c2[i] = 0.25 * ldexp(f.c2[i], -exponent);
        f.c3[i] = 0.25 * ldexp(f.c3[i], -exponent);
        f.d0[i] = ldexp(xS[i] - xA[i], -exponent) - (f.c1[i] + f.c2[i] - f.c3[i]);
    }
    return f;
}

/* Computes a step from (xi,eta).  Returns 0 if its equations have no finite solution. */
static int step(const struct surface *f, int gauss_newton, double xi, double eta, double move[2])
{
    double a[3], b[3], d[3];
    for (int i = 0; i < 3; i++) {
        a[i] = f->c1[i] + f->c3[i] * eta;
        b[i] = f->c2[i] + f->c3[i] * xi;
        d[i] = f->d0[i] - f->c1[i] * xi - b[i] * eta;
    }
    const double aa = vector_dot(a, a), bb = vector_dot(b, b), ad = vector_dot(a, d), bd = vector_dot(b, d);
    const double ab = vector_dot(a, b) - (gauss_newton ? 0.0 : vector_dot(f->c3, d));
    const double determinant = aa * bb - ab * ab;
    /* If r_xi and r_eta are parallel, the determinant is only rounding. */
    if (!(fabs(determinant) > 4.0 * DBL_EPSILON * (aa * bb)) || !number_finite(determinant))
        return 0;
    move[0] = (bb * ad - ab * bd) / determinant;
    move[1] = (aa * bd - ab * ad) / determinant;
    return number_finite(move[0]) && number_finite(move[1]);
}

/* Returns 1 if a triangle at a corner has an area. */
static int has_area(const double xA[3], const double xB[3], const double xC[3], const double xD[3])
{
    double n[3];
    return footpoint_normal(xA, xB, xD, n) == FOOTPOINT_OK || footpoint_normal(xB, xC, xA, n) == FOOTPOINT_OK ||
           footpoint_normal(xC, xD, xB, n) == FOOTPOINT_OK || footpoint_normal(xD, xA, xC, n) == FOOTPOINT_OK;
}

int footpoint_newton(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     int max_iterations, double tolerance, double loc[2], double *gap, int *iterations)
{
    double xi = 0.0, eta = 0.0, move[2];
    if (max_iterations < 1 || !(tolerance > 0.0) || !number_finite(tolerance))
        return FOOTPOINT_ERR_ARGUMENT;
    if (!vector_finite(xA) || !vector_finite(xB) || !vector_finite(xC) || !vector_finite(xD) || !vector_finite(xS))
        return FOOTPOINT_ERR_NOT_FINITE;
    const struct surface f = surface_of(xA, xB, xC, xD, xS);
    for (int n = 1; n <= max_iterations; n++) {
        if (!step(&f, n <= GAUSS_NEWTON_STEPS, xi, eta, move))
            break;
        xi += move[0];
        eta += move[1];
        if (fabs(move[0]) > tolerance || fabs(move[1]) > tolerance)
            continue;
        if (footpoint_quad4_gap(xA, xB, xC, xD, xS, xi, eta, gap) != FOOTPOINT_OK)
            break;
        loc[0] = xi;
        loc[1] = eta;
        if (iterations)
            *iterations = n;
        return FOOTPOINT_OK;
    }
    return has_area(xA, xB, xC, xD) ? FOOTPOINT_ERR_NO_CONVERGENCE : FOOTPOINT_ERR_DEGENERATE;
}
