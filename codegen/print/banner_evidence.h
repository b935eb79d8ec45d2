/* Prints the banner's lines on the region, poles and rounding errors. */
#ifndef FOOTPOINT_BANNER_EVIDENCE_H
#define FOOTPOINT_BANNER_EVIDENCE_H

#include "../compile/compiled_file.h"

/** Prints the ranges of the file, if it has any. */
void banner_region(const struct genome_file *f, FILE *out);

/** Prints the poles of a function of the unit, a line each, and bounds of its rounding errors. */
void banner_evidence(const struct unit *u, const struct function *function, FILE *out);

#endif
