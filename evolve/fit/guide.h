/* Terms for programs that their derivatives suggest, by reverse-mode differentiation on some of the samples. */
#ifndef FOOTPOINT_GUIDE_H
#define FOOTPOINT_GUIDE_H

#include "../eval/lines_run.h"
#include "../genotype/lines_edit.h"

struct guide;
/** For programs over a table, of which it looks at the first rows. */
struct guide *guide_new(const struct line_rules *r, const struct columns *table);
void guide_free(struct guide *g);

/** Copies a program with a term c x y added to one of its lines: of hundreds of terms the one that promises most.
 *  Returns false, with *child undefined, if none promises anything.
 *  @param[in] last  function that the program ends in; -1: none */
bool guide_insert(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                  size_t max, struct genes *child);

#endif
