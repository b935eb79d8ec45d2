/* The cost of a tree: its operations, each value computed once. */
#ifndef FOOTPOINT_OPERATION_COUNT_H
#define FOOTPOINT_OPERATION_COUNT_H

#include "../genotype/line_program.h"

/** Operations of a tree, in which equal values count once. Operands of + and * may be swapped, and values that differ
 *  only in sign are equal. Factors 1 and -1, terms 0 and changes of sign are free. A product with 0 is not computed,
 *  operations on constants are folded, and a quotient by a constant is a product. */
struct operation_count {
    unsigned mul, add, div;
    unsigned other; /* square roots, absolute values, minima, maxima */
    double path;    /* longest chain of dependent operations, in units of a sum; a quotient counts 3.25 */
    uint64_t hash;  /* equal for trees whose values are equal by these rules and which so have equal errors */
};

/** Prices of operations, in units of a multiplication. Any other operation costs as much as a sum. */
struct prices {
    double add, div;
    double path; /* extra price of a sum on the longest chain */
};
double operations_price(const struct operation_count *o, const struct prices *m);

/** Workspace. */
struct counter;
struct counter *counter_new(void);
void counter_free(struct counter *c);

/** Counts in time proportional to the number of genes.
 *  @param[in] constant  the constants to which genes refer; NULL: decimal numbers (decimal.h) */
struct operation_count count_operations(struct counter *c, const struct genes *t,
                                        const struct genome_constant *constant);

/* Counts step by step, for programs that are not trees. Leaves and operations return numbers of values. */
void counter_begin(struct counter *c);
int counter_leaf(struct counter *c, int gene);
int counter_number(struct counter *c, double value);
/** Adds an operation; b must be -1 for a unary gene. */
int counter_operation(struct counter *c, int gene, int a, int b);
/** Counts the operations of all values that the roots need. */
struct operation_count counter_end(struct counter *c, const int *root, size_t roots);

/* ---- programs: lines_count.c ---- */

/** Counts the operations of programs: both outputs with all values of the frame that they need, each once. */
struct lines_counter;
struct lines_counter *lines_counter_new(const struct line_rules *r);
void lines_counter_free(struct lines_counter *c);
/** Counts the operations of a program.
 *  @param[in] last  function that the program ends in, or -1 */
struct operation_count count_lines(struct lines_counter *c, const struct genes *t, int last);

#endif
