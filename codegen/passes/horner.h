/* Common factors taken out of sums. */
#ifndef FOOTPOINT_HORNER_H
#define FOOTPOINT_HORNER_H

#include "../graph/dag.h"
#include "choices.h"

/** A new graph of the same outputs with fewer multiplications.  Each sub-sum first gives up the factor that most of its
 *  terms hold, unless the policy says otherwise (CHOICE_FACTOR).  Free with dag_free. */
struct dag *horner_factor(const struct dag *g, const struct policy *policy, struct record *record);

#endif
