/* Held-out samples as text, for who measures code on them: footpoint-codegen --samples. */
#ifndef FOOTPOINT_SAMPLES_WRITE_H
#define FOOTPOINT_SAMPLES_WRITE_H

#include "../input/scene.h"

/** Writes CSV: the line "part,<inputs of the segment>,xi,eta", then one for each sample, the part heldout,
 *  heldout_random or heldout_even, the numbers hexadecimal and exact.  `scene` as for scene_read.  Behind a part, as
 *  heldout_climbing or heldout_random_climbing, those that climbing from the worst samples of genomes ends at, of scenes in float
 *  by errors in float.
 *  @param[in] run      seed of the run that holds them out
 *  @param[in] genomes  path of the genomes to climb with, or NULL */
bool samples_write(const char *root, const char *scene, size_t run, const char *genomes, const char *path,
                   struct diag *d);

#endif
