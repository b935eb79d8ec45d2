/* Where a program finds frames, scenes and start genomes. */
#ifndef FOOTPOINT_DATA_ROOT_H
#define FOOTPOINT_DATA_ROOT_H

#include <stdbool.h>

/** Folder that holds evolve/: the current one, or, where that has none, ../share/footpoint beside the program's own
 *  folder, where `make install` puts it.  Static storage. */
const char *root_default(void);

/** Whether a root is the installed one: read, never written. */
bool root_is_installed(const char *root);

#endif
