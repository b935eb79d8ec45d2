/* Samples one at a time; see sampler.h. A draw that yields no sample is repeated with the next numbers of its
 * stream. */
#include "sampler.h"

#include "../input/mesh.h"
#include "body_samples.h"
#include "source.h"

#include <stdlib.h>
#include <string.h>

enum { TRIES = 1000000 };

static bool is_float(const struct scene *scene)
{
    return strcmp(scene->precision, "float") == 0;
}

static bool prepare(struct sampler *p, struct diag *d)
{
    if (*p->scene->segment->normals)
        return patches_prepare(p, d);
    switch (p->scene->source) {
    case SOURCE_LATTICE:
        return lattice_prepare(p, d);
    case SOURCE_RANDOM:
        p->draw = shapes_draw;
        return true;
    case SOURCE_MESH:
        break;
    }
    return mesh_prepare(p, d);
}

/* Rounds the listed samples to float and removes samples that no longer have a foot point in the box. */
static void round_listed(struct sampler *p)
{
    struct sample_set *set = &p->listed;
    size_t kept = 0, real = 0;
    for (size_t i = 0; i < set->n; i++) {
        struct sample s = set->s[i];
        if (!sample_round(p->scene, &s))
            continue;
        set->s[kept++] = s;
        real += i < set->real;
    }
    set->n = kept;
    set->real = real;
}

struct sampler *sampler_new(const struct scene *scene, enum sample_part part, struct diag *d)
{
    struct sampler *p = new_array(1, sizeof *p);
    *p = (struct sampler){.scene = scene, .part = part, .stream = stream_new()};
    bool good = prepare(p, d);
    if (good && is_float(scene))
        round_listed(p);
    p->count = p->draw ? samples_wanted(scene, part) : 0;
    if (p->count < p->listed.n)
        p->count = p->listed.n;
    if (good && p->count == 0)
        good = diag_at(d, scene->path, 0, 0, "no sample is left %s",
                       is_float(scene) ? "once coordinates are rounded to float"
                                       : "to hold out: all are mirror images of training samples");
    if (good)
        return p;
    sampler_free(p);
    return NULL;
}

void sampler_free(struct sampler *p)
{
    if (!p)
        return;
    sample_set_free(&p->listed);
    gsl_rng_free(p->stream);
    mesh_free(p->mesh);
    smooth_free(p->body);
    free(p);
}

static void key(const struct sampler *p, uint64_t i)
{
    const bool seen = p->part == PART_TRAINING || p->part == PART_TRAINING_RANDOM || p->part == PART_VALIDATION;
    const uint64_t run = seen ? 0 : p->scene->run - 1;
    stream_key(p->stream, p->scene->seed, (uint64_t)p->part, i, 2 * run + (p->mesh != NULL));
}

/* Draws until a sample results. *s must be 0 or the result of an earlier draw. */
static bool draw(struct sampler *p, struct sample *s)
{
    return p->draw(p, s) && (!is_float(p->scene) || sample_round(p->scene, s));
}

bool sampler_take(struct sampler *p, size_t i, struct sample *s, struct diag *d)
{
    if (i < p->listed.n) {
        *s = p->listed.s[i];
        return true;
    }
    key(p, i - p->listed.n);
    *s = (struct sample){0};
    for (int n = 0; n < TRIES; n++)
        if (draw(p, s))
            return true;
    return diag_at(d, p->scene->path, 0, 0, "no sample within the scene's limits in %d draws", (int)TRIES);
}

void sampler_record(struct sampler *p, size_t i, struct stream_tape *tape)
{
    struct sample s = {0};
    key(p, i - p->listed.n);
    do {
        tape->n = 0;
        stream_play(p->stream, tape);
    } while (!draw(p, &s));
    stream_play(p->stream, NULL);
}

bool sampler_play(struct sampler *p, struct stream_tape *tape, struct sample *s)
{
    key(p, UINT64_MAX);
    stream_play(p->stream, tape);
    *s = (struct sample){0};
    const bool drawn = draw(p, s);
    stream_play(p->stream, NULL);
    return drawn;
}

void heldout_free(struct heldout *h)
{
    for (int part = 0; part < HELDOUT_PARTS; part++)
        sampler_free(h->part[part]);
    *h = (struct heldout){.lines = 0};
}
