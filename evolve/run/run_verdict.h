/* The last word of a run: what it found beside the functions of the kind of face. */
#ifndef FOOTPOINT_RUN_VERDICT_H
#define FOOTPOINT_RUN_VERDICT_H

#include "run_parts.h"

/** Prints the verdict on samples held out, whatever genomes the run began with; nothing of runs without generations, and of
 *  scenes that are called as their kind. */
void run_verdict(const struct call *call, const struct problem *p, const struct heldout *heldout);

#endif
