/* Finds the files of a run and checks that they are compatible. */
#ifndef FOOTPOINT_RUN_FILES_H
#define FOOTPOINT_RUN_FILES_H

#include "run_parts.h"

/** Chooses the paths of the start genomes, which a checkpoint may contain, and of the output. */
bool run_files_choose(const struct call *call, const struct scene *scene, struct run_files *f, struct diag *d);

/** Starts a scene without genomes from its kind's genomes. */
void run_files_start_from_shipped(const struct call *call, const struct scene *scene, struct run_files *f);

/** Finds the genomes of the scene's kind of face. Returns false if they do not exist or are the scene's own. */
bool run_files_of_kind(const struct call *call, const struct scene *scene, char path[1024]);

/** Reads the start file, in the form that checkpoints store. */
bool run_files_keep_start(struct run_files *f, struct diag *d);

/** Checks that outputs are writable and are not inputs. Only the start file and the checkpoint may be both. */
bool run_files_suit(const struct call *call, const struct scene *scene, const struct run_files *f, struct diag *d);

#endif
