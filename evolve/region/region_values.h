/* Which values of a genome file regions speak of. */
#ifndef FOOTPOINT_REGION_VALUES_H
#define FOOTPOINT_REGION_VALUES_H

#include "../../codegen/genome/genome.h"

/** By let: the genomes depend on it.  Caller frees. */
bool *used_lets(const struct genome_file *f);

/** By let: it is used, a quotient or made of such, and has a name.  Caller frees. */
bool *named_quotients(const struct genome_file *f, const bool *used);

/** Whether an output is more than a let or an input, and made of quotients. */
bool output_is_quotient(const struct genome_file *f, const struct genome_expr *out);

/** The range of an input, widened to two decimals. */
void add_range(struct genome_file *f, size_t input, double lo, double hi);

/** Require an expression of `length` genes to be below a number, of a magnitude; in two digits. */
void require_magnitude(struct genome_file *f, const int *gene, size_t length, double most);

/** The same to be above `nearest`, or below it where that is below 0. */
void require_sign(struct genome_file *f, const int *gene, size_t length, double nearest);

#endif
