/* Fair Newton over arrays with gap and status; see newton_lanes.h. */
#ifndef FOOTPOINT_NEWTON_LANES_CALLS_H
#define FOOTPOINT_NEWTON_LANES_CALLS_H

#include "newton_lanes.h"
#include "rivals_calls.h"

/** Computes, for each column of x[15], the gap, and 1 if the lane has converged and the segment has a normal there,
 *  otherwise 0. */
RIVAL_FN void newton_lanes_gap(const struct newton_lanes *lanes, const double *const x[15],
                               double gap[restrict NEWTON_LANES], long long answered[restrict NEWTON_LANES])
{
    for (int i = 0; i < NEWTON_LANES; i++) {
        const double xA[3] = {x[0][i], x[1][i], x[2][i]}, xB[3] = {x[3][i], x[4][i], x[5][i]};
        const double xC[3] = {x[6][i], x[7][i], x[8][i]}, xD[3] = {x[9][i], x[10][i], x[11][i]};
        const double xS[3] = {x[12][i], x[13][i], x[14][i]};
        const struct rival_point p = {lanes->u[i], lanes->v[i]};
        struct rival_basis b;
        double found;
        rival_basis_centre(xA, xB, xC, xD, xS, &b);
        const long long normal = rival_basis_gap(&b, p, &found);
        gap[i] = found;
        answered[i] = lanes->moving[i] ? 0 : normal;
    }
}

/** Searches NEWTON_LANES columns. Groups of `over` slave nodes share a segment; each slave node has its own column. */
RIVAL_FN void newton_lanes_fair(const double *const x[15], int over, double xi[], double eta[], double gap[],
                                int answered[])
{
    struct newton_lanes lanes;
    double found[NEWTON_LANES]; /* a local array, which compilers know to overlap no column */
    long long stands[NEWTON_LANES];
    if (over > 1)
        newton_lanes_read_over(&lanes, x, over);
    else
        newton_lanes_read(&lanes, x, NEWTON_LANES_TAPER);
    newton_lanes_run(&lanes, NEWTON_LANES_TAPER, RIVAL_FAIR_TOLERANCE);
    newton_lanes_gap(&lanes, x, found, stands);
    for (int i = 0; i < NEWTON_LANES; i++) {
        xi[i] = lanes.u[i];
        eta[i] = lanes.v[i];
        gap[i] = found[i];
        answered[i] = stands[i] != 0;
    }
}

#endif
