/* Genome text to graph, in exact rational arithmetic. */
#ifndef FOOTPOINT_FROM_GENOME_H
#define FOOTPOINT_FROM_GENOME_H

#include "dag.h"

/** Which named values (lets used more than once) stay whole instead of being multiplied out into products. */
enum keep_lets { KEEP_QUOTIENTS, KEEP_ALL };

/** The graph of the outputs of one genome, or NULL with *d filled when it divides by a value that is identically 0.
 *  dag_removed counts the divisions and roots that cancelled. Free with dag_free. */
struct dag *simplify_genome(const struct genome_file *f, const struct genome *genome, enum keep_lets keep,
                            struct diag *d);

#endif
