/* Error statistics, and the errors of finished genomes on samples that evolution has not seen. */
#ifndef FOOTPOINT_ERRORS_H
#define FOOTPOINT_ERRORS_H

#include "../genotype/tree.h"
#include "../surface/sample.h"
#include "kernel.h"

/** Statistics of |value - reference|; all dimensionless, as xi and eta are. */
struct errors {
    size_t n;
    double mean, p99, max; /* infinite if a value is not finite */
};

/** value[i] = |value[i] - reference[i]|, INFINITY where that is not a number. */
void errors_absolute(double *value, const double *reference, size_t n);
double errors_max(const double *absolute, size_t n);
/** The ceil(0.99 n)-th smallest; reorders absolute[]. */
double errors_p99(double *absolute, size_t n);

/** Errors of one output (0: xi, 1: eta) of a program over the samples, which are taken in pieces so that memory stays
 *  bounded by one value for each sample. */
struct errors errors_measure(struct kernel *k, const struct genome_file *program, const struct tree *t, int output,
                             const struct sample_set *set);

#endif
