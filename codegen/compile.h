/* The pipeline for one genome: simplify, horner, share, schedule, emit; the cheapest of a few variants wins. */
#ifndef FOOTPOINT_COMPILE_H
#define FOOTPOINT_COMPILE_H

#include "cost.h"
#include "emit.h"

struct compile_options {
    struct cost_model cost;
    unsigned long seed;
    long effort;   /* work that the search may do, in units of about a millisecond; same effort, same bytes */
    FILE *explain; /* one line per pass with its counts, or NULL */
};

struct compiled {
    struct emission emission; /* owned text */
    size_t removed;           /* divisions that cancelled: singularities of the genome that the code does not have */
};

/** Sum of the costs of all operations. */
double operations_cost(const struct operations *ops, const struct cost_model *m);

/** False with *d filled, and no text, when the genome divides by 0 everywhere or needs a constant that is no double. */
bool compile_genome(const struct genome_file *f, const struct genome *genome, const struct compile_options *o,
                    struct compiled *c, struct diag *d);

/** Throughput model, seed 1, the default effort, nothing explained. */
struct compile_options compile_defaults(void);

#endif
