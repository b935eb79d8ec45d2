/* Linear genetic programming in register form (Brameier and Banzhaf). A program is a list of lines. Each line is an
 * operation on the frame's values, on numbers and on earlier lines. Two values are its answers, xi and eta, and share
 * their common subexpressions.
 *
 * Populations, fronts, parcels and checkpoints store a program as genes (genotype.h):
 *
 *   xi, eta, then three for each line: operator, first operand, second operand (-1 for a unary operator)
 *
 * An operand is the gene of a symbol or of a decimal number (decimal.h), or LINE_GENE + k, the result of line k.
 *
 * If a tier sets `last`, the two values are the arguments of that function instead, so that no change of the program
 * can lose the function. */
#ifndef FOOTPOINT_LINE_PROGRAM_H
#define FOOTPOINT_LINE_PROGRAM_H

#include "../../codegen/base/index_table.h"
#include "genotype.h"

enum {
    LINE_GENE = 1 << 24,
    LINE_GENES = 3,
    LINE_NUMBER = -1, /* gene of a line that is a number */
    ANY_POWER = 127,  /* power of length of a value that may be added to any other */
    NO_POWER = 126    /* power of length of a sum of unlike powers */
};

/** The meaning of the symbols, and the functions that a program may call. */
struct line_rules {
    const struct genome_file *program; /* not owned */
    size_t symbols;
    size_t *partner;    /* owned: partner[i] is the image of symbol i under exchange of xi and eta */
    signed char *power; /* owned: power[i] is the power of length of symbol i, or ANY_POWER */
};
/** Returns rules for `program`, which must outlive them. The program may get more lets later. */
struct line_rules *line_rules_new(const struct genome_file *program);
void line_rules_free(struct line_rules *r);
/** Returns the index of the function with this name that maps two numbers to two or more, or -1. */
int line_function(const struct genome_file *program, const char *name);

/** An operation on earlier lines, or a leaf, whose gene is a symbol or LINE_NUMBER. */
struct line {
    int gene, a, b; /* b: -1 for a unary operator; both: negative for a leaf */
    double number;
};
static inline bool line_is_operation(const struct line *x)
{
    return x->a >= 0;
}

/** A program as lines, leaves included. Equal values share a line. */
struct lines {
    const struct line_rules *rules; /* not owned */
    struct line *line;              /* owned */
    bool *needed;                   /* owned: needed[i]: a root depends on line i */
    bool *divides;                  /* divides[i]: line i is a divisor */
    size_t lines, room, needed_room;
    int root[2];    /* lines of xi and eta */
    size_t *number; /* owned: lines of the numbers to be fitted (LINES_APART), and the indices of their genes */
    size_t *place;
    size_t numbers, number_room;
    struct index_table known; /* the lines */
    int *map;                 /* owned scratch */
    size_t map_room;
};
struct lines *lines_new(const struct line_rules *r);
void lines_free(struct lines *c);

/** Returns true if `gene` encodes a program that uses only the symbols of these rules. */
bool lines_valid(const struct line_rules *r, const int *gene, size_t length);

/** How lines_load() reads a program. */
enum lines_use {
    LINES_INNER, /* as it is stored */
    LINES_WHOLE, /* followed by the function that it ends in */
    LINES_APART  /* as LINES_WHOLE, with a separate line for each number that may be fitted */
};
/** Loads a valid program.
 *  @param[in] last  index of the function that it ends in, or -1 */
void lines_load(struct lines *c, const struct genes *t, int last, enum lines_use use);
/** Loads an expression in prefix form, operation by operation, without simplifying. Both roots become its value. Needs
 *  no rules.
 *  @param[in] constant  the constants to which its genes refer; NULL: decimal numbers */
void lines_expression(struct lines *c, const int *gene, size_t length, const struct genome_constant *constant);
/** Writes the lines that the roots need as genes. Returns false, with *t undefined, if that takes more than max genes.
 *  */
bool lines_store(struct lines *c, size_t max, struct genes *t);

/* Empties the program, to be built line by line. Lines that follow are simplified wherever that is exact. */
void lines_begin(struct lines *c);
int lines_number(struct lines *c, double value);
int lines_symbol(struct lines *c, int gene);
/** Adds an operation and returns its line; b must be -1 for a unary operator. */
int lines_operation(struct lines *c, int gene, int a, int b);
/** Sets x = function(x), a function of two numbers with at least two results. */
void lines_call(struct lines *c, int function, int x[2]);
/** Copies line i of another program, with all that it needs, and returns the new line. map[k] is the line of `to` that
 *  stands for line k; if map[k] is -1, line k is copied and map[k] set. */
int lines_take(struct lines *to, const struct lines *from, int i, int *map);
/** Returns true for a guard: a divisor that a maximum or minimum keeps away from 0. No change of a program replaces it.
 *  */
static inline bool line_is_guard(const struct lines *c, size_t i)
{
    return c->divides[i] && (c->line[i].gene == GENE_MAX || c->line[i].gene == GENE_MIN);
}
/** Computes the power of length of each line. Zero has any power. */
void lines_powers(const struct lines *c, signed char *power);
/** Returns true if no line adds unlike powers of length, so that the answers do not depend on the unit. */
bool lines_keep_powers(const struct lines *c);
/** Returns n times -1, owned by the caller. */
int *no_lines(size_t n);
/** Computes image[i], the line that equals line i after exchange of xi and eta, or -1. */
void lines_images(struct lines *c, int *image);

#endif
