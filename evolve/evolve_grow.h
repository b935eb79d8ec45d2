/* Seeds grown for every output of every tier, shared out over the ranks. */
#ifndef FOOTPOINT_EVOLVE_GROW_H
#define FOOTPOINT_EVOLVE_GROW_H

#include "evolve_run.h"

/** Collective: polynomials, and quotients where the genes have them, from nothing and from the champion, become seeds
 *  of the archive; the same on any number of ranks. */
void evolve_grow(struct run *r);

#endif
