/* Which nodes of a mesh are no slave nodes of a face.  In self contact a node that is on the face, or next to it, is a slave
 * node too, but never comes into contact with the face: its gap is 0, or what the mesh makes it. */
#ifndef FOOTPOINT_MESH_NEIGHBOURS_H
#define FOOTPOINT_MESH_NEIGHBOURS_H

#include "../input/mesh.h"

/** The neighbours of one face at a time: nodes of the elements under contact surfaces that share a node with the face.  Its
 *  own nodes are among them, those of neighbouring faces, and those on the other side of an element. */
struct neighbours;

/** `mesh` must stay as it is. */
struct neighbours *neighbours_new(const struct mesh *mesh);
void neighbours_free(struct neighbours *n);

/** Finds the neighbours of another face. */
void neighbours_of(struct neighbours *n, const struct mesh_face *face);

/** Returns true if the node is a neighbour of that face. */
bool neighbours_has(const struct neighbours *n, int node);

#endif
