/* Measures distances from the truth; see verdict.h. */
#include "verdict.h"

#include <math.h>

double verdict_root(wide x)
{
    return sqrt((double)x);
}

double verdict_tie(const struct truth *t)
{
    return 1e-13 * (1 + t->surface.distance);
}

/* Judges a foot point: near a stationary point, which must be the closest point of the segment if a closest point is inside. */
double verdict_free(const struct truth *t, const double loc[2], double worst)
{
    wide z[2];
    if (!truth_stationary(&t->surface, loc, z))
        return INFINITY;
    const double error = fmax(fabs((double)(z[0] - loc[0])), fabs((double)(z[1] - loc[1])));
    const int inside = z[0] * z[0] <= 1 && z[1] * z[1] <= 1;
    if (inside && verdict_root(truth_square(&t->surface, z)) > verdict_root(t->point[0].square) + verdict_tie(t))
        return INFINITY;
    if (!inside && !t->point[0].on_edge && truth_between(&t->surface, z, t->point[0].z) > worst)
        return INFINITY;
    return error;
}

static wide dot(const wide a[3], const wide b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double verdict_minimum(const struct truth *t, const double loc[2])
{
    const struct truth_surface *const f = &t->surface;
    wide z[2], a[3], b[3], d[3];
    if (!truth_stationary(f, loc, z))
        return INFINITY;
    truth_offset(f, z, d);
    for (int k = 0; k < 3; k++) {
        a[k] = f->c1[k] + z[1] * f->c3[k];
        b[k] = f->c2[k] + z[0] * f->c3[k];
    }
    const wide mixed = dot(a, b) - dot(f->c3, d);
    if (!(dot(a, a) * dot(b, b) > mixed * mixed))
        return INFINITY;
    const double size = fmax(1, fmax(fabs((double)z[0]), fabs((double)z[1])));
    return fmax(fabs((double)(z[0] - loc[0])), fabs((double)(z[1] - loc[1]))) / size;
}
