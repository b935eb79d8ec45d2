/* Closest point of a face of an FE mesh. The face is a closed piece of surface: edges and corners count. For the files
 * of this folder; other code uses attach_2d.c.
 *
 * Nodes are numbered as in CalculiX and Abaqus: corners counter-clockwise, then midside nodes, the first between
 * corners 1 and 2. Local coordinates: xi, eta in [-1,1] with corners at (-1,-1), (1,-1), (1,1), (-1,1) for
 * quadrilaterals; xi, eta >= 0, xi + eta <= 1 with corners at (0,0), (1,0), (0,1) for triangles. Coordinates must be
 * finite and share a unit of length in which faces are from 1e-30 to 1e30 long: there no product leaves its range. */
#ifndef FOOTPOINT_ATTACH_H
#define FOOTPOINT_ATTACH_H

#include "../certain/ieee.h"
#include "../geometry/vector.h"

/* Hidden from callers of the library. */
#ifdef __GNUC__
#pragma GCC visibility push(hidden)
#endif

/** Finds the closest point of the straight edges of a polygon with n corners x.
 *  @param[in]  corner  their local coordinates
 *  @return its squared distance */
double footpoint_attach_edges(int n, const double x[][3], const double corner[][2], const double xs[3], double loc[2]);

/** Finds the closest point of a plane triangle, to rounding. */
void footpoint_attach_tri3(const double x[3][3], const double xs[3], double loc[2]);

/** Finds the closest point of a bilinear segment: if the distance is convex over the segment, by the expressions of
 *  generated/footpoint_quad4.h and Newton's method; otherwise as the minimum over all stationary points and edges. */
void footpoint_attach_quad4(const double x[4][3], const double xs[3], double loc[2]);

/** Finds the closest point of a quadratic triangle or serendipity quadrilateral: no other point is nearer by more than
 *  1e-10 of the largest difference of coordinates. */
void footpoint_attach_tri6(const double x[6][3], const double xs[3], double loc[2]);
void footpoint_attach_quad8(const double x[8][3], const double xs[3], double loc[2]);

#ifdef __GNUC__
#pragma GCC visibility pop
#endif

/* m(p) = g . p + p . H p / 2, the change of half the squared distance by a move p in (xi, eta). */
struct model {
    double g[2], h00, h01, h11;
};

static inline double model_at(const struct model *m, double p, double q)
{
    return m->g[0] * p + m->g[1] * q + 0.5 * (m->h00 * p * p + 2.0 * m->h01 * p * q + m->h11 * q * q);
}

static inline double clamp(double value, double low, double high)
{
    return value < low ? low : value > high ? high : value;
}

/* Corners of the domains of (xi, eta). */
static const double square[4][2] = {{-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
static const double triangle[3][2] = {{0.0, 0.0}, {1.0, 0.0}, {0.0, 1.0}};

/* Computes the minimum of the model in the whole plane; H must be positive definite. */
static inline void free_move(const struct model *m, double move[2])
{
    const double scale = 1.0 / (m->h00 * m->h11 - m->h01 * m->h01);
    move[0] = scale * (m->h01 * m->g[1] - m->h11 * m->g[0]);
    move[1] = scale * (m->h01 * m->g[0] - m->h00 * m->g[1]);
}

/* Computes the move from `at` to the minimum of the model in the square (triangle). If the free minimum lies outside,
 * the minimum is on an edge that has it beyond; from any other edge, the line to the free minimum starts inside and
 * descends. */
static inline void least_in_square(const struct model *m, const double at[2], double move[2])
{
    free_move(m, move);
    const double u = at[0] + move[0], v = at[1] + move[1];
    if (fabs(u) <= 1.0 && fabs(v) <= 1.0)
        return;
    const double p = copysign(1.0, u) - at[0], q = copysign(1.0, v) - at[1];
    const double beside_p = clamp(-(m->g[1] + m->h01 * p) / m->h11, -1.0 - at[1], 1.0 - at[1]);
    const double beside_q = clamp(-(m->g[0] + m->h01 * q) / m->h00, -1.0 - at[0], 1.0 - at[0]);
    const int on_v = fabs(u) <= 1.0 || (fabs(v) > 1.0 && model_at(m, beside_q, q) < model_at(m, p, beside_p));
    move[0] = on_v ? beside_q : p;
    move[1] = on_v ? q : beside_p;
}

static inline void least_in_triangle(const struct model *m, const double at[2], double move[2])
{
    double best = HUGE_VAL, free[2];
    free_move(m, free);
    const double u = at[0] + free[0], v = at[1] + free[1];
    const int beyond[3] = {v<0.0, u + v> 1.0, u < 0.0};
    move[0] = free[0];
    move[1] = free[1];
    for (int i = 0; i < 3; i++) {
        if (!beyond[i])
            continue;
        const double *const c = triangle[i], *const next = triangle[i < 2 ? i + 1 : 0];
        const double a = c[0] - at[0], b = c[1] - at[1], s = next[0] - c[0], t = next[1] - c[1];
        const double slope = s * (m->g[0] + m->h00 * a + m->h01 * b) + t * (m->g[1] + m->h01 * a + m->h11 * b);
        const double along = clamp(-slope / (m->h00 * s * s + 2.0 * m->h01 * s * t + m->h11 * t * t), 0.0, 1.0);
        const double value = model_at(m, a + along * s, b + along * t);
        if (value < best) {
            best = value;
            move[0] = a + along * s;
            move[1] = b + along * t;
        }
    }
}

#endif
