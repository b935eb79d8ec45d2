/* Proves a foot point by Krawczyk's test for (7), (8), whose Jacobian is the Hessian H of bilinear.h, in the variables m1 xi and
 * m2 eta.
 *
 * Let Y be any matrix near the inverse of H at the point, and let all norms be maximum norms.  If
 *     |Y f| + k(r) r < r   with   k(r) >= |I - Y H'|   for all H' within r of the point,
 * then z -> z + Y f(z) contracts the square of half-width r into itself, so exactly one stationary point lies there.
 * As H is quadratic in z, its change within r is bounded in closed form:
 *     |dH11| <= 2 |a.c3| r + c3.c3 r^2,  |dH22| <= 2 |b.c3| r + c3.c3 r^2,
 *     |dH12| <= 2 (|a.c3| + |b.c3|) r + 2 c3.c3 r^2.
 * Here r = 2 |Y f|, so that k(r) < 1/2 suffices.  The step to z + Y f(z) leaves k(r) r of the error.
 *
 * Every product carries the bound on its rounding error from bilinear_at.  Computing with these bounds rounds by a few units
 * each time, which ROUND_UP exceeds amply.  No rounding mode is changed, and multiplications and additions may be fused. */
#include "bilinear.h"

#define ROUND_UP (1.0 + 0x1p-40)
#define CONTRACTION 0.49 /* bound on k(r); the rest up to 1/2 is for rounding */

static double norm(double y11, double y12, double y22)
{
    return bilinear_larger(fabs(y11), fabs(y22)) + fabs(y12);
}

int footpoint_bilinear_prove_from(const struct bilinear *f, double xi, double eta, const struct bilinear_point *p,
                                  double error, struct bilinear_proof *proof)
{
    const double per = 1.0 / (p->h11 * p->h22 - p->h12 * p->h12);
    const double y11 = p->h22 * per, y22 = p->h11 * per, y12 = -p->h12 * per;
    const double move1 = y11 * p->f1 + y12 * p->f2, move2 = y12 * p->f1 + y22 * p->f2;
    proof->move[0] = move1 / f->m1;
    proof->move[1] = move2 / f->m2;
    if (!(fabs(proof->move[0]) <= DBL_MAX && fabs(proof->move[1]) <= DBL_MAX))
        return -1;
    const double y = norm(y11, y12, y22), h = norm(p->h11, p->h12, p->h22), error_c = p->error / f->m;
    const double doubt = y * (error + 4.0 * BILINEAR_UNIT * bilinear_larger(fabs(p->f1), fabs(p->f2)));
    const double r = 2.0 * (bilinear_larger(fabs(move1), fabs(move2)) + doubt) * ROUND_UP;
    const double rest1 = fabs(1.0 - (y11 * p->h11 + y12 * p->h12)) + fabs(y11 * p->h12 + y12 * p->h22);
    const double rest2 = fabs(y12 * p->h11 + y22 * p->h12) + fabs(1.0 - (y12 * p->h12 + y22 * p->h22));
    const double there = bilinear_larger(rest1, rest2) + 8.0 * BILINEAR_UNIT * (1.0 + y * h) + 2.0 * y * p->error;
    const double around =
        y * r * (4.0 * (fabs(p->ac) + fabs(p->bc) + 2.0 * error_c) + 3.0 * (p->cc + error_c / f->m) * r);
    const double k = (there + around) * ROUND_UP;
    if (!(k <= CONTRACTION && r <= DBL_MAX))
        return 0;
    proof->radius = r;
    proof->radius_after =
        (k * r + doubt + 4.0 * BILINEAR_UNIT * (f->m * bilinear_larger(fabs(xi), fabs(eta)) + r)) * ROUND_UP;
    return 1;
}

int footpoint_bilinear_prove(const struct bilinear *f, double xi, double eta, struct bilinear_point *p,
                             struct bilinear_proof *proof)
{
    bilinear_at(f, xi, eta, p);
    return footpoint_bilinear_prove_from(f, xi, eta, p, p->error * f->m, proof);
}

/* Returns 1 if q(v) = h22 |a + v c3|^2 - (h12 + v b.c3)^2, less the margin, is positive for low <= v <= high, a range that contains
 * 0.  As q is convex, its tangent at 0 or its discriminant proves this.  The discriminant is reduced by the rounding error of the
 * coefficient of v^2, which vanishes if b and c3 are parallel. */
static int is_definite(double h11, double h12, double h22, double ac, double bc, double cc, double low, double high,
                       double margin, double m)
{
    const double q0 = h11 * h22 - h12 * h12 - margin, q1 = 2.0 * (h22 * ac - h12 * bc);
    if (!(q0 > 0.0 && h22 > 0.0))
        return 0;
    return (q0 + q1 * low > 0.0 && q0 + q1 * high > 0.0) ||
           0.999 * 4.0 * q0 * (h22 * cc - bc * bc - 0.125 * margin / (m * m)) > q1 * q1;
}

/* Beyond the gradient, |d'|^2 of bilinear.h has, with a' = a + v c3,
 *     |u a' + v b|^2 - 2 u v c3.d = u^2 a'.a' + 2 u v (a'.b - c3.d) + v^2 b.b,
 * a quadratic form in (u,v) whose coefficients depend only on v, with the determinant q(v).  If q is positive for all v of the
 * segment, no point is nearer; the same holds with xi and eta exchanged.  The margin covers rounding, and a shift of the point
 * by slack, which changes h11, h12, h22 by at most 2 (|a.c3| + |b.c3| + c3.c3 slack) slack.  An eighth of the margin, over
 * m^2, covers the coefficient of v^2, whose terms are at most `sum` over m^2. */
int footpoint_bilinear_is_nearest(const struct bilinear *f, const struct bilinear_point *p, double xi, double eta,
                                  double slack, double floor)
{
    const double change = fabs(p->ac) + fabs(p->bc) + 2.0 * f->m * p->cc;
    const double sum = p->h11 + p->h22 + 2.0 * fabs(p->h12) + 6.0 * f->m * change;
    const double margin = (6.0 * change * slack + 96.0 * p->error + floor) * sum;
    const double m1 = f->m1, m2 = f->m2;
    return is_definite(p->h11, p->h12, p->h22, p->ac, p->bc, p->cc, m2 * (-1.0 - eta), m2 * (1.0 - eta), margin,
                       f->m) ||
           is_definite(p->h22, p->h12, p->h11, p->bc, p->ac, p->cc, m1 * (-1.0 - xi), m1 * (1.0 - xi), margin, f->m);
}

int footpoint_certify(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      const double xS[3], const double loc[2], double rho[2])
{
    struct bilinear f;
    struct bilinear_point p;
    struct bilinear_proof proof;
    if (!isfinite(loc[0]) || !isfinite(loc[1]))
        return FOOTPOINT_ERR_NOT_FINITE;
    const int status = footpoint_bilinear_of(xA, xB, xC, xD, xS, &f);
    if (status != FOOTPOINT_OK)
        return status;
    if (footpoint_bilinear_prove(&f, loc[0], loc[1], &p, &proof) != 1)
        return FOOTPOINT_ERR_UNPROVED;
    rho[0] = proof.radius / f.m1 * ROUND_UP;
    rho[1] = proof.radius / f.m2 * ROUND_UP;
    return FOOTPOINT_OK;
}
