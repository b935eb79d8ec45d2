/* Evaluates (7), (8) with twice the digits, for segments on which a double leaves too few.  Near a centre of curvature and near a
 * collapsed edge the products a . d cancel, and the error of xi and eta is the products' error over a small determinant. */
#include "bilinear.h"

enum { STEPS = 6 };

#define FARTHEST 1e-5  /* a point with a larger error has no place of its own */
#define ENOUGH 0x1p-44 /* error of m1 xi and m2 eta, over m */

void footpoint_bilinear_wide_at(const double *const x[5], int exponent, const double z[2], struct bilinear_wide *p)
{
    const struct twofold s = twofold_scale(0.5, twofold_sum(1.0, z[0]));
    const struct twofold t = twofold_scale(0.5, twofold_sum(1.0, z[1]));
    for (int i = 0; i < 3; i++) {
        const struct twofold ab = bilinear_difference(x[1][i], x[0][i], exponent);
        const struct twofold dc = bilinear_difference(x[2][i], x[3][i], exponent);
        const struct twofold ad = bilinear_difference(x[3][i], x[0][i], exponent);
        const struct twofold c = twofold_subtract(dc, ab), along = twofold_add(ad, twofold_multiply(s, c));
        const struct twofold r = twofold_add(twofold_multiply(s, ab), twofold_multiply(t, along));
        p->a[i] = twofold_scale(0.5, twofold_add(ab, twofold_multiply(t, c)));
        p->b[i] = twofold_scale(0.5, along);
        p->c[i] = twofold_scale(0.25, c);
        p->d[i] = twofold_subtract(bilinear_difference(x[4][i], x[0][i], exponent), r);
    }
}

int footpoint_bilinear_refine(const double *const x[5], const struct bilinear *f, double z[2], double *radius)
{
    const double start[2] = {z[0], z[1]};
    double xi = z[0], eta = z[1];
    for (int n = 0; n < STEPS; n++) {
        struct bilinear_point p;
        struct bilinear_proof proof;
        struct bilinear_wide w;
        const double at[2] = {xi, eta};
        bilinear_at(f, xi, eta, &p);
        footpoint_bilinear_wide_at(x, f->exponent, at, &w);
        p.f1 = twofold_dot(w.a, w.d).high / f->m1;
        p.f2 = twofold_dot(w.b, w.d).high / f->m2;
        const int solved = footpoint_bilinear_prove_from(f, xi, eta, &p, 0x1p-40 * p.error * f->m, &proof);
        if (solved < 0)
            return 0;
        xi += proof.move[0];
        eta += proof.move[1];
        if (!(fabs(xi - start[0]) <= FARTHEST && fabs(eta - start[1]) <= FARTHEST))
            return 0;
        if (solved && proof.radius_after <= ENOUGH * f->m) {
            z[0] = xi;
            z[1] = eta;
            *radius = proof.radius_after;
            return 1;
        }
    }
    return 0;
}
