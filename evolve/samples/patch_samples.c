/* Gregory and Bezier patches as segments: the vectors of a sample are corners and node normals. */
#include "../surface/foot_patch.h"
#include "../surface/surface.h"
#include "body_samples.h"
#include "lattice_normals.h"
#include "source.h"

/* Returns how many configurations make `samples` samples. */
static size_t configurations(const struct lattice *l, size_t samples)
{
    const size_t sets = (size_t)l->normal_sets;
    return (samples + sets - 1) / sets;
}

static enum patch_kind kind_of(const struct scene *scene)
{
    return surface_find(scene->segment)->patch;
}

static bool on_the_grid(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d)
{
    struct scene facets = *scene;
    facets.training = configurations(&scene->lattice, scene->training);
    const struct lattice_gregory plan = {&facets,
                                         part == PART_HELDOUT ? configurations(&scene->lattice, scene->heldout) : 0,
                                         scene->lattice.normal_sets, scene->lattice.tilt, kind_of(scene)};
    return lattice_gregory_samples(&plan, part, set, NULL, d) &&
           (set->n > 0 || diag_at(d, scene->path, 0, 0, "no sample's foot point lies in the box"));
}

/* Draws a configuration off the grid, with one set of normals. */
static bool draw_facet(const struct sampler *p, struct sample *s)
{
    double lo[2], hi[2];
    if (!lattice_draw(p, s))
        return false;
    draw_normals(p->stream, p->scene->lattice.tilt, s);
    scene_box(p->scene, lo, hi);
    return foot_patch(kind_of(p->scene), s, lo, hi, (double[]){s->xi, s->eta});
}

static bool draw_body(const struct sampler *p, struct sample *s)
{
    return smooth_draw(p->stream, p->body, p->scene->shapes.gap, kind_of(p->scene), s);
}

size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    if (scene->source != SOURCE_LATTICE)
        return smooth_drawn(line);
    const size_t lines = lattice_drawn(scene, line);
    snprintf(line[lines], DRAWN_LENGTH,
             "normals at each corner: tilt uniform in a disc, %d sets a configuration of the grid",
             scene->lattice.normal_sets);
    return lines + 1;
}

bool patches_prepare(struct sampler *p, struct diag *d)
{
    if (p->scene->source != SOURCE_LATTICE) {
        p->body = smooth_new(p->scene->seed);
        p->draw = draw_body;
    } else if (p->part == PART_TRAINING || p->part == PART_HELDOUT)
        return on_the_grid(p->scene, p->part, &p->listed, d);
    else
        p->draw = draw_facet;
    return true;
}
