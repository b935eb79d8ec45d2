/* What is bred: genes, which are a program (line_program.h) or one of the paper's trees (tree.h). */
#ifndef FOOTPOINT_GENOTYPE_H
#define FOOTPOINT_GENOTYPE_H

#include "../../codegen/genome/genome.h"

#include <stdint.h>

/** One individual's. */
struct genes {
    int *gene; /* not owned; room for the longest genome of its population */
    size_t length;
};

/** The genes that random changes choose from. */
struct gene_set {
    int *symbol; /* owned: variables */
    size_t symbols;
    int *constant; /* owned; decimal numbers (decimal.h), ascending, so that neighbours are near in value */
    size_t constants;
    int *operation;               /* owned; those of two operands, then those of one */
    size_t operations, functions; /* how many of each */
};
void gene_set_free(struct gene_set *s);

void genes_copy(const struct genes *from, struct genes *to);
/** Copy of a tree in prefix form whose decimal numbers become constants of a program. */
void genes_bind(struct genome_file *program, const struct genes *t, struct genes *bound);
bool genes_equal(const struct genes *a, const struct genes *b);
/** 64 bits that identify a genome for all practical purposes. */
uint64_t genes_hash(const struct genes *t);

#endif
