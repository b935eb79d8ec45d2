/* Reads terms given by hand instead of a search: a line for each output, "xi = yd, xs, xc ys, 1"; # begins a comment. */
#ifndef FOOTPOINT_PGA_TERMS_H
#define FOOTPOINT_PGA_TERMS_H

#include "polynomials.h"

/** Reads the terms of an output ("xi") as a choice among the monomials.  Returns false with *d filled if the file has no line for it,
 *  or a product that is not a monomial of these symbols and this order. */
bool pga_terms_read(const char *path, const char *output, const struct genome_file *program,
                    const struct polynomials *p, gene_bit *chosen, struct diag *d);

#endif
