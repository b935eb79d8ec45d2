/* The longer parts of a scene, read into it; for scene.c. */
#ifndef FOOTPOINT_SCENE_PARTS_H
#define FOOTPOINT_SCENE_PARTS_H

#include "scene.h"
#include "scene_keys.h"

/** Exactly one of lattice, shapes and mesh: scene->source and its group, NULL if there is none, which is gathered. */
bool scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **group);

/** Its keys are known ones; those that lack are gathered.  Nothing is said of a group NULL or, but for meshes, of one
 *  whose kind of segment is not known. */
bool scene_check_source(const struct scene_reader *r, config_setting_t *group, const struct scene *scene);

/** The group `mesh`.  Where the scene names no segment, scene->segment becomes what the master faces are.  The
 *  mesh is added to the scene's digest. */
bool scene_read_mesh(const struct scene_reader *r, config_setting_t *group, struct scene *scene);

/** The group `lattice` or `shapes`. */
bool scene_read_source(const struct scene_reader *r, config_setting_t *group, struct scene *scene);

/** The keys of tiers, as above. */
bool scene_check_tiers(const struct scene_reader *r, config_setting_t *root);

/** `frame` and `tiers`, or neither.  Tiers without a frame take that of the scene of their kind, scene_of_kind. */
bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

#endif
