/* The iteration-free search of one pair, and of many in the plainest arrays; see footpoint.h. */
#include "footpoint_batch.h"

#include "check.h"

#include "../generated/footpoint_quad4.h"

int footpoint_locate(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *gap)
{
    double found[2], g;
    const int status = footpoint_quad4_accurate(xA, xB, xC, xD, xS, found, &g);
    if (status != FOOTPOINT_OK)
        return status;
    if (!footpoint_check(xA, xB, xC, xD, xS, found[0], found[1]))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = found[0];
    loc[1] = found[1];
    *gap = g;
    return FOOTPOINT_OK;
}

_Static_assert(sizeof(int) == sizeof(int32_t), "indices of 32 bits");

size_t footpoint_locate_pairs(size_t n, const double *xyz, size_t nodes, const int *seg, const int *slave, double *loc,
                              double *gap, int *status)
{
    const struct footpoint_pairs p = {.n = n,
                                      .nodes = nodes,
                                      .x = xyz,
                                      .y = nodes ? xyz + 1 : NULL,
                                      .z = nodes ? xyz + 2 : NULL,
                                      .stride = 3,
                                      .seg = seg,
                                      .slave = slave,
                                      .sure = 1};
    return footpoint_locate_batch(&p, FOOTPOINT_ACCURATE, loc, gap, status);
}
