/* The longer parts of a scene, read into it; for scene.c. */
#ifndef FOOTPOINT_SCENE_PARTS_H
#define FOOTPOINT_SCENE_PARTS_H

#include "scene.h"
#include "scene_keys.h"

/** Exactly one of lattice, shapes and mesh.
 *  @param[out] mesh, size  what the mesh adds to the scene's digest; the caller frees it */
bool scene_read_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene, char **mesh,
                       size_t *size);

/** `frame` and `tiers`, or neither. */
bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

#endif
