/* How islands change programs and fit their numbers: functions that the run supplies. */
#ifndef FOOTPOINT_FITTING_H
#define FOOTPOINT_FITTING_H

#include "../genotype/genotype.h"

#include <gsl/gsl_rng.h>

struct fits;

struct fitting {
    struct fits *fits; /* not owned */
    /** Copies a program with its numbers fitted, with more iterations if `thoroughly` is set. Returns false, with *out
     *  undefined, if there is nothing to fit. Deterministic in its arguments. */
    bool (*fit)(struct fits *f, const struct genes *in, int last, bool thoroughly, struct genes *out);
    /** Makes a changed copy. Returns false, with *child undefined, if it fails. */
    bool (*change)(struct fits *f, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                   const struct genes *mate, int last, size_t max_length, struct genes *child);
};

#endif
