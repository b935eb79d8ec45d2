/* Contact surfaces of an Abaqus or CalculiX input file. */
#ifndef FOOTPOINT_MESH_H
#define FOOTPOINT_MESH_H

#include "../../codegen/base/base.h"
#include "../../codegen/genome/segment_kind.h"

/** Corner nodes (and mid-side nodes, and the middle, in Abaqus order) of one element face, counter-clockwise seen from
 * outside. */
struct mesh_face {
    int nodes;   /* 3, 4, 6, 8 or 9 */
    int node[9]; /* indices into xyz */
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
    int *label;       /* owned; the file's own node numbers, of each instance from 1 or so */
    size_t nodes;
    struct mesh_pair {
        int *slave; /* owned: node indices, ascending by label, each once */
        size_t slaves;
        struct mesh_face *master; /* owned */
        size_t masters;
    } * pair; /* owned */
    size_t pairs;
    struct mesh_element
        *element; /* owned: elements under contact surfaces that hold both slave nodes and nodes of masters */
    size_t elements;
    char *notes; /* owned: lines about what was skipped, or NULL */
    char **file; /* owned: the paths that it was read from, included files, too */
    size_t files;
};

/** Read a model.  Returns NULL with *d "file:line: error: ..." (line within the included file where it stands). */
struct mesh *mesh_read(const char *path, struct diag *d);
void mesh_free(struct mesh *m);

/** Shortest edge between corners of master faces, collapsed ones apart; INFINITY: there is no other. */
double mesh_shortest_edge(const struct mesh *m);

/** The kind of segment that all master faces are, or NULL: there are several.  `text` says how many of each, "7 of
 *  quad4, 2 of tri3". */
const struct segment_kind *mesh_segment(const struct mesh *m, char *text, size_t size);

/** Leave the master faces of one kind alone; returns how many there are. */
size_t mesh_keep_faces(struct mesh *m, const struct segment_kind *kind);

#endif
