/* A program at one point in single precision: the numbers that the emitted float code computes, operation by operation,
 * where products and sums are not contracted. */
#ifndef FOOTPOINT_EVALUATE_FLOAT_H
#define FOOTPOINT_EVALUATE_FLOAT_H

#include "program.h"

/** Values of the operations that are constants; the others are left alone. */
void single_constants(const struct program *p, float *value);

/** Values of all operations, beside constants, which are there already. */
void single_values(const struct program *p, const float *input, float *value);

/** What the float code of a segment makes of its coordinates, by vector and coordinate, before it computes: nodes less
 *  the first one, times 4 over the sum of the corners' distances from that, component by component; normals as they
 *  are.  Products of many lengths stay in the range of float, whatever the unit.  (header_float.c prints the same.) */
void single_inputs(const struct segment_kind *k, const float *x, float *y);

/** Whether a program of a segment gives the same wherever that is and however large, which random ones tell. */
bool single_is_relative(const struct segment_kind *k, const struct program *p);

#endif
