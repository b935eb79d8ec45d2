/* A unit as templates of C++, for numbers of any type. */
#ifndef FOOTPOINT_HEADER_GENERIC_H
#define FOOTPOINT_HEADER_GENERIC_H

#include "../../compile/compiled_file.h"

/** Prints a header of function templates over the type T of numbers.  A genome NAME of scalars becomes
 *  `NAME(in_..., &out_...)`.  A genome of a segment becomes `NAME_at(xA, ..., xS, &xi, &eta)`.  For faces without normals
 *  whose corners may be in any order, NAME takes a Newton step from there and computes the gap.  The C header PREFIX.h, which
 *  this header includes, has the overload of NAME with a proof.
 *  Returns false with *d filled for functions at a place of a face. */
bool generic_print(const struct unit *u, FILE *out, struct diag *d);

#endif
