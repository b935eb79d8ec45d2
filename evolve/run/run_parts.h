/* What the files of a run hand each other: how it was called, what it is to find, how far it has come. */
#ifndef FOOTPOINT_RUN_PARTS_H
#define FOOTPOINT_RUN_PARTS_H

#include "../archive/archive.h"
#include "../common/stop.h"
#include "../fit/fits.h"
#include "../mpi/team.h"
#include "resume.h"
#include "run_options.h"

/** How it was called. */
struct call {
    const struct evolve_options *options; /* not owned, as are these */
    const struct team *team;
    const struct resume *resume; /* NULL: a new run */
    double begun;                /* seconds_now() */
};

/** Its files, beside those of the options. */
struct run_files {
    char start[1024], output[1024]; /* paths; start is empty where there is none */
    bool shipped;                   /* start is not the scene's own, but its kind's */
    char *start_text;               /* owned; on rank 0: the start file, for checkpoints */
    size_t start_bytes;
    char frames_sha256[65]; /* of what genes in checkpoints mean */
};

/** What it is to find, and what that is measured by: the same on all ranks. */
struct problem {
    struct scene *scene;
    struct archive *archive;
    struct gene_set *genes; /* one for each tier */
    struct columns table;   /* of the training samples */
    struct objective *objective;
    struct fits *fits;    /* of constants, for the islands */
    struct fitting hooks; /* the same as the islands call it */
    struct plan plan;
};

/** How far it has come. */
struct outcome {
    size_t generation;       /* reached */
    enum stop_reason reason; /* why it ended */
    bool unsaved;            /* the last checkpoint or the log could not be written */
};

#endif
