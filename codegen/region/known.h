/* What is known of the values of a program before anything is searched: in which ranges its inputs lie, what else the
 * file requires, and which values are multiples of others.  What the file requires and the program computes become one
 * program, so that what is known of a value serves for both. */
#ifndef FOOTPOINT_KNOWN_H
#define FOOTPOINT_KNOWN_H

#include "../program/program.h"
#include "interval.h"

/** What the program computes in. */
struct arithmetic {
    double unit;  /* unit roundoff */
    double least; /* the smallest number above 0 */
    double most;  /* the largest number */
    double given; /* relative error of what the program is given */
};
extern const struct arithmetic arithmetic_double, arithmetic_single;
/** Nodes less the first one, times a factor (single_inputs in evaluate_float.h), are what the program is given. */
extern const struct arithmetic arithmetic_single_scaled;

/** How far a constant is off. */
double constant_error(const struct arithmetic *a, const struct program *p, const struct op *o);
/** Whether the sum, difference or product of two numbers is one that the arithmetic has. */
bool result_is_exact(const struct arithmetic *a, enum op_kind kind, double x, double y);

struct known {
    struct arena arena;           /* of all arrays of numbers */
    struct arithmetic arithmetic; /* double at first */
    size_t inputs;                /* what varies: of the file, or of its region block */
    fmpq *lo, *hi;                /* owned: by input, exact; 0 where no range is given */
    struct interval *range;       /* owned: by input, around [lo,hi]; the whole line where none is given */
    bool complete;                /* every input that the program or a require reads has a range */
    size_t variables;             /* those inputs, as far as they vary; a box has a side for each */
    size_t *input;                /* owned: by variable */
    size_t *variable;             /* owned: by input, or `variables` where it is fixed or does not matter */
    struct program *program;      /* owned: inputs, requires, then the program's operations; outputs: the requires */
    size_t first;                 /* the first operation of the program; those before it are exact */
    size_t shapes;                /* operations of the region block: what they say of others is taken in */
    struct program *place;        /* owned: from inputs to those of the file; NULL: the same */
    int *placed;                  /* owned: by input of the file, its operation */
    size_t places;
    struct interval *value; /* owned: by operation, what is proved of it on the region */
    bool *joint;            /* owned: by operation, a value with a name or a divisor: a link of error bounds */
    int *twin;              /* owned: by operation, an earlier one that it is a multiple of, or -1 */
    struct interval *ratio; /* owned: by operation, to its twin */
    size_t *length;         /* owned: by operation, how many it is made of (at most; of requires alone) */
};

/** Of the values of program p, made from a genome of file f.  `shapes`: the region is that of the file's region block, if it
 *  has one; otherwise all that is said of the inputs themselves is known. */
struct known *known_new(const struct genome_file *f, const struct program *p, bool shapes);
void known_free(struct known *x);
/** Whether no require can be > 0 where operation `op` is 0: one is a multiple of it, or made of a quotient by it. */
bool known_requires(const struct known *x, int op);
/** Where the joint program has operation `op` of p. */
int known_op(const struct known *x, int op);

#endif
