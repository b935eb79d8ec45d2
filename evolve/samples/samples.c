/* The samples of a scene, whatever they come from; see samples.h. */
#include "samples.h"

#include <string.h>

static bool draw_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d)
{
    if (*s->segment->normals)
        return patches_samples(s, part, set, d);
    switch (s->source) {
    case SOURCE_LATTICE:
        return lattice_samples(s, part, set, d);
    case SOURCE_RANDOM:
        return shapes_samples(s, part, set, d);
    case SOURCE_MESH:
        break;
    }
    return mesh_samples(s, part, set, d);
}

bool scene_has(const struct scene *s, enum sample_part part)
{
    if (part == PART_HELDOUT_RANDOM)
        return s->source != SOURCE_MESH;
    return part != PART_HELDOUT_EVEN || (s->source == SOURCE_RANDOM && !*s->segment->normals);
}

static size_t scene_drawn(const struct scene *s, size_t real, char line[DRAWN_LINES][DRAWN_LENGTH])
{
    if (*s->segment->normals)
        return patches_drawn(s, line);
    switch (s->source) {
    case SOURCE_LATTICE:
        return lattice_drawn(s, line);
    case SOURCE_RANDOM:
        return shapes_drawn(s, line);
    case SOURCE_MESH:
        break;
    }
    return mesh_drawn(s, real, line);
}

bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d)
{
    const size_t before = set->n;
    if (!draw_samples(s, part, set, d))
        return false;
    const bool rounded = strcmp(s->precision, "float") == 0;
    if (rounded)
        samples_round(s, set, before);
    return set->n > before || diag_at(d, s->path, 0, 0, "no sample is left %s",
                                      rounded ? "once coordinates are rounded to float"
                                              : "to hold out: all are mirror images of training samples");
}

bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d)
{
    bool drawn = true;
    for (int k = 0; k < HELDOUT_PARTS && drawn; k++)
        drawn = !scene_has(s, heldout_part[k].part) || scene_samples(s, heldout_part[k].part, &h->part[k], d);
    h->lines = scene_drawn(s, h->part[0].real, h->drawn);
    return drawn;
}
