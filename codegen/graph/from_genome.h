/* Converts genome text to a graph, in exact rational arithmetic. */
#ifndef FOOTPOINT_FROM_GENOME_H
#define FOOTPOINT_FROM_GENOME_H

#include "dag.h"

/** Which named values (lets used more than once) are not multiplied out into products. */
enum keep_lets { KEEP_QUOTIENTS, KEEP_ALL };

/** Returns the graph of the outputs of a genome, or NULL, with *d filled, if it divides by a value that is identically
 *  0. dag_removed counts the divisions and roots that cancelled. Free it with dag_free. */
struct dag *simplify_genome(const struct genome_file *f, const struct genome *genome, enum keep_lets keep,
                            struct diag *d);

#endif
