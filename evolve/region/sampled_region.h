/* The region that a genome file speaks of: where the inputs of the scene lie. */
#ifndef FOOTPOINT_SAMPLED_REGION_H
#define FOOTPOINT_SAMPLED_REGION_H

#include "../../codegen/genome/genome.h"
#include "../surface/sample.h"

/** Adds the region of shapes (shape_requires.h), or, of other kinds and where the order of corners depends on the slave
 *  node, ranges of all inputs from samples, moved to A at the origin, B = (1,0,0), the last corner in the x-y plane, y >
 *  0; for each expression of the file's `least` lines that is made of what the genomes need, where it is > 0 on all
 *  samples, the require that it is at least half of the least it is there; and for each quotient, or what is made of
 *  quotients, that does not change with the segment's size, local coordinates on the way to the result and the result
 *  itself, the require that it is at most twice as large as it is there.  The genome's expressions do not change under
 *  translation, rotation and scaling, so this covers every segment that is similar to one in that region. */
void scene_region_add(struct genome_file *f, const struct sample_set *set, size_t sets);

/** Survey samples in pieces, then add the region.  The file must have its genomes before. */
struct region_survey *region_survey_new(struct genome_file *f);
void region_survey_take(struct region_survey *s, const struct sample *sample, size_t n);
/** Adds the region and frees the survey. */
void region_survey_add(struct region_survey *s);

#endif
