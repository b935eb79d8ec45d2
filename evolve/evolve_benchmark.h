/* Speed of the evaluator, beside a plain interpreter of the same genomes. */
#ifndef FOOTPOINT_EVOLVE_BENCHMARK_H
#define FOOTPOINT_EVOLVE_BENCHMARK_H

#include <stdio.h>

/** CSV engine,precision,bits,genes_samples_per_s: random genomes of 50..250 genes over 8 inputs and 28,672 samples,
 *  polynomials, then with protected division among the operators; the best of several rounds in which the engines take
 *  turns. */
void evolve_benchmark(FILE *stream);

#endif
