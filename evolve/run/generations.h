/* The generations of a run. */
#ifndef FOOTPOINT_GENERATIONS_H
#define FOOTPOINT_GENERATIONS_H

#include "islands.h"
#include "run_parts.h"

/** Collective: let all islands evolve from out->generation to the last, or to one that all ranks agree on when the run
 *  is to end before; sets *out.  False with *d: the log is unusable. */
bool evolve_islands(const struct call *call, const struct problem *p, const struct islands *islands,
                    const struct run_files *files, struct outcome *out, struct diag *d);

#endif
