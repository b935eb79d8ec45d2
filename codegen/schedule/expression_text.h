/* Text of one operation, made from the texts of its operands.  Operations are counted here, where they are written, so
 * the counts are those of the text. */
#ifndef FOOTPOINT_EXPRESSION_TEXT_H
#define FOOTPOINT_EXPRESSION_TEXT_H

#include "../genome/genome.h"
#include "../genome/text.h"
#include "schedule.h"

enum precedence { ATOM, PRODUCT, SUM };

/** Text of a node: numerator, and denominator when it is a quotient not yet written out. */
struct expression {
    char *num, *den;       /* owned; num NULL: 1; den NULL: none */
    enum precedence level; /* of num */
};

/** A constant that has a name: "u" and `helper`. */
struct named_constant {
    rational value;
    long helper;
};

/** A function under construction. */
struct emitter {
    const struct genome_file *file;
    const struct schedule *s;
    struct expression *text; /* owned; by node */
    bool *named;             /* owned: must have a name, because it is written twice */
    bool *early;             /* owned: a sum that is used in a later stage than its own */
    bool *last;              /* owned: reaches an output past no choice (min, max, protected quotient) */
    struct growing body;     /* owned: the statements so far */
    struct operations ops;
    long negations;
    bool out_of_range; /* a constant factor is no normal double, or its quotient's parts are none */
    long helpers;      /* named operands that are no nodes */
    long *term_named;  /* owned: by place in the schedule's table, helper that is this term; 0: none yet */
    struct named_constant *constant; /* owned */
    size_t constants, constant_room;
};

/** Adds a statement, `head` and `value`; a long one is broken at spaces. */
void emitter_write(struct emitter *e, const char *head, const char *value);

/** Adds the statement "const double NAME = value;": a temporary, "t" or "u" and a number. */
void emitter_name(struct emitter *e, char prefix, long number, const char *value, char name[32]);

/** The same for a constant: "double uNUMBER = value;". */
void emitter_name_constant(struct emitter *e, long number, const char *value, char name[32]);

/** Numerator and denominator as one expression; a division is counted by who creates the denominator.  Caller frees. */
char *expression_whole(const struct expression *t, enum precedence *level);

/** Numerator of the inverse n, NULL if it is 1.  Caller frees. */
char *expression_numerator(struct emitter *e, int n);

/** coef * text for a coefficient > 0, as a factor or term.  Caller frees. */
char *expression_scaled(struct emitter *e, rational coef, const struct expression *t);

/** The empty text of node n, a sum, a product, or a function of one or two operands, is filled. */
void expression_sum(struct emitter *e, int n, struct expression *t);
void expression_product(struct emitter *e, int n, struct expression *t);
void expression_function(struct emitter *e, int n, struct expression *t);

#endif
