/* Measures the speed of the evaluator on trees. */
#ifndef FOOTPOINT_TREE_BENCHMARK_H
#define FOOTPOINT_TREE_BENCHMARK_H

#include <stdio.h>

/** Writes CSV engine,genes_samples_per_s over 8 inputs and 28,672 samples: the best of several rounds. Engines:
 *  "footpoint", random polynomials of 50..250 genes; "footpoint-rational", with protected division among their
 *  operators; "footpoint-short", polynomials of 15 genes. Leaves count as genes, as in all published figures. */
void evolve_benchmark(FILE *stream);

#endif
