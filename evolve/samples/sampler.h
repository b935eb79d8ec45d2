/* Draws the samples of a part of a scene one at a time, so that a million can be measured and none is stored.  A random sample
 * depends only on the seeds of the scene and of the run, the part and the sample's number.  A sample can also be drawn from
 * given random numbers; evolve/write/climb.h finds the neighbours of a sample in this way. */
#ifndef FOOTPOINT_SAMPLER_H
#define FOOTPOINT_SAMPLER_H

#include "../common/stream.h"
#include "source.h"

/** Opens a part of a scene.  Returns NULL with *d filled if the part has no samples. */
struct sampler *sampler_new(const struct scene *scene, enum sample_part part, struct diag *d);
void sampler_free(struct sampler *p);

/** Draws sample i < p->count.  Returns false with *d filled if no draw makes a sample. */
bool sampler_take(struct sampler *p, size_t i, struct sample *s, struct diag *d);

/** Records the random numbers from which sample i is drawn. Sample i must not be listed. */
void sampler_record(struct sampler *p, size_t i, struct stream_tape *tape);
/** Draws a sample from recorded or changed numbers. Returns false if these yield no sample. */
bool sampler_play(struct sampler *p, struct stream_tape *tape, struct sample *s);

/** The held-out parts of a scene. */
struct heldout {
    struct sampler *part[HELDOUT_PARTS];   /* owned; indexed as heldout_part[]; NULL if the scene lacks the part */
    char drawn[DRAWN_LINES][DRAWN_LENGTH]; /* how the samples are drawn, in words for banners */
    size_t lines;                          /* number of lines in `drawn` */
};
void heldout_free(struct heldout *h);

#endif
