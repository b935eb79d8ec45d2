/* Held-out samples, measured as they are drawn; see measure.h. */
#include "measure.h"

#include "../eval/frame.h"
#include "../region/sampled_region.h"

#include <stdlib.h>
#include <string.h>

bool heldout_piece(struct sampler *p, size_t most, size_t *at, struct sample *s, size_t *n, struct diag *d)
{
    const size_t end = p->count < most ? p->count : most;
    for (*n = 0; *n < HELDOUT_PIECE && *at < end; ++*n, ++*at)
        if (!sampler_take(p, *at, &s[*n], d))
            return false;
    return true;
}

/* Measures all samples of a part, and the region unless it is NULL. */
static bool take_part(struct measurement *m, struct sampler *p, size_t most, struct region_survey *region,
                      struct diag *d)
{
    struct sample *s = new_array(HELDOUT_PIECE, sizeof *s);
    size_t at = 0, n;
    bool good;
    while ((good = heldout_piece(p, most, &at, s, &n, d)) && n > 0) {
        measurement_take(m, s, n);
        if (region)
            region_survey_take(region, s, n);
    }
    free(s);
    return good;
}

static bool measure_part(const struct genome_file *f, struct measured *m, int part, const struct heldout *heldout,
                         size_t most, size_t outs, struct region_survey *region, struct diag *d)
{
    struct sampler *p = heldout->part[part];
    struct errors *found = m->found[part] = arena_array(&m->memory, m->n, sizeof *found);
    struct measurement all = measurement_open(f, m->t, m->output, m->n, p->count);
    double *worst = arena_array(&m->memory, m->n, sizeof *worst);
    const bool good = take_part(&all, p, most, p->part == PART_HELDOUT_EVEN ? NULL : region, d);
    for (size_t i = 0; i < m->n && good && outs == 2 && climb_can(p) && most == SIZE_MAX; i += outs)
        climb(p, &all, i, outs, worst + i, NULL, NULL);
    measurement_close(&all, found);
    for (size_t i = 0; i < m->n; i++)
        found[i].climbed = worst[i];
    return good;
}

static void list_outputs(const struct genome_file *f, size_t outs, struct measured *m)
{
    m->t = arena_array(&m->memory, 2 * f->genomes, sizeof *m->t);
    m->output = arena_array(&m->memory, 2 * f->genomes, sizeof *m->output);
    for (size_t g = 0; g < f->genomes; g++)
        for (size_t k = 0; k < outs && f->genome[g].outs == outs; k++) {
            const struct genome_expr *e = &f->genome[g].out[k];
            m->t[m->n] = (struct genes){e->gene, e->length};
            m->output[m->n++] = strcmp(e->name, frame_output[0]) != 0;
        }
}

bool measure_genomes(struct genome_file *f, size_t outs, const struct heldout *heldout, size_t most, struct measured *m,
                     struct diag *d)
{
    struct region_survey *region = region_survey_new(f);
    bool good = true;
    *m = (struct measured){.n = 0};
    list_outputs(f, outs, m);
    for (int part = 0; part < HELDOUT_PARTS && good; part++)
        if (heldout->part[part])
            good = measure_part(f, m, part, heldout, most, outs, region, d);
    region_survey_add(region);
    return good;
}

bool measure_climbed(const struct genome_file *f, struct sampler *p, bool single,
                     void (*found)(void *to, const struct sample *s), void *to, struct diag *d)
{
    struct measured m = {.n = 0};
    double worst[2];
    list_outputs(f, 2, &m);
    struct measurement all = measurement_open(f, m.t, m.output, m.n, p->count);
    all.single = single;
    const bool good = take_part(&all, p, SIZE_MAX, NULL, d);
    for (size_t i = 0; i < m.n && good; i += 2)
        climb(p, &all, i, 2, worst, found, to);
    measurement_close(&all, arena_array(&m.memory, m.n, sizeof(struct errors)));
    arena_free(&m.memory);
    return good;
}
