/* Expands the bilinear segment for the files of this folder; see bilinear.h. */
#include "bilinear.h"

static void subtract(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     struct bilinear *f)
{
    for (int i = 0; i < 3; i++) {
        f->ab[i] = xB[i] - xA[i];
        f->dc[i] = xC[i] - xD[i];
        f->ad[i] = xD[i] - xA[i];
        f->bc[i] = xC[i] - xB[i];
        f->as[i] = xS[i] - xA[i];
    }
    f->m1 = bilinear_larger(bilinear_largest(f->ab), bilinear_largest(f->dc));
    f->m2 = bilinear_larger(bilinear_largest(f->ad), bilinear_largest(f->bc));
    f->m = bilinear_larger(f->m1, f->m2);
    f->s = bilinear_largest(f->as);
}

/* Subtracts quarters of the coordinates, if differences of the coordinates overflow. */
static void subtract_quarters(const double *const x[5], struct bilinear *f)
{
    double y[5][3];
    for (int k = 0; k < 15; k++)
        y[k / 3][k % 3] = 0.25 * x[k / 3][k % 3];
    subtract(y[0], y[1], y[2], y[3], y[4], f);
    f->exponent = 2;
}

static void scale_by(struct bilinear *f, int exponent)
{
    for (int i = 0; i < 3; i++) {
        f->ab[i] = ldexp(f->ab[i], exponent);
        f->dc[i] = ldexp(f->dc[i], exponent);
        f->ad[i] = ldexp(f->ad[i], exponent);
        f->bc[i] = ldexp(f->bc[i], exponent);
        f->as[i] = ldexp(f->as[i], exponent);
    }
    f->m1 = ldexp(f->m1, exponent);
    f->m2 = ldexp(f->m2, exponent);
    f->m = ldexp(f->m, exponent);
    f->s = ldexp(f->s, exponent);
}

/* Computes c3 from the shorter edges, which gives the smaller error. */
static void expand(struct bilinear *f)
{
    const double *const from = f->m1 < f->m2 ? f->ab : f->ad, *const to = f->m1 < f->m2 ? f->dc : f->bc;
    for (int i = 0; i < 3; i++) {
        f->c1[i] = 0.25 * (f->ab[i] + f->dc[i]);
        f->c2[i] = 0.25 * (f->ad[i] + f->bc[i]);
        f->c3[i] = 0.25 * (to[i] - from[i]);
        f->d0[i] = f->as[i] - (f->c1[i] + f->c2[i] - f->c3[i]);
    }
}

/* Returns 0 if all are finite, otherwise NaN. */
static double sum_of(const double x[3])
{
    return x[0] * 0.0 + x[1] * 0.0 + x[2] * 0.0;
}

int footpoint_bilinear_of(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                          const double xS[3], struct bilinear *f)
{
    if (!(sum_of(xA) + sum_of(xB) + sum_of(xC) + sum_of(xD) + sum_of(xS) == 0.0))
        return FOOTPOINT_ERR_NOT_FINITE;
    subtract(xA, xB, xC, xD, xS, f);
    f->exponent = 0;
    if (!(f->m >= BILINEAR_LEAST && f->m <= BILINEAR_MOST)) {
        int exponent;
        if (!(f->m > 0.0))
            return FOOTPOINT_ERR_DEGENERATE;
        if (!(f->m <= DBL_MAX && f->s <= DBL_MAX))
            subtract_quarters((const double *const[5]){xA, xB, xC, xD, xS}, f);
        (void)frexp(f->m, &exponent);
        if (!(f->s * (1.0 / BILINEAR_FARTHEST) <= f->m))
            return FOOTPOINT_ERR_DOMAIN;
        scale_by(f, -exponent);
        f->exponent += exponent;
    }
    if (!(f->s <= BILINEAR_FARTHEST * f->m))
        return FOOTPOINT_ERR_DOMAIN;
    expand(f);
    return FOOTPOINT_OK;
}

static int parallel(const double a[3], const double b[3])
{
    double n[3];
    vector_cross(a, b, n);
    return vector_dot(n, n) <= 1024.0 * DBL_EPSILON * DBL_EPSILON * (vector_dot(a, a) * vector_dot(b, b));
}

int footpoint_bilinear_has_area(const struct bilinear *f)
{
    return !(parallel(f->ab, f->ad) && parallel(f->ab, f->bc) && parallel(f->dc, f->ad) && parallel(f->dc, f->bc));
}
