/* Hand-written methods as seeds: what the functions of a tier give, one after the other, from each of its terminals. */
#ifndef FOOTPOINT_COMPOSE_H
#define FOOTPOINT_COMPOSE_H

#include "../eval/objective.h"
#include "../eval/operation_count.h"
#include "../genotype/front.h"

/** Offer compositions of the set's functions to a front, by their errors on some of the objective's samples: all that
 *  begin with the most promising ones.  Deterministic.
 *  @param[in] objective  of decimal numbers */
void compose_twins(const struct gene_set *genes, const struct objective *objective, const struct prices *prices,
                   struct front *found);

#endif
