/* Writes a straight-line program (program.h) in a language: C, Fortran, LaTeX, plain infix. A language is data, a
 * pattern for each operation. The program determines association; parentheses are written only if needed. */
#ifndef FOOTPOINT_DIALECT_H
#define FOOTPOINT_DIALECT_H

#include "program.h"

/** How tightly a text binds. An operand below the level that its place requires gets parentheses. */
enum level { LEVEL_SUM, LEVEL_MINUS, LEVEL_PRODUCT, LEVEL_ATOM, LEVEL_NAME };

/** An operation: "$a2" stands for operand a, with at least level 2 (LEVEL_PRODUCT). */
struct pattern {
    const char *text;
    enum level level; /* of the whole text */
};

struct dialect {
    struct pattern op[OP_KINDS];    /* by enum op_kind; empty for constants and inputs */
    struct pattern square;          /* text NULL: as any product */
    struct pattern second[2];       /* for OP_MIN and OP_MAX with a constant second operand; text NULL: as any */
    const char *type;               /* of temporaries; NULL: not written */
    const char *open, *close;       /* parentheses */
    const char *decimal, *quotient; /* formats of a constant: sign, digits; sign, digits, denominator */
    /** Each returns new text, which the printer frees. */
    char *(*constant)(const fmpq *value, enum level *level); /* NULL: by these formats */
    char *(*input)(const struct genome_file *f, size_t k);
    char *(*name)(const char *plain); /* of a temporary or an output; NULL: unchanged */
    bool bare;                        /* inputs have no prefix, so temporaries get names that no input or output has */
    size_t longest; /* approximate limit on the characters of a statement; parts of longer statements are named. 0: no
                     * limit */
};

struct printer {
    const struct genome_file *file; /* not owned, like genome, program and dialect */
    const struct genome *genome;
    const struct program *program;
    const struct dialect *dialect;
    char **name;       /* owned: indexed by operation; its name, if any */
    enum level *level; /* owned: indexed by operation */
    size_t *width;     /* owned: indexed by operation; approximate number of characters */
    size_t tail;       /* underscores after a temporary's name */
    long cuts;         /* parts of statements that were named */
};

/** Receives a statement, which sets a temporary (output -1) or an output of the genome. */
typedef void write_statement(void *to, const char *name, long output, const char *text);

struct printer *printer_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                            const struct dialect *d);
void printer_free(struct printer *r);

/** Writes all statements, in order. */
void printer_run(struct printer *r, write_statement *write, void *to);

/** Returns the text of an operation after printer_run, with at least level `least`. The caller frees it. */
char *printer_text(struct printer *r, int op, enum level least);

/** Patterns of sums, products and quotients in languages that write them as C does. */
#define DIALECT_ARITHMETIC                                                                                             \
    [OP_NEG] = {"-$a3", LEVEL_MINUS}, [OP_ADD] = {"$a0 + $b2", LEVEL_SUM}, [OP_SUB] = {"$a0 - $b2", LEVEL_SUM},        \
    [OP_MUL] = {"$a1 * $b3", LEVEL_PRODUCT}, [OP_DIV] = {"$a1 / $b3", LEVEL_PRODUCT}

/** Splits a constant into sign, digits and denominator: "0.05", "7" and "3". The caller frees both texts; *den is NULL
 *  for a decimal. */
void split_constant(const fmpq *value, bool *negative, char **num, char **den);

#endif
