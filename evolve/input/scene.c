/* Names and properties of a scene; see scene.h. */
#include "scene.h"

#include <stdlib.h>
#include <string.h>

char *scene_path(const char *root, const char *name)
{
    const size_t length = strlen(name), suffix = strlen(".scene");
    char path[1024];
    if (strchr(name, '/') || (length > suffix && strcmp(name + length - suffix, ".scene") == 0))
        return new_text(name, length);
    snprintf(path, sizeof path, "%s%sevolve/scenes/%s.scene", root, *root ? "/" : "", name);
    return new_text(path, strlen(path));
}

void scene_free(struct scene *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->tiers; i++) {
        for (size_t k = 0; k < s->tier[i].terminals; k++)
            free(s->tier[i].terminal[k]);
        free(s->tier[i].terminal);
        for (size_t k = 0; k < s->tier[i].functions; k++)
            free(s->tier[i].function[k]);
        free(s->tier[i].function);
        for (size_t k = 0; k < s->tier[i].starts; k++) {
            free(s->tier[i].start[k][0]);
            free(s->tier[i].start[k][1]);
        }
        free(s->tier[i].start);
        free(s->tier[i].frame);
        free(s->tier[i].last);
        free(s->tier[i].name);
    }
    free(s->tier);
    free(s->mesh.file);
    for (size_t i = 0; i < s->mesh.reads; i++)
        free(s->mesh.read[i]);
    free(s->mesh.read);
    free(s->warnings);
    free(s->path);
    free(s->name);
    free(s);
}

void scene_box(const struct scene *s, double lo[2], double hi[2])
{
    const double overhang = s->source == SOURCE_RANDOM ? s->shapes.overhang : MESH_OVERHANG;
    const double reach = s->segment->triangle ? 1 + overhang : 1 + 2 * overhang;
    const bool lattice = s->source == SOURCE_LATTICE;
    lo[0] = lattice ? s->lattice.xi[0] : s->segment->triangle ? -overhang : -reach;
    hi[0] = lattice ? s->lattice.xi[1] : reach;
    lo[1] = lattice ? s->lattice.eta[0] : lo[0];
    hi[1] = lattice ? s->lattice.eta[1] : reach;
}

void scene_choose_reference(struct scene *s, bool from_corner)
{
    double lo[2], hi[2];
    scene_box(s, lo, hi);
    for (int k = 0; k < 2; k++)
        s->reference[k] = s->segment->triangle ? 1.0 / 3 : from_corner ? -1 : (lo[k] + hi[k]) / 2;
}

void tier_frame_path(const char *root, const struct tier *t, char path[FRAME_PATH])
{
    snprintf(path, FRAME_PATH, "%s/evolve/frames/%s.gen", root, t->frame);
}

void tier_suffix(const struct tier *t, char text[16])
{
    text[0] = '\0';
    if (t->at)
        snprintf(text, 16, "_at%d", t->at);
}
