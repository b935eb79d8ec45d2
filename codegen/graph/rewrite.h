/* Walks a graph, operands first, and builds a new graph: the core of every pass that rewrites a graph. */
#ifndef FOOTPOINT_REWRITE_H
#define FOOTPOINT_REWRITE_H

#include "dag.h"

struct walk {
    const struct dag *from;
    struct dag *to;
    struct value *image; /* owned: of each node of `from`, once visited */
    int *uses;           /* owned: of each node of `from` */
};

struct walk walk_begin(const struct dag *g);
/** Maps the outputs and returns the new graph. */
struct dag *walk_end(struct walk *w);

/** Returns the image of coef * node. */
struct value walk_image(const struct walk *w, const struct edge *e);
/** Returns the node rebuilt from the images of its operands, in the same form. */
struct value walk_map(struct walk *w, const struct node *n);

/** Rebuilds a graph whose node numbers are not a topological order, as share_pairs leaves it. */
struct dag *walk_again(const struct dag *g);

#endif
