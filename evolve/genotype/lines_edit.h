/* Changes of programs. */
#ifndef FOOTPOINT_LINES_EDIT_H
#define FOOTPOINT_LINES_EDIT_H

#include "line_program.h"

#include <gsl/gsl_rng.h>

/** Replaces a line in all its uses. Operands are lines of the program, numbered as lines_load() does, or LINE_GENE +
 *  gene for a symbol. */
struct line_edit {
    enum {
        EDIT_VALUE,     /* c x */
        EDIT_NUMBER,    /* c */
        EDIT_OPERATION, /* x gene y */
        EDIT_TERM,      /* line + c x y, or line + c x if y is -1 */
        EDIT_QUOTIENT   /* line / (1 - c x), to first order line + c x line; the divisor is guarded */
    } kind;
    int line, gene, x, y;
    double c;
};

/** Workspace. */
struct line_editor {
    const struct line_rules *rules; /* not owned */
    struct lines *from, *mate, *to; /* owned */
    struct arena arena;             /* owned: of the following arrays */
    int *map, *clean, *image;
    signed char *power, *mate_power;
    bool *depends;
    size_t room;
};
struct line_editor *line_editor_new(const struct line_rules *r);
void line_editor_free(struct line_editor *e);

/** Applies an edit to a program, and also its image under exchange of xi and eta if `both` is set and an image exists.
 *  Returns false, with *child undefined, if the program does not change or has more than max genes. */
bool lines_apply(struct line_editor *e, const struct genes *t, const struct line_edit *edit, bool both, size_t max,
                 struct genes *child);

/** Applies a random change: a value of the mate, another operand, a shortcut, another operator, a step of one of the
 *  set's functions, or one shared division for two. Only equal powers of length are added. */
bool lines_edit(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                const struct genes *mate, size_t max, struct genes *child);

/** Sets depends[i] if line i is line n or depends on it. */
void lines_dependents(const struct lines *c, int n, bool *depends);

#endif
