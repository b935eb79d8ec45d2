/* Headers of edges, for contact in the plane: one unknown, xi, and nodes of two coordinates. Foot points are roots of
 * polynomials, in closed form or by steps, so these headers consist of templates, without a genome. */
#ifndef FOOTPOINT_HEADER_EDGE_H
#define FOOTPOINT_HEADER_EDGE_H

#include "../../compile/compiled_file.h"

#include <stdio.h>

struct edge_kind;

/** Returns the kind with this name, "edge2" or "edge3", or NULL. */
const struct edge_kind *edge_find(const char *name);

/** Prints the header of a kind, whose functions' names begin with `prefix`; in float without those at a place. */
void edge_print(const struct edge_kind *k, const char *prefix, enum precision precision, FILE *out);

#endif
