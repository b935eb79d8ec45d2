/* A run of footpoint-evolve: what it reads, its islands, what it finds. */
#ifndef FOOTPOINT_RUN_H
#define FOOTPOINT_RUN_H

#include "../archive/archive.h"
#include "../fit/fits.h"
#include "../mpi/team.h"
#include "../samples/variation.h"
#include "resume.h"
#include "run_options.h"
#include "stop.h"

/** The output that a ring of islands searches. */
struct quest {
    size_t tier;
    int output;
};

struct run {
    const struct evolve_options *options; /* not owned */
    const struct team *team;              /* not owned */
    const struct resume *resume;          /* not owned; NULL: a new run */
    double begun;                         /* seconds_now() */
    char start[1024], output[1024];       /* paths; start is empty where there is none */
    char *start_text;                     /* owned; on rank 0: the start file, for checkpoints */
    size_t start_bytes;
    struct scene *scene;
    struct archive *archive;
    struct gene_set *genes;     /* one for each tier */
    struct sample_set training; /* empty once the table is there */
    struct heldout heldout;     /* on rank 0 */
    struct vary vary;           /* of the training samples */
    bool follows;               /* frame and tiers follow from that */
    struct columns table;
    struct judge *judge;
    struct fits *fits;    /* of constants, for the islands */
    struct fitting hooks; /* the same as the islands call it */
    struct plan plan;
    struct quest *quest; /* one for each ring */
    bool *seeded;        /* one for each island: started from a champion */
    struct sea sea;
    size_t generation;       /* reached */
    enum stop_reason reason; /* why it ended */
    bool unsaved;            /* the last checkpoint or the log could not be written */
};

/** Collective: the whole run.  False with *d; *status is the exit status of one that ended well. */
bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d);

/** Genes of the longest expression of a tier. */
size_t run_max_length(const struct run *r, size_t tier);

/** Expressions of one gene are chosen among the frame's values: nothing to evolve. */
bool run_chooses(const struct run *r, size_t tier);

/** The ring's key in random streams. */
size_t run_ring(const struct run *r, size_t ring);

#endif
