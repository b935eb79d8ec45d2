/* Twin trees as text, and as lets and outputs of a genome file. */
#ifndef FOOTPOINT_TWIN_TEXT_H
#define FOOTPOINT_TWIN_TEXT_H

#include "twin.h"

/** Gene of an operator of the genome text, "exchange", "halves" or a function of the file from two numbers
 *  to two; -1: there is none. */
int twin_gene(const struct genome_file *f, const char *name);

/** The tree in prefix order, words between blanks; owned by the caller. */
char *twin_print(const struct genome_file *f, const struct tree *t);
/** Such a text as a tree, whose genes the caller owns; numbers are rounded to decimals.  False where it is none. */
bool twin_parse(const struct genome_file *f, const char *text, struct tree *t);

/** Write a tree as expressions of the file that the twins are of: values that are used twice, and divisors, become lets
 *  <name>_1, <name>_2, ..., from which xi and eta follow; divisors are measured as least_<name>_1, ...
 *  @param[out] out  genes owned by the caller; constants are the file's */
void twin_expand(const struct twins *twins, const struct tree *t, struct genome_file *f, const char *name,
                 struct tree out[2]);

#endif
