/* Genotypes: genes that encode a program (line_program.h) or one of the paper's trees (tree.h). */
#ifndef FOOTPOINT_GENOTYPE_H
#define FOOTPOINT_GENOTYPE_H

#include "../../codegen/genome/genome.h"

#include <stdint.h>

/** The genes of an individual. */
struct genes {
    int *gene; /* not owned; must have room for the longest genome of its population */
    size_t length;
};

/** The genes from which random changes choose. */
struct gene_set {
    int *symbol; /* owned: variables */
    size_t symbols;
    int *constant; /* owned: decimal numbers (decimal.h), ascending, so that neighbours are close in value */
    size_t constants;
    int *operation;               /* owned: binary operators, then unary operators */
    size_t operations, functions; /* number of each */
};
void gene_set_free(struct gene_set *s);

void genes_copy(const struct genes *from, struct genes *to);
/** Copies a prefix tree and replaces its decimal numbers with constants of `program`. */
void genes_bind(struct genome_file *program, const struct genes *t, struct genes *bound);
bool genes_equal(const struct genes *a, const struct genes *b);
/** Returns a 64-bit hash, which callers treat as unique to the genome. */
uint64_t genes_hash(const struct genes *t);

#endif
