/* Samples on meshes of smooth bodies: what a contact search on smoothed surfaces meets. */
#ifndef FOOTPOINT_BODY_SAMPLES_H
#define FOOTPOINT_BODY_SAMPLES_H

#include "../surface/patch.h"
#include "../surface/sample.h"

#include <gsl/gsl_rng.h>
#include <stdint.h>

struct smooth_mesh;
/** The meshes of all bodies; to be freed. */
struct smooth_mesh **smooth_new(uint64_t seed);
void smooth_free(struct smooth_mesh **mesh);

/** A body, one of its meshes, a segment and a slave node over it at random, with the node normals of the mesh.  The foot point
 *  is the patch's certain closest point.  False: draw again, for another point is nearer, or it cannot be told.
 *  @param[in] gap  |gap| over the shortest edge, 0..gap */
bool smooth_draw(gsl_rng *stream, struct smooth_mesh *const *mesh, double gap, enum patch_kind kind, struct sample *s);

struct smooth {
    uint64_t seed;
    double gap; /* |gap| over the shortest edge, 0..gap */
    enum patch_kind kind;
};

/** Append `count` such samples of the part.  Deterministic in seed, gap, kind and part; different parts share no sample. */
void smooth_samples(const struct smooth *smooth, enum sample_part part, size_t count, struct sample_set *set);

/** How these are drawn, as lattice_drawn (samples.h) says it. */
size_t smooth_drawn(char line[DRAWN_LINES][DRAWN_LENGTH]);

#endif
