/* The pipeline for a genome: simplify, horner, share, schedule, lower; the cheapest of a few variants wins. */
#ifndef FOOTPOINT_COMPILE_H
#define FOOTPOINT_COMPILE_H

#include "search.h"

struct compiled {
    char *text;              /* owned: the statements in C */
    struct program *program; /* owned: read back from the text */
    struct operations ops;
    struct removed removed; /* singularities of the genome that cancelled in the code */
};

/** Compiles a genome. Returns false, with *d filled and nothing to free, if the genome divides by 0 everywhere or needs
 *  a constant that is not a double. */
bool compile_genome(const struct genome_file *f, const struct genome *genome, const struct compile_options *o,
                    struct compiled *c, struct diag *d);
void compiled_free(struct compiled *c);

/** Returns the default options: throughput model, seed 1, default effort, no explanations. */
struct compile_options compile_defaults(void);

#endif
