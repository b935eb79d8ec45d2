/* Writes a straight-line program (program.h) in the words of a language: C, Fortran, LaTeX, plain infix.  The language
 * is data, a pattern for each operation; association is the program's, parentheses stand only where they are needed. */
#ifndef FOOTPOINT_DIALECT_H
#define FOOTPOINT_DIALECT_H

#include "program.h"

/** How tightly a text holds together; an operand below what its place asks for gets parentheses. */
enum level { LEVEL_SUM, LEVEL_MINUS, LEVEL_PRODUCT, LEVEL_ATOM, LEVEL_NAME };

/** An operation: "$a2" stands for operand a, of level 2 (LEVEL_PRODUCT) at least. */
struct pattern {
    const char *text;
    enum level level; /* of the whole */
};

struct dialect {
    struct pattern op[OP_KINDS];    /* by enum op_kind; none for constants and inputs */
    struct pattern square;          /* text NULL: as any product */
    struct pattern second[2];       /* OP_MIN and OP_MAX whose second operand is constant; text NULL: as any */
    const char *type;               /* of temporaries; NULL: none is written */
    const char *open, *close;       /* parentheses */
    const char *decimal, *quotient; /* formats of a constant: sign, digits; sign, digits, denominator */
    /** Each returns new text, which the printer frees. */
    char *(*constant)(const fmpq *value, enum level *level); /* NULL: by these formats */
    char *(*input)(const struct genome_file *f, size_t k);
    char *(*name)(const char *plain); /* of a temporary or an output; NULL: as it is */
    bool bare;      /* inputs are written without a prefix: temporaries get names that no input or output has */
    size_t longest; /* characters of a statement, about; longer ones are cut and their parts named. 0: no limit */
};

struct printer {
    const struct genome_file *file; /* not owned, as are genome, program and dialect */
    const struct genome *genome;
    const struct program *program;
    const struct dialect *dialect;
    char **name;       /* owned: by operation, its name once it has one */
    enum level *level; /* owned: by operation */
    size_t *width;     /* owned: by operation, characters, about */
    size_t tail;       /* underscores after a temporary's name */
    long cuts;         /* parts of statements that were named */
};

/** Takes one statement: sets a temporary (output -1) or an output of the genome. */
typedef void write_statement(void *to, const char *name, long output, const char *text);

struct printer *printer_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                            const struct dialect *d);
void printer_free(struct printer *r);

/** All statements, in order. */
void printer_run(struct printer *r, write_statement *write, void *to);

/** Text of an operation after printer_run, on the level `least` at least; caller frees. */
char *printer_text(struct printer *r, int op, enum level least);

/** Patterns of sums, products and quotients in languages that write them as C does. */
#define DIALECT_ARITHMETIC                                                                                             \
    [OP_NEG] = {"-$a3", LEVEL_MINUS}, [OP_ADD] = {"$a0 + $b2", LEVEL_SUM}, [OP_SUB] = {"$a0 - $b2", LEVEL_SUM},        \
    [OP_MUL] = {"$a1 * $b3", LEVEL_PRODUCT}, [OP_DIV] = {"$a1 / $b3", LEVEL_PRODUCT}

/** Sign, digits and denominator of a constant: "0.05", "7" and "3".  Caller frees both; *den is NULL for a decimal. */
void split_constant(const fmpq *value, bool *negative, char **num, char **den);

#endif
