/* The pipeline for one genome: simplify, horner, share, schedule, lower; the cheapest of a few variants wins. */
#ifndef FOOTPOINT_COMPILE_H
#define FOOTPOINT_COMPILE_H

#include "search.h"

struct compiled {
    char *text;              /* owned: the statements in C */
    struct program *program; /* owned: as it is read from the text */
    struct operations ops;
    struct removed removed; /* what cancelled: singularities of the genome that the code does not have */
};

/** False with *d filled, and nothing to free, when the genome divides by 0 everywhere or needs a constant that is no
 *  double. */
bool compile_genome(const struct genome_file *f, const struct genome *genome, const struct compile_options *o,
                    struct compiled *c, struct diag *d);
void compiled_free(struct compiled *c);

/** Throughput model, seed 1, the default effort, nothing explained. */
struct compile_options compile_defaults(void);

#endif
