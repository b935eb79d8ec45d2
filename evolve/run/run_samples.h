/* The samples of a run. */
#ifndef FOOTPOINT_RUN_SAMPLES_H
#define FOOTPOINT_RUN_SAMPLES_H

#include "../samples/samples.h"
#include "../samples/variation.h"
#include "run_parts.h"

struct run_samples {
    struct sample_set training; /* empty after the table is computed */
    struct columns validation;  /* on rank 0, as is: */
    struct heldout heldout;
    struct variation vary; /* of the training samples */
    size_t real;           /* number of slave nodes of a mesh among them */
    bool follows;          /* true if frame and tiers follow from that */
};

/** Draws the training samples, unless they are drawn. */
bool run_draw_training(const struct scene *scene, struct run_samples *s, struct diag *d);

/** Computes the table of training samples and, on rank 0, draws the samples that islands do not see.  A scene that leaves
 *  its tiers to the run trains on the hardest tenth of ten times its samples, and is judged by five times as many. */
bool run_draw_samples(const struct call *call, struct problem *p, struct run_samples *s, struct diag *d);

#endif
