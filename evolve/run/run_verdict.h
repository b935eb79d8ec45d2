/* Prints the verdict of a run: its functions beside the functions of the kind of face. */
#ifndef FOOTPOINT_RUN_VERDICT_H
#define FOOTPOINT_RUN_VERDICT_H

#include "../samples/sampler.h"
#include "run_parts.h"

/** Prints the verdict on held-out samples, for any genomes from which the run began, and writes the page that the options ask for.
 *  Scenes with the name of their kind get neither, runs without generations get no verdict.  Returns false with *d filled. */
bool run_verdict(const struct call *call, const struct problem *p, const struct heldout *heldout, struct diag *d);

#endif
