/* Proves that a genome and its code are equal. */
#ifndef FOOTPOINT_PROVE_H
#define FOOTPOINT_PROVE_H

#include "../program/program.h"

/** How equality was proved. */
struct proof {
    bool exact; /* as rational functions over Q; otherwise only at random points */
    int points; /* random points, modulo a random prime of `bits` bits */
    unsigned long bits;
    double log2_failure; /* log2 of the chance that the points mislead */
};

/** Compares program and genome, operation by operation, as rational functions in which sqrt, abs, min, max and
 *  protected quotients are new variables. If polynomials grow too large, compares at random points. Returns false, with
 *  *d filled, if they differ (an internal error), if the genome divides by a value that is always 0, or if polynomials
 *  are too large and degrees too high for a prime of 1024 bits (from 2^500 on). */
bool prove_equal(const struct genome_file *f, const struct genome *genome, const struct program *p, struct proof *how,
                 struct diag *d);

/** Writes a line without its end, for the header. */
void proof_print(const struct proof *how, char text[120]);

#endif
