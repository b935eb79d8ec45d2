/* Held-out samples as text, for who measures code on them: footpoint-codegen --samples. */
#ifndef FOOTPOINT_SAMPLES_WRITE_H
#define FOOTPOINT_SAMPLES_WRITE_H

#include "../input/scene.h"

/** Writes CSV: the line "part,<inputs of the segment>,xi,eta", then one for each sample, the part heldout,
 *  heldout_random or heldout_even, the numbers hexadecimal and exact.  `scene` as for scene_read.
 *  @param[in] run  seed of the run that holds them out */
bool samples_write(const char *root, const char *scene, size_t run, const char *path, struct diag *d);

#endif
