/* Functions that read the longer parts of a scene, for scene_read.c. */
#ifndef FOOTPOINT_SCENE_PARTS_H
#define FOOTPOINT_SCENE_PARTS_H

#include "scene.h"
#include "scene_keys.h"

/** Finds the setting of the scene's source, lattice, shapes or mesh, and sets scene->source. A missing source is
 *  collected, with *setting NULL. There must not be two. */
bool scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **setting);

/** Checks the source's keys and collects missing keys. Checks nothing if `setting` is NULL or, except for meshes, if
 *  the kind of segment is unknown. */
bool scene_check_source(const struct scene_reader *r, config_setting_t *setting, const struct scene *scene);

/** Reads the source. If a scene of a mesh names no segment, scene->segment becomes the kind of the master faces. The
 *  mesh is added to the scene's digest. */
bool scene_read_source(const struct scene_reader *r, config_setting_t *setting, struct scene *scene);

/** Checks the keys of tiers in the same way. */
bool scene_check_tiers(const struct scene_reader *r, config_setting_t *root);

/** Reads `frame` and `tiers`, if present. Tiers without a frame name get no frame. */
bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene);

#endif
