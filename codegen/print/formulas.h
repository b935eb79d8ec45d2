/* Prints programs as formulas: plain infix for other programs, LaTeX for people. */
#ifndef FOOTPOINT_FORMULAS_H
#define FOOTPOINT_FORMULAS_H

#include "../compile/compiled_file.h"

/** Prints a formula a line for each named value and output, with an empty line between genomes; in LaTeX an align environment a
 *  genome.  Returns false with *d filled if an output has the name of an input. */
bool formulas_print(const struct unit *u, bool latex, FILE *out, struct diag *d);

#endif
