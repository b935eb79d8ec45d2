/* The equations (7), (8) with twice the digits, for segments on which one double leaves too few: near a centre of
 * curvature and near a collapsed edge the products a . d cancel, and the error of xi and eta is that of the products
 * over a small determinant. */
#include "bilinear.h"
#include "twofold.h"

enum { STEPS = 6 };

#define FARTHEST 1e-5  /* what is so much off has no place of its own */
#define ENOUGH 0x1p-44 /* of m1 xi and m2 eta, over m */

/* y - x, times a power of two. */
static struct twofold difference(double y, double x, int exponent)
{
    struct twofold d;
    if (exponent == 0)
        return twofold_sum(y, -x);
    const double by = exponent > 0 ? 0.25 : 1.0; /* differences may overflow, or have no room below */
    d = twofold_sum(by * y, -by * x);
    d.high = ldexp(d.high, (exponent > 0 ? 2 : 0) - exponent);
    d.low = ldexp(d.low, (exponent > 0 ? 2 : 0) - exponent);
    return d;
}

/* a . d and b . d, where a and b are r_xi and r_eta. */
static void residual(const double *const x[5], int exponent, double xi, double eta, double f[2])
{
    struct twofold s = twofold_sum(1.0, xi), t = twofold_sum(1.0, eta), f1 = {0.0, 0.0}, f2 = {0.0, 0.0};
    s.high *= 0.5, s.low *= 0.5, t.high *= 0.5, t.low *= 0.5;
    for (int i = 0; i < 3; i++) {
        const struct twofold ab = difference(x[1][i], x[0][i], exponent), dc = difference(x[2][i], x[3][i], exponent);
        const struct twofold ad = difference(x[3][i], x[0][i], exponent), bc = difference(x[2][i], x[1][i], exponent);
        const struct twofold a = twofold_add(ab, twofold_multiply(t, twofold_subtract(dc, ab)));
        const struct twofold b = twofold_add(ad, twofold_multiply(s, twofold_subtract(bc, ad)));
        const struct twofold r = twofold_add(twofold_multiply(s, ab), twofold_multiply(t, b));
        const struct twofold d = twofold_subtract(difference(x[4][i], x[0][i], exponent), r);
        f1 = twofold_add(f1, twofold_multiply(a, d));
        f2 = twofold_add(f2, twofold_multiply(b, d));
    }
    f[0] = 0.5 * f1.high;
    f[1] = 0.5 * f2.high;
}

int footpoint_bilinear_refine(const double *const x[5], const struct bilinear *f, double z[2], double *radius)
{
    const double start[2] = {z[0], z[1]};
    double xi = z[0], eta = z[1];
    for (int n = 0; n < STEPS; n++) {
        struct bilinear_point p;
        struct bilinear_proof proof;
        double rest[2];
        bilinear_at(f, xi, eta, &p);
        residual(x, f->exponent, xi, eta, rest);
        p.f1 = rest[0] / f->m1;
        p.f2 = rest[1] / f->m2;
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
