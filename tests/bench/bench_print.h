/* What the bench prints of one run: everything, as comma-separated values or as a table, or the front alone. */
#ifndef FOOTPOINT_BENCH_PRINT_H
#define FOOTPOINT_BENCH_PRINT_H

#include "bench_measure.h"

/** The header line goes before the first of several runs. */
void bench_print_csv(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run);
void bench_print_all(const struct scene *scene, const char *sample, const struct bench_table *table,
                     const struct bench_run *run);

/** Of bare searches converged and fair Newton, and the methods that no other one leaves behind: as fast and more accurate,
 *  or as accurate and faster, in calls, dependent or not, or over arrays; by the mean error, the larger of those of xi and eta; those
 *  that fail on a sample are left out.  Then, of each thing that callers get besides, all methods, by the error of the
 *  distance of closest points and along a direction. */
void bench_print_front(const struct scene *scene, const struct bench_table *table, const struct bench_run *run);

#endif
