/* Terms that are added to trees and dropped from them. */
#ifndef FOOTPOINT_TERM_H
#define FOOTPOINT_TERM_H

#include "tree.h"

enum { TERM_SYMBOLS = 2, TERM_GENES = 2 + 2 * TERM_SYMBOLS };

/** A constant times up to two symbols, to be added to the branch that begins at gene `at`. */
struct term {
    size_t at;
    int symbol[TERM_SYMBOLS]; /* genes */
    size_t symbols;
    double coefficient;
    bool unit;   /* it is 1 or -1 and needs no multiplication; there is a symbol */
    double gain; /* what the term is expected to take from the loss */
};

/** Copy a tree, which grows by at most TERM_GENES, with the term added. */
void term_insert(const struct tree *t, const struct term *x, struct tree *to);
/** A term without a coefficient that the sum it would join has already: twice it is a multiplication after all. */
bool term_repeats(const struct tree *t, const struct term *x);
/** Copy a tree without the terms and factors that constants of 0 make superfluous. */
void terms_drop_zeros(const struct tree *t, struct tree *to);

#endif
