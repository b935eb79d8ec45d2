/* Samples on meshes of smooth bodies, as contact searches on smoothed surfaces meet them. */
#ifndef FOOTPOINT_BODY_SAMPLES_H
#define FOOTPOINT_BODY_SAMPLES_H

#include "../surface/patch.h"
#include "../surface/sample.h"

#include <gsl/gsl_rng.h>
#include <stdint.h>

struct smooth_mesh;
/** Returns meshes of all bodies; the caller must free them. */
struct smooth_mesh **smooth_new(uint64_t seed);
void smooth_free(struct smooth_mesh **mesh);

/** Draws a body, one of its meshes, a segment, and a slave node over it, with the mesh's node normals. The foot point
 *  is the patch's certain closest point. Returns false, to be drawn again, if another point is nearer or the search
 *  cannot decide.
 *  @param[in] gap  |gap| over the shortest edge, 0..gap */
bool smooth_draw(gsl_rng *stream, struct smooth_mesh *const *mesh, double gap, enum patch_kind kind, struct sample *s);

struct smooth {
    uint64_t seed;
    double gap; /* |gap| over the shortest edge, 0..gap */
    enum patch_kind kind;
};

/** Appends `count` such samples of the part. They depend only on seed, gap, kind and part; different parts share no
 *  sample. */
void smooth_samples(const struct smooth *smooth, enum sample_part part, size_t count, struct sample_set *set);

/** Writes how the samples are drawn, like lattice_drawn (source.h). Returns the number of lines. */
size_t smooth_drawn(char line[DRAWN_LINES][DRAWN_LENGTH]);

#endif
