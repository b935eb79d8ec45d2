/* Compares rational functions exactly. */
#ifndef FOOTPOINT_PROVE_EXACT_H
#define FOOTPOINT_PROVE_EXACT_H

#include "prove_points.h"

enum verdict { EQUAL, DIFFERENT, UNDECIDED };

/** Compares the first half of a program's outputs, made before operation `border`, with the second half, as rational
 *  functions over Q in its inputs and in a new variable for each function of different arguments (rules for functions:
 *  points_new). points (may be NULL): propose values that both halves share; if polynomials grow large, these become
 *  variables, each proved equal. Returns UNDECIDED if that fails or is too much work. */
enum verdict exact_compare(const struct program *p, size_t border, const struct points *points);

#endif
