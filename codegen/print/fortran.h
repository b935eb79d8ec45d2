/* A unit as a Fortran 2008 module. */
#ifndef FOOTPOINT_FORTRAN_H
#define FOOTPOINT_FORTRAN_H

#include "../compile/compiled_file.h"

/** A module named as the unit's prefix.  A genome NAME of scalars becomes `pure elemental subroutine NAME(in_...,
 * out_...)`, with a last argument `status` (0, or 2: degenerate) if a denominator may be 0; one of a segment becomes
 *  `pure subroutine NAME_at(xA, xB, xC, xD, xS, xi, eta)`, nothing checked.
 *  False with *d filled if Fortran cannot have the names, or a statement grows too long. */
bool fortran_print(const struct unit *u, FILE *out, struct diag *d);

#endif
