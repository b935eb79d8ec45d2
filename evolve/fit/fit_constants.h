/* Constants inside a tree, fitted to a column of samples by Levenberg and Marquardt's method. */
#ifndef FOOTPOINT_FIT_CONSTANTS_H
#define FOOTPOINT_FIT_CONSTANTS_H

#include "../eval/objective.h"
#include "../eval/tape.h"
#include "normal_equations.h"

/** What is summed over the samples, of the residual r. */
enum loss_kind {
    LOSS_SQUARES,
    LOSS_ABSOLUTE, /* sqrt(r^2 + scale^2) */
    LOSS_POWER,    /* |r / scale|^power: the largest errors count */
    LOSS_MOST /* the same, but for residuals above `scale` hardly anything is lost beyond that: outliers are let go */
};
struct loss {
    enum loss_kind kind;
    double scale;
    int power; /* even */
};

/** Workspace of fits to one table. */
struct fitter {
    const struct columns *table; /* not owned */
    struct tape *tape;           /* owned: the tree that is being fitted */
    double guard; /* > 0: no divisor may change its sign or come nearer to 0 than this fraction of its mean size */
    size_t room;
    struct products products;                    /* owned, as are these: */
    double *panel, *normal, *work, *step, *kept; /* for `room` columns */
    struct divisor *divisor;                     /* owned: by gene */
    size_t gene_room;
};
struct fitter *fitter_new(const struct columns *table);
void fitter_free(struct fitter *f);

/** Loss of the tree on the tape; INFINITY where a value is not finite or a divisor is not guarded. */
double fitter_loss(struct fitter *f, size_t target, const struct loss *loss);
/** Change the tape's constants so that the loss falls, in at most so many iterations; returns it. */
double fitter_descend(struct fitter *f, size_t target, const struct loss *loss, int iterations);
/** The same for a norm: losses that approach it, one after the other, each with so many iterations. */
void fitter_descend_norm(struct fitter *f, size_t target, enum scene_norm norm, int iterations);

/** Copy a tree with its constants fitted in the objective's norm on the fitter's table, which may hold fewer samples
 *  than the objective's.  `out`, with room for as many genes, is the tree itself where none is better; *error is what
 *  the objective says of it.  Returns true if it is better. */
bool fit_constants(struct fitter *f, struct objective *objective, const struct tree *in, size_t target, int iterations,
                   struct tree *out, double *error);

/** A table of every `stride`-th sample of another. */
struct columns columns_thin(const struct columns *all, size_t stride);

#endif
