/* Terms to add to programs, suggested by reverse-mode differentiation on a part of the samples. */
#ifndef FOOTPOINT_GUIDE_H
#define FOOTPOINT_GUIDE_H

#include "../eval/lines_run.h"
#include "../genotype/lines_edit.h"

struct guide;
/** Returns a workspace for programs over a table; it looks at the first rows only. */
struct guide *guide_new(const struct line_rules *r, const struct columns *table);
void guide_free(struct guide *g);

/** Copies a program and adds a term c x y to one of its lines: the most promising of hundreds of terms. Returns false,
 *  with *child undefined, if no term reduces the error.
 *  @param[in] last  function that the program ends in, or -1 */
bool guide_insert(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                  size_t max, struct genes *child);

#endif
