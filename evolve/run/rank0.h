/* What rank 0 does beside its islands: it collects log lines and checkpoints as they come in, and shows the progress.
 */
#ifndef FOOTPOINT_RANK0_H
#define FOOTPOINT_RANK0_H

#include "run.h"
#include "progress.h"

struct keeper {
    struct run *run; /* not owned */
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

/** Collective, as it learns the sizes of all islands' states; the rest is rank 0's.  False with *d: the log cannot be
 *  written, or is another run's. */
bool keeper_open(struct keeper *k, struct run *r, struct diag *d);
/** Take what has come in.  All islands of this rank have done `generation`; nothing later is expected. */
void keeper_poll(struct keeper *k, size_t generation);
/** True when the next checkpoint is due. */
bool keeper_wishes_save(const struct keeper *k);
/** The states of this generation are on their way.  Waits for an earlier checkpoint under way. */
void keeper_save(struct keeper *k, size_t generation);
/** Show what a poll said. */
void keeper_show(struct keeper *k, size_t generation, const double *best, double work);
/** Wait for all that is on its way, and close the files. */
void keeper_close(struct keeper *k);

#endif
