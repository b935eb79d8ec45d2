/* Headers of edges, for contact in the plane: one unknown, xi, and nodes of two coordinates.  Foot points are roots of
 * polynomials, in closed form or by steps, so that these headers are templates: there is no genome. */
#ifndef FOOTPOINT_HEADER_EDGE_H
#define FOOTPOINT_HEADER_EDGE_H

#include <stdio.h>

struct edge_kind;

/** Returns the kind with this name, "edge2" or "edge3", or NULL. */
const struct edge_kind *edge_find(const char *name);

/** Prints the header of a kind in double, whose functions' names begin with `prefix`. */
void edge_print(const struct edge_kind *k, const char *prefix, FILE *out);

#endif
