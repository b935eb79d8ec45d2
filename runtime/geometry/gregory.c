/* Gregory patches; see footpoint-gregory-geometry.h.
 *
 * Inner points. Let c_0, c_1, c_2 be the differences of an edge's four control points, and a_0 ... a_3 the differences
 * from them to the next row, of which a_0 and a_3 are given. With g_0 = n_0 x c_0 and g_3 = n_3 x c_2, the edge's
 * tangents rotated about the normals of its ends, the derivative across the edge is set to (g(t) k(t) + h(t) c(t))/3
 * with g, k and h linear and c the edge's own derivative. So the plane of g and c depends only on the edge. In
 * Bernstein form
 *
 *     3 a_1 = (k_0 + k_1) g_0 + k_0 g_3 + 2 h_0 c_1 + h_1 c_0
 *     3 a_2 = k_1 g_0 + (k_0 + k_1) g_3 + h_0 c_2 + 2 h_1 c_1,    a_0 = k_0 g_0 + h_0 c_0,  a_3 = k_1 g_3 + h_1 c_2.
 *
 * Evaluation. (47) is P_110 + w (P_111 - P_110), w = v/(u + v), so the patch is the Bezier patch of the net plus, at
 * each corner, q e with e = P_111 - P_110 and q = 9 (1-u)^2 (1-v)^2 f, f = u v^2/(u + v). With z = u/(u + v) = 1 - w, f
 * = u v w,  f_u = v w^2,  f_v = u w (1 + z),  f_uu = -2 w^3,  f_uv = w^2 (1 + 2 z),  f_vv = 2 z^3: only w needs a
 * division. */
#include "footpoint-gregory-geometry.h"

#include "vector.h"

/* One edge: net points p0 ... p3 along it, q0 and q3 of the next row at its ends, and the normals n0 and n3 there.
 * Determines q1 and q2 of the next row. */
struct edge {
    const double *p0, *p1, *p2, *p3, *q0, *q3, *n0, *n3;
    double *q1, *q2;
};

/* Resolves a = k g + h c, for g = n x c. */
static void resolve(const double a[3], const double g[3], const double c[3], double *k, double *h)
{
    const double square = vector_dot(c, c);
    *k = vector_dot(a, g) / square;
    *h = vector_dot(a, c) / square;
}

static void smooth(const struct edge *e)
{
    double c0[3], c1[3], c2[3], a0[3], a3[3], g0[3], g3[3], k0, k1, h0, h1;
    vector_sub(e->p1, e->p0, c0);
    vector_sub(e->p2, e->p1, c1);
    vector_sub(e->p3, e->p2, c2);
    vector_sub(e->q0, e->p0, a0);
    vector_sub(e->q3, e->p3, a3);
    vector_cross(e->n0, c0, g0);
    vector_cross(e->n3, c2, g3);
    resolve(a0, g0, c0, &k0, &h0);
    resolve(a3, g3, c2, &k1, &h1);
    for (int i = 0; i < 3; i++) {
        const double a1 = (k0 + k1) * g0[i] + k0 * g3[i] + 2.0 * h0 * c1[i] + h1 * c0[i];
        const double a2 = k1 * g0[i] + (k0 + k1) * g3[i] + h0 * c2[i] + 2.0 * h1 * c1[i];
        e->q1[i] = e->p1[i] + a1 / 3.0;
        e->q2[i] = e->p2[i] + a2 / 3.0;
    }
}

