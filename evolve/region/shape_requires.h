/* The region of segments that are told by their shape. */
#ifndef FOOTPOINT_SHAPE_REQUIRES_H
#define FOOTPOINT_SHAPE_REQUIRES_H

#include "../../codegen/genome/genome.h"
#include "../surface/sample.h"

/** Adds the region block of the kind, with the ranges of its numbers on samples, and requires of the values on the way:
 *  each is as near to a multiple, by powers of 2 and 3, of xi, eta or one of the block's values foot_... as at most twice the
 *  farthest on the samples; or, where that says little, as large as twice the largest there; and as small as half the
 *  smallest, where it has a sign.  NULL if the kind has no such block: nothing is added. */
struct shape_survey *shape_survey_new(struct genome_file *f);
void shape_survey_take(struct shape_survey *s, const struct sample *sample, size_t n);
/** Adds the ranges and requires, and frees the survey. */
void shape_survey_add(struct shape_survey *s);

#endif
