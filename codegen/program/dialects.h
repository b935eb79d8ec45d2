/* The dialects of C; see dialect.h. */
#ifndef FOOTPOINT_DIALECTS_H
#define FOOTPOINT_DIALECTS_H

#include "dialect.h"

/** In double, the words that program_read reads; in float; in float, of coordinates yA, yB, ... relative to the segment. */
extern const struct dialect c_double, c_float, c_relative;

/** A statement in C: it sets `name`, a temporary that it declares or an output of the genome. */
struct c_statement {
    const char *declares; /* not owned: "const " or ""; NULL: an output */
    char *name, *value;   /* owned; the value is broken where lines get long */
    long output;          /* -1: a temporary */
    bool zero;            /* the value begins with the variable `zero` */
};

/** The statements of a program in order, and the printer that has the texts of all operations. */
struct c_code {
    struct printer *printer;       /* owned */
    struct c_statement *statement; /* owned */
    size_t statements, room;
};
struct c_code c_code_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                         const struct dialect *d);

/** Frees all but the printer, which it returns. */
struct printer *c_code_clear(struct c_code *c);

/** Prints a statement, without the semicolon; returns the number of characters. */
int c_statement_print(const struct c_code *c, size_t i, FILE *out);

/** Writes the statements, the last ones set *out_... (segment: *xi, *eta); if out is NULL, the printer alone is made. */
struct printer *c_statements(const struct genome_file *f, const struct genome *genome, const struct program *p,
                             const struct dialect *d, FILE *out);

#endif
