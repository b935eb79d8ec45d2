/* Evaluates a program at a point in single precision: the numbers that the emitted float code computes, operation by
 * operation, without contraction. */
#ifndef FOOTPOINT_EVALUATE_FLOAT_H
#define FOOTPOINT_EVALUATE_FLOAT_H

#include "program.h"

/** Computes the values of the constants; leaves other operations unchanged. */
void single_constants(const struct program *p, float *value);

/** Computes the values of all operations except constants, which must be set already. */
void single_values(const struct program *p, const float *input, float *value);

/** Converts a segment's coordinates, by vector and coordinate, as its float code does first: nodes minus the first
 *  node, times 4 over the sum of the corners' distances from it, component by component; normals unchanged. So products
 *  of many lengths stay in the range of float, whatever the unit. (header_float.c prints the same code.) */
void single_inputs(const struct segment_kind *k, const float *x, float *y);

/** Returns true if a program of a segment does not depend on its position and size, tested on random segments. */
bool single_is_relative(const struct segment_kind *k, const struct program *p);

#endif
