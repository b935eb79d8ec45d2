/* Coefficients of outputs, absorbed by what their sums are made of. */
#ifndef FOOTPOINT_ABSORB_H
#define FOOTPOINT_ABSORB_H

#include "../graph/dag.h"

/** A new graph in which sums that stand only in outputs, several with the same coefficient c, hold it themselves, and a
 *  product among their terms takes it from a factor that is a term, too: c (x + x y) is v + v y with v = c x.  Node
 *  numbers are a topological order, but values are not unique.  NULL if there is no such coefficient. */
struct dag *absorb_coefficients(const struct dag *g);

#endif
