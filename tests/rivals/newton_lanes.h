/* Converged Newton for columns of samples, NEWTON_LANES at a time. All lanes step until the last converges; converged
 * lanes stay unchanged, so each lane gets the answer of its own search. Compilers vectorise the loops over lanes. See
 * rivals_converged.h. */
#ifndef FOOTPOINT_NEWTON_LANES_H
#define FOOTPOINT_NEWTON_LANES_H

#include "rivals_converged.h"

enum { NEWTON_LANES = 32 };

/** Start of the lanes: the centre, their present u and v, or the taper, as in fair Newton. */
enum newton_lanes_start { NEWTON_LANES_CENTRE, NEWTON_LANES_GIVEN, NEWTON_LANES_TAPER };

struct newton_lanes {
    double g11[NEWTON_LANES], g12[NEWTON_LANES], g13[NEWTON_LANES], g22[NEWTON_LANES], g23[NEWTON_LANES];
    double g33[NEWTON_LANES], g1[NEWTON_LANES], g2[NEWTON_LANES], g3[NEWTON_LANES];
    double u[NEWTON_LANES], v[NEWTON_LANES];
    long long moving[NEWTON_LANES]; /* 1 or 0 */
};

RIVAL_FN void newton_lanes_set(struct newton_lanes *lanes, int i, const struct rival_products *g)
{
    lanes->g11[i] = g->g11;
    lanes->g12[i] = g->g12;
    lanes->g13[i] = g->g13;
    lanes->g22[i] = g->g22;
    lanes->g23[i] = g->g23;
    lanes->g33[i] = g->g33;
    lanes->g1[i] = g->g1;
    lanes->g2[i] = g->g2;
    lanes->g3[i] = g->g3;
}

RIVAL_FN struct rival_products newton_lanes_get(const struct newton_lanes *lanes, int i)
{
    return (struct rival_products){lanes->g11[i], lanes->g12[i], lanes->g13[i], lanes->g22[i], lanes->g23[i],
                                   lanes->g33[i], lanes->g1[i],  lanes->g2[i],  lanes->g3[i]};
}

RIVAL_FN void newton_lanes_begin(struct newton_lanes *lanes, int i, const struct rival_products *g,
                                 enum newton_lanes_start start)
{
    const struct rival_point p = start == NEWTON_LANES_TAPER ? rival_taper(g) : rival_first(g, 0, 1.0);
    lanes->u[i] = start == NEWTON_LANES_GIVEN ? lanes->u[i] : p.u;
    lanes->v[i] = start == NEWTON_LANES_GIVEN ? lanes->v[i] : p.v;
    lanes->moving[i] = 1;
}

/** Reads the segment and the slave node of lane i from column i of x[15]. */
RIVAL_FN void newton_lanes_read(struct newton_lanes *lanes, const double *const x[15], enum newton_lanes_start start)
{
    for (int i = 0; i < NEWTON_LANES; i++) {
        const double xA[3] = {x[0][i], x[1][i], x[2][i]}, xB[3] = {x[3][i], x[4][i], x[5][i]};
        const double xC[3] = {x[6][i], x[7][i], x[8][i]}, xD[3] = {x[9][i], x[10][i], x[11][i]};
        const double xS[3] = {x[12][i], x[13][i], x[14][i]};
        struct rival_basis b;
        rival_basis_centre(xA, xB, xC, xD, xS, &b);
        const struct rival_products g = rival_products_of(&b, RIVAL_MANY);
        newton_lanes_set(lanes, i, &g);
        newton_lanes_begin(lanes, i, &g, start);
    }
}

/** Reads segments with `over` slave nodes each, to start from the taper. The segment of lane i is in the first column
 *  of its group. */
RIVAL_FN void newton_lanes_read_over(struct newton_lanes *lanes, const double *const x[15], int over)
{
    for (int first = 0; first < NEWTON_LANES; first += over) {
        double node[4][3];
        struct rival_basis b;
        for (int k = 0; k < 12; k++)
            node[k / 3][k % 3] = x[k][first];
        rival_basis_centre(node[0], node[1], node[2], node[3], node[0], &b);
        struct rival_products g = rival_products_of(&b, RIVAL_MANY);
        for (int i = first; i < first + over; i++) {
            const double d[3] = {b.d[0] + 4 * (x[12][i] - node[0][0]), b.d[1] + 4 * (x[13][i] - node[0][1]),
                                 b.d[2] + 4 * (x[14][i] - node[0][2])};
            g.g1 = rival_dot(b.e1, d);
            g.g2 = rival_dot(b.e2, d);
            g.g3 = rival_dot(b.c3, d);
            newton_lanes_set(lanes, i, &g);
        }
    }
    for (int i = 0; i < NEWTON_LANES; i++) {
        const struct rival_products g = newton_lanes_get(lanes, i);
        newton_lanes_begin(lanes, i, &g, NEWTON_LANES_TAPER);
    }
}

/* Takes one step in all lanes; returns how many still move. */
RIVAL_FN long long newton_lanes_step(struct newton_lanes *lanes, int newton, double tolerance)
{
    long long count = 0;
    for (int i = 0; i < NEWTON_LANES; i++) {
        const struct rival_products g = newton_lanes_get(lanes, i);
        const double u = lanes->u[i], v = lanes->v[i];
        const long long moving = lanes->moving[i];
        const struct rival_point p = {u, v}, next = rival_step(&g, newton, p, 1.0);
        const double du = fabs(next.u - u), dv = fabs(next.v - v), most = du < dv ? dv : du;
        lanes->u[i] = moving ? next.u : u;
        lanes->v[i] = moving ? next.v : v;
        lanes->moving[i] = most <= tolerance ? 0 : moving;
    }
    for (int i = 0; i < NEWTON_LANES; i++)
        count += lanes->moving[i];
    return count;
}

/** Takes steps until all lanes, which must have been read, converge. */
RIVAL_FN void newton_lanes_run(struct newton_lanes *lanes, enum newton_lanes_start start, double tolerance)
{
    const int most = start == NEWTON_LANES_TAPER ? RIVAL_FAIR_STEPS_MAX : RIVAL_STEPS_MAX;
    long long moving = NEWTON_LANES;
    int n = start == NEWTON_LANES_GIVEN ? 0 : 1;
    for (; start == NEWTON_LANES_CENTRE && n < RIVAL_NEWTON_GAUSS && moving > 0; n++)
        moving = newton_lanes_step(lanes, 0, tolerance);
    for (; n < most && moving > 0; n++)
        moving = newton_lanes_step(lanes, 1, tolerance);
}

#endif
