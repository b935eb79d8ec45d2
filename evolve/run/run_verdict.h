/* The last word of a run: what it found beside the functions of the kind of face. */
#ifndef FOOTPOINT_RUN_VERDICT_H
#define FOOTPOINT_RUN_VERDICT_H

#include "../samples/sampler.h"
#include "run_parts.h"

/** Prints the verdict on samples held out, whatever genomes the run began with, and writes the page that the options ask for;
 *  nothing of scenes that are called as their kind, and no verdict of runs without generations.  False with *d filled. */
bool run_verdict(const struct call *call, const struct problem *p, const struct heldout *heldout, struct diag *d);

#endif
