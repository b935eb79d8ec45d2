/* Equality of the emitted text and its genome. */
#ifndef FOOTPOINT_PROVE_H
#define FOOTPOINT_PROVE_H

#include "genome.h"

/** Reads the emitted statements as C and compares them with the genome at random rational points: exactly over the
 *  rationals, and where numbers grow beyond 2^16 bits modulo a 60-bit prime.  sqrt stands for an arbitrary function,
 * the same on both sides.  False with *d filled if they differ (a fault of this program) or if the genome divides by 0
 *  wherever it was tried. */
bool prove_equal(const struct genome_file *f, const struct genome *genome, const char *statements, struct diag *d);

#endif
