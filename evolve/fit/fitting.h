/* How islands call fits of constants; who provides them fills in the functions. */
#ifndef FOOTPOINT_FITTING_H
#define FOOTPOINT_FITTING_H

#include "../genotype/tree.h"

struct fits;

struct fitting {
    struct fits *fits; /* not owned */
    /** A tree of at most max_length genes whose root terms have the coefficients of least squares against table column
     *  `target`, into *out; false, with *out undefined, where there is none.  Deterministic in its arguments. */
    bool (*root_terms)(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out);
    /** The same tree with its constants fitted by a few iterations; for children. */
    bool (*tune)(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out);
    /** The same with more iterations, if that is better; for members of the front. */
    bool (*constants)(struct fits *f, const struct tree *in, size_t target, size_t max_length, struct tree *out);
    /** A changed copy of a program; may fail, with *child undefined. */
    bool (*change)(struct fits *f, gsl_rng *rng, const struct gene_set *genes, const struct tree *t,
                   const struct tree *mate, size_t target, size_t max_length, struct tree *child);
};

#endif
