/* Samples of a part of a scene, drawn one at a time, so that as many can be measured as one likes and none needs to be kept.
 * Random samples follow from the scene's seed, that of the run, the part and their number alone; they may also be drawn from
 * given random numbers, which is how a sample's neighbours are found (evolve/write/climb.h). */
#ifndef FOOTPOINT_SAMPLER_H
#define FOOTPOINT_SAMPLER_H

#include "../common/stream.h"
#include "source.h"

/** A sampler of a part that the scene has.  NULL with *d filled: there are no samples. */
struct sampler *sampler_new(const struct scene *scene, enum sample_part part, struct diag *d);
void sampler_free(struct sampler *p);

/** Draws sample i of `count`.  False with *d filled if none is found. */
bool sampler_take(struct sampler *p, size_t i, struct sample *s, struct diag *d);

/** Records the random numbers that sample i, which is not listed, is drawn from. */
void sampler_record(struct sampler *p, size_t i, struct stream_tape *tape);
/** Draws a sample from these.  Returns false if they make none. */
bool sampler_play(struct sampler *p, struct stream_tape *tape, struct sample *s);

/** The parts that a scene holds out; read one at a time. */
struct heldout {
    struct sampler *part[HELDOUT_PARTS];   /* owned, as heldout_part[]; NULL where the scene has none */
    char drawn[DRAWN_LINES][DRAWN_LENGTH]; /* how they are drawn, in words for banners */
    size_t lines;                          /* of `drawn` */
};
void heldout_free(struct heldout *h);

#endif
