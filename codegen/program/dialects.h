/* The dialects of C; see dialect.h. */
#ifndef FOOTPOINT_DIALECTS_H
#define FOOTPOINT_DIALECTS_H

#include "dialect.h"

/** In double, the text that program_read reads; in float; in float with coordinates yA, yB, ... relative to the
 *  segment. */
extern const struct dialect c_double, c_float, c_relative;

/** A statement in C, which sets `name`, a temporary that it declares or an output of the genome. */
struct c_statement {
    const char *declares; /* not owned: "const " or ""; NULL: an output */
    char *name, *value;   /* owned; long values are broken into lines */
    long output;          /* -1: a temporary */
    bool zero;            /* the value begins with the variable `zero` */
};

/** The statements of a program in order, and the printer with the texts of all operations. */
struct c_code {
    struct printer *printer;       /* owned */
    struct c_statement *statement; /* owned */
    size_t statements, room;
};
struct c_code c_code_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                         const struct dialect *d);

/** Frees everything except the printer, which it returns. */
struct printer *c_code_clear(struct c_code *c);

/** Prints a statement without the semicolon; returns the number of characters. */
int c_statement_print(const struct c_code *c, size_t i, FILE *out);

/** Writes the statements, the last of which set *out_... (segment: *xi, *eta). If `out` is NULL, only makes the
 *  printer. Returns the printer. */
struct printer *c_statements(const struct genome_file *f, const struct genome *genome, const struct program *p,
                             const struct dialect *d, FILE *out);

#endif
