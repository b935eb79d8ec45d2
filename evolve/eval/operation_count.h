/* What a tree costs: its operations, each value computed once. */
#ifndef FOOTPOINT_OPERATION_COUNT_H
#define FOOTPOINT_OPERATION_COUNT_H

#include "../genotype/line_program.h"

/** Operations of a tree, equal values counted once: operands of + and * in any order, and values that differ in sign
 *  alone, are equal.  Factors 1 and -1, terms 0 and changes of sign are free, what is multiplied by 0 is not computed,
 *  operations on constants are folded, and a quotient by a constant is a product. */
struct operation_count {
    unsigned mul, add, div;
    unsigned other; /* square roots, absolute values, minima, maxima */
    double path;    /* longest chain of operations that wait for each other, in sums; a quotient is as long as 3.25 */
    uint64_t hash;  /* equal for trees whose values are equal by these rules, and so for trees of equal error */
};

/** Prices of operations in multiplications.  An operation of another kind costs as much as a sum. */
struct prices {
    double add, div;
    double path; /* of a sum on the longest chain, beside its own */
};
double operations_price(const struct operation_count *o, const struct prices *m);

/** Workspace for trees of at most max_length genes, or for so many leaves and operations. */
struct counter;
struct counter *counter_new(size_t max_length);
void counter_free(struct counter *c);

/** Count in time proportional to the genes, without allocation.
 *  @param[in] constant  what constants mean; NULL: decimal numbers (decimal.h) */
struct operation_count count_operations(struct counter *c, const struct genes *t,
                                        const struct genome_constant *constant);

/* The same step by step, for what is no tree: numbers of values, from leaves and operations on them. */
void counter_begin(struct counter *c);
int counter_leaf(struct counter *c, int gene);
int counter_number(struct counter *c, double value);
/** b: -1 where the gene has one operand. */
int counter_operation(struct counter *c, int gene, int a, int b);
/** Counts the operations of all that the roots need. */
struct operation_count counter_end(struct counter *c, const int *root, size_t roots);

/* ---- programs: lines_count.c ---- */

/** Counts operations of programs: of both outputs, with all that they need of the frame, each value once. */
struct lines_counter;
struct lines_counter *lines_counter_new(const struct line_rules *r);
void lines_counter_free(struct lines_counter *c);
/** @param[in] last  function that the program ends in; -1: none */
struct operation_count count_lines(struct lines_counter *c, const struct genes *t, int last);

#endif
