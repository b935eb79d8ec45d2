/* Judges the hard cases in single precision: generated/footpoint_quad4_float.h against truth.c. */
#ifndef FOOTPOINT_HARD_FLOAT_H
#define FOOTPOINT_HARD_FLOAT_H

#include <stdint.h>

/** Prints the lines of a family of the table of hard_main.c: the finest function, and all functions together.  Returns 0 if any
 *  answer that is OK was beyond its promise, or not finite, or a status was wrong. */
int hard_float_family(int family, long n, uint64_t seed);

#endif
