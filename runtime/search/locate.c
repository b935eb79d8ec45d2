/* Searches a pair without iteration; see footpoint.h. */
#include "locate.h"

#include "../certain/check.h"
#include "../certain/convex.h"

#include "../../generated/footpoint_quad4.h"

enum { ORDINARY = 32 }; /* edges within 2^-32 to 2^32 keep all products of the check in range */

/* Calls footpoint_check, also in another unit of length if edges are not ordinary. */
static int is_sure(const double *const *x, const double loc[2])
{
    double y[5][3];
    int exponent;
    return footpoint_check(x[0], x[1], x[2], x[3], x[4], loc[0], loc[1]) ||
           (footpoint_detail_scale(x, 4, 5, y, &exponent) == FOOTPOINT_OK &&
            (exponent > ORDINARY || exponent < -ORDINARY) &&
            footpoint_check(y[0], y[1], y[2], y[3], y[4], loc[0], loc[1]));
}

int footpoint_locate_one(enum footpoint_tier tier, int sure, const double *const *x, double loc[2], double *gap)
{
    static int (*const search[FOOTPOINT_TIERS])(const double *, const double *, const double *, const double *,
                                                const double *, double *, double *) = {
        footpoint_quad4_fast,    footpoint_quad4_coarse,   footpoint_quad4_gauss2,
        footpoint_quad4_medium,  footpoint_quad4_balanced, footpoint_quad4_fine,
        footpoint_quad4_precise, footpoint_quad4_accurate, footpoint_quad4_full};
    double found[2], g;
    const int status = search[tier](x[0], x[1], x[2], x[3], x[4], found, &g);
    if (status < FOOTPOINT_OK)
        return status;
    if (sure && !is_sure(x, found))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = found[0];
    loc[1] = found[1];
    *gap = g;
    return sure ? FOOTPOINT_OK : status; /* the check proves the answer, too */
}

/* Returns 1 if no point of the segment is nearer than the foot point within the promise of (xi,eta). */
static int is_nearest(const double *const *x, double xi, double eta)
{
    struct check p;
    footpoint_check_at(x[0], x[1], x[2], x[3], x[4], xi, eta, &p);
    return footpoint_check_nearest(&p, 0.5 * CONVEX_BEYOND * FOOTPOINT_QUAD4_ACCURATE_PROMISE) &
           footpoint_check_alone(&p);
}

/* Does the work of footpoint_locate_one if the search proves its own answer, whose error is then below CONVEX_BEYOND. */
int footpoint_locate(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *gap)
{
    const double *const x[5] = {xA, xB, xC, xD, xS};
    double xi, eta, g;
    struct convex v;
    if (footpoint_quad4_accurate_detail_checked(x, 2, 0.0, &xi, &eta, &g) >> 63)
        return footpoint_locate_one(FOOTPOINT_ACCURATE, 1, x, loc, gap);
    convex_of(x, &v);
    const double reach = footpoint_check_larger(1.0, footpoint_check_larger(fabs(xi), fabs(eta)));
    if (!convex_holds(&v, 1.001 * reach) && !is_nearest(x, xi, eta))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = xi;
    loc[1] = eta;
    *gap = g;
    return FOOTPOINT_OK;
}
