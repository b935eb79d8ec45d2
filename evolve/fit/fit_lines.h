/* Fits the numbers of a program by GSL's Levenberg-Marquardt method. */
#ifndef FOOTPOINT_FIT_LINES_H
#define FOOTPOINT_FIT_LINES_H

#include "../eval/lines_run.h"
#include "../input/scene.h"

/** Copies a program and fits its numbers, except those that are part of the structure, to the run's table. The norm of
 *  both coordinates' errors is approached by a sequence of losses, each with this many iterations. Returns false, with
 *  *out undefined, if there is no number to fit or a value is not finite.
 *  @param[in] last  function that the program ends in, or -1 */
bool lines_fit(struct lines_run *r, const struct genes *in, int last, enum scene_norm norm, int iterations,
               struct genes *out);

#endif
