/* Protects the files of a scene from being overwritten. */
#ifndef FOOTPOINT_SCENE_FILES_H
#define FOOTPOINT_SCENE_FILES_H

#include "scene.h"

#include "../../codegen/base/outfile.h"

/** Returns true if n files of a command line are distinct, as files_apart checks, and no output is the scene's file,
 *  the scene of its kind, its mesh with included files, or one of its frames (all but the mesh under root). */
bool scene_files_apart(const char *program, const char *root, const struct scene *s, const struct file_use *file,
                       size_t n, struct diag *d);

#endif
