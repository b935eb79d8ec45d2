/* The closest point of straight edges and of a plane triangle, clamped; see attach.h. */
#include "../certain/twofold.h"
#include "attach.h"

#include <float.h>

/* Squared sine of the angle below which a triangle is a needle. */
#define NEEDLE 1e-4

enum { REFINEMENTS = 4 };

double footpoint_attach_edges(int n, const double x[][3], const double corner[][2], const double xs[3], double loc[2])
{
    double best = HUGE_VAL;
    for (int i = 0; i < n; i++) {
        const int next = i + 1 < n ? i + 1 : 0;
        double edge[3], d[3];
        vector_sub(x[next], x[i], edge);
        vector_sub(xs, x[i], d);
        const double length2 = vector_dot(edge, edge);
        const double along = length2 > 0.0 ? clamp(vector_dot(d, edge) / length2, 0.0, 1.0) : 0.0;
        for (int k = 0; k < 3; k++)
            d[k] -= along * edge[k];
        const double square_distance = vector_dot(d, d);
        if (square_distance < best) {
            best = square_distance;
            for (int k = 0; k < 2; k++)
                loc[k] = corner[i][k] + along * (corner[next][k] - corner[i][k]);
        }
    }
    return best;
}

/* Finds the foot point on a triangle of nearly no area with twice the digits, and corrects it in further steps. Returns
 * 0 if it lies outside or does not exist. */
static int find_widely(const double x[3][3], const double xs[3], double loc[2])
{
    struct twofold a[3], b[3], d[3], u = {0.0, 0.0}, v = {0.0, 0.0};
    for (int i = 0; i < 3; i++) {
        a[i] = twofold_sum(x[1][i], -x[0][i]);
        b[i] = twofold_sum(x[2][i], -x[0][i]);
        d[i] = twofold_sum(xs[i], -x[0][i]);
    }
    const struct twofold aa = twofold_dot(a, a), ab = twofold_dot(a, b), bb = twofold_dot(b, b);
    const struct twofold area = twofold_subtract(twofold_multiply(aa, bb), twofold_multiply(ab, ab));
    if (!(area.high > 0x1p-90 * aa.high * bb.high))
        return 0;
    for (int n = 0; n < REFINEMENTS; n++) {
        const struct twofold ad = twofold_dot(a, d), bd = twofold_dot(b, d);
        const struct twofold up =
            twofold_divide(twofold_subtract(twofold_multiply(bb, ad), twofold_multiply(ab, bd)), area);
        const struct twofold vp =
            twofold_divide(twofold_subtract(twofold_multiply(aa, bd), twofold_multiply(ab, ad)), area);
        u = twofold_add(u, up);
        v = twofold_add(v, vp);
        for (int i = 0; i < 3; i++)
            d[i] = twofold_subtract(d[i], twofold_add(twofold_multiply(up, a[i]), twofold_multiply(vp, b[i])));
    }
    if (!(u.high >= 0.0 && v.high >= 0.0 && u.high + v.high <= 1.0))
        return 0;
    loc[0] = u.high;
    loc[1] = v.high;
    return 1;
}

/* The distance is a quadratic function, so one move leads to its minimum; on an edge, a second move removes the
 * rounding error. */
void footpoint_attach_tri3(const double x[3][3], const double xs[3], double loc[2])
{
    double e1[3], e2[3], d[3], move[2];
    vector_sub(x[1], x[0], e1);
    vector_sub(x[2], x[0], e2);
    struct model m = {{0.0, 0.0}, vector_dot(e1, e1), vector_dot(e1, e2), vector_dot(e2, e2)};
    if (!(m.h00 * m.h11 - m.h01 * m.h01 > NEEDLE * m.h00 * m.h11)) {
        if (!find_widely(x, xs, loc))
            footpoint_attach_edges(3, x, triangle, xs, loc);
        return;
    }
    loc[0] = loc[1] = 0.0;
    for (int n = 0; n < 2; n++) {
        for (int i = 0; i < 3; i++)
            d[i] = (xs[i] - x[0][i]) - loc[0] * e1[i] - loc[1] * e2[i];
        m.g[0] = -vector_dot(e1, d);
        m.g[1] = -vector_dot(e2, d);
        least_in_triangle(&m, loc, move);
        loc[0] = clamp(loc[0] + move[0], 0.0, 1.0);
        loc[1] = clamp(loc[1] + move[1], 0.0, 1.0 - loc[0]);
        if (loc[0] > 0.0 && loc[1] > 0.0 && loc[0] + loc[1] < 1.0)
            return;
    }
}
