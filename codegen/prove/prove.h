/* Equality of a genome and the code made for it. */
#ifndef FOOTPOINT_PROVE_H
#define FOOTPOINT_PROVE_H

#include "../program/program.h"

/** How equality is known. */
struct proof {
    bool exact; /* as rational functions over Q; else at random points only */
    int points; /* random points, modulo a random prime of `bits` bits */
    unsigned long bits;
    double log2_failure; /* log2 of the chance that the points mislead */
};

/** Compares program and genome, both as operations one by one: as rational functions in which sqrt, abs, min, max and
 * protected quotients stand for new variables; where polynomials grow too large for that, at random points.  False with
 * *d filled if they differ (a fault of this program), if the genome divides by a value that is always 0, or if
 * polynomials are too large and degrees too high for a prime of 1024 bits (from 2^500 on). */
bool prove_equal(const struct genome_file *f, const struct genome *genome, const struct program *p, struct proof *how,
                 struct diag *d);

/** One line without its end, for the header. */
void proof_print(const struct proof *how, char text[120]);

#endif
