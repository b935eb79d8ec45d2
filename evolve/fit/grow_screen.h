/* Which terms added to a tree would lower its error, by one projection each. */
#ifndef FOOTPOINT_GROW_SCREEN_H
#define FOOTPOINT_GROW_SCREEN_H

#include "../genotype/term.h"
#include "fit_constants.h"

struct term_list {
    struct term *term; /* owned */
    size_t n, room;
};

/** Candidates to be added to the tree on the fitter's tape: a constant, or a constant or 1 or -1 times one or two of
 * the symbols, at the root or at an operand of anything but a sum.  Gains are those of sum r^2 / sqrt(r^2 + scale^2)
 *  over the fitter's table, to first order and after all other constants have followed; those that constants there
 *  could take as well are left out. */
void screen_terms(struct fitter *f, size_t target, double scale, const int *symbol, size_t symbols,
                  struct term_list *found);

#endif
