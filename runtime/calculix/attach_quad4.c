/* The closest point of a bilinear segment r = c0 + c1 xi + c2 eta + c3 xi eta, clamped to it, with certainty.
 *
 * Half the squared distance f has the Hessian [a(eta) m; m b(xi)], a = |r_xi|^2, b = |r_eta|^2 and m = r_xi . r_eta -
 * c3 . (xS - r). m is bilinear in (xi, eta), so its bounds over the segment are its values at corners. If a b > m^2
 * holds for these bounds, f is convex, and a point from which no direction descends is the closest. Newton's method
 * finds it, starting from the value of an expression. Otherwise footpoint_robust finds it. */
#include "../../generated/footpoint_quad4.h"
#include "../footpoint.h"
#include "attach.h"

enum { MAX_STEPS = 8 };

/* Newton's method ends when its next step would be below this. */
#define NEXT_STEP 1e-10

/* The data of the distance: vectors and their scalar products. */
struct segment {
    double c1[3], c2[3], c3[3], q[3];
    double c11, c12, c13, c22, c23, c33, q1, q2, q3;
};

static void set_segment(struct segment *f, const double x[4][3], const double xs[3])
{
    for (int i = 0; i < 3; i++) {
        const double ab = x[1][i] - x[0][i], dc = x[2][i] - x[3][i], ad = x[3][i] - x[0][i], bc = x[2][i] - x[1][i];
        f->c1[i] = 0.25 * (ab + dc);
        f->c2[i] = 0.25 * (ad + bc);
        f->c3[i] = 0.25 * (dc - ab);
        f->q[i] = (xs[i] - x[0][i]) - (f->c1[i] + f->c2[i] - f->c3[i]);
    }
    f->c11 = vector_dot(f->c1, f->c1);
    f->c12 = vector_dot(f->c1, f->c2);
    f->c13 = vector_dot(f->c1, f->c3);
    f->c22 = vector_dot(f->c2, f->c2);
    f->c23 = vector_dot(f->c2, f->c3);
    f->c33 = vector_dot(f->c3, f->c3);
    f->q1 = vector_dot(f->q, f->c1);
    f->q2 = vector_dot(f->q, f->c2);
    f->q3 = vector_dot(f->q, f->c3);
}

/* Returns a lower bound of c + 2 b t + a t^2 for t in [-1,1]. */
static double below(double c, double b, double a)
{
    return fabs(b) < a ? c - fabs(b) : c - 2.0 * fabs(b) + a;
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* Returns the largest |m| over the segment, attained at a corner. */
static double most_mixed(const struct segment *f)
{
    const double m = f->c12 - f->q3, sum = 2.0 * (f->c13 + f->c23), difference = 2.0 * (f->c13 - f->c23);
    const double even = fabs(m + 2.0 * f->c33) + fabs(sum), odd = fabs(m - 2.0 * f->c33) + fabs(difference);
    return larger(even, odd);
}

/* Returns true if f is proved convex over the whole segment. */
static int convex(const struct segment *f)
{
    const double a = below(f->c11, f->c13, f->c33), b = below(f->c22, f->c23, f->c33), m = most_mixed(f);
    return a > 0.0 && b > 0.0 && a * b > (1.0 + 1e-6) * m * m;
}

static struct model model_of(const struct segment *f, double u, double v)
{
    struct model m;
    m.h00 = f->c11 + v * (2.0 * f->c13 + v * f->c33);
    m.h11 = f->c22 + u * (2.0 * f->c23 + u * f->c33);
    m.h01 = f->c12 - f->q3 + 2.0 * (u * f->c13 + v * (f->c23 + u * f->c33));
    m.g[0] = u * m.h00 - (f->q1 + v * (f->q3 - f->c12 - v * f->c23));
    m.g[1] = v * m.h11 - (f->q2 + u * (f->q3 - f->c12 - u * f->c13));
    return m;
}

/* Iterates Newton's method within the segment. Returns 1 when it has settled: the next step would be at most the third
 * and fourth derivatives of f times the square of the last step, through the inverse of the Hessian. */
static int settle(const struct segment *f, double loc[2])
{
    const double bend = 2.0 * (fabs(f->c13) + fabs(f->c23)) + 8.0 * f->c33;
    for (int n = 0; n < MAX_STEPS; n++) {
        const struct model m = model_of(f, loc[0], loc[1]);
        const double det = m.h00 * m.h11 - m.h01 * m.h01;
        double move[2];
        if (!(det > 0.0))
            return 0;
        least_in_square(&m, loc, move);
        loc[0] = clamp(loc[0] + move[0], -1.0, 1.0);
        loc[1] = clamp(loc[1] + move[1], -1.0, 1.0);
        if (bend * (move[0] * move[0] + move[1] * move[1]) * (m.h00 + m.h11) <= NEXT_STEP * det)
            return 1;
    }
    return 0;
}

void footpoint_attach_quad4(const double x[4][3], const double xs[3], double loc[2])
{
    struct segment f;
    set_segment(&f, x, xs);
    if (convex(&f)) {
        footpoint_quad4_coarse_at(x[0], x[1], x[2], x[3], xs, &loc[0], &loc[1]);
        if (!(fabs(loc[0]) + fabs(loc[1]) < HUGE_VAL))
            loc[0] = loc[1] = 0.0;
        loc[0] = clamp(loc[0], -1.0, 1.0);
        loc[1] = clamp(loc[1], -1.0, 1.0);
        if (settle(&f, loc))
            return;
    }
    double dist;
    if (footpoint_robust(x[0], x[1], x[2], x[3], xs, loc, &dist) == FOOTPOINT_ERR_DOMAIN)
        footpoint_attach_edges(4, x, square, xs, loc); /* for a distant slave node, any point is equally close */
}
