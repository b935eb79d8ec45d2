/* Operations that wait for their statement, as trees; and the program that statements become.  A tree knows how wide its
 * text is in C, since what is short stands where it is used. */
#ifndef FOOTPOINT_OPERATION_TREE_H
#define FOOTPOINT_OPERATION_TREE_H

#include "../graph/rational.h"
#include "../program/dialect.h"

enum { NO_TREE = 0 };

struct tree {
    enum op_kind kind; /* OP_INPUT: a name or an input, operation a of the program; OP_CONSTANT: > 0 or 0 */
    int a, b;          /* trees; NO_TREE where there is none */
    rational constant;
    bool quotient; /* a constant that is written as one */
    enum level level;
    size_t width; /* characters */
};

struct forest {
    const struct genome_file *file; /* not owned */
    struct program *program;        /* owned: the statements so far */
    struct tree *tree;              /* owned; tree[NO_TREE] is none */
    size_t trees, tree_room;
    int *waiting; /* owned: a stack */
    size_t waits, wait_room;
};

struct forest forest_new(const struct genome_file *f, size_t outputs);
/** The program, which is the caller's; the rest is freed. */
struct program *forest_take(struct forest *x);

int forest_input(struct forest *x, int input);
int forest_constant(struct forest *x, rational c);
int forest_unary(struct forest *x, enum op_kind kind, int a);
int forest_binary(struct forest *x, enum op_kind kind, int a, int b);
/** a * b; of a product b that is `flat` one factor after the other. */
int forest_multiply(struct forest *x, int a, int b, bool flat);
/** -a, the sign before the first factor of a product; a is no longer to be used. */
int forest_negate(struct forest *x, int a);

/** A name or an input. */
bool forest_is_name(const struct forest *x, int tree);
/** So short that it needs no name: a name, an input or a decimal. */
bool forest_is_plain(const struct forest *x, int tree);
size_t forest_width(const struct forest *x, int tree);

/** Adds the statement that gives a tree the name of that letter and number; the name's tree. */
int forest_name(struct forest *x, char letter, long number, int tree);
/** Adds the statement of the next output. */
void forest_output(struct forest *x, const char *name, int tree);

#endif
