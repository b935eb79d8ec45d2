/* Hand-written methods as seeds of programs: what the functions of a tier give, one after the other, from each of its
 * starts. */
#ifndef FOOTPOINT_COMPOSE_H
#define FOOTPOINT_COMPOSE_H

#include "../eval/objective.h"
#include "../eval/operation_count.h"
#include "../genotype/front.h"

/** Tiers of programs that differ in nothing but their names and budgets compose the same. */
bool compose_alike(const struct tier *a, const struct tier *b);

/** Offer programs to a front, by their errors on some of the objective's samples: the starts, and the compositions of
 *  functions that begin with the most promising ones.  Deterministic.
 *  @param[in] objective  of decimal numbers */
void compose_programs(const struct tier *tier, const struct gene_set *genes, const struct objective *objective,
                      int last, const struct prices *prices, struct front *found);

#endif
