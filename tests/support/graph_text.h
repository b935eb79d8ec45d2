/* Tests passes from graph to graph by tables: a genome, and the graph that the pass makes of it, as text.
 *
 * In the text a value that is used more than once is a statement of its own, "t1 = x + y; r = t1^2 - t1"; other values
 * stand at their use.  Operands are in the order of their text, written out to the inputs: constants first,
 * sums that are factors last.
 * Operations are counted in the text: each * and /, one less than its power for a power, each + and -. */
#ifndef FOOTPOINT_GRAPH_TEXT_H
#define FOOTPOINT_GRAPH_TEXT_H

#include "../../codegen/graph/dag.h"
#include "genome_text.h"

/** `genome` is an expression of a, b, c, d, x, y, z, the output r; or the text between the inputs and "end". */
struct graph_row {
    const char *genome;
    const char *expected; /* NULL: the pass does not change the graph */
    long mul, add, div;
};

/** Returns a new graph, or NULL without a change. */
typedef struct dag *graph_pass(const struct dag *g);

/** Checks each row: the text, the operations, and that genome and graph have the same values at some rational points. */
void check_graphs(graph_pass *pass, const struct graph_row *row, size_t rows);

/** Returns the file of a row's genome; genome_file_free it. */
struct genome_file *row_file(const char *genome);

/** Returns its graph as read; dag_free it. */
struct dag *row_graph(const struct genome_file *f);

/** Returns the graph as text; caller frees. */
char *graph_text(const struct genome_file *f, const struct dag *g);

/** Returns the statements in C; caller frees. */
char *row_code(const struct genome_file *f, const struct program *p);

/** Fails unless the graph has the values of the genome at some rational points.  An irrational square root counts there as any
 *  function, the same in both. */
void check_values(const struct genome_file *f, const struct dag *g);

#define CHECK_GRAPHS(pass, row) check_graphs(pass, row, sizeof(row) / sizeof *(row))

#endif
