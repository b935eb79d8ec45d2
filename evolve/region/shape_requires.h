/* The region of segments that are described by their shape. */
#ifndef FOOTPOINT_SHAPE_REQUIRES_H
#define FOOTPOINT_SHAPE_REQUIRES_H

#include "../../codegen/genome/genome.h"
#include "../surface/sample.h"

/** Adds the kind's region block. The survey then measures the ranges of its numbers on samples, and three requires for
 *  each intermediate value. The value stays within twice its largest distance from a multiple of xi, eta or a value
 *  foot_... of the block; the factor is a power of 2 times a power of 3. If that bounds little, its modulus stays below
 *  twice the largest on the samples. If it has a sign, its modulus stays above half the smallest. Returns NULL, and
 *  adds nothing, if the kind has no such block. */
struct shape_survey *shape_survey_new(struct genome_file *f);
void shape_survey_take(struct shape_survey *s, const struct sample *sample, size_t n);
/** Adds the ranges and requires, and frees the survey. */
void shape_survey_add(struct shape_survey *s);

#endif
