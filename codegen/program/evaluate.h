/* Evaluates a program at a point: in double as the C text prescribes, and exactly. */
#ifndef FOOTPOINT_EVALUATE_H
#define FOOTPOINT_EVALUATE_H

#include "../base/random.h"
#include "program.h"

#include <arb.h>
#include <stdint.h>

/** Returns the result of an operation in double. */
double point_operation(enum op_kind kind, double a, double b);

/** Computes the values of the constants; leaves other operations unchanged. */
void point_constants(const struct program *p, double *value);

/** Computes the values of all operations in double except constants, which must be set already. contract: NULL, or a
 *  stream of random numbers that decides for each sum of products whether, and in which way, it becomes one fma(), as
 *  compilers may choose. */
void point_double(const struct program *p, const double *input, uint64_t *contract, double *value);

/** Returns the double of a constant in the text. *error: its distance from the constant, rounded up. */
double point_constant(const struct program *p, const struct op *op, double *error);

/** Computes exact values of all outputs, as balls of at least 64 good bits. Returns false if a value is undefined or
 *  too hard to find. */
bool point_exact(const struct program *p, const double *input, arb_ptr output);

/** Computes exact values of the first `ops` operations at a rational point. Values that are undefined, irrational or
 *  too long are not `defined`, nor are values that depend on them. */
void point_rational(const struct program *p, size_t ops, const fmpq *input, fmpq *value, bool *defined);

double double_nearest(const fmpq *q);
float single_nearest(const fmpq *q);

/** Converts a double exactly. */
void double_rational(fmpq *q, double x);

/** Finds the double nearest to a ball's number; returns false if the ball contains two candidates. */
bool ball_nearest(const arb_t x, double *nearest);

#endif
