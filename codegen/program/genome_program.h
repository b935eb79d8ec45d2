/* Genomes as programs, operation by operation as they are written: what code is proved equal to, and what `require`s
 * are evaluated by. */
#ifndef FOOTPOINT_GENOME_PROGRAM_H
#define FOOTPOINT_GENOME_PROGRAM_H

#include "program.h"

struct genome_program {
    const struct genome_file *file; /* not owned */
    struct program *program;        /* owned by whom genome_program_end hands it to */
    int *symbol;                    /* owned: operation of a symbol, once it is known */
    const int *shape;               /* not owned: of a symbol of the region, where requires may use these */
};

/** A program of the file's inputs, with room for so many outputs. */
struct genome_program genome_program_start(const struct genome_file *f, size_t outputs);
/** Append an expression of known symbols; its operation. */
int genome_program_add(struct genome_program *b, const struct genome_expr *e);
/** The program, without what served to make it. */
struct program *genome_program_end(struct genome_program *b);

/** Append the operations of q, whose inputs are the operations input[]; NULL: inputs are shared.  Returns what is to be
 *  added to the numbers of its operations. */
int program_append(struct program *p, const struct program *q, const int *input);

#endif
