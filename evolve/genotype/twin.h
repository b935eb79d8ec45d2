/* Twin trees: every value in them is two, a half for xi and a half for eta, so that one tree makes both coordinates and
 * what these share is there once.
 *
 *   symbol         itself, and what the frame's `exchange` lines make of it; itself again where they say nothing
 *   number         twice the same
 *   + - * ...      on each half by itself
 *   exchange x     the halves of x in the other order
 *   halves x y     the first half of x, the second half of y
 *   newton x       any `function` of the frame from two numbers to two, of the halves of x
 *
 * A tree is translated to lines, each an operation on earlier ones, in which equal values are there once.  Thus a step
 * of a step grows by a gene and costs what its operations cost. */
#ifndef FOOTPOINT_TWIN_H
#define FOOTPOINT_TWIN_H

#include "tree.h"

/** The exchanges and functions of a program. */
struct twins {
    const struct genome_file *program; /* not owned */
    size_t *partner;                   /* owned: by symbol; what exchanging xi and eta makes of it */
    size_t symbols;
    struct twin_body *body; /* owned: by function */
};
/** The program must outlive it, and may get more lets. */
struct twins *twins_new(const struct genome_file *program);
void twins_free(struct twins *t);

/** An operation on earlier lines; or a leaf, whose gene is a symbol, or -1 for a number. */
struct twin_line {
    int gene, a, b; /* b: -1 where there is one operand; both: -1 of a leaf */
    double number;
};

struct twin_code {
    const struct twins *twins; /* not owned */
    struct twin_line *line;    /* owned */
    bool *needed;              /* owned: by line; a root needs it */
    size_t lines, room;
    int root[2];    /* lines of xi and of eta */
    size_t *number; /* owned: lines of the tree's own numbers, in the order of its genes, where these are kept apart */
    size_t numbers, number_room;
    struct twin_slot *slot; /* owned, as is the rest: the hash table of the lines, and scratch */
    size_t slots;
    unsigned round;
    int (*stack)[2], *map;
    size_t stack_room, map_room;
};
struct twin_code *twin_code_new(const struct twins *t);
void twin_code_free(struct twin_code *c);

/** Translate a tree of decimal numbers.
 *  @param[in] apart  each of its numbers has a line of its own, so that it can be fitted */
void twin_translate(struct twin_code *c, const struct tree *t, bool apart);

#endif
