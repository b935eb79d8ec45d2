/* Nodes that are not slave nodes of a face in self contact. Nodes on a face or next to it belong to the slave surface,
 * too, but never come into contact with the face: their gap is 0, or depends only on the mesh. */
#ifndef FOOTPOINT_MESH_NEIGHBOURS_H
#define FOOTPOINT_MESH_NEIGHBOURS_H

#include "../input/mesh.h"

/** The neighbours of one face at a time: nodes of the elements under contact surfaces that share a node with the face.
 *  They include the face's own nodes and nodes on the opposite side of an element. */
struct neighbours;

/** Allocates; `mesh` must stay unchanged. */
struct neighbours *neighbours_new(const struct mesh *mesh);
void neighbours_free(struct neighbours *n);

/** Finds the neighbours of `face`. */
void neighbours_of(struct neighbours *n, const struct mesh_face *face);

/** Returns true if the node is a neighbour of the last face. */
bool neighbours_has(const struct neighbours *n, int node);

#endif
