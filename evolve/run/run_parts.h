/* Data that the files of a run share: how it was called, its goal, its progress. */
#ifndef FOOTPOINT_RUN_PARTS_H
#define FOOTPOINT_RUN_PARTS_H

#include "../archive/archive.h"
#include "../common/stop.h"
#include "../fit/fits.h"
#include "../mpi/team.h"
#include "resume.h"
#include "run_options.h"

/** How the run was called. */
struct call {
    const struct evolve_options *options; /* not owned */
    const struct team *team;
    const struct resume *resume; /* NULL: a new run */
    double begun;                /* seconds_now() */
};

/** Files that the options do not name. */
struct run_files {
    char start[1024], output[1024]; /* start may be empty */
    bool shipped;                   /* start belongs to the scene's kind, not to the scene */
    char *start_text;               /* owned; on rank 0: the start file, for checkpoints */
    size_t start_bytes;
    char frames_sha256[65]; /* of the frames that define genes in checkpoints */
};

/** The goal of the run and its measures, the same on all ranks. */
struct problem {
    struct scene *scene;
    struct archive *archive;
    struct gene_set *genes; /* indexed by tier */
    struct columns table;   /* of the training samples */
    struct objective *objective;
    struct fits *fits;    /* for constants, for the islands */
    struct fitting hooks; /* `fits` as the islands call it */
    struct plan plan;
};

/** The progress of the run. */
struct outcome {
    size_t generation;       /* reached */
    enum stop_reason reason; /* why it ended */
    bool unsaved;            /* the last checkpoint or the log could not be written */
};

#endif
