/* Chooses the segment around the nearest master node that a slave node hits, by (3) to (6).  With n = c1 x c2, all of c1 x r,
 * r x c2 and n are parallel, and the part of t along m drops out of n . (c1 x r) = n . (c1 x t).  So (3) and (4) are
 *     n . (c1 x t) > 0   and   n . (t x c2) > 0,
 * without a root or a division. */
#include "../footpoint.h"
#include "../geometry/vector.h"

#include <float.h>

enum { ORDINARY = 100 }; /* vectors from 2^-100 to 2^100 long keep products of six of them in range */

/* The place of a slave node relative to the angle between two edges. */
enum place { OUTSIDE, ON_EDGE, INSIDE };

/* Scales a vector of extreme length by a power of 2.  Places and signs below do not depend on lengths. */
static void bring_into_range(double a[3])
{
    const int exponent = vector_exponent(a);
    for (int i = 0; (exponent > ORDINARY || exponent < -ORDINARY) && i < 3; i++)
        a[i] = ldexp(a[i], -exponent);
}

/* Returns the sign of n . (a x b), 0 within rounding. */
static int side(const double n[3], const double a[3], const double b[3])
{
    double c[3];
    vector_cross(a, b, c);
    const double product = vector_dot(n, c);
    const double size = sqrt(vector_dot(n, n)) * sqrt(vector_dot(a, a) * vector_dot(b, b));
    if (fabs(product) <= 16.0 * DBL_EPSILON * size)
        return 0;
    return product > 0.0 ? 1 : -1;
}

static enum place place_of(double c1[3], double c2[3], double t[3])
{
    double n[3];
    bring_into_range(c1);
    bring_into_range(c2);
    bring_into_range(t);
    vector_cross(c1, c2, n);
    if (!(vector_dot(n, n) > VECTOR_PARALLEL * (vector_dot(c1, c1) * vector_dot(c2, c2))))
        return OUTSIDE;
    const int first = side(n, c1, t), second = side(n, t, c2);
    return first < 0 || second < 0 ? OUTSIDE : first > 0 && second > 0 ? INSIDE : ON_EDGE;
}

/* Finds the place of xS at the corner `master` of a segment; returns a status. */
static int place_in(const double *xyz, int master, const int node[4], const double xS[3], enum place *place)
{
    const double *const x = xyz + 3 * (size_t)master;
    double c1[3], c2[3], t[3];
    int k = 0;
    while (k < 4 && node[k] != master)
        k++;
    if (k == 4 || node[(k + 1) % 4] < 0 || node[(k + 2) % 4] < 0 || node[(k + 3) % 4] < 0)
        return FOOTPOINT_ERR_ARGUMENT;
    vector_sub(xyz + 3 * (size_t)node[(k + 1) % 4], x, c1);
    vector_sub(xyz + 3 * (size_t)node[(k + 3) % 4], x, c2);
    vector_sub(xS, x, t);
    if (!vector_finite(c1) || !vector_finite(c2) || !vector_finite(xyz + 3 * (size_t)node[(k + 2) % 4]))
        return FOOTPOINT_ERR_NOT_FINITE;
    *place = place_of(c1, c2, t);
    return FOOTPOINT_OK;
}

static int check_master(const double *xyz, int master, int candidates, const double xS[3])
{
    if (master < 0 || candidates < 0)
        return FOOTPOINT_ERR_ARGUMENT;
    return vector_finite(xS) && vector_finite(xyz + 3 * (size_t)master) ? FOOTPOINT_OK : FOOTPOINT_ERR_NOT_FINITE;
}

int footpoint_select_segment(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen)
{
    int found = -1, status = check_master(xyz, master, candidates, xS);
    for (int s = 0; status == FOOTPOINT_OK && s < candidates; s++) {
        enum place place;
        status = place_in(xyz, master, seg + 4 * (size_t)s, xS, &place);
        if (status != FOOTPOINT_OK)
            return status;
        if (place == INSIDE) {
            *chosen = s;
            return FOOTPOINT_OK;
        }
        if (place == ON_EDGE && found < 0)
            found = s;
    }
    if (status != FOOTPOINT_OK)
        return status;
    if (found < 0)
        return FOOTPOINT_ERR_DOMAIN;
    *chosen = found;
    return FOOTPOINT_OK;
}

/* ---- by distance ---- */

/* Distances are equal, to rounding, if they differ by less than this fraction of the extent of the two segments. */
#define TIE (64.0 * DBL_EPSILON)

/* Measures the distance to a segment, and the extent of its corners from xS, which scales rounding in that distance.  Clears
 * *sure if the distance is not proved. */
static int measure(const double *xyz, const int node[4], const double xS[3], double *distance, double *extent,
                   int *sure)
{
    const double *x[4];
    double at[2];
    int status;
    *extent = 0.0;
    for (int k = 0; k < 4; k++) {
        double d[3];
        if (node[k] < 0)
            return FOOTPOINT_ERR_ARGUMENT;
        x[k] = xyz + 3 * (size_t)node[k];
        vector_sub(xS, x[k], d);
        if (!vector_finite(d))
            return FOOTPOINT_ERR_NOT_FINITE;
        *extent = fmax(*extent, hypot(hypot(d[0], d[1]), d[2])); /* squares of lengths might overflow */
    }
    status = footpoint_robust(x[0], x[1], x[2], x[3], xS, at, distance);
    if (status == FOOTPOINT_ERR_DOMAIN) /* from so far away, the segment is a point */
        *distance = *extent;
    *distance = fabs(*distance);
    *sure &= status != FOOTPOINT_UNPROVED;
    return isfinite(*distance) ? FOOTPOINT_OK : FOOTPOINT_ERR_NOT_FINITE;
}

int footpoint_select_closest(const double *xyz, int master, int candidates, const int *seg, const double xS[3],
                             int *chosen, double *distance)
{
    double least = 0.0, reach = 0.0;
    enum place best = OUTSIDE;
    int found = -1, sure = 1, status = check_master(xyz, master, candidates, xS);
    for (int s = 0; status == FOOTPOINT_OK && s < candidates; s++) {
        enum place place;
        double to, extent;
        status = place_in(xyz, master, seg + 4 * (size_t)s, xS, &place);
        if (status == FOOTPOINT_OK)
            status = measure(xyz, seg + 4 * (size_t)s, xS, &to, &extent, &sure);
        if (status != FOOTPOINT_OK)
            return status;
        const double margin = TIE * fmax(extent, reach);
        if (found >= 0 && !(to < least - margin) && !(to <= least + margin && place > best))
            continue;
        found = s;
        best = place;
        least = to;
        reach = extent;
    }
    if (status != FOOTPOINT_OK)
        return status;
    if (found < 0)
        return FOOTPOINT_ERR_DOMAIN;
    *chosen = found;
    if (distance)
        *distance = least;
    return sure ? FOOTPOINT_OK : FOOTPOINT_UNPROVED;
}
