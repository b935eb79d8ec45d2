/* The longer parts of a scene, read into it; for scene.c. */
#ifndef FOOTPOINT_SCENE_PARTS_H
#define FOOTPOINT_SCENE_PARTS_H

#include "scene.h"
#include "scene_keys.h"

/** Exactly one of lattice, shapes and mesh: sets scene->source and returns the group, or NULL with the diagnostic. */
config_setting_t *scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

/** The group `mesh`.  Where the scene names no segment, scene->segment becomes what the master faces are.
 *  @param[out] data, size  what the mesh adds to the scene's digest; the caller frees it */
bool scene_read_mesh(const struct scene_reader *r, config_setting_t *group, struct scene *scene, char **data,
                     size_t *size);

/** The group `lattice` or `shapes`. */
bool scene_read_source(const struct scene_reader *r, config_setting_t *group, struct scene *scene);

/** `frame` and `tiers`, or neither. */
bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

#endif
