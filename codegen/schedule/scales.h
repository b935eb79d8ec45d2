/* The scales of a schedule. */
#ifndef FOOTPOINT_SCALES_H
#define FOOTPOINT_SCALES_H

#include "scales_memo.h"

/** Which scales: every value as the graph has it, or in scales that cost fewer multiplications by constants; changed
 *  one by one, or in groups of operands that share a coefficient in a sum, too, which takes longer. */
enum scale_search { SCALES_KEPT, SCALES_SINGLE, SCALES_GROUPS };

/** Returns a finished schedule of the outputs, in such scales; its `work` is that of the search for them.  `memo` may be
 *  NULL. */
struct schedule *scaled_schedule(const struct dag *g, const struct cost_model *model, enum scale_search search,
                                 struct scales_memo *memo);

#endif
