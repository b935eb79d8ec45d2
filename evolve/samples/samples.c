/* The samples of a scene from any source; see samples.h. */
#include "samples.h"

bool scene_has(const struct scene *s, enum sample_part part)
{
    if (part == PART_HELDOUT_RANDOM)
        return s->source == SOURCE_LATTICE;
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
    struct sampler *p = sampler_new(s, part, d);
    bool drawn = p != NULL;
    for (size_t i = 0; drawn && i < p->count; i++) {
        struct sample one;
        drawn = sampler_take(p, i, &one, d);
        if (drawn)
            sample_set_add(set, &one);
    }
    set->real += drawn ? p->listed.real : 0;
    sampler_free(p);
    return drawn;
}

void scene_hold_out_less(struct scene *s)
{
    enum { MOST = 200000 };
    s->heldout = s->heldout < MOST ? s->heldout : MOST;
}

bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d)
{
    bool good = true;
    for (int k = 0; k < HELDOUT_PARTS && good; k++)
        good = !scene_has(s, heldout_part[k].part) || (h->part[k] = sampler_new(s, heldout_part[k].part, d));
    h->lines = good ? scene_drawn(s, h->part[0]->listed.real, h->drawn) : 0;
    return good;
}
