/* Prints a unit as a Fortran 2008 module. */
#ifndef FOOTPOINT_FORTRAN_H
#define FOOTPOINT_FORTRAN_H

#include "../compile/compiled_file.h"

/** Prints a module with the unit's prefix as name.  A genome NAME of scalars becomes `pure elemental subroutine NAME(in_...,
 *  out_...)`, with a last argument `status` (0, or 2: degenerate) if a denominator may be 0.  A segment's genome becomes
 *  `pure subroutine NAME_at(xA, xB, xC, xD, xS, xi, eta)`, unchecked.
 *  Returns false with *d filled if Fortran does not permit the names, or a statement grows too long. */
bool fortran_print(const struct unit *u, FILE *out, struct diag *d);

#endif
