/* Newton's steps in quadruple precision; see judged_faces.h. */
#include "judged_faces.h"

#include <math.h>

enum { STEPS = 60 };

/* Takes Newton's steps from z until they converge; returns true if they end at a minimum. */
static bool minimum_near(const struct curved_case *f, wide z[2])
{
    for (int k = 0; k < STEPS; k++) {
        wide g[2], H[3];
        curved_slopes(f, z, g, H);
        const wide det = H[0] * H[2] - H[1] * H[1];
        const wide s = (H[2] * g[0] - H[1] * g[1]) / det, t = (H[0] * g[1] - H[1] * g[0]) / det;
        if (!(size_of(s) + size_of(t) < 1e3)) /* NaN, too */
            return false;
        z[0] += s;
        z[1] += t;
        if (size_of(s) + size_of(t) < 1e-17 * (1 + size_of(z[0]) + size_of(z[1]))) /* the next is its square */
            return det > 0 && H[0] > 0;
    }
    return false;
}

static bool is_within(const wide z[2], const double loc[2], double promise)
{
    const double most = promise * fmax(1, fmax(fabs(loc[0]), fabs(loc[1])));
    return size_of(z[0] - loc[0]) <= most && size_of(z[1] - loc[1]) <= most;
}

bool judged_holds(const struct curved_case *f, const double loc[2], double promise, wide known[2], bool *is_known)
{
    if (*is_known && is_within(known, loc, promise))
        return true;
    for (int i = 0; i < 25; i++) {
        const int along = (i + 2) % 5 - 2, across = (i / 5 + 2) % 5 - 2;
        wide z[2] = {loc[0] + promise * along / 2, loc[1] + promise * across / 2};
        if (minimum_near(f, z) && is_within(z, loc, promise)) {
            known[0] = z[0];
            known[1] = z[1];
            *is_known = true;
            return true;
        }
    }
    return false;
}

struct curved_case judged_unit(const struct curved_case *f)
{
    struct curved_case g = *f;
    int exponent;
    double most = 0;
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            most = fmax(most, fabs(f->x[k][i]));
    (void)frexp(most, &exponent);
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            g.x[k][i] = ldexp(ldexp(f->x[k][i], -exponent / 2), exponent / 2 - exponent);
    return g;
}
