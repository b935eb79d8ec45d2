/* The intermediate form: a directed acyclic graph in which every value exists once.
 *
 * A value is a rational coefficient times a primitive node, so factors of 1/4 or -1 never hide an equality.  Nodes are
 * made children first, so their numbers are a topological order.  Two nodes are the same when their values agree at two
 * random points modulo two 60-bit primes (the merge of FFTW's genfft, made exact up to a chance below 2^-100), which
 * finds x-x, x/x and any other identity whatever its shape. */
#ifndef FOOTPOINT_DAG_H
#define FOOTPOINT_DAG_H

#include "genome.h"

#include <flint/fmpq.h>

enum node_kind {
    NODE_ONE,     /* the constant 1; node 0 */
    NODE_INPUT,   /* input `input` */
    NODE_SUM,     /* sum of coef * node; the first coefficient is 1 */
    NODE_PRODUCT, /* product of node^power, power > 0; no coefficients */
    NODE_INVERSE, /* 1 / node */
    NODE_PDIV,    /* edge 1 is 0 ? 1 : edge 0 / edge 1 */
    NODE_MIN,
    NODE_MAX,
    NODE_SQRT,
    NODE_ABS
};

/** An operand: coef * node^power. */
struct edge {
    fmpq_t coef; /* owned by the node that holds the edge */
    int node;
    int power;
};

struct node {
    enum node_kind kind;
    int input;
    struct edge *edge; /* owned */
    size_t edges;
    bool kept;             /* a named value that products leave whole */
    unsigned long mark[2]; /* values at the two random points */
};

/** coef * node: what an expression is. The coefficient of the value 0 is 0 and its node NODE_ONE. */
struct value {
    fmpq_t coef;
    int node;
};

struct dag {
    struct node *node; /* owned */
    size_t nodes, node_room;
    int *bucket; /* owned: hash table of node numbers + 1 */
    size_t buckets;
    struct value *output; /* owned */
    char **output_name;   /* owned */
    size_t outputs, output_room, output_name_room;
    size_t inputs;
    size_t removed; /* singularities that cancellation removed (x/x and the like) */
};

struct dag *dag_new(size_t inputs);
void dag_free(struct dag *g);
/** Same nodes, same numbers. */
struct dag *dag_copy(const struct dag *g);
void dag_add_output(struct dag *g, const char *name, const struct value *v);

/** A list of operands under construction; coefficients are owned by the list. */
struct edges {
    struct edge *edge; /* owned */
    size_t n, room;
};
void edges_add(struct edges *list, const fmpq *coef, int node, int power);
void edges_clear(struct edges *list);

void value_init(struct value *v); /* 0 */
void value_clear(struct value *v);

/** Each maker sets *v, initialised by the caller.  Lists are consumed: emptied on return. */
void dag_input(struct dag *g, size_t input, struct value *v);
void dag_sum(struct dag *g, struct edges *terms, struct value *v);
/** coef times the product of node^power; powers may be negative: those are divided by. */
void dag_product(struct dag *g, const fmpq_t coef, struct edges *factors, struct value *v);
/** 1/a.  False if a is identically 0. */
bool dag_inverse(struct dag *g, const struct value *a, struct value *v);
/** NODE_PDIV, NODE_MIN, NODE_MAX of two values; NODE_SQRT, NODE_ABS of one (b ignored). */
void dag_function(struct dag *g, enum node_kind kind, const struct value *a, const struct value *b, struct value *v);

/** How often each node is used by the outputs, directly or not; unused nodes have 0.  uses[g->nodes], caller frees. */
int *dag_uses(const struct dag *g);

#endif
