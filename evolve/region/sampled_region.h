/* The region for which a genome file holds, measured on the inputs of the scene's samples. */
#ifndef FOOTPOINT_SAMPLED_REGION_H
#define FOOTPOINT_SAMPLED_REGION_H

#include "../../codegen/genome/genome.h"
#include "../surface/sample.h"

/** Surveys samples piece by piece, for the region that is added at the end. The file must already contain its
 *  genomes. */
struct region_survey *region_survey_new(struct genome_file *f);
void region_survey_take(struct region_survey *s, const struct sample *sample, size_t n);

/** Adds the region and frees the survey: the region of shapes (shape_region.h). Other kinds, and corner orders that depend
 *  on the slave node, get ranges of all inputs, with A at the origin, B = (1,0,0) and the last corner in the x-y plane, y >
 *  0.
 *
 *  They also get requires. A `least` expression of the file that is > 0 on all samples, and made of values that the
 *  genomes use, must be at least half its least value. A quotient, or a value computed from quotients, that does not
 *  change with the segment's size must be at most twice its largest modulus on the samples.
 *
 *  Translation, rotation and scaling do not change the genome's results, so the region covers every similar segment. */
void region_survey_add(struct region_survey *s);

#endif
