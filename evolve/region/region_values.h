/* The values of a genome file that regions bound. */
#ifndef FOOTPOINT_REGION_VALUES_H
#define FOOTPOINT_REGION_VALUES_H

#include "../../codegen/genome/genome.h"

/** Returns an array indexed by let: a genome depends on it. The caller frees it. */
bool *used_lets(const struct genome_file *f);

/** Returns an array indexed by let: it is used, named, and a quotient or made of quotients. The caller frees it. */
bool *named_quotients(const struct genome_file *f, const bool *used);

/** Returns true if an output is made of quotients and is not itself a let or an input. */
bool output_is_quotient(const struct genome_file *f, const struct genome_expr *out);

/** Extends *lo..*hi to n values; ignores NaN. */
void extend_range(const double *value, size_t n, double *lo, double *hi);

/** Returns the largest of |value - factor mark| and `far`. */
double farthest(const double *value, const double *mark, double factor, size_t n, double far);

/** Adds the range of an input, widened to two decimals. */
void add_range(struct genome_file *f, size_t input, double lo, double hi);

/** Requires the magnitude of an expression of `length` genes to be below `most`, rounded to two digits. */
void require_magnitude(struct genome_file *f, const int *gene, size_t length, double most);

/** Requires an expression to be above `nearest`, or below it if `nearest` is negative. */
void require_sign(struct genome_file *f, const int *gene, size_t length, double nearest);

#endif
