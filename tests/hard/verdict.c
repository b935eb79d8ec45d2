/* Distances from the truth; see verdict.h. */
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

/* A foot point: near a stationary point, which is the closest one of the segment if any is inside. */
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
