/* Speed of the evaluator. */
#ifndef FOOTPOINT_KERNEL_BENCHMARK_H
#define FOOTPOINT_KERNEL_BENCHMARK_H

#include <stdio.h>

/** CSV engine,precision,bits,genes_samples_per_s over 8 inputs and 28,672 samples, the best of several rounds in which
 *  all take turns.  Engines: "footpoint", for random polynomials of 50..250 genes; "footpoint-rational", with protected
 *  division among their operators; "footpoint-short", for polynomials of 15 genes.  Leaves count, as in all published
 *  figures. */
void evolve_benchmark(FILE *stream);

#endif
