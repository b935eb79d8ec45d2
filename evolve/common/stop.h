/* What ends a run before its last generation: signals, and the time that it is given. */
#ifndef FOOTPOINT_STOP_H
#define FOOTPOINT_STOP_H

#include <stdbool.h>

/** Why a run ends; where there are several reasons the highest counts. */
enum stop_reason { STOP_DONE, STOP_TIME, STOP_WARNED, STOP_TERMINATED, STOP_INTERRUPTED, STOP_REASONS };

/** From now on SIGUSR1, SIGTERM and SIGINT are noted instead of ending the process, the second SIGINT excepted, which
 *  ends it at once; and a file that grows beyond the limit is an error of writing. */
void stop_listen(void);
/** The signal noted so far, or STOP_DONE. */
enum stop_reason stop_noted(void);

/** "time limit", "SIGTERM", ... */
const char *stop_name(enum stop_reason reason);
/** Exit status of a run that ended well for this reason: 0 where the time was up or a batch system warned (SIGUSR1),
 *  128 + the signal's number where somebody ended it. */
int stop_status(enum stop_reason reason);

#endif
