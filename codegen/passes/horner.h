/* Extracts common factors from sums. */
#ifndef FOOTPOINT_HORNER_H
#define FOOTPOINT_HORNER_H

#include "../graph/dag.h"
#include "choices.h"

/** Returns a new graph of the same outputs with fewer multiplications. Each sub-sum first extracts the factor that most
 *  of its terms contain, unless the policy overrides it (CHOICE_FACTOR). Free it with dag_free. */
struct dag *horner_factor(const struct dag *g, const struct policy *policy, struct record *record);

#endif
