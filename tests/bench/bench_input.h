/* Samples as the methods of the bench take them. */
#ifndef FOOTPOINT_BENCH_INPUT_H
#define FOOTPOINT_BENCH_INPUT_H

#include "../../evolve/surface/sample.h"
#include "bench_methods.h"

/** What a method is given of sample number i.  The answer of the step before lies a hundredth of the segment away. */
struct bench_input bench_input_of(const struct segment_kind *kind, const struct sample *s, size_t i);

#endif
