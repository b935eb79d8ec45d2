/* The longer parts of a scene, read into it; for scene_read.c. */
#ifndef FOOTPOINT_SCENE_PARTS_H
#define FOOTPOINT_SCENE_PARTS_H

#include "scene.h"
#include "scene_keys.h"

/** Exactly one of lattice, shapes and mesh: scene->source and its setting, NULL if there is none, which is gathered. */
bool scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **setting);

/** Its keys are known ones; those that lack are gathered.  Nothing is said of a setting NULL or, but for meshes, of one
 *  whose kind of segment is not known. */
bool scene_check_source(const struct scene_reader *r, config_setting_t *setting, const struct scene *scene);

/** Reads it.  Where a scene of a mesh names no segment, scene->segment becomes what the master faces are.  The mesh is
 *  added to the scene's digest. */
bool scene_read_source(const struct scene_reader *r, config_setting_t *setting, struct scene *scene);

/** The keys of tiers, as above. */
bool scene_check_tiers(const struct scene_reader *r, config_setting_t *root);

/** `frame` and `tiers`, or neither.  Tiers for which no frame is named have none. */
bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

#endif
