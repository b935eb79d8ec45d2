/* The code to which a genome is translated. The engines of kernel_engine.h run it over all tiles of samples. */
#ifndef FOOTPOINT_KERNEL_CODE_H
#define FOOTPOINT_KERNEL_CODE_H

#include "kernel_task.h"

/* Operands of a binary instruction, first and second. A tile is computed in registers A, or in registers B while A is
 * live. Form f of B is form f of A plus FORMS_OF_ONE. */
enum kernel_form {
    A_COLUMN, /* A = A op column */
    COLUMN_A,
    A_CONSTANT,
    CONSTANT_A,
    COLUMN_COLUMN, /* A = column op column: starts a new value */
    COLUMN_CONSTANT,
    CONSTANT_COLUMN,
    FORMS_OF_ONE,
    A_B = 2 * FORMS_OF_ONE, /* A = A op B */
    B_A,
    A_SLOT, /* A = A op slot */
    SLOT_A,
    FORMS
};

/* Codes: gene * FORMS + form for + - * / % min max, then the following. */
enum kernel_code {
    LOAD_COLUMN = (GENE_MAX + 1) * FORMS, /* A = column */
    LOAD_CONSTANT,
    STORE, /* slot = A */
    SLOW,  /* A = op A: a unary operator, in memory */
    END,
    CODES
};

enum { SLOT = 512 /* most bytes of a tile */ };

struct instruction {
    int code;
    int gene; /* for SLOW */
    size_t a; /* byte offset of the column, of the first of two columns, or of the slot */
    union {
        size_t b; /* byte offset of the second column */
        double number;
    } u;
};

/* A table as the engines use it. */
struct kernel_table {
    const void *data;
    size_t n, stride; /* stride: bytes between columns */
};

/* A run of an engine: computes the error sum if `value` is NULL, otherwise the values. */
struct kernel_run {
    const struct instruction *code;
    struct kernel_table table;
    size_t target; /* byte offset of its column */
    double bound;
    double *value;
    char *slot;  /* aligned room for one tile more than the code has slots; the first is the engine's */
    size_t done; /* samples evaluated */
};

/** The translator and its memory. */
struct translator;
struct translator *translator_new(void);
void translator_free(struct translator *t);
/** Returns the code of a genome for a table, valid until the next call. *slots: slots that the code uses, besides the
 *  engine's own. */
const struct instruction *translator_code(struct translator *t, const struct kernel_task *task,
                                          const struct kernel_table *table, size_t *slots);

#endif
