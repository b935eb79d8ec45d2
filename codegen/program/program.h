/* A straight-line program of rounded operations, in the order and association of its C text. Everything about the
 * emitted code (text, counts, proof, error bound, poles, other languages) is computed from the program, never from the
 * graph behind it. The proof is about the program read back from the text. */
#ifndef FOOTPOINT_PROGRAM_H
#define FOOTPOINT_PROGRAM_H

#include "../genome/genome.h"
#include "../graph/cost.h"

#include <flint/fmpq.h>

enum op_kind {
    OP_CONSTANT, /* constant[input]; written as a decimal, or as a quotient of two decimals if `quotient` */
    OP_INPUT,    /* input number `input` of the genome file */
    OP_NEG,      /* -a */
    OP_ADD,      /* a + b */
    OP_SUB,      /* a - b */
    OP_MUL,      /* a * b */
    OP_DIV,      /* a / b */
#define OP(gene, ...) OP_##gene,
    CHOICES(OP) /* b == 0.0 ? 1.0 : a / b; a < b ? a : b; a > b ? a : b */
    UNARY(OP)   /* sqrt(a), fabs(a), ... */
#undef OP
    OP_FUNCTION = OP_DIV + 1, /* functions of two operands, then of one */
    OP_UNARY = OP_MAX + 1     /* + k: function k of one number */
};
enum { OP_KINDS = OP_MAX + 1 + UNARIES };

/** An operation; operands are numbers of earlier operations. */
struct op {
    enum op_kind kind;
    int a, b;      /* -1 if missing */
    int input;     /* OP_INPUT: index of the input; OP_CONSTANT: index of the constant */
    bool quotient; /* OP_CONSTANT: written (n.0 / d.0) */
    bool squared;  /* OP_MUL: both operands are the same operation */
};

/** A statement, which names the value of its last operation. */
struct statement {
    char *name; /* owned: "t1", "u2"; the output's name for an output */
    int op;
    int first;   /* operations first..op belong to this statement, in postorder; names and inputs that it reads are
                  * operations of earlier statements or OP_INPUT */
    long output; /* index among the genome's outputs, or -1 */
};

struct program {
    struct op *op; /* owned; inputs first: op[k] is OP_INPUT k for k < inputs */
    size_t ops, op_room;
    fmpq *constant; /* owned: exact values as written */
    size_t constants, constant_room;
    struct statement *statement; /* owned, in order */
    size_t statements, statement_room;
    size_t inputs, outputs;
    int *output; /* owned: operation of each of the genome's outputs */
};

/** Returns a program with the inputs only, and room for this many outputs. */
struct program *program_new(const struct genome_file *f, size_t outputs);
void program_free(struct program *p);

/** Reads the C statements that c_statements (dialects.h) prints of a program for `genome` of file f. Returns NULL, with
 *  *d filled, for other text. */
struct program *program_read(const struct genome_file *f, const struct genome *genome, const char *statements,
                             struct diag *d);

/** Appends an operation; returns its number. */
int program_add(struct program *p, enum op_kind kind, int a, int b);
int program_add_constant(struct program *p, const fmpq *q, bool quotient);
/** Appends the statement of the operations from `first` on. */
void program_add_statement(struct program *p, const char *name, int op, size_t first, long output);

/** Returns the function of an operation OP_UNARY + k. */
const struct unary *op_unary(enum op_kind kind);

/** Returns true for a constant, with or without a sign. */
bool program_is_constant(const struct program *p, int op);
/** Returns true if functions have a parameter `zero`, which is added to the constants of min and max: see the template
 *  "bits". */
bool program_hides_constants(const struct genome_file *f);
bool program_equal(const struct program *p, const struct program *q);
/** Returns an array indexed by operation, inputs first: an operation or an output reads it. The caller frees it. */
bool *program_reads(const struct program *p);
struct operations program_count(const struct program *p);

#endif
