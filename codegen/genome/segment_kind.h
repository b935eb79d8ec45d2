/* Kinds of master segments: the names of their inputs in genomes. evolve/surface/surface.h defines a kind for evolve/,
 * runtime/ its geometry, and codegen/print/templates/ its geometry in headers. */
#ifndef FOOTPOINT_SEGMENT_KIND_H
#define FOOTPOINT_SEGMENT_KIND_H

#include <stdbool.h>
#include <stddef.h>

/** Most vectors of a segment: nodes, and unit normals if it has them; without the slave node. */
enum { SEGMENT_VECTORS = 9, SEGMENT_INPUTS = 3 * (SEGMENT_VECTORS + 1) };

/** A kind. The vectors are, in this order, the nodes, the normals and the slave node S. Node A is xA[3] in C, and xA yA
 *  zA in a genome; the normal there is nA[3], and xnA ynA znA. */
struct segment_kind {
    const char *name;    /* "quad4" */
    const char *nodes;   /* their letters, "ABCD": corners counter-clockwise from outside, then mid-side nodes */
    const char *normals; /* letters of the nodes with unit normals as inputs; may be "" */
    size_t corners;
    bool bilinear; /* four nodes and straight edges */
    bool triangle; /* xi, eta >= 0, xi + eta <= 1; otherwise -1 <= xi, eta <= 1 */
    int growth;    /* joint power of xi and eta with which r_xi and r_eta grow far outside; at least 1 */
    bool turns;    /* genomes may use an order of corners other than "any" */
};

/** Returns the kind with this name, or NULL. */
const struct segment_kind *segment_find(const char *name);

/** Returns the kind without normals of faces with this many nodes, or NULL. */
const struct segment_kind *segment_of_face(size_t nodes);

/** Returns the number of vectors without the slave node. */
size_t segment_vectors(const struct segment_kind *k);
/** Returns the number of coordinates of all vectors, including the slave node. */
size_t segment_inputs(const struct segment_kind *k);

/** Writes the name of a vector in C: "xA", "nA"; "xS" for the last. */
void segment_vector_name(const struct segment_kind *k, size_t vector, char name[4]);
/** Writes the name of an input: "yA", "ynA", "yS". */
void segment_input_name(const struct segment_kind *k, size_t input, char name[5]);

#endif
