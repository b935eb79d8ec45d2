/* Samples on meshes of smooth bodies: what a contact search on smoothed surfaces meets. */
#ifndef FOOTPOINT_BODY_SAMPLES_H
#define FOOTPOINT_BODY_SAMPLES_H

#include "../surface/patch.h"
#include "../surface/sample.h"

#include <stdint.h>

struct smooth {
    uint64_t seed;
    double gap; /* |gap| over the shortest edge, 0..gap */
    enum patch_kind kind;
};

/** Append `count` samples of the part: a body, one of its meshes, a segment and a slave node over it at random, with
 * the node normals of the mesh.  The foot point is the patch's certain closest point.  Deterministic in seed, gap, kind
 *  and part; different parts share no sample. */
void smooth_samples(const struct smooth *smooth, enum sample_part part, size_t count, struct sample_set *set);

/** How these are drawn, as lattice_drawn (samples.h) says it. */
size_t smooth_drawn(char line[DRAWN_LINES][DRAWN_LENGTH]);

#endif
