/* The code that a genome is translated to, and that the engines of kernel_engine.h run over one tile of samples after
 * the other. */
#ifndef FOOTPOINT_KERNEL_CODE_H
#define FOOTPOINT_KERNEL_CODE_H

#include "kernel_task.h"

/* Operands of an instruction of an operator of two, first and second.  A tile is computed in the registers A, or beside
 * a live A in the registers B.  Form f of B is form f of A plus FORMS_OF_ONE. */
enum kernel_form {
    A_COLUMN, /* A = A op column */
    COLUMN_A,
    A_CONSTANT,
    CONSTANT_A,
    COLUMN_COLUMN, /* A = column op column: a new value begins */
    COLUMN_CONSTANT,
    CONSTANT_COLUMN,
    FORMS_OF_ONE,
    A_B = 2 * FORMS_OF_ONE, /* A = A op B */
    B_A,
    A_SLOT, /* A = A op slot */
    SLOT_A,
    FORMS
};

/* Codes: gene * FORMS + form of + - * / % min max, then these. */
enum kernel_code {
    LOAD_COLUMN = (GENE_MAX + 1) * FORMS, /* A = column */
    LOAD_CONSTANT,
    STORE, /* slot = A */
    SLOW,  /* A = op A: an operator of one operand, in memory */
    END,
    CODES
};

enum { SLOT = 512 /* bytes of a tile, at most */ };

struct instruction {
    int code;
    int gene; /* of SLOW */
    size_t a; /* bytes: the column, the first column of two, or the slot, from where they begin */
    union {
        size_t b; /* bytes: the second column */
        double number;
    } u;
};

/* A table as the engines see it. */
struct kernel_table {
    const void *data;
    size_t n, stride; /* stride: bytes from column to column */
};

/* What an engine runs: for the error sum when `value` is NULL, or else for the values. */
struct kernel_run {
    const struct instruction *code;
    struct kernel_table table;
    size_t target; /* bytes: its column */
    double bound;
    double *value;
    char *slot;  /* aligned room for one tile more than the code has slots; the first is the engine's */
    size_t done; /* samples that have been evaluated */
};

/** Translator with its room. */
struct translator;
struct translator *translator_new(void);
void translator_free(struct translator *t);
/** Code of a genome for a table; valid until the next call.  *slots: how many the code uses, the engine's own apart. */
const struct instruction *translator_code(struct translator *t, const struct kernel_task *task,
                                          const struct kernel_table *table, size_t *slots);

#endif
