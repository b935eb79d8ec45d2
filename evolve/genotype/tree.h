/* The paper's expression trees, prefix genomes, and the genetic operators on them (sections 4.1 and 4.2). */
#ifndef FOOTPOINT_TREE_H
#define FOOTPOINT_TREE_H

#include "genotype.h"

#include <gsl/gsl_rng.h>

/** A random tree of at most `room` >= 1 genes and `depth` >= 0 operators from root to leaf.  `full`: leaves stand at
 *  that depth alone (while there is room); otherwise branches end anywhere. */
void tree_random(gsl_rng *rng, const struct gene_set *s, int depth, bool full, size_t room, struct genes *t);

/** Two children that exchange a random branch of their parents.  A child that would be longer than `max` genes is a
 *  copy of its first parent instead. */
void tree_cross(gsl_rng *rng, const struct genes *a, const struct genes *b, size_t max, struct genes *child_a,
                struct genes *child_b);

/** Change one gene to another of its kind: operator to operator, leaf to leaf. */
void tree_mutate_gene(gsl_rng *rng, const struct gene_set *s, struct genes *t);

/** Copy of `t` with a random new branch; at most `max` genes. t has no more than that. */
void tree_mutate_branch(gsl_rng *rng, const struct gene_set *s, const struct genes *t, size_t max, struct genes *child);

#endif
