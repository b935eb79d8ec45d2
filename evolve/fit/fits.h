/* How islands change programs and fit their numbers, with Levenberg-Marquardt steps. Fits use a part of the samples;
 * results are measured on all. */
#ifndef FOOTPOINT_FITS_H
#define FOOTPOINT_FITS_H

#include "../eval/objective.h"

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

/** Returns fits on an objective, which is not owned. */
struct fits *fits_new(struct objective *objective);
void fits_free(struct fits *f);
struct fitting fits_hooks(struct fits *f);

#endif
