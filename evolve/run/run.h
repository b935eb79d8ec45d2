/* A run of footpoint-evolve: how it was called, its goal, its progress, and the steps that its files share. */
#ifndef FOOTPOINT_RUN_H
#define FOOTPOINT_RUN_H

#include "../archive/archive.h"
#include "../common/stop.h"
#include "../fit/fits.h"
#include "../samples/samples.h"
#include "../samples/variation.h"
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

/** The samples of the run. */
struct run_samples {
    struct sample_set training; /* empty after the table is computed */
    struct columns validation;  /* on rank 0, as is: */
    struct heldout heldout;
    struct variation vary; /* of the training samples */
    size_t real;           /* number of slave nodes of a mesh among them */
    bool follows;          /* true if frame and tiers follow from that */
};

/** Runs everything. Collective. Returns false with *d on failure; otherwise *status is the exit status. */
bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d);

/* ---- run_files.c ---- */

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

/* ---- run_samples.c ---- */

/** Draws the training samples, unless they are drawn. */
bool run_draw_training(const struct scene *scene, struct run_samples *s, struct diag *d);

/** Computes the table of training samples and, on rank 0, draws the samples that islands do not see.  A scene that leaves
 *  its tiers to the run trains on the hardest tenth of ten times its samples, and is judged by five times as many. */
bool run_draw_samples(const struct call *call, struct problem *p, struct run_samples *s, struct diag *d);

/* ---- generations.c ---- */

/** Evolves all islands from out->generation to the last generation, or to an earlier generation on which all ranks
 *  agree, and sets *out. Collective. Returns false with *d if the log is unusable. */
bool evolve_islands(const struct call *call, const struct problem *p, const struct islands *islands,
                    const struct run_files *files, struct outcome *out, struct diag *d);

/* ---- run_verdict.c ---- */

/** Returns the functions of the scene's kind of face.  Returns NULL if the kind has no genomes, or they are the scene's own. */
struct archive *run_shipped(const struct call *call, const struct problem *p);
/** Measures them on the training samples. */
void run_measure_shipped(const struct problem *p, struct archive *shipped);

/** Prints the verdict on held-out samples, for any genomes from which the run began, and writes the page that the options ask for.
 *  Scenes with the name of their kind get neither, runs without generations get no verdict.  Returns false with *d filled.
 *  @param[in] shipped  measured, or NULL */
bool run_verdict(const struct call *call, const struct problem *p, const struct archive *shipped,
                 const struct heldout *heldout, struct diag *d);

#endif
