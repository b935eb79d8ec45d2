/* Numbers in a twin tree, fitted by GSL's Levenberg-Marquardt method. */
#ifndef FOOTPOINT_FIT_TWIN_H
#define FOOTPOINT_FIT_TWIN_H

#include "../eval/twin_tape.h"
#include "../input/scene.h"

/** Copy a tree with its numbers fitted to the run's table in a norm of both coordinates' errors, by losses that
 * approach it, each with so many iterations.  False, with *out undefined, where it has no number or a value is not
 * finite. */
bool twin_fit(struct twin_run *r, const struct tree *in, enum scene_norm norm, int iterations, struct tree *out);

#endif
