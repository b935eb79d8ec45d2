/* The samples of a scene, drawn and labelled with their certain foot points. */
#ifndef FOOTPOINT_SAMPLES_H
#define FOOTPOINT_SAMPLES_H

#include "sampler.h"

/** Returns true if a scene has the part. PART_HELDOUT_RANDOM exists only for lattices, PART_HELDOUT_EVEN only for
 *  shapes. */
bool scene_has(const struct scene *s, enum sample_part part);

/** Appends all samples of a part to *set. Coordinates are numbers of the scene's precision. Samples depend only on the
 *  scene and its run. Returns false with *d filled if there are no samples. */
bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d);

/** Limits held-out samples to 200,000 a part, for callers that store them. */
void scene_hold_out_less(struct scene *s);

/** Opens the held-out parts of a scene.  Returns false with *d filled; *h must be freed in either case. */
bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d);

#endif
