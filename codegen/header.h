/* The header file: banner, shared helpers and one function, or pair of functions, a genome. */
#ifndef FOOTPOINT_HEADER_H
#define FOOTPOINT_HEADER_H

#include "compile.h"

/** Print the header of all genomes of a file.  `prefix` begins every name (a C identifier), `sha256` is that of the
 *  genome text.  compiled[f->genomes]. */
void header_print(const struct genome_file *f, const struct compiled *compiled, const char *prefix, const char *sha256,
                  FILE *out);

#endif