int footpoint_gregory_points(const double x[4][3], const double n[4][3], struct footpoint_gregory *patch)
{
    struct footpoint_gregory made;
    const int status = footpoint_bezier_points(x, n, &made.net);
    if (status != FOOTPOINT_OK)
        return status;
    double(*p)[4][3] = made.net.p;
    const struct edge edges[4] = {
        {p[0][0], p[1][0], p[2][0], p[3][0], p[0][1], p[3][1], n[0], n[1], p[1][1], p[2][1]},
        {p[0][3], p[1][3], p[2][3], p[3][3], p[0][2], p[3][2], n[3], n[2], p[1][2], p[2][2]},
        {p[0][0], p[0][1], p[0][2], p[0][3], p[1][0], p[1][3], n[0], n[3], made.twin[0][0], made.twin[0][1]},
        {p[3][0], p[3][1], p[3][2], p[3][3], p[2][0], p[2][3], n[1], n[2], made.twin[1][0], made.twin[1][1]},
    };
    for (int i = 0; i < 4; i++) {
        smooth(&edges[i]);
        if (!vector_finite(edges[i].q1) || !vector_finite(edges[i].q2))
            return FOOTPOINT_ERR_DEGENERATE;
    }
    *patch = made;
    return FOOTPOINT_OK;
}

/* Computes q and its derivatives by u and v: 0, u, v, uu, uv, vv. */
static void blend(double u, double v, double q[6])
{
    const double s = 1.0 - u, t = 1.0 - v, above_u = u > 0.0 ? u : 0.0, above_v = v > 0.0 ? v : 0.0;
    const double sum = above_u + above_v, w = sum > 0.0 ? above_v / sum : 0.5, z = 1.0 - w;
    const int fixed = u < 0.0 || v < 0.0; /* w is constant here */
    const double f = u * v * w, f_u = fixed ? v * w : v * w * w, f_v = fixed ? u * w : u * w * (1.0 + z);
    const double f_uu = fixed ? 0.0 : -2.0 * w * w * w, f_vv = fixed ? 0.0 : 2.0 * z * z * z;
    const double f_uv = fixed ? w : w * w * (1.0 + 2.0 * z);
    const double ss = s * s, tt = t * t, c = 9.0 * ss * tt, c_u = -18.0 * s * tt, c_v = -18.0 * ss * t;
    q[0] = c * f;
    q[1] = c_u * f + c * f_u;
    q[2] = c_v * f + c * f_v;
    q[3] = 18.0 * tt * f + 2.0 * c_u * f_u + c * f_uu;
    q[4] = 36.0 * s * t * f + c_u * f_v + c_v * f_u + c * f_uv;
    q[5] = 18.0 * ss * f + 2.0 * c_v * f_v + c * f_vv;
}

void footpoint_gregory_jet(const struct footpoint_gregory *patch, double xi, double eta, struct footpoint_jet *jet)
{
    footpoint_bezier_jet(&patch->net, xi, eta, jet);
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++) {
            const double su = i == 0 ? 0.5 : -0.5, sv = j == 0 ? 0.5 : -0.5;
            double e[3], q[6];
            vector_sub(patch->twin[i][j], patch->net.p[i + 1][j + 1], e);
            blend(0.5 + su * xi, 0.5 + sv * eta, q);
            for (int k = 0; k < 3; k++) {
                jet->r[k] += q[0] * e[k];
                jet->r_xi[k] += su * q[1] * e[k];
                jet->r_eta[k] += sv * q[2] * e[k];
                jet->r_xixi[k] += 0.25 * q[3] * e[k];
                jet->r_xieta[k] += su * sv * q[4] * e[k];
                jet->r_etaeta[k] += 0.25 * q[5] * e[k];
            }
        }
}

void footpoint_gregory_position(const struct footpoint_gregory *patch, double xi, double eta, double r[3])
{
    struct footpoint_jet jet;
    footpoint_gregory_jet(patch, xi, eta, &jet);
    for (int k = 0; k < 3; k++)
        r[k] = patch->net.origin[k] + jet.r[k];
}

int footpoint_gregory_normal(const struct footpoint_gregory *patch, double xi, double eta, double n[3])
{
    struct footpoint_jet jet;
    footpoint_gregory_jet(patch, xi, eta, &jet);
    return footpoint_jet_normal(patch->net.origin, &jet, NULL, n, NULL);
}

int footpoint_gregory_gap(const struct footpoint_gregory *patch, const double xS[3], double xi, double eta, double *gap)
{
    struct footpoint_jet jet;
    double n[3];
    footpoint_gregory_jet(patch, xi, eta, &jet);
    return footpoint_jet_normal(patch->net.origin, &jet, xS, n, gap);
}
