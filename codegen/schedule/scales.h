/* The scales of a schedule. */
#ifndef FOOTPOINT_SCALES_H
#define FOOTPOINT_SCALES_H

#include "scales_memo.h"

/** How scales are chosen: values as in the graph, or with fewer multiplications by constants, found by changing single
 *  scales, or also groups of operands that share a coefficient in a sum, which takes longer. */
enum scale_search { SCALES_KEPT, SCALES_SINGLE, SCALES_GROUPS };

/** Returns a finished schedule of the outputs with such scales; its `work` is the search's. `memo` may be NULL. */
struct schedule *scaled_schedule(const struct dag *g, const struct cost_model *model, enum scale_search search,
                                 struct scales_memo *memo);

#endif
