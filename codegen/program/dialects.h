/* The dialects of C; see dialect.h. */
#ifndef FOOTPOINT_DIALECTS_H
#define FOOTPOINT_DIALECTS_H

#include "dialect.h"

/** In double, the words that program_read reads; in float; in float, of coordinates yA, yB, ... relative to the segment. */
extern const struct dialect c_double, c_float, c_relative;

/** Writes the statements, the last ones set *out_... (segment: *xi, *eta); if out is NULL, the printer alone is made. */
struct printer *c_statements(const struct genome_file *f, const struct genome *genome, const struct program *p,
                             const struct dialect *d, FILE *out);

#endif
