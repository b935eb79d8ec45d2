// NimbleSM: replaces ContactManager::Projection. Projects a node on a whole four-node face instead of four triangles
// about its middle. The answer has four weights, one for each corner, instead of three barycentric coordinates: forces
// act only on the corners, and no node in the middle is needed. An entity has members coord_1_x_ to coord_4_z_; for a
// node, coord_1_ is read.
#ifndef FOOTPOINT_REPLACE_NIMBLESM
#define FOOTPOINT_REPLACE_NIMBLESM

#include "footpoint_quad4.h"

namespace nimble
{

/** @param[out] in      true if the node lies over the face, to `tol` in xi and eta, and has penetrated it (gap <= 0)
 *  @param[out] gap     along the normal; mesh length, < 0 penetrating
 *  @param[out] normal  of length 1, at the foot point
 *  @param[out] weights shape functions of the corners there; they add up to 1 */
template <class Node, class Face>
FOOTPOINT_FN void Projection(const Node &node, const Face &face, bool &in, double &gap, double normal[3],
                             double weights[4], double tol = 1.e-8)
{
    const double x[5][3] = {{face.coord_1_x_, face.coord_1_y_, face.coord_1_z_},
                            {face.coord_2_x_, face.coord_2_y_, face.coord_2_z_},
                            {face.coord_3_x_, face.coord_3_y_, face.coord_3_z_},
                            {face.coord_4_x_, face.coord_4_y_, face.coord_4_z_},
                            {node.coord_1_x_, node.coord_1_y_, node.coord_1_z_}};
    double loc[2], u[3], v[3], area = 0.;
    in = false;
    if (footpoint_quad4_accurate(x[0], x[1], x[2], x[3], x[4], loc, &gap) != FOOTPOINT_OK)
        return;
    const double s = 0.5 + 0.5 * loc[0], t = 0.5 + 0.5 * loc[1];
    weights[0] = (1. - s) * (1. - t);
    weights[1] = s * (1. - t);
    weights[2] = s * t;
    weights[3] = (1. - s) * t;
    for (int k = 0; k < 3; k++) {
        u[k] = (1. - t) * (x[1][k] - x[0][k]) + t * (x[2][k] - x[3][k]);
        v[k] = (1. - s) * (x[3][k] - x[0][k]) + s * (x[2][k] - x[1][k]);
    }
    for (int k = 0; k < 3; k++) {
        normal[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
        area += normal[k] * normal[k];
    }
    for (int k = 0; k < 3; k++)
        normal[k] /= sqrt(area);
    in = gap <= 0. && s >= -tol && s <= 1. + tol && t >= -tol && t <= 1. + tol;
}

} // namespace nimble

#endif
