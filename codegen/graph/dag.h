/* The intermediate form: a directed acyclic graph in which every value exists once.
 *
 * A value is a rational coefficient times a primitive node, so factors of 1/4 or -1 never hide an equality. Operands
 * are made before their users, so node numbers are a topological order. Two nodes are the same if their values agree at
 * two random points modulo two 60-bit primes (the merge of FFTW's genfft, exact up to a chance below 2^-100). This
 * finds x-x, x/x and every other identity, whatever its form. */
#ifndef FOOTPOINT_DAG_H
#define FOOTPOINT_DAG_H

#include "../base/index_table.h"
#include "../genome/genome.h"
#include "rational.h"

enum node_kind {
    NODE_ONE,     /* the constant 1; node 0 */
    NODE_INPUT,   /* input `input` */
    NODE_SUM,     /* sum of coef * node; the first coefficient is 1 */
    NODE_PRODUCT, /* product of node^power, power > 0; no coefficients */
    NODE_INVERSE, /* 1 / node */
#define NODE(gene, ...) NODE_##gene,
    CHOICES(NODE) /* NODE_PDIV: edge 1 is 0 ? 1 : edge 0 / edge 1 */
    UNARY(NODE)
#undef NODE
        NODE_UNARY = NODE_MAX + 1 /* + k: function k of one number */
};

/** An operand: coef * node^power. */
struct edge {
    rational coef;
    int node;
    int power;
};

struct node {
    enum node_kind kind;
    int input;
    struct edge *edge; /* owned by the graph */
    size_t edges;
    bool kept;              /* a named value that products do not expand */
    bool divides;           /* it, or a value that it uses, divides */
    bool partial;           /* it, or a value that it uses, divides or has a root, so that it is undefined somewhere */
    mp_limb_t mark[PRIMES]; /* values at the random points */
};

/** Returns true for a function that is undefined below 0. */
static inline bool node_is_root(enum node_kind kind)
{
    return kind >= NODE_UNARY && !unary_of[kind - NODE_UNARY].negative;
}

/** Returns true for a minimum, maximum or protected quotient, which compilers may turn into a branch. */
bool node_chooses(const struct node *n);

/** The value of an expression: coef * node. The value 0 has coefficient ZERO and node NODE_ONE. */
struct value {
    rational coef;
    int node;
};

struct dag {
    struct node *node; /* owned */
    size_t nodes, node_room;
    struct edge **pool; /* owned: blocks of the nodes' edges; the last is used up to pool_used */
    size_t pools, pool_room, pool_used, pool_size;
    struct index_table known; /* nodes by their marks */
    struct value *output;     /* owned */
    char **output_name;       /* owned */
    size_t outputs, output_room, output_name_room;
    size_t inputs;
    struct removal *removed; /* owned: removals in the graphs from which this one was made, unordered, with
                              * duplicates */
    size_t removals, removal_room;
    int *lost; /* owned: partial nodes that values no longer use; with duplicates */
    size_t losses, loss_room;
};

/** A singularity of the genome that the code lacks, unless another value has it: a cancelled divisor, or a root. */
struct removal {
    mp_limb_t mark[PRIMES]; /* of the divisor, or of the root's argument */
    bool root;
};

/** Their numbers. */
struct removed {
    size_t divisions, roots;
};

/** Returns true for a difference of two inputs. */
bool node_is_difference(const struct dag *g, const struct node *n);

struct dag *dag_new(size_t inputs);
void dag_free(struct dag *g);
/** Returns a copy with the same node numbers. */
struct dag *dag_copy(const struct dag *g);
void dag_add_output(struct dag *g, const char *name, struct value v);

/** A list of operands under construction. */
struct edges {
    struct edge *edge; /* owned */
    size_t n, room;
};
void edges_add(struct edges *list, rational coef, int node, int power);
void edges_clear(struct edges *list);

/** Makers. Lists are consumed: empty on return. */
struct value dag_constant(rational c);
struct value dag_input(struct dag *g, size_t input);
struct value dag_sum(struct dag *g, struct edges *terms);
/** Returns coef times the product of node^power; negative powers divide. */
struct value dag_product(struct dag *g, rational coef, struct edges *factors);
/** Returns a * b, for short lists of factors. */
struct value dag_times(struct dag *g, struct value a, struct value b);
/** Returns 1/a; a must not be 0. */
struct value dag_inverse(struct dag *g, struct value a);
/** Returns NODE_PDIV, NODE_MIN or NODE_MAX of two values, or NODE_UNARY + k of one (b is ignored). Constant operands
 *  give a constant. */
struct value dag_function(struct dag *g, enum node_kind kind, struct value a, struct value b);

/** Returns the number that a value equals, whatever its form, if the number is short; otherwise the value. */
struct value dag_number(struct dag *g, struct value v);

/** Appends a node with room for n edges, without looking it up; the caller fills them. */
int dag_append(struct dag *g, enum node_kind kind, const struct edge *edge, size_t n);
/** Returns room for n edges in the graph's pool. */
struct edge *dag_room(struct dag *g, size_t n);

/** Notes that a value no longer uses a node, so that the node's divisors and roots may be gone. */
void dag_lose(struct dag *g, int node);
/** Notes that a value is no longer divided by a node. */
void dag_remove(struct dag *g, int node);
/** Copies what was removed from `from` to g. */
void dag_inherit_removed(struct dag *g, const struct dag *from);
/** Counts the different divisors and roots that were removed and that no used node has. */
struct removed dag_removed(const struct dag *g);

/** Returns the greatest |power| with which any used value scales when all inputs are scaled together. It decides at
 *  which scale values leave the range of double. */
int dag_degree(const struct dag *g);

/** Returns uses[g->nodes], how often the outputs use each node, directly or not; unused nodes have 0. The caller frees
 *  it. */
int *dag_uses(const struct dag *g);

#endif
