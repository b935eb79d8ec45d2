/* Lines through faces; see along_judge.h. */
#include "along_judge.h"

#include <math.h>

double along_uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

void along_draw(uint64_t *stream, int nodes, double slim, double angle, along_vectors x)
{
    const struct exact_face f = exact_face_of(nodes);
    const int triangle = nodes == 3 || nodes == 6;
    const double u = along_uniform(stream), v = along_uniform(stream), t = along_uniform(stream) - 0.5,
                 turn = 6.28 * along_uniform(stream);
    const double xi = triangle ? u : 2.0 * u - 1.0, eta = triangle ? v * (1.0 - u) : 2.0 * v - 1.0;
    const double q[3] = {cos(angle) * cos(turn), cos(angle) * sin(turn), sin(angle)};
    quadruple y[MOST_ALONG], r[3], normal[3];
    for (int j = 0; j < nodes; j++)
        for (int i = 0; i < 3; i++) {
            x[j][i] = (i < 2 ? f.place[j][i] : 0.0) + 0.1 * (along_uniform(stream) - 0.5);
            x[j][i] *= i == 0 ? slim : 1.0;
            y[3 * j + i] = x[j][i];
        }
    exact_point(&f, y, xi, eta, r, normal);
    for (int i = 0; i < 3; i++) {
        x[nodes][i] = (double)r[i] + t * q[i];
        x[nodes + 1][i] = q[i] * exp(turn - 3.0);
    }
}

double along_length(const double direction[3])
{
    return fmin(1.0, hypot(hypot(direction[0], direction[1]), direction[2]));
}

static quadruple determinant(const quadruple a[3], const quadruple b[3], const quadruple c[3])
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

void along_tangents(const struct exact_face *f, const quadruple *y, quadruple xi, quadruple eta, quadruple a[3],
                    quadruple b[3])
{
    quadruple end[4][3], normal[3];
    exact_point(f, y, xi + 1, eta, end[0], normal);
    exact_point(f, y, xi - 1, eta, end[1], normal);
    exact_point(f, y, xi, eta + 1, end[2], normal);
    exact_point(f, y, xi, eta - 1, end[3], normal);
    for (int i = 0; i < 3; i++) {
        a[i] = (end[0][i] - end[1][i]) / 2;
        b[i] = (end[2][i] - end[3][i]) / 2;
    }
}

/* Takes a Newton step for {xi, eta, distance}. */
static void newton(const struct exact_face *f, const quadruple *y, const quadruple q[3], quadruple at[3])
{
    quadruple r[3], a[3], b[3], c[3], normal[3];
    exact_point(f, y, at[0], at[1], r, normal);
    along_tangents(f, y, at[0], at[1], a, b);
    for (int i = 0; i < 3; i++)
        c[i] = y[3 * f->nodes + i] - r[i] - at[2] * q[i];
    const quadruple det = determinant(a, b, q);
    at[0] += determinant(c, b, q) / det;
    at[1] += determinant(a, c, q) / det;
    at[2] += determinant(a, b, c) / det;
}

void along_solve(const struct exact_face *f, const quadruple *y, const double from[3], quadruple at[3])
{
    quadruple q[3];
    for (int i = 0; i < 3; i++) {
        q[i] = y[3 * f->nodes + 3 + i];
        at[i] = from[i];
    }
    exact_unit(q);
    for (int step = 0; step < 5; step++)
        newton(f, y, q, at);
}
