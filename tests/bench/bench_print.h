/* Prints the results of one run: everything, as comma-separated values or as a table, or only the front. */
#ifndef FOOTPOINT_BENCH_PRINT_H
#define FOOTPOINT_BENCH_PRINT_H

#include "bench_measure.h"

/** Prints the header line before the first of several runs. */
void bench_print_csv(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run);
void bench_print_all(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run);

/** Prints, for bare searches, converged and fair Newton and the methods on the front: no other method is as fast and
 *  more accurate, or as accurate and faster, in calls, dependent or not, or over arrays. The error is the mean, the
 *  larger of xi's and eta's; methods that fail on a sample are omitted. Then prints all methods for each other
 *  question; closest points and searches along a direction by the error of the distance. */
void bench_print_front(const struct scene *scene, const struct bench_table *table, const struct bench_run *run);

#endif
