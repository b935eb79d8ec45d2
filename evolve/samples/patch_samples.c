/* Gregory and Bezier patches as kinds of segments: the vectors of a sample are corners and node normals. */
#include "../surface/foot_patch.h"
#include "../surface/surface.h"
#include "body_samples.h"
#include "lattice_normals.h"
#include "samples.h"

/* Configurations that make `samples` samples. */
static size_t configurations(const struct lattice *l, size_t samples)
{
    const size_t sets = (size_t)l->normal_sets;
    return (samples + sets - 1) / sets;
}

static bool of_lattice(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d)
{
    struct scene facets = *scene;
    const struct lattice_gregory plan = {&facets, configurations(&scene->lattice, scene->heldout),
                                         scene->lattice.normal_sets, scene->lattice.tilt,
                                         surface_find(scene->segment)->patch};
    const struct lattice_gregory all = {&facets, 0, scene->lattice.normal_sets, scene->lattice.tilt, plan.kind};
    facets.training = configurations(&scene->lattice, scene->training);
    facets.lattice.random = configurations(&scene->lattice, scene->lattice.random);
    facets.heldout = plan.configurations;
    const bool held_out = part == PART_HELDOUT || part == PART_HELDOUT_RANDOM;
    return lattice_gregory_samples(held_out ? &plan : &all, part, set, NULL, d);
}

size_t patches_drawn(const struct scene *scene, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    if (scene->source != SOURCE_LATTICE)
        return smooth_drawn(line);
    const size_t lines = lattice_drawn(scene, line);
    snprintf(line[lines], DRAWN_LENGTH, "normals at each corner: tilt uniform in a disc, %d sets a configuration",
             scene->lattice.normal_sets);
    return lines + 1;
}

bool patches_samples(const struct scene *scene, enum sample_part part, struct sample_set *set, struct diag *d)
{
    const size_t before = set->n;
    bool done = true;
    if (scene->source == SOURCE_LATTICE)
        done = of_lattice(scene, part, set, d);
    else
        smooth_samples(&(struct smooth){scene->seed, scene->shapes.gap, surface_find(scene->segment)->patch}, part,
                       samples_wanted(scene, part), set);
    return done && (set->n > before || diag_at(d, scene->path, 0, 0, "no sample's foot point lies in the box"));
}
