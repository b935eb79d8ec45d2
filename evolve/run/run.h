/* A run of footpoint-evolve. */
#ifndef FOOTPOINT_RUN_H
#define FOOTPOINT_RUN_H

#include "resume.h"
#include "run_options.h"

/** Runs everything. Collective. Returns false with *d on failure; otherwise *status is the exit status. */
bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d);

#endif
