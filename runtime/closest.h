/* The closest point of a bilinear segment, edges and corners included, for the choice among segments. */
#ifndef FOOTPOINT_CLOSEST_H
#define FOOTPOINT_CLOSEST_H

#include "footpoint.h"

/* Least distance from xS to the segment with -1 <= xi, eta <= 1, mesh length, and where: at = {xi, eta}.  Nodes are
 * finite; corners may coincide. */
double footpoint_closest(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                         const double xS[3], double at[2]);

#endif
