/* The functions of one number (UNARY of genes.h), exactly. */
#ifndef FOOTPOINT_UNARY_H
#define FOOTPOINT_UNARY_H

#include "../genome/genome.h"

#include <arb.h>
#include <flint/fmpq.h>

/** Sets *x = function k of *a, which may be *x. Returns false, and leaves *x unchanged, if the value is not
 *  rational. */
bool unary_exact(unsigned k, fmpq *x, const fmpq *a);

/** Computes a ball that encloses the values on a ball; not finite if the function is undefined there. */
void unary_ball(unsigned k, arb_t x, const arb_t a, slong bits);

#endif
