/* Reads programs from the lets and outputs of a genome file, and writes them there.
 *
 * A function that programs end in is called like this:
 *
 *     let NAME_u = ...
 *     let NAME_v = ...
 *     let NAME_xi NAME_eta ... = FUNCTION NAME_u NAME_v
 *
 * Its results other than xi and eta are measured as divisors are. */
#ifndef FOOTPOINT_LINES_TEXT_H
#define FOOTPOINT_LINES_TEXT_H

#include "line_program.h"

/** Reads the program that computes two expressions of a file from the values of c's program that are symbols of the
 *  set, matched by name. Numbers are rounded to decimals.
 *  @param[in] called  the expressions are results of a function call: reads its arguments, whichever function it is
 *  @returns false, with *t undefined, if it needs other inputs, has more than max genes, or `called` is set without a
 *  call */
bool lines_read(struct lines *c, const struct genome_file *f, const struct genome_expr *const out[2],
                const struct gene_set *genes, bool called, size_t max, struct genes *t);

/** Reads the program of two values of c's program, by name, from the symbols of the set.
 *  @returns as lines_read() */
bool lines_read_values(struct lines *c, char *const name[2], const struct gene_set *genes, size_t max, struct genes *t);

/** Rewrites a program as if its text had been read: values introduced by functions that are not symbols of the set are
 *  replaced by their definitions.
 *  @returns false, with *to undefined, if the result has more than max genes */
bool lines_respell(struct lines *c, const struct genes *t, const struct gene_set *genes, size_t max, struct genes *to);

/** Writes a program as expressions of the file to which the rules belong. Values used twice and divisors become lets
 *  <name>_1, <name>_2, ..., or reuse lets of a program written before. Divisors are measured (`least`).
 *  @param[out] out  xi and eta; genes owned by the caller; constants belong to the file */
void lines_expand(struct lines *c, const struct genes *t, int last, struct genome_file *f, const char *name,
                  struct genes out[2]);

/** Returns the program as a line of text, owned by the caller. */
char *lines_print(struct lines *c, const struct genes *t, int last);

#endif
