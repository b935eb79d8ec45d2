/* Trains perceptrons: least squares of both outputs' errors over samples, by GSL's Levenberg-Marquardt method. */
#ifndef FOOTPOINT_PERCEPTRON_TRAIN_H
#define FOOTPOINT_PERCEPTRON_TRAIN_H

#include "../../../evolve/common/columns.h"
#include "perceptron.h"

/** Samples to train with. */
struct lesson {
    const struct columns *table; /* not owned */
    const size_t *input;         /* not owned: columns of the network's inputs */
    size_t target[2];            /* columns of its outputs */
    size_t n;                    /* the first n rows of the table */
};

/** Improves the weights by at most so many steps, until a step gains nothing.  Deterministic: the result does not depend on
 *  vectors or load.  Returns the root of the mean square error. */
double perceptron_train(const struct perceptron *p, const struct lesson *lesson, size_t iterations, double *weight);

#endif
