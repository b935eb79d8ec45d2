/* Error statistics, and the errors of finished genomes on samples that evolution has not seen. */
#ifndef FOOTPOINT_ERRORS_H
#define FOOTPOINT_ERRORS_H

#include "../genotype/genotype.h"
#include "../surface/sample.h"

/** Statistics of |value - reference|; dimensionless, like xi and eta. */
struct errors {
    size_t n;
    double mean, p99, max;  /* infinite if a value is not finite */
    double climbed;         /* largest, including climbing from the worst samples (write/climb.c); 0: not climbed */
    double band[GAP_BANDS]; /* means in the bands of |gap|; -1: no sample in the band */
};

/** Overwrites value[i] with |value[i] - reference[i]|, or INFINITY if that is not a number. */
void errors_absolute(double *value, const double *reference, size_t n);
double errors_max(const double *absolute, size_t n);
/** Returns the ceil(0.99 n)-th smallest of `absolute`, which it overwrites. */
double errors_p99(double *absolute, size_t n);
/** Returns the larger of `least` and errors_p99(absolute, n). */
double errors_p99_above(double *absolute, size_t n, double least);
/** Returns true if the 99 % error is at most `most`. */
bool errors_p99_within(const double *absolute, size_t n, double most);

/** Running statistics of errors, in memory that grows only with the hundredth part that is kept. */
struct tally {
    size_t n, most; /* errors added, and the most that may be added */
    double sum, band[GAP_BANDS];
    size_t in_band[GAP_BANDS];
    struct largest { /* owned heap of the largest hundredth, at least TALLY_WORST; the least comes first */
        double error;
        size_t sample; /* index of the sample */
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

/** Expressions of a program, and the tallies of their errors; output[i] of t[i] is 0 for xi, 1 for eta. */
struct measurement {
    const struct genome_file *program; /* not owned, as is: */
    const struct genes *t;
    const int *output;
    size_t trees;
    struct tally *tally; /* owned, indexed by expression */
    bool single;         /* evaluated in float */
};
struct measurement measurement_open(const struct genome_file *program, const struct genes *t, const int *output,
                                    size_t trees, size_t most);
/** Adds the errors on the next n samples. Values that several expressions share are computed once. */
void measurement_take(struct measurement *m, const struct sample *s, size_t n);
/** Writes found[i] for expression i and frees the tallies. */
void measurement_close(struct measurement *m, struct errors *found);

/** Computes the absolute errors of expressions first to last - 1 on n samples: error[i - first][0..n-1]. */
void measurement_errors(const struct measurement *m, size_t first, size_t last, const struct sample *s, size_t n,
                        double **error);

#endif
