/* Programs: linear genetic programming in register form (Brameier and Banzhaf).  A program is a list of lines, each an
 * operation on the frame's values, numbers and earlier lines; two of its values are xi and eta.  What both need is
 * there once.
 *
 * As genes (genotype.h), which populations, fronts, parcels and checkpoints hold:
 *
 *   xi, eta, then three for each line: operator, first operand, second operand (-1 where the operator has one)
 *
 * An operand is a symbol's gene, a decimal number's (decimal.h), or LINE_GENE + k: what line k gives.
 *
 * A program of a tier that says what programs end in (`last`) has that function's arguments as its two values, so that
 * no change of it can lose the function. */
#ifndef FOOTPOINT_LINE_PROGRAM_H
#define FOOTPOINT_LINE_PROGRAM_H

#include "../../codegen/base/index_table.h"
#include "genotype.h"

enum {
    LINE_GENE = 1 << 24,
    LINE_GENES = 3,
    LINE_NUMBER = -1, /* gene of a line that is a number */
    ANY_POWER = 127,  /* of a length: of a value that may be added to any */
    NO_POWER = 126    /* of a sum of unlike ones */
};

/** What the values of a program mean, and the functions that it may be made of. */
struct line_rules {
    const struct genome_file *program; /* not owned */
    size_t symbols;
    size_t *partner;        /* owned: by symbol; what exchanging xi and eta makes of it */
    signed char *power;     /* owned: by symbol; the power of a length that it is, or ANY_POWER */
    struct line_body *body; /* owned: by function of the program; of those from two numbers to two or more */
};
/** The program must outlive it, and may get more lets. */
struct line_rules *line_rules_new(const struct genome_file *program);
void line_rules_free(struct line_rules *r);
/** The function of that name, from two numbers to two or more; -1: there is none. */
int line_function(const struct genome_file *program, const char *name);

/** An operation on earlier lines; or a leaf, whose gene is a symbol's, or LINE_NUMBER. */
struct line {
    int gene, a, b; /* b: -1 where there is one operand; both: negative of a leaf */
    double number;
};
static inline bool line_is_operation(const struct line *x)
{
    return x->a >= 0;
}

/** A program by lines, leaves among them, in which equal values are there once. */
struct lines {
    const struct line_rules *rules; /* not owned */
    struct line *line;              /* owned */
    bool *needed;                   /* owned: by line; a root needs it, and: */
    bool *divides;                  /* it is a divisor */
    size_t lines, room, needed_room;
    int root[2];    /* lines of xi and of eta */
    size_t *number; /* owned: lines of the numbers to be fitted, where these are kept apart, and their genes */
    size_t *place;
    size_t numbers, number_room;
    struct index_table known; /* the lines */
    int *map;                 /* owned: scratch */
    size_t map_room;
};
struct lines *lines_new(const struct line_rules *r);
void lines_free(struct lines *c);

/** True of genes that are a program over symbols of these rules. */
bool lines_valid(const struct line_rules *r, const int *gene, size_t length);

/** How programs are taken. */
enum lines_use {
    LINES_INNER, /* as they are stored */
    LINES_WHOLE, /* with the function that they end in */
    LINES_APART  /* the same, and each number that may be fitted has a line of its own */
};
/** Take a valid program.
 *  @param[in] last  function that it ends in; -1: none */
void lines_load(struct lines *c, const struct genes *t, int last, enum lines_use use);
/** Take an expression in prefix form, whose value both roots become: operation by operation, nothing simplified.  It
 *  needs no rules.
 *  @param[in] constant  what constants mean */
void lines_expression(struct lines *c, const int *gene, size_t length, const struct genome_constant *constant);
/** What the roots need, as genes; false, with *t undefined, where these are more than max. */
bool lines_store(struct lines *c, size_t max, struct genes *t);

/* To build one: from nothing, each value by the lines of others, simplified where that is exact. */
void lines_begin(struct lines *c);
int lines_number(struct lines *c, double value);
int lines_symbol(struct lines *c, int gene);
/** b: -1 where the operator has one operand. */
int lines_operation(struct lines *c, int gene, int a, int b);
/** x = function(x), from two numbers to two. */
void lines_call(struct lines *c, int function, int x[2]);
/** What line i of another program gives; map[k]: line of `to` that takes the place of line k, or -1: taken over as it
 *  is, and noted there. */
int lines_take(struct lines *to, const struct lines *from, int i, int *map);
/** A divisor that a maximum or minimum keeps from 0: no change of a program replaces it. */
static inline bool line_is_guard(const struct lines *c, size_t i)
{
    return c->divides[i] && (c->line[i].gene == GENE_MAX || c->line[i].gene == GENE_MIN);
}
/** Power of a length that each line is; zero is a number of any power. */
void lines_powers(const struct lines *c, signed char *power);
/** Whether no line adds unlike powers of a length: what it gives does not depend on the unit. */
bool lines_keep_powers(const struct lines *c);
/** -1, n times; caller frees. */
int *no_lines(size_t n);
/** image[i]: the line that exchanging xi and eta makes of line i, or -1. */
void lines_images(struct lines *c, int *image);

#endif
