/* Prints the verdict of a run: its functions beside the functions of the kind of face. */
#ifndef FOOTPOINT_RUN_VERDICT_H
#define FOOTPOINT_RUN_VERDICT_H

#include "../samples/samples.h"
#include "run_parts.h"

/** Returns the functions of the scene's kind of face.  Returns NULL if the kind has no genomes, or they are the scene's own. */
struct archive *run_shipped(const struct call *call, const struct problem *p);
/** Measures them on the training samples. */
void run_measure_shipped(const struct problem *p, struct archive *shipped);

/** Prints the verdict on held-out samples, for any genomes from which the run began, and writes the page that the options ask for.
 *  Scenes with the name of their kind get neither, runs without generations get no verdict.  Returns false with *d filled.
 *  @param[in] shipped  measured, or NULL */
bool run_verdict(const struct call *call, const struct problem *p, const struct archive *shipped,
                 const struct heldout *heldout, struct diag *d);

#endif
