/* What rank 0 does beside its islands: it collects log lines as they come in, knows when checkpoints are due,
 * and shows the progress.
 */
#ifndef FOOTPOINT_RANK0_H
#define FOOTPOINT_RANK0_H

#include "islands.h"
#include "progress.h"
#include "run_parts.h"

struct rank0 {
    const struct call *call; /* not owned, as are these */
    const struct scene *scene;
    const char *frames_sha256;
    const struct islands *islands;
    struct run_log log;
    struct gather rows;
    size_t logged; /* generations whose lines are written, or that have none */
    double saved;  /* when the last checkpoint was written */
    bool bad_log, bad_save;
    struct progress progress;
};

/** The pointers in *k are set, and `generation` is where the islands are.  False with *d: the log cannot be written, or
 *  is another run's. */
bool rank0_open(struct rank0 *k, size_t generation, struct diag *d);
/** Take what has come in.  All islands of this rank have done `generation`; nothing later is expected. */
void rank0_poll(struct rank0 *k, size_t generation);
/** True when the next checkpoint is due. */
bool rank0_wishes_save(const struct rank0 *k);
/** The facts of a checkpoint of this generation.  Waits for the log lines up to it, so that the two agree after a
 *  restart. */
void rank0_facts(struct rank0 *k, size_t generation, char facts[FACTS]);
/** The checkpoint is written, or, with *d, not. */
void rank0_saved(struct rank0 *k, bool good, const struct diag *d);
/** Show what a poll said: the best error of each ring, and the work done. */
void rank0_show(struct rank0 *k, size_t generation, const double *best, double work);
/** Wait for all that is on its way up to `generation`, and close the files.  False where the last checkpoint or the log
 *  could not be written, which has been said. */
bool rank0_close(struct rank0 *k, size_t generation);

#endif
