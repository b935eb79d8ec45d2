/* Checks that outputs do not overwrite a scene's inputs; see scene_files.h. */
#include "scene_files.h"

#include <stdlib.h>
#include <string.h>

bool scene_files_apart(const char *program, const char *root, const struct scene *s, const struct file_use *file,
                       size_t n, struct diag *d)
{
    enum { SCENES = 2 };
    struct file_use *all = new_array(n + SCENES + s->mesh.reads + s->tiers, sizeof *all);
    char *kind = scene_path(root, s->segment->name); /* may supply frame and tiers */
    char(*frame)[FRAME_PATH] = new_array(s->tiers, sizeof *frame);
    size_t used = n;
    memcpy(all, file, n * sizeof *all);
    all[used++] = (struct file_use){.what = "the scene", .path = s->path};
    all[used++] = (struct file_use){.what = "the scene of the kind", .path = kind};
    for (size_t i = 0; i < s->mesh.reads; i++)
        all[used++] = (struct file_use){.what = "the mesh", .path = s->mesh.read[i]};
    for (size_t i = 0; i < s->tiers; i++) {
        tier_frame_path(root, &s->tier[i], frame[i]);
        all[used++] = (struct file_use){.what = "a frame", .path = frame[i]};
    }
    const bool apart = files_apart(program, all, used, d);
    free(frame);
    free(kind);
    free(all);
    return apart;
}
