/* Expression trees as prefix genomes, and the genetic operators on them (sections 4.1 and 4.2 of the paper). */
#ifndef FOOTPOINT_TREE_H
#define FOOTPOINT_TREE_H

#include "../../codegen/genome/genome.h"

#include <gsl/gsl_rng.h>
#include <stdint.h>

/** A genome under breeding. */
struct tree {
    int *gene; /* not owned; room for the longest genome of its population */
    size_t length;
};

/** The genes that random trees are made of. */
struct gene_set {
    int *symbol; /* owned: variables */
    size_t symbols;
    int *constant; /* owned; decimal numbers (decimal.h), ascending, so that neighbours are near in value */
    size_t constants;
    int *operation;               /* owned; those of two operands, then those of one */
    size_t operations, functions; /* how many of each */
};
void gene_set_free(struct gene_set *s);

/** A random tree of at most `room` >= 1 genes and `depth` >= 0 operators from root to leaf.  `full`: leaves stand at
 *  that depth alone (while there is room); otherwise branches end anywhere. */
void tree_random(gsl_rng *rng, const struct gene_set *s, int depth, bool full, size_t room, struct tree *t);

/** Two children that exchange a random branch of their parents.  A child that would be longer than `max` genes is a
 *  copy of its first parent instead. */
void tree_cross(gsl_rng *rng, const struct tree *a, const struct tree *b, size_t max, struct tree *child_a,
                struct tree *child_b);

/** Change one gene to another of its kind: operator to operator, leaf to leaf. */
void tree_mutate_gene(gsl_rng *rng, const struct gene_set *s, struct tree *t);

/** Copy of `t` with a random new branch; at most `max` genes. t has no more than that. */
void tree_mutate_branch(gsl_rng *rng, const struct gene_set *s, const struct tree *t, size_t max, struct tree *child);

void tree_copy(const struct tree *from, struct tree *to);
/** Copy of a tree whose decimal numbers become constants of a program. */
void tree_bind(struct genome_file *program, const struct tree *t, struct tree *bound);
bool tree_equal(const struct tree *a, const struct tree *b);
/** 64 bits that identify a genome for all practical purposes. */
uint64_t tree_hash(const struct tree *t);

#endif
