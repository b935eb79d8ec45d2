/* Rank 0's duties besides its islands: it collects log lines as they arrive, decides when checkpoints are due, and
 * shows progress. */
#ifndef FOOTPOINT_RANK0_H
#define FOOTPOINT_RANK0_H

#include "islands.h"
#include "progress.h"
#include "run.h"

struct rank0 {
    const struct call *call; /* not owned */
    const struct scene *scene;
    const char *frames_sha256;
    const struct islands *islands;
    struct run_log log;
    struct gather rows;
    size_t logged; /* generations whose lines, if any, are written */
    double saved;  /* time of the last checkpoint */
    bool bad_log, bad_save;
    struct progress progress;
};

/** Opens the log. The pointers in *k must be set; `generation` is the islands' current generation. Returns false with
 *  *d if the log cannot be written or belongs to another run. */
bool rank0_open(struct rank0 *k, size_t generation, struct diag *d);
/** Processes messages that have arrived. All islands of this rank have completed `generation`; nothing later is
 *  expected. */
void rank0_poll(struct rank0 *k, size_t generation);
/** Returns true if the next checkpoint is due. */
bool rank0_wishes_save(const struct rank0 *k);
/** Writes the facts of a checkpoint of this generation. Waits for the log lines up to it, so that log and checkpoint
 *  agree after a restart. */
void rank0_facts(struct rank0 *k, size_t generation, char facts[FACTS]);
/** Records that the checkpoint was written or, with *d, that it failed. */
void rank0_saved(struct rank0 *k, bool good, const struct diag *d);
/** Shows the result of a poll: the best error of each ring, and the work done. */
void rank0_show(struct rank0 *k, size_t generation, const double *best, double work);
/** Waits for all messages up to `generation` and closes the files. Returns false if the last checkpoint or the log
 *  could not be written; the error was already reported. */
bool rank0_close(struct rank0 *k, size_t generation);

#endif
