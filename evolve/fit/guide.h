/* Changes of programs that their derivatives suggest, by reverse-mode differentiation on some of the samples. */
#ifndef FOOTPOINT_GUIDE_H
#define FOOTPOINT_GUIDE_H

#include "../eval/lines_run.h"
#include "../genotype/lines_edit.h"

struct guide;
/** For programs over a table, of which it looks at the first rows. */
struct guide *guide_new(const struct line_rules *r, const struct columns *table);
void guide_free(struct guide *g);

/** A copy with a term c x y added to one of its lines: of those looked at the one that promises most.  False, with
 *  *child undefined, where none promises anything.
 *  @param[in] last  function that the program ends in; -1: none */
bool guide_insert(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                  size_t max, struct genes *child);
/** A copy with one of its lines replaced by a number, or by another value times a number: of those looked at the one
 *  that promises the least error for each operation saved. */
bool guide_prune(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t, int last,
                 size_t max, struct genes *child);
/** A copy with two of its lines that are near the answers replaced: by the mate's answers, by lines of the mate that are
 *  near them, or by what one of the set's functions makes of them. */
bool guide_restart(struct guide *g, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                   const struct genes *mate, int last, size_t max, struct genes *child);

#endif
