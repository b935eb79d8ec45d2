/* The samples of a scene, drawn and labelled with their certain foot points: one function for each kind of source. */
#ifndef FOOTPOINT_SAMPLES_H
#define FOOTPOINT_SAMPLES_H

#include "sampler.h"

/** False for PART_HELDOUT_EVEN of scenes that have none, and for PART_HELDOUT_RANDOM of all but lattices. */
bool scene_has(const struct scene *s, enum sample_part part);

/** Append the part's samples, of a part that the scene has, to *set; their coordinates are numbers of the scene's
 *  precision.  Deterministic in the scene alone.  False with *d filled when none is left. */
bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d);

/** For who keeps them all: holds out 200,000 samples of a part at most. */
void scene_hold_out_less(struct scene *s);

/** Opens the parts held out that the scene has.  False with *d filled; then, too, to be freed. */
bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d);

#endif
