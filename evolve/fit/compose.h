/* Hand-written methods as seeds of programs: compositions of a tier's functions, applied to each of its starts. */
#ifndef FOOTPOINT_COMPOSE_H
#define FOOTPOINT_COMPOSE_H

#include "../eval/objective.h"
#include "../eval/operation_count.h"
#include "../genotype/front.h"

/** Returns true if two tiers of programs differ only in name and budget, and so compose the same seeds. */
bool compose_alike(const struct tier *a, const struct tier *b);

/** Offers programs to a front, with errors on a part of the objective's samples: the starts, and the compositions that
 *  continue the most promising ones. Deterministic.
 *  @param[in] objective  must use decimal numbers */
void compose_programs(const struct tier *tier, const struct gene_set *genes, const struct objective *objective,
                      int last, const struct prices *prices, struct front *found);

#endif
