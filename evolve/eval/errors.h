/* Error statistics, and the errors of finished genomes on samples that evolution has not seen. */
#ifndef FOOTPOINT_ERRORS_H
#define FOOTPOINT_ERRORS_H

#include "../genotype/genotype.h"
#include "../surface/sample.h"

/** Statistics of |value - reference|; all dimensionless, as xi and eta are. */
struct errors {
    size_t n;
    double mean, p99, max;  /* infinite if a value is not finite */
    double band[GAP_BANDS]; /* means in the bands of |gap|; -1: no sample; of expressions on segments */
};

/** value[i] = |value[i] - reference[i]|, INFINITY where that is not a number. */
void errors_absolute(double *value, const double *reference, size_t n);
double errors_max(const double *absolute, size_t n);
/** The ceil(0.99 n)-th smallest; overwrites absolute[]. */
double errors_p99(double *absolute, size_t n);
/** The same, or `least` where it is no more than that. */
double errors_p99_above(double *absolute, size_t n, double least);
/** Whether it is no more than `most`. */
bool errors_p99_within(const double *absolute, size_t n, double most);

/** Errors of expressions of a program, t[i] of output[i] (0: xi, 1: eta), over the samples, which are taken in pieces:
 *  what all of them are made of is computed once, and memory bounded by a value for each sample and expression. */
void errors_measure(const struct genome_file *program, const struct genes *t, const int *output, size_t trees,
                    const struct sample_set *set, struct errors *found);

#endif
