/* Seeds grown for every output of every tier, shared out over the ranks. */
#ifndef FOOTPOINT_SEEDING_H
#define FOOTPOINT_SEEDING_H

#include "run.h"

/** Collective: greedy polynomials, grown polynomials and, where the genes have them, grown quotients become seeds
 *  of the archive; the same on any number of ranks.  If a signal or the time limit ends growth before all are there,
 *  r->reason says so. */
void evolve_grow(struct run *r);

#endif
