/* Node normals of a surface of four-node segments: the paper's (44). */
#ifndef FOOTPOINT_NODE_NORMALS_INCLUDED
#define FOOTPOINT_NODE_NORMALS_INCLUDED

#include "../footpoint.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Computes unit normals at the nodes: the sum of c1 x c2 over the segments that share the node, with c1 and c2 the
 *  edges that leave it. Each segment must be counter-clockwise from outside; it is weighted by its area at that corner.
 *  @param[in]  xyz     nodes x 3, mesh length
 *  @param[in]  seg     segments x 4 node indices A, B, C, D, from 0
 *  @param[out] normal  nodes x 3, dimensionless; 0 at nodes without a normal: without a segment, or where the sum
 *                      vanishes, is not finite, or has a square beyond double or too small for all its digits
 *  @return FOOTPOINT_OK; FOOTPOINT_ERR_ARGUMENT if an index is out of range, normal is then untouched */
int footpoint_node_normals(size_t nodes, const double *xyz, size_t segments, const int *seg, double *normal);

#ifdef __cplusplus
}
#endif

#endif
