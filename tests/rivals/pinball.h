/* The pinball test (Belytschko and Neal, Int. J. Numer. Meth. Engng 31 (1991) 547-572), which decides contact and its
 * depth. Every element of the contact surfaces contains a sphere of its own volume about its centre of gravity; two
 * elements are in contact if their spheres overlap. It finds no xi and eta.
 *
 * Five nodes do not describe the elements. Here the segment is a face of an element that is as deep as the root h of
 * the segment's area, a cube if the segment is a square. The slave node is the middle of an equal face of an element
 * behind it. With n the unit normal, e = xS - (xA + xB + xC + xD)/4 and equal radii R = (3/(4 pi))^(1/3) h, the centres
 * are e + h n apart: contact if |e + h n| < 2 R,  depth 2 R - |e + h n|.
 *
 * A counter of operations may replace the scalar type, as in rivals.h. */
#ifndef FOOTPOINT_PINBALL_H
#define FOOTPOINT_PINBALL_H

#include "rivals.h"

/** 2 R / h = (6 / pi)^(1/3). */
#define PINBALL_DIAMETER 1.2407009817988

/** Returns the depth of the overlap, > 0 in contact, in the nodes' unit of length. */
RIVAL_FN FOOTPOINT_REAL rival_pinball_depth(RIVAL_NODES)
{
    const FOOTPOINT_REAL half = 0.5, quarter = 0.25, diameter = PINBALL_DIAMETER;
    FOOTPOINT_REAL ac[3], bd[3], e[3];
    for (int i = 0; i < 3; i++) {
        ac[i] = xC[i] - xA[i];
        bd[i] = xD[i] - xB[i];
        e[i] = xS[i] - ((xA[i] + xC[i]) + (xB[i] + xD[i])) * quarter;
    }
    const FOOTPOINT_REAL n[3] = {ac[1] * bd[2] - ac[2] * bd[1], ac[2] * bd[0] - ac[0] * bd[2],
                                 ac[0] * bd[1] - ac[1] * bd[0]}; /* 2 h^2 times the unit normal */
    const FOOTPOINT_REAL h2 = sqrt(rival_dot(n, n)) * half, h = sqrt(h2);
    return h * diameter - sqrt(rival_dot(e, e) + rival_dot(e, n) / h + h2);
}

/** Has the signature of a search: returns the depth as xi and no eta. */
RIVAL_FN void rival_pinball(RIVAL_NODES, FOOTPOINT_REAL *xi, FOOTPOINT_REAL *eta)
{
    *xi = rival_pinball_depth(xA, xB, xC, xD, xS);
    *eta = 0.0;
}

#endif
