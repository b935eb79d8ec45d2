/* The samples of a scene, drawn and labelled with their certain foot points: one at a time, so that a million can be measured
 * and none is stored, or all of a part.  A random sample depends only on the seeds of the scene and of the run, the part and the
 * sample's number.  A sample can also be drawn from given random numbers; evolve/write/climb.c finds the neighbours of a sample in
 * this way. */
#ifndef FOOTPOINT_SAMPLES_H
#define FOOTPOINT_SAMPLES_H

#include "../common/stream.h"
#include "../input/scene.h"
#include "../surface/surface.h"

/** An open part of a scene. */
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

/** Returns true if a scene has the part. PART_HELDOUT_RANDOM exists only for lattices, PART_HELDOUT_EVEN only for
 *  shapes. */
bool scene_has(const struct scene *s, enum sample_part part);

/** Appends all samples of a part to *set. Coordinates are numbers of the scene's precision. Samples depend only on the
 *  scene and its run. Returns false with *d filled if there are no samples. */
bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d);

/** Opens the held-out parts of a scene.  Returns false with *d filled; *h must be freed in either case. */
bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d);

/** Below this number of mesh nodes over master faces, errors are measured on random nodes. */
enum { MESH_FEW = 1000 };

/* ---- sources: shapes, meshes, lattices, smooth bodies; only for this room and its tests ---- */

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
bool shapes_prepare(struct sampler *p, struct diag *d);
/** lattice_grid appends the part's configurations on the lattice's grid; lattice_draw draws a configuration off the
 *  grid. */
bool lattice_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d);
bool lattice_draw(const struct sampler *p, struct sample *s);

/** Writes how held-out samples are drawn, in words for banners. Returns the number of lines. */
size_t lattice_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t shapes_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t mesh_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH]);
size_t patches_drawn(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH]);

/** Frees the meshes of smooth bodies; NULL is harmless. */
void smooth_free(struct smooth_mesh **mesh);

/** Returns a number that is uniform in -max..max. */
double draw_uniform(gsl_rng *stream, double max);

/** Draws a segment about the origin, with edges of length about 2, within the limits of the shapes: bilinear
 *  (random_quads.c), or with shape functions of degree up to 2 in xi and in eta (random_faces.c). Returns false to draw
 *  again. */
bool draw_quad(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);
bool draw_face(const struct surface *f, gsl_rng *stream, const struct shapes *shapes, double (*x)[3]);

/** Draws a slave node of segment s->x: s->xs = r(xi,eta) + gap n with (xi,eta) uniform in the scene's box, labelled
 *  with its certain foot point. Returns false, to draw again, if another point of the box is nearer.
 *  @param[in] least, most  |gap|, mesh length: uniform logarithm, random sign; if least is 0, gap is uniform */
bool place_slave(gsl_rng *stream, const struct scene *scene, double least, double most, struct sample *s);

/** Renumbers corners and foot point: A becomes the corner nearest to the slave node (the first of equals).
 *  CORNERS_NEAREST_SHORTER also requires |AD| <= |AB|, which may exchange xi and eta and so turn the normal. */
void sample_order(struct sample *s, enum corner_order order);

#endif
