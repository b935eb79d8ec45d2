/* The files that a scene is made of are not to be written over. */
#ifndef FOOTPOINT_SCENE_FILES_H
#define FOOTPOINT_SCENE_FILES_H

#include "scene.h"

#include "../../codegen/base/outfile.h"

/** Whether n files of a command line are apart from each other, as files_apart says, and those written from the scene's
 *  file, the scene of its kind, its mesh with what that includes, and its frames (all but the mesh under root), too. */
bool scene_files_apart(const char *program, const char *root, const struct scene *s, const struct file_use *file,
                       size_t n, struct diag *d);

#endif
