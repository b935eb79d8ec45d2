/* Finds the folder of frames, scenes and start genomes. */
#ifndef FOOTPOINT_DATA_ROOT_H
#define FOOTPOINT_DATA_ROOT_H

#include <stdbool.h>

/** Returns the folder that contains evolve/: the current folder, or otherwise ../share/footpoint relative to the
 *  program's own folder, where `make install` puts it. Static storage. */
const char *root_default(void);

/** Returns true if `root` is the installed folder, which is read but never written. */
bool root_is_installed(const char *root);

#endif
