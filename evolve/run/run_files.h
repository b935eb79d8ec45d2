/* The files of a run: where they are, and whether they suit each other. */
#ifndef FOOTPOINT_RUN_FILES_H
#define FOOTPOINT_RUN_FILES_H

#include "run_parts.h"

/** Paths of the genomes to start from, which a checkpoint may hold, and of those to write. */
bool run_files_choose(const struct call *call, const struct scene *scene, struct run_files *f, struct diag *d);

/** A scene that has no genomes yet starts from those of its kind. */
void run_files_start_from_shipped(const struct call *call, const struct scene *scene, struct run_files *f);

/** The genomes of the scene's kind of face; false if there are none, or they are the scene's own. */
bool run_files_of_kind(const struct call *call, const struct scene *scene, char path[1024]);

/** Reads the start file as checkpoints hold it. */
bool run_files_keep_start(struct run_files *f, struct diag *d);

/** A run may go on with its start file and its checkpoint; apart from that, what it writes is nothing that it reads, and
 *  can be written. */
bool run_files_suit(const struct call *call, const struct scene *scene, const struct run_files *f, struct diag *d);

#endif
