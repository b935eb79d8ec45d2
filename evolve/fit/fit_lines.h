/* Numbers in a program, fitted by GSL's Levenberg-Marquardt method. */
#ifndef FOOTPOINT_FIT_LINES_H
#define FOOTPOINT_FIT_LINES_H

#include "../eval/lines_run.h"
#include "../input/scene.h"

/** Copy a program with its numbers, but for those that stand for a structure, fitted to the run's table in a norm of
 * both coordinates' errors, by losses that approach it, each with so many iterations.  False, with *out undefined, where
 * there is no such number or a value is not finite.
 * @param[in] last  function that it ends in; -1: none */
bool lines_fit(struct lines_run *r, const struct genes *in, int last, enum scene_norm norm, int iterations,
               struct genes *out);

#endif
