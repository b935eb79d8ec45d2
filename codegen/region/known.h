/* Facts known about the values of a program before any search: the ranges of its inputs, the file's requires, and which
 * values are multiples of others. The requires and the program are merged into a single program, so that a fact about a
 * value serves both. */
#ifndef FOOTPOINT_KNOWN_H
#define FOOTPOINT_KNOWN_H

#include "../program/program.h"
#include "interval.h"

/** The arithmetic in which the program computes. */
struct arithmetic {
    double unit;  /* unit roundoff */
    double least; /* the smallest number above 0 */
    double most;  /* the largest number */
    double given; /* relative error of the program's inputs */
};
extern const struct arithmetic arithmetic_double, arithmetic_single;
/** The program's inputs are nodes minus the first node, times a factor (single_inputs in evaluate_float.h). */
extern const struct arithmetic arithmetic_single_scaled;

/** Returns the error of a constant. */
double constant_error(const struct arithmetic *a, const struct program *p, const struct op *o);
/** Returns true if the sum, difference or product of two numbers is a number of the arithmetic. */
bool result_is_exact(const struct arithmetic *a, enum op_kind kind, double x, double y);

struct known {
    struct arena arena;           /* of all arrays of numbers */
    struct arithmetic arithmetic; /* double by default */
    size_t inputs;                /* number of varying inputs: the file's, or its region block's */
    fmpq *lo, *hi;                /* owned: by input, exact; 0 without a range */
    struct interval *range;       /* owned: by input, enclosing [lo,hi]; the whole line without a range */
    bool complete;                /* every input that the program or a require reads has a range */
    size_t variables;             /* number of those inputs that vary; a box has a side for each */
    size_t *input;                /* owned: by variable */
    size_t *variable;             /* owned: by input, or `variables` if it is fixed or unused */
    struct program *program;      /* owned: inputs, requires, then the program's operations; outputs: the requires */
    size_t first;                 /* the first operation of the program; earlier operations are exact */
    size_t shapes;                /* number of operations of the region block, which narrow others */
    struct program *place;        /* owned: computes the file's inputs; NULL: they are the inputs */
    int *placed;                  /* owned: by input of the file; its operation */
    size_t places;
    struct interval *value; /* owned: by operation; encloses its values on the region */
    bool *joint;            /* owned: by operation; a joint of error bounds: a named value or a divisor */
    int *twin;              /* owned: by operation; an earlier operation of which it is a multiple, or -1 */
    struct interval *ratio; /* owned: by operation; over its twin */
    size_t *length;         /* owned: by operation; number of operations in it (at most; requires only) */
};

/** Returns the facts about program p, made from a genome of file f. If `shapes` is set, the region comes from the
 *  file's region block, if any; otherwise only facts about the inputs themselves are used. */
struct known *known_new(const struct genome_file *f, const struct program *p, bool shapes);
void known_free(struct known *x);
/** Returns true if no require can be > 0 where operation `op` is 0: a require is a multiple of it, or depends on a
 *  quotient by it. */
bool known_requires(const struct known *x, int op);
/** Returns the operation of the merged program for operation `op` of p. */
int known_op(const struct known *x, int op);

#endif
