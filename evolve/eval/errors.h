/* Error statistics, and the errors of finished genomes on samples that evolution has not seen. */
#ifndef FOOTPOINT_ERRORS_H
#define FOOTPOINT_ERRORS_H

#include "../genotype/genotype.h"
#include "../surface/sample.h"

/** Statistics of |value - reference|; all dimensionless, as xi and eta are. */
struct errors {
    size_t n;
    double mean, p99, max; /* infinite if a value is not finite */
    double climbed; /* the largest, that of climbing from the worst samples, too (write/climb.h); 0: not climbed */
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

/** Running statistics of errors: keeps sums and the largest errors only. */
struct tally {
    size_t n, most; /* how many have come, and will come at most */
    double sum, band[GAP_BANDS];
    size_t in_band[GAP_BANDS];
    struct largest { /* owned: a heap, the least first, of the largest hundredth and at least TALLY_WORST */
        double error;
        size_t sample; /* its number */
    } * largest;
    size_t kept;
};
enum { TALLY_WORST = 100 };
void tally_open(struct tally *t, size_t most);
/** Adds the errors of the next n samples. */
void tally_take(struct tally *t, const double *error, size_t n);
/** Sorts t->largest in descending order; no errors can be added afterwards. */
void tally_sort(struct tally *t);
/** Returns the statistics and frees the tally. */
struct errors tally_close(struct tally *t);

/** Expressions of a program, t[i] for output[i] (0 is xi, 1 is eta), and the tallies of their errors. */
struct measurement {
    const struct genome_file *program; /* not owned, as is: */
    const struct genes *t;
    const int *output;
    size_t trees;
    struct tally *tally; /* owned, by expression */
    bool single;         /* errors are those in float */
};
struct measurement measurement_open(const struct genome_file *program, const struct genes *t, const int *output,
                                    size_t trees, size_t most);
/** Adds the errors on the next n samples; values that several expressions share are computed once. */
void measurement_take(struct measurement *m, const struct sample *s, size_t n);
/** Writes found[i] for each expression and frees the tallies. */
void measurement_close(struct measurement *m, struct errors *found);

/** Computes the absolute errors of expressions first to last - 1 on n samples: error[i - first][0..n-1]. */
void measurement_errors(const struct measurement *m, size_t first, size_t last, const struct sample *s, size_t n,
                        double **error);

/** Measures expressions on a set of samples. */
void errors_measure(const struct genome_file *program, const struct genes *t, const int *output, size_t trees,
                    const struct sample_set *set, struct errors *found);

#endif
