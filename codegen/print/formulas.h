/* Programs as formulas: plain infix for other programs to read, LaTeX for people. */
#ifndef FOOTPOINT_FORMULAS_H
#define FOOTPOINT_FORMULAS_H

#include "../compile/compiled_file.h"

/** One formula a line for each named value and output, genomes apart by an empty line; in LaTeX an align environment a
 *  genome.  False with *d filled if an output has the name of an input. */
bool formulas_print(const struct unit *u, bool latex, FILE *out, struct diag *d);

#endif
