/* The samples of a scene, drawn and labelled with their certain foot points: one function for each kind of source. */
#ifndef FOOTPOINT_SAMPLES_H
#define FOOTPOINT_SAMPLES_H

#include "../input/scene.h"
#include "../surface/surface.h"

#include <gsl/gsl_rng.h>

/** Fewer nodes of a mesh over its faces say little: errors are those of random nodes. */
enum { MESH_FEW = 1000 };

/** False for PART_HELDOUT_EVEN of scenes that have none, and for PART_HELDOUT_RANDOM of meshes, whose held-out samples are
 *  real and random. */
bool scene_has(const struct scene *s, enum sample_part part);

/** Append the part's samples, of a part that the scene has, to *set; their coordinates are numbers of the scene's
 *  precision.  Deterministic in the scene alone.  False with *d filled when none is left. */
bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d);

/** All parts held out that the scene has.  False with *d filled; then, too, to be freed. */
bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d);

/* ---- for the files of this room ---- */

/** How many samples of a part are drawn at random. */
static inline size_t samples_wanted(const struct scene *s, enum sample_part part)
{
    switch (part) {
    case PART_TRAINING:
        return s->training;
    case PART_TRAINING_RANDOM:
        return s->lattice.random;
    case PART_VALIDATION:
        return s->training + s->lattice.random;
    case PART_HELDOUT:
    case PART_HELDOUT_RANDOM:
    case PART_HELDOUT_EVEN:
        break;
    }
    return s->heldout;
}

bool lattice_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool shapes_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool mesh_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);

/** How each draws the parts held out, in words for banners: lines of text, as many as it returns. */
size_t lattice_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t shapes_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t mesh_drawn(const struct scene *scene, size_t real, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);

/** Of segments with normals: the lattice with random ones, where `training` and `heldout` count samples before those
 *  are left out whose foot point is not in the box, or smooth bodies. */
bool patches_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);

/** A random segment about the origin, edges of length about 2, in the limits of the shapes: bilinear (random_quads.c),
 *  or of shape functions of degree up to 2 in xi and in eta (random_faces.c).  False: draw again. */
bool draw_quad(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);
bool draw_face(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);

/** A random slave node of segment s->x: s->xs = r(xi,eta) + gap n with (xi,eta) uniform in the scene's box, labelled with
 *  its certain foot point.  False, to be drawn again, when another point of the box is nearer.
 *  @param[in] least, most  |gap|, mesh length: its logarithm is uniform and its sign random; least 0: gap is uniform */
bool place_slave(gsl_rng *stream, const struct scene *scene, double least, double most, struct sample *s);

/** Round the coordinates of samples `first` and on to float, and find their foot points anew.  Those leave that have
 *  none in the scene's box any more, but for rounding. */
void samples_round(const struct scene *scene, struct sample_set *set, size_t first);

/** Renumber the corners as the order says, and the foot point with them: A becomes the corner nearest to the slave
 *  node (the first of equals), for CORNERS_NEAREST_SHORTER with |AD| <= |AB|, which may exchange xi and eta and so turn
 *  the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
