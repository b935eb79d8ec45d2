/* Ends a run before its last generation, by signal or time limit. */
#ifndef FOOTPOINT_STOP_H
#define FOOTPOINT_STOP_H

#include <stdbool.h>

/** Why a run ends; of several reasons, the highest counts. */
enum stop_reason { STOP_DONE, STOP_TIME, STOP_WARNED, STOP_TERMINATED, STOP_INTERRUPTED, STOP_REASONS };

/** From now on records SIGUSR1, SIGTERM and SIGINT instead of ending the process; a second SIGINT ends it at once. A
 *  file that grows beyond the limit becomes a write error. */
void stop_listen(void);
/** Returns the signal recorded so far, or STOP_DONE. */
enum stop_reason stop_noted(void);

/** Returns "time limit", "SIGTERM", ... */
const char *stop_name(enum stop_reason reason);
/** Returns the exit status of a run that ended well for this reason: 0 for the time limit or a batch system's warning
 *  (SIGUSR1), 128 + the signal's number if a user ended it. */
int stop_status(enum stop_reason reason);

#endif
