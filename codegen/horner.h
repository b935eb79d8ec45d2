/* Factoring of sums: Horner's rule for several variables. */
#ifndef FOOTPOINT_HORNER_H
#define FOOTPOINT_HORNER_H

#include "dag.h"

/** A new graph with the same outputs, sums factored.  Free with dag_free. */
struct dag *horner_factor(const struct dag *g);

#endif
