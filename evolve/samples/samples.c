/* The samples of a scene from any source; see samples.h. A draw that yields no sample is repeated with the next numbers of
 * its stream. */
#include "samples.h"

#include "../input/mesh.h"

#include <stdlib.h>
#include <string.h>

enum { TRIES = 1000000 };

static bool is_float(const struct scene *scene)
{
    return strcmp(scene->precision, "float") == 0;
}

/* A source of samples: how a part is opened, and how its samples are drawn, in words. */
struct source {
    bool (*prepare)(struct sampler *p, struct diag *d);
    size_t (*drawn)(const struct sampler *p, char line[DRAWN_LINES][DRAWN_LENGTH]);
};

static const struct source *source_of(const struct scene *s)
{
    static const struct source patches = {patches_prepare, patches_drawn},
                               source[] = {[SOURCE_LATTICE] = {lattice_prepare, lattice_drawn},
                                           [SOURCE_RANDOM] = {shapes_prepare, shapes_drawn},
                                           [SOURCE_MESH] = {mesh_prepare, mesh_drawn}};
    return *s->segment->normals ? &patches : &source[s->source];
}

/* Rounding may move a foot point by this much, in xi and eta, beyond the edge of the box. */
#define BEYOND 1e-3

/* volatile, because gcc 12 -O3 drops the two conversions when it vectorises. */
static void round_vector(double x[3])
{
    for (int k = 0; k < 3; k++) {
        const volatile float nearest = (float)x[k];
        x[k] = (double)nearest;
    }
}

/* Rounds the coordinates of a sample to float, which callers of code in single precision have, and computes its foot point
 * again. Returns false if the foot point has left the scene's box by more than rounding. */
static bool sample_round(const struct scene *scene, struct sample *s)
{
    const struct surface *f = surface_find(scene->segment);
    double lo[2], hi[2];
    scene_box(scene, lo, hi);
    for (int k = 0; k < 2; k++) {
        lo[k] -= BEYOND;
        hi[k] += BEYOND;
    }
    for (size_t k = 0; k < segment_vectors(scene->segment); k++)
        round_vector(s->x[k]);
    round_vector(s->xs);
    if (!f->foot(f, s, lo, hi, (double[]){s->xi, s->eta}))
        return false;
    sample_order(s, scene->order);
    return true;
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
    bool good = source_of(scene)->prepare(p, d);
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

bool scene_has(const struct scene *s, enum sample_part part)
{
    if (part == PART_HELDOUT_RANDOM)
        return s->source == SOURCE_LATTICE;
    return part != PART_HELDOUT_EVEN || (s->source == SOURCE_RANDOM && !*s->segment->normals);
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

bool scene_heldout(const struct scene *s, struct heldout *h, struct diag *d)
{
    bool good = true;
    for (int k = 0; k < HELDOUT_PARTS && good; k++)
        good = !scene_has(s, heldout_part[k].part) || (h->part[k] = sampler_new(s, heldout_part[k].part, d));
    h->lines = good ? source_of(s)->drawn(h->part[0], h->drawn) : 0;
    return good;
}

void heldout_free(struct heldout *h)
{
    for (int part = 0; part < HELDOUT_PARTS; part++)
        sampler_free(h->part[part]);
    *h = (struct heldout){.lines = 0};
}
