/* A program at one point: in double as the C text says, and exactly. */
#ifndef FOOTPOINT_EVALUATE_H
#define FOOTPOINT_EVALUATE_H

#include "../base/random.h"
#include "program.h"

#include <arb.h>
#include <stdint.h>

/** An operation in double. */
double point_operation(enum op_kind kind, double a, double b);

/** Values of the operations that are constants; the others are left alone. */
void point_constants(const struct program *p, double *value);

/** Values of all operations in double, beside constants, which are there already.  `contract`: NULL, or a stream of
 *  random numbers that decides for each sum of products whether it is one fma(), as compilers may have it, and which.
 */
void point_double(const struct program *p, const double *input, uint64_t *contract, double *value);

/** The double that a constant of the text is, and how far that is from the constant (not less). */
double point_constant(const struct program *p, const struct op *op, double *error);

/** Exact values of all outputs, as balls of at least 64 good bits.  False where one is undefined, or too hard to
 *  find. */
bool point_exact(const struct program *p, const double *input, arb_ptr output);

/** Exact values of the first `ops` operations at a rational point.  Those that are undefined, irrational or too long
 * are not `defined`, nor what depends on them. */
void point_rational(const struct program *p, size_t ops, const fmpq *input, fmpq *value, bool *defined);

double double_nearest(const fmpq *q);
float single_nearest(const fmpq *q);

/** A double, exactly. */
void double_rational(fmpq *q, double x);

/** The double nearest to a ball's number; false if the ball holds two candidates. */
bool ball_nearest(const arb_t x, double *nearest);

#endif
