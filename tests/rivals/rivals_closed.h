/* Closed forms that finite element programmers use for the local contact search, without dependent steps. See
 * rivals.h. */
#ifndef FOOTPOINT_RIVALS_CLOSED_H
#define FOOTPOINT_RIVALS_CLOSED_H

#include "rivals_hand.h"

/** Closed forms: R(name). */
#define RIVAL_CLOSED_FORMS(R)                                                                                          \
    R(area)                                                                                                            \
    R(centroid)                                                                                                        \
    R(plane)                                                                                                           \
    RIVAL_HAND(R)

/* Returns twice the area of the triangle of the origin, a and b. */
RIVAL_FN FOOTPOINT_REAL rival_triangle(const FOOTPOINT_REAL a[3], const FOOTPOINT_REAL b[3])
{
    const FOOTPOINT_REAL x = a[1] * b[2] - a[2] * b[1], y = a[2] * b[0] - a[0] * b[2], z = a[0] * b[1] - a[1] * b[0];
    return sqrt(x * x + y * y + z * z);
}

/** Computes area coordinates (12)-(16) with the triangles of S itself. With D1 = SAB, D2 = SBC, D3 = SCD, D4 = SDA the
 *  shape functions of A, B, C, D are D2 D3, D3 D4, D4 D1, D1 D2 over (D1 + D3)(D2 + D4). So xi = phi_B + phi_C - phi_A
 *  - phi_D = (D4 - D2)/(D4 + D2) and eta = (D1 - D3)/(D1 + D3). */
RIVAL_FN void rival_area(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    FOOTPOINT_REAL a[3], b[3], c[3], d[3];
    for (int i = 0; i < 3; i++) {
        a[i] = xA[i] - xS[i];
        b[i] = xB[i] - xS[i];
        c[i] = xC[i] - xS[i];
        d[i] = xD[i] - xS[i];
    }
    const FOOTPOINT_REAL d1 = rival_triangle(a, b), d2 = rival_triangle(b, c), d3 = rival_triangle(c, d),
                         d4 = rival_triangle(d, a);
    *xi = (d4 - d2) / (d4 + d2);
    *eta = (d1 - d3) / (d1 + d3);
}

/** Computes area ratios about the centroid, as in explicit crash codes. With the areas a_BC, a_DA, ... of the triangles
 *  of the edges and the centroid, and b_BC, b_DA, ... of the edges and S, all projected along the normal AC x BD, xi =
 *  (a_BC b_DA - b_BC a_DA)/(a_BC b_DA + b_BC a_DA), and likewise eta with AB, CD: 0 at the centroid, -1 and 1 on the
 *  edges. Lagrange's identity yields the areas from the products of AC and BD with the nodes about the centroid. */
RIVAL_FN void rival_centroid(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    FOOTPOINT_REAL ac[3], bd[3], a[3], s[3]; /* a: four times A, s: four times S, about the centroid */
    for (int i = 0; i < 3; i++) {
        ac[i] = xC[i] - xA[i];
        bd[i] = xD[i] - xB[i];
        const FOOTPOINT_REAL ab = xB[i] - xA[i], as = xS[i] - xA[i], as2 = as + as;
        const FOOTPOINT_REAL to_centroid = (ab + ab) + (ac[i] + bd[i]);
        a[i] = -to_centroid;
        s[i] = (as2 + as2) - to_centroid;
    }
    const FOOTPOINT_REAL cc = rival_dot(ac, ac), cd = rival_dot(ac, bd), dd = rival_dot(bd, bd);
    const FOOTPOINT_REAL cc2 = cc + cc, cd2 = cd + cd, dd2 = dd + dd;
    /* products p with AC, q with BD; C = A + AC, D = B + BD, A + B + C + D = 0 */
    const FOOTPOINT_REAL pa = rival_dot(ac, a), qa = rival_dot(bd, a), ps = rival_dot(ac, s), qs = rival_dot(bd, s);
    const FOOTPOINT_REAL pc = pa + (cc2 + cc2), qc = qa + (cd2 + cd2);
    const FOOTPOINT_REAL pb = -pa - (cc2 + cd2), qb = -qa - (cd2 + dd2);
    const FOOTPOINT_REAL pd = pb + (cd2 + cd2), qd = qb + (dd2 + dd2);
    const FOOTPOINT_REAL a_ab = pa * qb - pb * qa, a_bc = pb * qc - pc * qb, a_cd = pc * qd - pd * qc,
                         a_da = pd * qa - pa * qd;
    /* b_XY = a_XY - (p_S (q_Y - q_X) - (p_Y - p_X) q_S) */
    const FOOTPOINT_REAL b_ab = a_ab - (ps * (qb - qa) - (pb - pa) * qs),
                         b_bc = a_bc - (ps * (qc - qb) - (pc - pb) * qs),
                         b_cd = a_cd - (ps * (qd - qc) - (pd - pc) * qs),
                         b_da = a_da - (ps * (qa - qd) - (pa - pd) * qs);
    const FOOTPOINT_REAL left = a_bc * b_da, right = b_bc * a_da, below = a_cd * b_ab, above = b_cd * a_ab;
    *xi = (left - right) / (left + right);
    *eta = (below - above) / (below + above);
}

/** Computes the exact answer for a plane segment. With d = p e1 + q e2 and c3 = a e1 + b e2 in its plane, u = p - a u v
 *  and v = q - b u v lead to b u^2 + (1 - k) u - p = 0, k = b p - a q. A warped segment is projected onto the plane of
 *  its mid-lines; a negative discriminant counts as 0. */
RIVAL_FN void rival_plane(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    const FOOTPOINT_REAL one = 1.0, none = 0.0;
    struct rival_basis e;
    rival_basis_centre(xA, xB, xC, xD, xS, &e);
    const FOOTPOINT_REAL g11 = rival_dot(e.e1, e.e1), g12 = rival_dot(e.e1, e.e2), g22 = rival_dot(e.e2, e.e2);
    const FOOTPOINT_REAL g13 = rival_dot(e.e1, e.c3), g23 = rival_dot(e.e2, e.c3);
    const FOOTPOINT_REAL g1 = rival_dot(e.e1, e.d), g2 = rival_dot(e.e2, e.d);
    const FOOTPOINT_REAL inverse = one / (g11 * g22 - g12 * g12);
    const FOOTPOINT_REAL p = (g22 * g1 - g12 * g2) * inverse, q = (g11 * g2 - g12 * g1) * inverse;
    const FOOTPOINT_REAL a = (g22 * g13 - g12 * g23) * inverse, b = (g11 * g23 - g12 * g13) * inverse;
    const FOOTPOINT_REAL bp = b * p, linear = one - (bp - a * q), bp2 = bp + bp;
    const FOOTPOINT_REAL square = linear * linear + (bp2 + bp2);
    const FOOTPOINT_REAL u = (p + p) / (linear + sqrt(square < none ? none : square));
    *xi = u;
    *eta = q / (one + b * u);
}

/** The methods as a table, in the order of the lists in rivals.h and above. */
typedef void rival_search(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta);
struct rival {
    const char *name;
    rival_search *search;
};
extern const struct rival rivals[];
extern const int rival_count;

#endif
