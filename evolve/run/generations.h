/* The generations of a run. */
#ifndef FOOTPOINT_GENERATIONS_H
#define FOOTPOINT_GENERATIONS_H

#include "islands.h"
#include "run_parts.h"

/** Evolves all islands from out->generation to the last generation, or to an earlier generation on which all ranks
 *  agree, and sets *out. Collective. Returns false with *d if the log is unusable. */
bool evolve_islands(const struct call *call, const struct problem *p, const struct islands *islands,
                    const struct run_files *files, struct outcome *out, struct diag *d);

#endif
