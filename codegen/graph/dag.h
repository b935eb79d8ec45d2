/* The intermediate form: a directed acyclic graph in which every value exists once.
 *
 * A value is a rational coefficient times a primitive node, so factors of 1/4 or -1 never hide an equality.  Nodes are
 * made children first, so their numbers are a topological order.  Two nodes are the same when their values agree at two
 * random points modulo two 60-bit primes (the merge of FFTW's genfft, made exact up to a chance below 2^-100), which
 * finds x-x, x/x and any other identity whatever its shape. */
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
    bool kept;              /* a named value that products leave whole */
    bool divides;           /* it, or what it is made of, divides */
    bool partial;           /* it, or what it is made of, divides or has a root: it has no value somewhere */
    mp_limb_t mark[PRIMES]; /* values at the random points */
};

/** True for a function that is not defined below 0. */
static inline bool node_is_root(enum node_kind kind)
{
    return kind >= NODE_UNARY && !unary_of[kind - NODE_UNARY].negative;
}

/** True for a minimum, a maximum or a protected quotient: what a compiler may make a jump of. */
bool node_chooses(const struct node *n);

/** coef * node: what an expression is. The coefficient of the value 0 is ZERO and its node NODE_ONE. */
struct value {
    rational coef;
    int node;
};

struct dag {
    struct node *node; /* owned */
    size_t nodes, node_room;
    struct edge **pool; /* owned: blocks that hold the nodes' edges; the last one is filled up to pool_used */
    size_t pools, pool_room, pool_used, pool_size;
    struct index_table known; /* nodes by their marks */
    struct value *output;     /* owned */
    char **output_name;       /* owned */
    size_t outputs, output_room, output_name_room;
    size_t inputs;
    struct removal *removed; /* owned: those of graphs that this one was made from, in no order, maybe repeated */
    size_t removals, removal_room;
    int *lost; /* owned: partial nodes that values were made of, and are no more; maybe repeated */
    size_t losses, loss_room;
};

/** A singularity of the genome that the code has not, if nothing else has it: a divisor that cancelled, or a root. */
struct removal {
    mp_limb_t mark[PRIMES]; /* of the divisor, or of what the root is of */
    bool root;
};

/** How many there are. */
struct removed {
    size_t divisions, roots;
};

/** True for a difference of two inputs. */
bool node_is_difference(const struct dag *g, const struct node *n);

struct dag *dag_new(size_t inputs);
void dag_free(struct dag *g);
/** Same nodes, same numbers. */
struct dag *dag_copy(const struct dag *g);
void dag_add_output(struct dag *g, const char *name, struct value v);

/** A list of operands under construction. */
struct edges {
    struct edge *edge; /* owned */
    size_t n, room;
};
void edges_add(struct edges *list, rational coef, int node, int power);
void edges_clear(struct edges *list);

/** Makers.  Lists are consumed: emptied on return. */
struct value dag_constant(rational c);
struct value dag_input(struct dag *g, size_t input);
struct value dag_sum(struct dag *g, struct edges *terms);
/** coef times the product of node^power; powers may be negative: those are divided by. */
struct value dag_product(struct dag *g, rational coef, struct edges *factors);
/** a * b, for a few factors at hand. */
struct value dag_times(struct dag *g, struct value a, struct value b);
/** 1/a; a must not be 0. */
struct value dag_inverse(struct dag *g, struct value a);
/** NODE_PDIV, NODE_MIN, NODE_MAX of two values; NODE_UNARY + k of one (b ignored).  A number where the operands are. */
struct value dag_function(struct dag *g, enum node_kind kind, struct value a, struct value b);

/** The number that a value is, of whatever form, if it is a short one; or the value. */
struct value dag_number(struct dag *g, struct value v);

/** A node that is not looked up, with room for its n edges; the caller fills them. */
int dag_append(struct dag *g, enum node_kind kind, const struct edge *edge, size_t n);
/** Room for n edges in the graph's pool. */
struct edge *dag_room(struct dag *g, size_t n);

/** Notes that a value is no longer made of a node: whatever that divides by, and its roots, may be gone. */
void dag_lose(struct dag *g, int node);
/** Notes that a value is no longer divided by a node. */
void dag_remove(struct dag *g, int node);
/** What was removed from `from` is removed from g, too. */
void dag_inherit_removed(struct dag *g, const struct dag *from);
/** How many different divisors and roots were removed and are none of the used ones any more. */
struct removed dag_removed(const struct dag *g);

/** Greatest |power| with which any used value grows when all inputs are scaled together: what decides at which scale
 *  values leave the range of double. */
int dag_degree(const struct dag *g);

/** How often each node is used by the outputs, directly or not; unused nodes have 0.  uses[g->nodes], caller frees. */
int *dag_uses(const struct dag *g);

#endif
