/* The functions of one number (UNARY of genes.h), exactly. */
#ifndef FOOTPOINT_UNARY_H
#define FOOTPOINT_UNARY_H

#include "../genome/genome.h"

#include <arb.h>
#include <flint/fmpq.h>

/** *x = function k of *a, which may be *x; false, and *x as it was, if that is no rational number. */
bool unary_exact(unsigned k, fmpq *x, const fmpq *a);

/** A ball of the values on a ball; not finite where it has none. */
void unary_ball(unsigned k, arb_t x, const arb_t a, slong bits);

#endif
