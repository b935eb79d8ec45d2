/* Changes of programs. */
#ifndef FOOTPOINT_LINES_EDIT_H
#define FOOTPOINT_LINES_EDIT_H

#include "line_program.h"

#include <gsl/gsl_rng.h>

/** What takes a line's place, in every use.  Operands are lines of the program, as lines_load() numbers them, or
 * LINE_GENE + gene: a symbol. */
struct line_edit {
    enum {
        EDIT_VALUE,     /* c x */
        EDIT_NUMBER,    /* c */
        EDIT_OPERATION, /* x gene y */
        EDIT_TERM,      /* the line itself + c x y, or c x where y is -1 */
        EDIT_QUOTIENT   /* the line itself / (1 - c x), to first order + c x times itself; the divisor is kept from 0 */
    } kind;
    int line, gene, x, y;
    double c;
};

/** Workspace. */
struct line_editor {
    const struct line_rules *rules; /* not owned */
    struct lines *from, *mate, *to; /* owned, as are these: by line of from or mate */
    int *map, *clean, *image;
    signed char *power, *mate_power;
    bool *depends;
    size_t room;
};
struct line_editor *line_editor_new(const struct line_rules *r);
void line_editor_free(struct line_editor *e);

/** Apply an edit to a program, and its image under exchange of xi and eta where `both` and there is one.  False, with
 *  *child undefined, where the outcome is the same program or has more than max genes. */
bool lines_apply(struct line_editor *e, const struct genes *t, const struct line_edit *edit, bool both, size_t max,
                 struct genes *child);

/** A random change: a value of the mate, another operand, a shorter way, another operator, a step of one of the set's
 *  functions, one division for two.  Sums are of equal powers of a length. */
bool lines_edit(struct line_editor *e, gsl_rng *rng, const struct gene_set *genes, const struct genes *t,
                const struct genes *mate, size_t max, struct genes *child);

/** depends[i]: line i needs line n, or is it. */
void lines_dependents(const struct lines *c, int n, bool *depends);

#endif
