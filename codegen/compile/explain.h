/* Explains passes: the number of operations in a graph, and the graph itself. */
#ifndef FOOTPOINT_EXPLAIN_H
#define FOOTPOINT_EXPLAIN_H

#include "../graph/dag.h"

#include <stdio.h>

/** Returns true if `text` names a pass: in lower case, with hyphens for spaces. */
bool explain_knows(const char *text);

/** Prints a line with the operations of a graph before scales are chosen. If `asked` names the pass, also prints the
 *  graph in infix: a statement for each value with several uses, and for each output. */
void explain_graph(FILE *out, const struct genome_file *f, const char *pass, const char *asked, const struct dag *g);

#endif
