/* From one graph to another, operands first: what every pass that rewrites a graph does. */
#ifndef FOOTPOINT_REWRITE_H
#define FOOTPOINT_REWRITE_H

#include "dag.h"

struct walk {
    const struct dag *from;
    struct dag *to;
    struct value *image; /* owned: of each node of `from`, once it was reached */
    int *uses;           /* owned: of each node of `from` */
};

struct walk walk_begin(const struct dag *g);
/** Maps the outputs; returns the new graph. */
struct dag *walk_end(struct walk *w);

/** Image of coef * node. */
struct value walk_image(const struct walk *w, const struct edge *e);
/** The node made anew from the images of its operands, in the same form. */
struct value walk_map(struct walk *w, const struct node *n);

/** A graph whose node numbers are no topological order, as share_pairs leaves it, made anew. */
struct dag *walk_again(const struct dag *g);

#endif
