/* Kinds of master segments as text knows them: what the inputs of a genome are called.  What evolve/ needs of a kind
 * stands in evolve/surface/surface.h, its geometry in runtime/, and that for headers in codegen/print/templates/. */
#ifndef FOOTPOINT_SEGMENT_KIND_H
#define FOOTPOINT_SEGMENT_KIND_H

#include <stdbool.h>
#include <stddef.h>

/** Vectors of a segment at most: nodes, and unit normals if it has them; the slave node not counted. */
enum { SEGMENT_VECTORS = 9, SEGMENT_INPUTS = 3 * (SEGMENT_VECTORS + 1) };

/** One kind.  The vectors of a segment and a slave node are, in this order, the nodes, the normals and the slave node
 * S; node A is xA[3] in C and the inputs xA yA zA of a genome, the normal there nA[3] and xnA ynA znA. */
struct segment_kind {
    const char *name;    /* "quad4" */
    const char *nodes;   /* their letters, "ABCD": corners counter-clockwise from outside, then mid-side nodes */
    const char *normals; /* letters of the nodes whose unit normals are inputs, too: "" */
    size_t corners;
    bool bilinear; /* the four-node segment, of straight edges */
    bool triangle; /* xi, eta >= 0, xi + eta <= 1; else -1 <= xi, eta <= 1 */
    int growth;    /* the power of xi and eta together that r_xi and r_eta grow with, far outside; at least 1 */
    bool turns;    /* genomes may ask for an order of the corners other than "any" */
};

/** NULL if there is none of that name. */
const struct segment_kind *segment_find(const char *name);

/** The kind, without normals, that faces of so many nodes are; NULL if there is none. */
const struct segment_kind *segment_of_face(size_t nodes);

/** Vectors without the slave node. */
size_t segment_vectors(const struct segment_kind *k);
/** Coordinates of all vectors, with the slave node. */
size_t segment_inputs(const struct segment_kind *k);

/** Name of a vector in C: "xA", "nA"; of the last one, "xS". */
void segment_vector_name(const struct segment_kind *k, size_t vector, char name[4]);
/** Name of an input: "yA", "ynA", "yS". */
void segment_input_name(const struct segment_kind *k, size_t input, char name[5]);

#endif
