/* Bounds of rounding errors, forwards. */
#ifndef FOOTPOINT_ROUNDING_FORWARDS_H
#define FOOTPOINT_ROUNDING_FORWARDS_H

#include "rounding_parts.h"

/** The errors of operation i from those of its operands. */
void rounding_propagate(struct rounding *e, size_t i);

/** What rounding the operation itself adds: up to share |value| + constant. */
double rounding_own_share(const struct rounding *e, int i, double *constant);

/** 1/n of an n-th root, 0 of what is none. */
double rounding_power(const struct op *op);
/** Derivative of an n-th root of a, which is that root / (n a); of other functions nothing is known. */
struct interval rounding_function_slope(const struct op *op, struct interval a);

/** A bound of the error of a value up to `most`, padded for the roundings of the bound itself; NaN, anything below 0, and what
 *  may overflow, is none. */
double rounding_checked(const struct rounding *e, double error, double most);

#endif
