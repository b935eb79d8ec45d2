/* Bicubic Bezier patches; see footpoint-bezier-geometry.h. */
#include "footpoint-bezier-geometry.h"

#include "vector.h"

/* Computes h: a third of the edge from corner p to corner q, projected on the plane normal to n. */
static int handle(const double p[3], const double q[3], const double n[3], double h[3])
{
    double d[3];
    vector_sub(q, p, d);
    const double along = vector_dot(d, n);
    for (int k = 0; k < 3; k++)
        h[k] = (d[k] - along * n[k]) / 3.0;
    return number_normal(vector_dot(h, h)) ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE;
}

/* Net indices of the corners, and the corner at the other end of each corner's edge along xi. */
static const int place[4][2] = {{0, 0}, {3, 0}, {3, 3}, {0, 3}}, along_xi[4] = {1, 0, 3, 2};

/* Returns the index next to a corner's, inwards. */
static int inwards(int i)
{
    return i == 0 ? 1 : 2;
}

int footpoint_bezier_points(const double x[4][3], const double n[4][3], struct footpoint_bezier *patch)
{
    struct footpoint_bezier made;
    for (int c = 0; c < 4; c++)
        if (!vector_finite(x[c]) || !vector_finite(n[c]))
            return FOOTPOINT_ERR_NOT_FINITE;
    for (int c = 0; c < 4; c++) {
        const int i = place[c][0], j = place[c][1], m = inwards(i), l = inwards(j);
        double by_xi[3], by_eta[3];
        if (!(vector_dot(n[c], n[c]) > 0.0) || handle(x[c], x[along_xi[c]], n[c], by_xi) != FOOTPOINT_OK ||
            handle(x[c], x[3 - c], n[c], by_eta) != FOOTPOINT_OK)
            return FOOTPOINT_ERR_DEGENERATE;
        vector_sub(x[c], x[0], made.p[i][j]);
        for (int k = 0; k < 3; k++) {
            made.origin[k] = x[0][k];
            made.p[m][j][k] = made.p[i][j][k] + by_xi[k];
            made.p[i][l][k] = made.p[i][j][k] + by_eta[k];
            made.p[m][l][k] = made.p[m][j][k] + by_eta[k];
        }
    }
    *patch = made;
    return FOOTPOINT_OK;
}

/* Computes Bernstein polynomials (46) of degree 3 at t, with first and second derivatives. */
static void bernstein(double t, double b[3][4])
{
    const double s = 1.0 - t;
    b[0][0] = s * s * s;
    b[0][1] = 3.0 * s * s * t;
    b[0][2] = 3.0 * s * t * t;
    b[0][3] = t * t * t;
    b[1][0] = -3.0 * s * s;
    b[1][1] = 3.0 * s * (s - 2.0 * t);
    b[1][2] = 3.0 * t * (2.0 * s - t);
    b[1][3] = 3.0 * t * t;
    b[2][0] = 6.0 * s;
    b[2][1] = 6.0 * (t - 2.0 * s);
    b[2][2] = 6.0 * (s - 2.0 * t);
    b[2][3] = 6.0 * t;
}

/* Computes sum = scale times the sum of a_i b_j P_ij. */
static void combine(const struct footpoint_bezier *patch, const double a[4], const double b[4], double scale,
                    double sum[3])
{
    for (int k = 0; k < 3; k++) {
        double total = 0.0;
        for (int i = 0; i < 4; i++) {
            const double(*row)[3] = patch->p[i];
            total += a[i] * (b[0] * row[0][k] + b[1] * row[1][k] + b[2] * row[2][k] + b[3] * row[3][k]);
        }
        sum[k] = scale * total;
    }
}

void footpoint_bezier_jet(const struct footpoint_bezier *patch, double xi, double eta, struct footpoint_jet *jet)
{
    double a[3][4], b[3][4];
    bernstein(0.5 * (1.0 + xi), a);
    bernstein(0.5 * (1.0 + eta), b);
    combine(patch, a[0], b[0], 1.0, jet->r);
    combine(patch, a[1], b[0], 0.5, jet->r_xi);
    combine(patch, a[0], b[1], 0.5, jet->r_eta);
    combine(patch, a[2], b[0], 0.25, jet->r_xixi);
    combine(patch, a[1], b[1], 0.25, jet->r_xieta);
    combine(patch, a[0], b[2], 0.25, jet->r_etaeta);
}

int footpoint_jet_normal(const double origin[3], const struct footpoint_jet *jet, const double xS[3], double n[3],
                         double *gap)
{
    double d[3];
    const int status = vector_normal(jet->r_xi, jet->r_eta, n);
    if (status != FOOTPOINT_OK || !gap)
        return status;
    vector_sub(xS, origin, d);
    vector_sub(d, jet->r, d);
    *gap = vector_dot(d, n);
    return FOOTPOINT_OK;
}
