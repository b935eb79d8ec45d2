/* The closest point of straight edges and of a plane triangle, clamped; see attach.h. */
#include "attach.h"

#include <float.h>

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

/* The distance is a quadratic function: its least point in one move; on an edge, in a second what rounding has left. */
void footpoint_attach_tri3(const double x[3][3], const double xs[3], double loc[2])
{
    double e1[3], e2[3], d[3], move[2];
    vector_sub(x[1], x[0], e1);
    vector_sub(x[2], x[0], e2);
    struct model m = {{0.0, 0.0}, vector_dot(e1, e1), vector_dot(e1, e2), vector_dot(e2, e2)};
    if (!(m.h00 * m.h11 - m.h01 * m.h01 > 16.0 * DBL_EPSILON * m.h00 * m.h11)) { /* no area */
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
