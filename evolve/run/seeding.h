/* Seeds grown for every output of every tier, shared out over the ranks. */
#ifndef FOOTPOINT_SEEDING_H
#define FOOTPOINT_SEEDING_H

#include "run_parts.h"

/** Collective: greedy polynomials, grown polynomials and, where the genes have them, grown quotients become seeds
 *  of the archive; the same on any number of ranks.  Returns why growth ended before all were there (a signal, the time
 *  limit), or STOP_DONE. */
enum stop_reason grow_seeds(const struct call *call, const struct problem *p);

/** Compositions of functions become seeds of the tiers of programs.  Not collective: all ranks find the same. */
void compose_all_seeds(const struct problem *p);

#endif
