/* What rank 0 does beside its islands: it collects log lines and checkpoints as they come in, and shows the progress.
 */
#ifndef FOOTPOINT_RANK0_H
#define FOOTPOINT_RANK0_H

#include "islands.h"
#include "progress.h"
#include "run_parts.h"

struct rank0 {
    const struct call *call; /* not owned, as are these */
    const struct scene *scene;
    const struct islands *islands;
    const struct run_files *files;
    struct run_log log;
    struct gather rows, states;
    size_t logged; /* generations whose lines are written, or that have none */
    size_t saving; /* generation of the checkpoint under way; 0: none */
    bool writing;  /* the writer is open */
    struct checkpoint_writer writer;
    size_t *state_bytes; /* owned: of each island */
    double saved;        /* when the last checkpoint began */
    bool bad_log, bad_save;
    struct progress progress;
};

/** Collective, as it learns the sizes of all islands' states; the rest is rank 0's.  The pointers in *k are set, and
 *  `generation` is where the islands are.  False with *d: the log cannot be written, or is another run's. */
bool rank0_open(struct rank0 *k, size_t generation, struct diag *d);
/** Take what has come in.  All islands of this rank have done `generation`; nothing later is expected. */
void rank0_poll(struct rank0 *k, size_t generation);
/** True when the next checkpoint is due. */
bool rank0_wishes_save(const struct rank0 *k);
/** The states of this generation are on their way.  Waits for an earlier checkpoint under way. */
void rank0_save(struct rank0 *k, size_t generation);
/** Show what a poll said: the best error of each ring, and the work done. */
void rank0_show(struct rank0 *k, size_t generation, const double *best, double work);
/** Wait for all that is on its way up to `generation`, and close the files.  False where the last checkpoint or the log
 *  could not be written, which has been said. */
bool rank0_close(struct rank0 *k, size_t generation);

#endif
