/* The generations of a run. */
#ifndef FOOTPOINT_GENERATIONS_H
#define FOOTPOINT_GENERATIONS_H

#include "run.h"

/** Collective: let all islands evolve from r->generation to the last, or to one that all ranks agree on when the run is
 *  to end before; sets r->generation, r->reason and r->unsaved.  False with *d: the log is unusable. */
bool evolve_islands(struct run *r, struct diag *d);

#endif
