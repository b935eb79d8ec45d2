/* The paper's expression trees, prefix genomes, and the genetic operators on them (sections 4.1 and 4.2). */
#ifndef FOOTPOINT_TREE_H
#define FOOTPOINT_TREE_H

#include "genotype.h"

#include <gsl/gsl_rng.h>

/** Makes a random tree of at most `room` >= 1 genes and at most `depth` >= 0 operators from root to leaf. If `full` is
 *  set, all leaves are at that depth, as long as there is room; otherwise branches end anywhere. */
void tree_random(gsl_rng *rng, const struct gene_set *s, int depth, bool full, size_t room, struct genes *t);

/** Makes two children that exchange random branches of their parents. A child that would have more than `max` genes
 *  becomes a copy of its first parent. */
void tree_cross(gsl_rng *rng, const struct genes *a, const struct genes *b, size_t max, struct genes *child_a,
                struct genes *child_b);

/** Changes one gene to another of its kind: operator to operator, leaf to leaf. */
void tree_mutate_gene(gsl_rng *rng, const struct gene_set *s, struct genes *t);

/** Copies `t` with a random new branch, to at most `max` genes. `t` must have no more. */
void tree_mutate_branch(gsl_rng *rng, const struct gene_set *s, const struct genes *t, size_t max, struct genes *child);

#endif
