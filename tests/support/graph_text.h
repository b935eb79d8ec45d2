/* Passes from graph to graph, tested by tables: a genome, and the graph that the pass makes of it, as text.
 *
 * In the text a value that is used more than once is a statement of its own, "t1 = x + y; r = t1^2 - t1"; the others
 * stand where they are used.  Operands stand in the order of their text, written out to the inputs: constants first,
 * sums that are factors last.
 * Operations are those of the text: each * and /, one less than its power for a power, each + and -. */
#ifndef FOOTPOINT_GRAPH_TEXT_H
#define FOOTPOINT_GRAPH_TEXT_H

#include "../../codegen/graph/dag.h"
#include "genome_text.h"

/** `genome` is one expression of a, b, c, d, x, y, z, which is output r; or what stands between the inputs and "end". */
struct graph_row {
    const char *genome;
    const char *expected; /* NULL: the pass leaves the graph as it is */
    long mul, add, div;
};

/** A new graph, or NULL where there is nothing to do. */
typedef struct dag *graph_pass(const struct dag *g);

/** Of each row, the text, the operations, and that genome and graph have the same values at some rational points. */
void check_graphs(graph_pass *pass, const struct graph_row *row, size_t rows);

/** The file that a row's genome is in; genome_file_free it. */
struct genome_file *row_file(const char *genome);

/** Its graph, nothing but read; dag_free it. */
struct dag *row_graph(const struct genome_file *f);

/** Caller frees. */
char *graph_text(const struct genome_file *f, const struct dag *g);

/** The statements in C; caller frees. */
char *row_code(const struct genome_file *f, const struct program *p);

/** Fails unless the graph has the values of the genome at some rational points.  A square root that is irrational is
 *  any function there: the same one in both. */
void check_values(const struct genome_file *f, const struct dag *g);

#define CHECK_GRAPHS(pass, row) check_graphs(pass, row, sizeof(row) / sizeof *(row))

#endif
