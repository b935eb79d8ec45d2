// MOOSE: replaces the iteration in Moose::findContactPoint (framework/src/geomsearch/FindContactPoint.C) for four-node
// sides (libMesh's QUAD4). Types are parameters, so it compiles with any version's types. The function returns the
// closest point, which a search from _closest_point_ref does not prove on folded sides; so the start is not used.
#ifndef FOOTPOINT_REPLACE_MOOSE
#define FOOTPOINT_REPLACE_MOOSE

#include "footpoint.h"

#include <cmath>
#include <vector>

namespace footpoint_moose
{

/** @param[in,out] p_info  of _side; receives _closest_point_ref, _closest_point, _normal, _distance (> 0: penetration),
 *                         _tangential_distance, _dxyzdxi, _dxyzdeta, _d2xyzdxideta, _side_phi, _side_grad_phi and
 *                         _off_edge_nodes
 *  @param[in] secondary_point       mesh length
 *  @param[in] tangential_tolerance  mesh length: how far beside the side a point may be
 *  @param[out] contact_point_on_side, search_succeeded */
template <class PenetrationInfo, class FEBase, class FEType, class Point>
void findContactPoint(PenetrationInfo &p_info, FEBase * /*fe_elem*/, FEBase *fe_side, FEType & /*fe_side_type*/,
                      const Point &secondary_point, bool /*start_with_centroid*/, const double tangential_tolerance,
                      bool &contact_point_on_side, bool &search_succeeded)
{
    double x[5][3], loc[2], distance;
    for (unsigned i = 0; i < 5; i++)
        for (unsigned k = 0; k < 3; k++)
            x[i][k] = i < 4 ? p_info._side->point(i)(k) : secondary_point(k);
    const int status = footpoint_robust(x[0], x[1], x[2], x[3], x[4], loc, &distance);
    contact_point_on_side = false;
    search_succeeded = status == FOOTPOINT_OK || status == FOOTPOINT_OUTSIDE || status == FOOTPOINT_NOT_UNIQUE;
    if (!search_succeeded)
        return;

    // At a collapsed or 180-degree corner, the normal is the limit from the middle.
    const double inward = 1 - 1. / 1024;
    std::vector<Point> points = {Point(inward * loc[0], inward * loc[1], 0)};
    fe_side->reinit(p_info._side, &points);
    const Point limit = fe_side->get_dxyzdxi()[0].cross(fe_side->get_dxyzdeta()[0]);
    points[0] = Point(loc[0], loc[1], 0);
    fe_side->reinit(p_info._side, &points);
    p_info._closest_point_ref = points[0];
    p_info._closest_point = fe_side->get_xyz()[0];
    p_info._normal = fe_side->get_dxyzdxi()[0].cross(fe_side->get_dxyzdeta()[0]);
    if (!(p_info._normal.norm() > limit.norm() / 1024))
        p_info._normal = limit;
    p_info._normal /= p_info._normal.norm();
    const Point offset = p_info._closest_point - secondary_point;
    const double along = offset * p_info._normal, square = offset * offset - along * along;
    const bool beside = status == FOOTPOINT_OUTSIDE;
    p_info._tangential_distance = beside ? std::sqrt(square > 0 ? square : 0) : 0;
    p_info._distance = beside ? -distance : along;
    p_info._dxyzdxi = fe_side->get_dxyzdxi();
    p_info._dxyzdeta = fe_side->get_dxyzdeta();
    p_info._d2xyzdxideta = fe_side->get_d2xyzdxideta();
    p_info._side_phi = fe_side->get_phi();
    p_info._side_grad_phi = fe_side->get_dphi();

    // The nodes of the edge, or the corner, closest to a point beside the side.
    static const double corner[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    p_info._off_edge_nodes.clear();
    for (unsigned i = 0; beside && i < 4; i++)
        if ((std::fabs(loc[0]) < 1 || loc[0] == corner[i][0]) && (std::fabs(loc[1]) < 1 || loc[1] == corner[i][1]))
            p_info._off_edge_nodes.push_back(p_info._side->node_ptr(i));
    contact_point_on_side = !beside || p_info._tangential_distance <= tangential_tolerance;
}

} // namespace footpoint_moose

#endif
