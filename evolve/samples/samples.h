/* Where the samples of a scene come from: one function for each kind of source; scene_samples (scene.h) dispatches. */
#ifndef FOOTPOINT_SAMPLES_H
#define FOOTPOINT_SAMPLES_H

#include "../input/scene.h"

#include <gsl/gsl_rng.h>

bool lattice_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool shapes_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool mesh_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);

/** What each draws, in words: scene_drawn (scene.h). */
size_t lattice_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t shapes_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t mesh_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);

/** Of segments with normals: the lattice with random ones, where `training` and `heldout` count samples before those
 *  are left out whose foot point is not in the box, or smooth bodies. */
bool patches_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);

/** A random slave node of segment s->x: s->xs = r(xi,eta) + gap n with (xi,eta) uniform in the scene's box and gap
 *  uniform in -gap..gap (mesh length), labelled with its certain foot point.  False, to be drawn again, when another
 *  point of the box is nearer. */
bool place_slave(gsl_rng *stream, const struct scene *scene, double gap, struct sample *s);

/** Round the coordinates of samples `first` and on to float, and find their foot points anew.  Those leave that have
 *  none in the scene's box any more, but for rounding. */
void samples_round(const struct scene *scene, struct sample_set *set, size_t first);

/** Renumber the corners as the order says, and the foot point with them: A becomes the corner nearest to the slave
 *  node (the first of equals), for CORNERS_NEAREST_SHORTER with |AD| <= |AB|, which may exchange xi and eta and so turn
 *  the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
