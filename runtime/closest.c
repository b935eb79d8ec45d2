/* Closest point of a bilinear segment by descent within -1 <= xi, eta <= 1, from its centre and its corners; see
 * closest.h.  A step is Newton's for the coordinates that no bound holds; where that does not come closer, (7) and (8)
 * are solved in turn, each of which is linear in its own coordinate, so that the distance never grows. */
#include "closest.h"
#include "vector.h"

#include <float.h>

enum { MOST_STEPS = 60 };

/* xS - r = d0 - c1 xi - c2 eta - c3 xi eta */
struct surface {
    double c1[3], c2[3], c3[3], d0[3];
};

/* r_xi, r_eta and xS - r at a point. */
struct place {
    double a[3], b[3], d[3];
};

static void place_at(const struct surface *f, const double at[2], struct place *p)
{
    for (int i = 0; i < 3; i++) {
        p->a[i] = f->c1[i] + f->c3[i] * at[1];
        p->b[i] = f->c2[i] + f->c3[i] * at[0];
        p->d[i] = f->d0[i] - f->c1[i] * at[0] - p->b[i] * at[1];
    }
}

static double square_distance(const struct surface *f, const double at[2])
{
    struct place p;
    place_at(f, at, &p);
    return vector_dot(p.d, p.d);
}

static double clamp(double x)
{
    return x > 1.0 ? 1.0 : x > -1.0 ? x : -1.0;
}

/* Solution of one of (7), (8) for its coordinate. */
static double solve(const double tangent[3], const double d[3], double x)
{
    const double square = vector_dot(tangent, tangent);
    return square > 0.0 ? clamp(x + vector_dot(tangent, d) / square) : x;
}

/* Whether a bound holds a coordinate at x whose distance falls along `slope`. */
static int held(double x, double slope)
{
    return (x >= 1.0 && slope > 0.0) || (x <= -1.0 && slope < 0.0);
}

static void newton(const struct surface *f, const double at[2], double to[2])
{
    struct place p;
    place_at(f, at, &p);
    const double aa = vector_dot(p.a, p.a), bb = vector_dot(p.b, p.b);
    const double ad = vector_dot(p.a, p.d), bd = vector_dot(p.b, p.d);
    const double ab = vector_dot(p.a, p.b) - vector_dot(f->c3, p.d), determinant = aa * bb - ab * ab;
    const int held_xi = held(at[0], ad), held_eta = held(at[1], bd);
    to[0] = at[0];
    to[1] = at[1];
    if (held_xi || held_eta) {
        if (!held_xi)
            to[0] = solve(p.a, p.d, at[0]);
        if (!held_eta)
            to[1] = solve(p.b, p.d, at[1]);
    } else if (determinant > DBL_EPSILON * aa * bb) {
        to[0] = clamp(at[0] + (bb * ad - ab * bd) / determinant);
        to[1] = clamp(at[1] + (aa * bd - ab * ad) / determinant);
    }
}

static void in_turn(const struct surface *f, const double at[2], double to[2])
{
    struct place p;
    place_at(f, at, &p);
    to[0] = solve(p.a, p.d, at[0]);
    to[1] = at[1];
    place_at(f, to, &p);
    to[1] = solve(p.b, p.d, at[1]);
}

/* Least square of the distance on the way down from `at`, which ends at the lowest point. */
static double descend(const struct surface *f, double at[2])
{
    double least = square_distance(f, at);
    for (int n = 0; n < MOST_STEPS; n++) {
        double to[2];
        newton(f, at, to);
        double square = square_distance(f, to);
        if (!(square < least)) {
            in_turn(f, at, to);
            square = square_distance(f, to);
        }
        if (!(square < least))
            break;
        least = square;
        at[0] = to[0];
        at[1] = to[1];
    }
    return least;
}

double footpoint_closest(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double at[2])
{
    static const double starts[5][2] = {{0.0, 0.0}, {-1.0, -1.0}, {1.0, -1.0}, {1.0, 1.0}, {-1.0, 1.0}};
    struct surface f;
    double least = 0.0;
    for (int i = 0; i < 3; i++) {
        const double ab = xB[i] - xA[i], dc = xC[i] - xD[i], ad = xD[i] - xA[i], bc = xC[i] - xB[i];
        f.c1[i] = 0.25 * (ab + dc);
        f.c2[i] = 0.25 * (ad + bc);
        f.c3[i] = 0.25 * (dc - ab);
        f.d0[i] = (xS[i] - xA[i]) - (f.c1[i] + f.c2[i] - f.c3[i]);
    }
    for (int k = 0; k < 5; k++) {
        double x[2] = {starts[k][0], starts[k][1]};
        const double square = descend(&f, x);
        if (k > 0 && !(square < least))
            continue;
        least = square;
        at[0] = x[0];
        at[1] = x[1];
    }
    return sqrt(least);
}
