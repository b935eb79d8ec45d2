/* Sources of samples: shapes, meshes, lattices, smooth bodies.  Used by the files of this room only. */
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
    struct sample_set listed; /* owned; the first samples, which are not drawn: a grid, a mesh's own nodes */
    gsl_rng *stream;          /* owned */
    bool (*draw)(const struct sampler *p, struct sample *s); /* draws once; returns false to draw again */
    struct mesh *mesh;                                       /* owned; NULL unless the scene has a mesh */
    struct smooth_mesh **body;                               /* owned; NULL unless the scene has smooth bodies */
};

/** With fewer mesh nodes over master faces, errors are those of random nodes. */
enum { MESH_FEW = 1000 };

/** PART_HELDOUT_EVEN only compares means and 99 % errors, which need no more samples. */
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

/** Set p->listed and p->draw.  Segments with normals lie on smooth bodies or on the lattice, with random normals; on the
 *  lattice's grid `training` and `heldout` include samples that are left out because their foot point is not in the box. */
bool lattice_prepare(struct sampler *p, struct diag *d);
bool mesh_prepare(struct sampler *p, struct diag *d);
bool patches_prepare(struct sampler *p, struct diag *d);
bool shapes_draw(const struct sampler *p, struct sample *s);
/** Append the part's configurations on the lattice's grid; draw one off the grid. */
bool lattice_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool lattice_draw(const struct sampler *p, struct sample *s);

/** Write how held-out samples are drawn, in words for banners.  Return the number of lines. */
size_t lattice_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t shapes_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t mesh_drawn(const struct scene *scene, size_t real, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH]);

/** A random segment about the origin, edges of length about 2, in the limits of the shapes: bilinear (random_quads.c),
 *  or of shape functions of degree up to 2 in xi and in eta (random_faces.c).  False: draw again. */
bool draw_quad(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);
bool draw_face(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);

/** A random slave node of segment s->x: s->xs = r(xi,eta) + gap n with (xi,eta) uniform in the scene's box, labelled with
 *  its certain foot point.  False, to be drawn again, when another point of the box is nearer.
 *  @param[in] least, most  |gap|, mesh length: its logarithm is uniform and its sign random; least 0: gap is uniform */
bool place_slave(gsl_rng *stream, const struct scene *scene, double least, double most, struct sample *s);

/** Rounds the coordinates of a sample to float and computes its foot point again.  Returns false if the foot point is no longer
 *  in the scene's box, up to rounding. */
bool sample_round(const struct scene *scene, struct sample *s);

/** Renumber the corners as the order says, and the foot point with them: A becomes the corner nearest to the slave
 *  node (the first of equals), for CORNERS_NEAREST_SHORTER with |AD| <= |AB|, which may exchange xi and eta and so turn
 *  the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
