/* The averaged normal at a node of a surface, a direction for footpoint_face_along, and the chain rule through it. */
#ifndef FOOTPOINT_AVERAGED_NORMAL_INCLUDED
#define FOOTPOINT_AVERAGED_NORMAL_INCLUDED

#include "../footpoint_face.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Computes the sum of r_xi x r_eta at a node over the faces that share it.  So each face's unit normal is weighted by its area
 *  there, as in MOOSE's mortar contact.  It is not normalised: projections along it do not depend on its length.
 *  @param[in]  xyz     coordinates by node index, mesh length
 *  @param[in]  seg     faces x N node indices, from 0; each face must contain `node`
 *  @param[out] normal  mesh length squared; on edges r_eta is (0, 0, 1)
 *  @return FOOTPOINT_OK, FOOTPOINT_ERR_ARGUMENT (no such kind, or a face without the node), FOOTPOINT_ERR_NOT_FINITE,
 *          FOOTPOINT_ERR_DEGENERATE (the sum is 0) */
int footpoint_averaged_normal(enum footpoint_face face, const double *xyz, size_t faces, const int *seg, int node,
                              double normal[3]);

/** Computes derivatives by the faces' nodes of a value that depends on them through the averaged normal, such as xi of
 *  footpoint_face_along.
 *      footpoint_face_along(FOOTPOINT_QUAD4, x, normal, loc, &dist);
 *      footpoint_face_differentiate_along(FOOTPOINT_QUAD4, x, normal, loc, NULL, d_xi, NULL, NULL, NULL, NULL, NULL);
 *      footpoint_averaged_normal_gradient(FOOTPOINT_QUAD4, xyz, faces, seg, node, d_xi + 15, by);
 *  @param[in]  by_normal  derivatives of the value by the normal: the last three elements of d_xi, d_eta or d_dist
 *  @param[out] by         faces x N x 3: by the nodes in the order of seg; a node's derivative is the sum over its places there
 *  @return as footpoint_averaged_normal, but for FOOTPOINT_ERR_DEGENERATE */
int footpoint_averaged_normal_gradient(enum footpoint_face face, const double *xyz, size_t faces, const int *seg,
                                       int node, const double by_normal[3], double *by);

#ifdef __cplusplus
}
#endif

#endif
