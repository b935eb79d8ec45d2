/* Trees of operations that await their statement, and the program that collects statements. A tree stores the width of
 * its C text, because short text is written at its use. */
#ifndef FOOTPOINT_OPERATION_TREE_H
#define FOOTPOINT_OPERATION_TREE_H

#include "../graph/rational.h"
#include "../program/dialect.h"

enum { NO_TREE = 0 };

struct tree {
    enum op_kind kind; /* OP_INPUT: a name or an input, operation a of the program; OP_CONSTANT: >= 0 */
    int a, b;          /* trees, or NO_TREE */
    rational constant;
    bool quotient; /* a constant written as a quotient */
    enum level level;
    size_t width; /* characters */
};

struct forest {
    const struct genome_file *file; /* not owned */
    struct program *program;        /* owned: the statements so far */
    struct tree *tree;              /* owned; tree[NO_TREE] is unused */
    size_t trees, tree_room;
    int *waiting; /* owned: a stack */
    size_t waits, wait_room;
};

struct forest forest_new(const struct genome_file *f, size_t outputs);
/** Returns the program, owned by the caller, and frees the rest. */
struct program *forest_take(struct forest *x);

int forest_input(struct forest *x, int input);
int forest_constant(struct forest *x, rational c);
int forest_unary(struct forest *x, enum op_kind kind, int a);
int forest_binary(struct forest *x, enum op_kind kind, int a, int b);
/** Returns a * b; if the product b is `flat`, its factors are multiplied one by one. */
int forest_multiply(struct forest *x, int a, int b, bool flat);
/** Returns -a, with the sign before the first factor of a product. a must not be used any more. */
int forest_negate(struct forest *x, int a);

/** Returns true for a name or an input. */
bool forest_is_name(const struct forest *x, int tree);
/** Returns true for a tree too short to need a name: a name, an input or a decimal. */
bool forest_is_plain(const struct forest *x, int tree);
size_t forest_width(const struct forest *x, int tree);

/** Adds the statement that names a tree by this letter and number; returns the name's tree. */
int forest_name(struct forest *x, char letter, long number, int tree);
/** Adds the statement of the next output. */
void forest_output(struct forest *x, const char *name, int tree);

#endif
