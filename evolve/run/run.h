/* A run of footpoint-evolve. */
#ifndef FOOTPOINT_RUN_H
#define FOOTPOINT_RUN_H

#include "resume.h"
#include "run_options.h"

/** Collective: the whole run.  False with *d; *status is the exit status of one that ended well. */
bool run_evolution(const struct evolve_options *o, const struct team *team, const struct resume *resume, double begun,
                   int *status, struct diag *d);

#endif
