/* Sources of samples: shapes, meshes, lattices, smooth bodies. Only files of this room use it. */
#ifndef FOOTPOINT_SOURCE_H
#define FOOTPOINT_SOURCE_H

#include "../input/scene.h"
#include "../surface/surface.h"

#include <gsl/gsl_rng.h>

/** An open part of a scene; see sampler.h. */
struct sampler {
    const struct scene *scene; /* not owned */
    enum sample_part part;
    size_t count;             /* samples of the part */
    struct sample_set listed; /* owned; the first samples, which are not drawn: a grid, or a mesh's own nodes */
    gsl_rng *stream;          /* owned */
    bool (*draw)(const struct sampler *p, struct sample *s); /* draws once; returns false to draw again */
    struct mesh *mesh;                                       /* owned; NULL unless the scene has a mesh */
    struct smooth_mesh **body;                               /* owned; NULL unless the scene has smooth bodies */
};

/** Below this number of mesh nodes over master faces, errors are measured on random nodes. */
enum { MESH_FEW = 1000 };

/** PART_HELDOUT_EVEN only compares means and 99 % errors, for which these suffice. */
enum { EVEN_MOST = 50000 };

/** Returns how many samples of a part are drawn at random. */
static inline size_t samples_wanted(const struct scene *s, enum sample_part part)
{
    switch (part) {
    case PART_TRAINING:
        return s->training;
    case PART_TRAINING_RANDOM:
        return s->lattice.random;
    case PART_VALIDATION:
        return s->training + s->lattice.random;
    case PART_HELDOUT_EVEN:
        return s->heldout < EVEN_MOST ? s->heldout : EVEN_MOST;
    case PART_HELDOUT:
    case PART_HELDOUT_RANDOM:
        break;
    }
    return s->heldout;
}

/** Sets p->listed and p->draw. Segments with normals lie on smooth bodies, or on the lattice with random normals. On
 *  the lattice's grid `training` and `heldout` include samples that are omitted because their foot point is not in the
 *  box. */
bool lattice_prepare(struct sampler *p, struct diag *d);
bool mesh_prepare(struct sampler *p, struct diag *d);
bool patches_prepare(struct sampler *p, struct diag *d);
bool shapes_draw(const struct sampler *p, struct sample *s);
/** lattice_grid appends the part's configurations on the lattice's grid; lattice_draw draws a configuration off the
 *  grid. */
bool lattice_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool lattice_draw(const struct sampler *p, struct sample *s);

/** Writes how held-out samples are drawn, in words for banners. Returns the number of lines. */
size_t lattice_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t shapes_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t mesh_drawn(const struct scene *scene, size_t real, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);

/** Draws a segment about the origin, with edges of length about 2, within the limits of the shapes: bilinear
 *  (random_quads.c), or with shape functions of degree up to 2 in xi and in eta (random_faces.c). Returns false to draw
 *  again. */
bool draw_quad(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);
bool draw_face(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);

/** Draws a slave node of segment s->x: s->xs = r(xi,eta) + gap n with (xi,eta) uniform in the scene's box, labelled
 *  with its certain foot point. Returns false, to draw again, if another point of the box is nearer.
 *  @param[in] least, most  |gap|, mesh length: uniform logarithm, random sign; if least is 0, gap is uniform */
bool place_slave(gsl_rng *stream, const struct scene *scene, double least, double most, struct sample *s);

/** Rounds the coordinates of a sample to float and computes its foot point again. Returns false if the foot point has
 *  left the scene's box by more than rounding. */
bool sample_round(const struct scene *scene, struct sample *s);

/** Renumbers corners and foot point: A becomes the corner nearest to the slave node (the first of equals).
 *  CORNERS_NEAREST_SHORTER also requires |AD| <= |AB|, which may exchange xi and eta and so turn the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
