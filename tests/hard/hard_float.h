/* The hard cases in single precision: generated/footpoint_quad4_float.h against truth.c. */
#ifndef FOOTPOINT_HARD_FLOAT_H
#define FOOTPOINT_HARD_FLOAT_H

#include <stdint.h>

/** Prints the lines of one family of the table of hard_main.c: the bare search, NAME_sure, and the NAME_sure of all
 *  functions together.  0 if any answer of these was worse than the header says, or not finite, without a status. */
int hard_float_family(int family, long n, uint64_t seed);

#endif
