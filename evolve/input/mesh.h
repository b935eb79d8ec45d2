/* Contact surfaces of an Abaqus or CalculiX input file. */
#ifndef FOOTPOINT_MESH_H
#define FOOTPOINT_MESH_H

#include "../../codegen/base/base.h"
#include "../../codegen/genome/segment_kind.h"

/** Corner nodes of an element face, counter-clockwise seen from outside, then mid-side nodes and the middle if it has
 *  them (Abaqus order). Of a plane element it is an edge: its ends, with the element to the left, and its middle. */
struct mesh_face {
    int nodes;   /* 3, 4, 6, 8 or 9; of an edge 2 or 3 */
    int node[9]; /* indices into xyz */
    bool edge;
};

enum { MESH_ELEMENT_NODES = 27 };

/** An element under a contact surface. */
struct mesh_element {
    int nodes;
    int node[MESH_ELEMENT_NODES]; /* indices into xyz */
};

/** The slave nodes and the master faces of all contact pairs of a model. */
struct mesh {
    double (*xyz)[3]; /* owned; nodes x 3, mesh length */
    int *label;       /* owned; the file's own node numbers, unique only within an instance */
    size_t nodes;
    struct mesh_pair {
        int *slave; /* owned: node indices, ascending by label, no duplicates */
        size_t slaves;
        struct mesh_face *master; /* owned */
        size_t masters;
    } * pair; /* owned */
    size_t pairs;
    struct mesh_element
        *element; /* owned: elements under contact surfaces that have both slave nodes and nodes of master faces */
    size_t elements;
    char *notes; /* owned: notes about skipped input, or NULL */
    char **file; /* owned: paths of all files read, including included files */
    size_t files;
};

/** Reads a model. Returns NULL with *d "file:line: error: ..." (file and line of the included file, if any). */
struct mesh *mesh_read(const char *path, struct diag *d);
void mesh_free(struct mesh *m);

/** Returns the shortest edge between corners of master faces, ignoring collapsed edges, or INFINITY. */
double mesh_shortest_edge(const struct mesh *m);

/** Returns the kind of segment of all master faces, or NULL if there are several, or edges. text: the number of each,
 *  "7 of quad4, 2 of tri3", "5 of edge3". */
const struct segment_kind *mesh_segment(const struct mesh *m, char *text, size_t size);

/** Returns true if all master faces are edges. */
bool mesh_is_plane(const struct mesh *m);

/** Removes all master faces of other kinds; returns the number left. */
size_t mesh_keep_faces(struct mesh *m, const struct segment_kind *kind);

#endif
