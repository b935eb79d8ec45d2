/* Operations of a tree, equal branches counted once. */
#ifndef FOOTPOINT_TALLY_H
#define FOOTPOINT_TALLY_H

#include "tree.h"

struct tally {
    size_t mul, add, div, other; /* add: sums and differences; other: the operators of codegen/genome.h beside these */
};
struct tally tally_tree(const struct tree *t);

#endif
