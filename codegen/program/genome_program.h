/* Converts genomes to programs, operation by operation as written. Code is proved equal to these programs, and
 * `require`s are evaluated by them. */
#ifndef FOOTPOINT_GENOME_PROGRAM_H
#define FOOTPOINT_GENOME_PROGRAM_H

#include "program.h"

struct genome_program {
    const struct genome_file *file; /* not owned */
    struct program *program;        /* owned by the receiver of genome_program_end */
    int *symbol;                    /* owned: indexed by symbol; its operation, once known */
    const int *shape;               /* not owned: of the region's symbols, if requires may use them */
};

/** Starts a program of the file's inputs, with room for this many outputs. */
struct genome_program genome_program_start(const struct genome_file *f, size_t outputs);
/** Appends an expression of known symbols; returns its operation. */
int genome_program_add(struct genome_program *b, const struct genome_expr *e);
/** Returns the program and frees the rest. */
struct program *genome_program_end(struct genome_program *b);

/** Appends the operations of q, with the operations input[] for its inputs (NULL: shared inputs). Returns the offset of
 *  its operation numbers. */
int program_append(struct program *p, const struct program *q, const int *input);

#endif
