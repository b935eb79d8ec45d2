/* The sources of samples: how each prepares a sampler, and draws; for the files of this room. */
#ifndef FOOTPOINT_SOURCE_H
#define FOOTPOINT_SOURCE_H

#include "../input/scene.h"
#include "../surface/surface.h"

#include <gsl/gsl_rng.h>

/** What samples of a part are taken from (sampler.h). */
struct sampler {
    const struct scene *scene; /* not owned */
    enum sample_part part;
    size_t count;             /* of samples */
    struct sample_set listed; /* owned: the first ones, which are not drawn: grids, nodes of meshes */
    gsl_rng *stream;          /* owned */
    bool (*draw)(const struct sampler *p, struct sample *s); /* once; false: draw again */
    struct mesh *mesh;                                       /* owned; of a scene of a mesh */
    struct smooth_mesh **body;                               /* owned; of a scene of smooth bodies */
};

/** Fewer nodes of a mesh over its faces say little: errors are those of random nodes. */
enum { MESH_FEW = 1000 };

/** Mean and 99 % of another distribution, all that PART_HELDOUT_EVEN is for, need no more. */
enum { EVEN_MOST = 50000 };

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
    case PART_HELDOUT_EVEN:
        return s->heldout < EVEN_MOST ? s->heldout : EVEN_MOST;
    case PART_HELDOUT:
    case PART_HELDOUT_RANDOM:
        break;
    }
    return s->heldout;
}

/** Prepare a sampler of each source: what is listed, and how the rest is drawn.  Segments with normals are of smooth bodies,
 *  or of the lattice with random normals, where `training` and `heldout` count samples before those are left out whose foot
 *  point is not in the box. */
bool lattice_prepare(struct sampler *p, struct diag *d);
bool mesh_prepare(struct sampler *p, struct diag *d);
bool patches_prepare(struct sampler *p, struct diag *d);
bool shapes_draw(const struct sampler *p, struct sample *s);
/** The configurations of the lattice's grid that belong to the part, and a draw off the grid. */
bool lattice_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool lattice_draw(const struct sampler *p, struct sample *s);

/** How each draws the parts held out, in words for banners: lines of text, as many as it returns. */
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

/** Round the coordinates of a sample to float, and find its foot point anew.  False if it has none in the scene's box any
 *  more, but for rounding. */
bool sample_round(const struct scene *scene, struct sample *s);

/** Renumber the corners as the order says, and the foot point with them: A becomes the corner nearest to the slave
 *  node (the first of equals), for CORNERS_NEAREST_SHORTER with |AD| <= |AB|, which may exchange xi and eta and so turn
 *  the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
