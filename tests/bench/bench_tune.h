/* The numbers that a scene determines for rivals before they run; see rivals_tuned.h. */
#ifndef FOOTPOINT_BENCH_TUNE_H
#define FOOTPOINT_BENCH_TUNE_H

#include "../../evolve/input/scene.h"
#include "../../evolve/surface/sample.h"
#include "bench_methods.h"

/** Finds the box of the scene's contact points and, for methods that need it, the starting point of least mean error
 *  (xi and eta) or the coefficients of least squares, on training samples. */
void bench_tune(const struct bench_method *m, const struct scene *scene, const struct sample_set *training,
                struct rival_tuning *t);

#endif
