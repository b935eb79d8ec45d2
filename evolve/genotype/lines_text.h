/* Programs and genome files: read from a genome's lets and outputs, and written as such.
 *
 * A function that programs end in is called:
 *
 *     let NAME_u = ...
 *     let NAME_v = ...
 *     let NAME_xi NAME_eta ... = FUNCTION NAME_u NAME_v
 *
 * What it gives besides xi and eta is measured as divisors are. */
#ifndef FOOTPOINT_LINES_TEXT_H
#define FOOTPOINT_LINES_TEXT_H

#include "line_program.h"

/** The program that two expressions of a file make, of those values of c's program alone that are among the set's
 *  symbols, by name.  Numbers are rounded to decimals.
 *  @param[in] called  they are what a function gives, any one, which is left away
 *  @returns false, with *t undefined, where it needs other inputs, or has more than max genes, or nothing is called */
bool lines_read(struct lines *c, const struct genome_file *f, const struct genome_expr *const out[2],
                const struct gene_set *genes, bool called, size_t max, struct genes *t);

/** A program as reading its text gives it: values that functions bring along and that are none of the set's symbols are
 *  what they are made of.
 *  @returns false, with *to undefined, where that has more than max genes */
bool lines_respell(struct lines *c, const struct genes *t, const struct gene_set *genes, size_t max, struct genes *to);

/** Write a program as expressions of the file that the rules are of: values that are used twice, and divisors, become
 *  lets <name>_1, <name>_2, ..., or are those of a program written before; xi and eta follow from them, and divisors are
 *  measured (`least`)
 *  @param[out] out  genes owned by the caller; constants are the file's */
void lines_expand(struct lines *c, const struct genes *t, int last, struct genome_file *f, const char *name,
                  struct genes out[2]);

/** The program in one line of text; owned by the caller. */
char *lines_print(struct lines *c, const struct genes *t, int last);

#endif
