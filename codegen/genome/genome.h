/* Genome text: a small straight-line program with named inputs, named values (`let`), functions and any number of
 * genomes.
 *
 *     footpoint-genome 3                   the format and its version: the first words of the file
 *     # comment                            anywhere, to the end of the line
 *     note scene quad4                     provenance: a key and the rest of the line; any number
 *     segment quad4 any                    the inputs are nodes of a segment and the slave node: a kind of segment_kind.h
 *                                          and the order of corners assumed: any | nearest | nearest-shorter
 *     face quad4                           instead: nodes and slave node in any order, and behind them xi and eta, a place
 *                                          on the segment
 *     input x y                            names of inputs, in order, where there is no segment; may be repeated
 *     range xC -0.5 2                      closed interval of an input; at most one for each
 *     range D 0 1 0 1 -0.3 0.3, xS 0 1     the same of a vector of inputs: of xD, yD and zD; and of another
 *     region ... end                       lines that say where the inputs are, by other numbers; see below
 *     let c1 = B - A                       a value: one expression of inputs and earlier values; here a vector
 *     let c11 = dot(c1, c1)                a number
 *     function step u v vector w -> un j   a function: from numbers and a vector to two values of its body
 *         let j = c11 + u*v
 *         let un = dot(w, c1)/j
 *     end
 *     let ju = derivative(j, xC)           the derivative of a value by another
 *     let u2 j2 = step(0.5, 2*c11, S - A)  the values of a function
 *     let p = c11*xS, q = c11*yS           several lets in a line
 *     exchange u2 c11                      of a frame: exchanging xi and eta turns the one number into the other
 *     least c11                            of a frame: an expression whose least value on samples bounds the region
 *     require xC - xD, 5 - abs(u2)         expressions that are > 0 on the region; any number
 *     genome fast                          a function to be made
 *     note training_xi genes 5 mean 1e-3   its own provenance
 *     xi = 0.05*c1x + yA                   an output: one expression; any number
 *     eta = u2, gap = 3*u2                 outputs in a line
 *     end
 *
 *     file       = "footpoint-genome" "3" { line | function | genome }
 *     line       = note | input | segment | face | region | list
 *     list       = ( range | let | exchange | least | require ) { "," item }      an item is such a line without its first word
 *     note       = "note" KEY text-to-the-end-of-the-line
 *     input      = "input" [ "vector" ] NAME { [ "vector" ] NAME }   before the first let and the first genome; no segment
 *     segment    = "segment" KIND ORDER                        at most one, before the first let, function and genome;
 *                                                              ORDER other than "any" for quad4 alone
 *     face       = "face" KIND                                 in its place
 *     range      = "range" INPUT NUMBER NUMBER                 lower limit <= upper limit
 *                | "range" VECTOR NUMBER NUMBER NUMBER NUMBER NUMBER NUMBER
 *     region     = "region" newline { input | range | let | function | require } "end"   at most one
 *     let        = "let" NAME "=" expression                   before the first genome
 *                | "let" NAME { NAME } "=" FUNCTION "(" expression { "," expression } ")"
 *                | "let" NAME "=" "derivative" "(" SYMBOL "," SYMBOL ")"   outside functions
 *     function   = "function" NAME { [ "vector" ] NAME } "->" NAME { NAME } newline { let { "," item } } "end"
 *     exchange   = "exchange" SYMBOL SYMBOL                    each symbol in one exchange at most
 *     least      = "least" expression
 *     require    = "require" expression
 *     genome     = "genome" NAME newline { note | output { "," output } } "end"
 *     output     = NAME "=" expression
 *                | NAME "=" expression { "," expression }      of a face; a vector stands for its components
 *                | "require" expression { "," expression }     of a face
 *     expression = product { ( "+" | "-" ) product }
 *     product    = signed { ( "*" | "/" | "%" ) signed }
 *     signed     = { "-" } operand
 *     operand    = SYMBOL | NUMBER | "(" expression ")"
 *                | OF2 "(" expression "," expression ")" | OF1 "(" expression ")"
 *     OF2        = "min" | "max" | "dot" | "cross"
 *     OF1        = "sqrt" | "abs" | "neg"
 *
 * Sums and products group from the left: a - b + c is (a - b) + c.  A minus directly before a number is the number's sign,
 * any other is neg: -a*b is neg(a)*b.  / is the quotient, % the protected quotient, which is 1 where the divisor is 0.
 * A NAME has letters, digits and underscores, 63 at most, does not begin with a digit and is no operator or keyword; a
 * SYMBOL is the name of an input or of an earlier let.  A NUMBER is decimal, has an exponent if need be (1e-3), and is
 * exact: 0.05 means 1/20.
 *
 * Each of the lines above is one line of the file, with two exceptions.  An expression goes on in the next line if it is
 * not complete: a parenthesis is open, or its last word is "=" or an operator.  A list or a row goes on after a comma.
 * Otherwise an expression ends with its line, or before a comma outside parentheses.  Words are parted by blanks; a mark
 * + - * / % ( ) , = in an expression needs none.
 *
 * Version 2, which programs write, has the same lines with prefix expressions.  Version 3 is read as the version 2 that it
 * stands for: the expression tree, each operator before its operands.
 *
 *     expression = OP2 expression expression | OP1 expression | SYMBOL | NUMBER
 *     OP2        = "+" | "-" | "*" | "/" | "%" | OF2           let u = * - + a 1 b neg c      (a + 1 - b)*-c
 *     OP1        = "neg" | "sqrt" | "abs"                      let u2 j2 = step 0.5 * 2 c11 - S A
 *
 * There, the operands of a function, of derivative and of a row follow each other without parentheses and commas.  All
 * words but the comma are parted by blanks.  An expression is complete when its stack count reaches 1 (an operator of two
 * operands counts -1, of one operand 0, a leaf +1), and may run over several lines; only the next argument or, in a list,
 * a comma may follow it on its line.
 *
 * A value is a number or a vector of three: + - and neg take either, * also a number and a vector in any order, dot and
 * cross two vectors, all else numbers, as do exchange, require and outputs.  The components of a vector e are the
 * numbers ex ey ez.  What a let is follows from its expression; of a function's parameters, "vector" says so.
 *
 * A function has names of its own: its parameters, and the lets of its body, which may use all that stands before the
 * function, other functions too.  A let that calls it stands for its body, with the arguments in the place of the
 * parameters; the names behind "->" are those of its values.  A file has GENOME_FUNCTIONS functions at most.  Reading
 * expands all lets to lets of numbers, in which there may be GENOME_MOST genes.
 *
 * derivative(y, x) is dy/dx, where x is varied by itself: an input or a let, of which nothing but y follows.  One of the two
 * may be a vector; the result is a vector then.  What y is made of must have derivatives: no minima, maxima, magnitudes or
 * protected quotients.
 *
 * A file with `face` has outputs of any number, each a row of values, and may say which expressions are > 0 where it
 * answers (`require` in a genome); elsewhere its function returns a status.
 *
 * A file with `segment` has exactly the inputs of that kind (quad4: xA yA zA ... xD yD zD xS yS zS), which are the
 * components of the vectors A, B, ..., S and, for unit normals, nA, nB, ...; each of its genomes has the outputs xi and
 * eta.  The region that bounds and verdicts of a header hold on is the box of the ranges, as far as all `require`s are
 * > 0.
 *
 * A region block has names of its own: inputs with ranges, and lets, one for each of the file's inputs (of a segment
 * one for each of its vectors, or an input), which says where it is.  The region is where the inputs are as these lie in their
 * ranges, as far as the requires of block and file are > 0; those of the file may use the block's values, where it has no
 * such name itself.  What the block's other lets are equal to, but for a factor, is enclosed by them as well: other forms of
 * the values on the way make bounds closer.
 *
 * Version 1 is version 2 without vectors and lists; "vector", "face", "derivative", "least", "region", "dot" and "cross"
 * are names like others, `input` lines name the inputs of a segment, too, and what a function is made of are lets of the
 * file:
 *
 *     function newton u v un vn            newton of a pair (a,b) is what the values un and vn are where a stands for u
 *                                          and b for v */
#ifndef FOOTPOINT_GENOME_H
#define FOOTPOINT_GENOME_H

#include "../base/base.h"
#include "genes.h"
#include "segment_kind.h"

#define GENOME_FORMAT 2 /* the version that is written; 1 and 3 are read, too */

/** A gene is an int.  0..GENE_OPERATORS-1: operators; GENE_SYMBOL+k: symbol k (inputs, then lets, in file order);
 *  GENE_LOCAL+k, in the body of a function: number k of its parameters and lets, in a require: symbol k of the file's
 *  region; -1-k: constant k of the file's table. */
#define GENE(name, ...) GENE_##name,
enum gene_operator {
    GENES_OF_TWO(GENE) GENES_OF_ONE(GENE) /* GENE_PDIV: 1 where the divisor is 0 */
    GENE_OPERATORS,
    GENE_FUNCTION = 16, /* + k, one operand: function k of the file, in sets of genes alone */
    GENE_SYMBOL = 64,
    GENE_LOCAL = 1 << 29
};
enum { GENOME_FUNCTIONS = GENE_SYMBOL - GENE_FUNCTION, GENOME_MOST = 1 << 22 };

/** Gene of a function of one number. */
#define GENE_UNARY(k) (GENE_OPERATORS - UNARIES + (k))

/** Operands of a gene: 2, 1 or 0. */
int gene_arity(int gene);
/** Text of an operator gene: "+", "min", ... */
const char *gene_name(int gene);
/** The operator of that text; -1: there is none. */
int gene_of_name(const char *name);
/** Length of the subtree that starts at gene[0] (Tokui and Iba: stack counts add up to 1), or 0 if `n` genes do not
 * hold one. */
size_t gene_span(const int *gene, size_t n);
/** Evaluates an expression in prefix form, operands before their operators, the last gene first.
 *  @param[in] value  returns the value of a gene from those of its operands; -1 stands for an operand that is not there
 *  @return the value of the expression's first gene */
int gene_fold(const int *gene, size_t length, int (*value)(void *context, int gene, int a, int b), void *context);
/** Returns true if a gene is a symbol or a number. */
static inline bool gene_is_leaf(int gene)
{
    return gene < 0 || gene >= GENE_SYMBOL;
}

/** A named prefix expression. */
struct genome_expr {
    char *name; /* owned */
    int *gene;  /* owned, length genes */
    size_t length;
    int line; /* where it stands in the file; 0 when made by a program */
};

/** A provenance line. */
struct genome_note {
    char *key, *text; /* owned */
};

/** Corner order that a genome of a segment assumes. */
enum corner_order {
    CORNERS_ANY,            /* as the mesh has them */
    CORNERS_NEAREST,        /* A is the corner nearest to the slave node */
    CORNERS_NEAREST_SHORTER /* and |AD| <= |AB| */
};

/** "any", "nearest", "nearest-shorter". */
const char *corner_order_name(enum corner_order order);

struct genome {
    char *name;               /* owned */
    struct genome_note *note; /* owned */
    size_t notes, note_room;
    struct genome_expr *out; /* owned */
    size_t outs, out_room;
    int line;
};

/** A constant keeps its decimal text, so that exact arithmetic can read it. */
struct genome_constant {
    char *text; /* owned */
    double value;
};

/** A parameter or a result of a function: the gene of a number, or of the first of three. */
struct genome_value {
    bool vector;
    int gene;
};

/** A function, its body expanded to lets of numbers. */
struct genome_function {
    char *name;                              /* owned */
    struct genome_value *parameter, *result; /* owned */
    size_t parameters, parameter_room, results, result_room;
    struct genome_expr *let; /* owned */
    size_t lets, let_room;
    int first_let; /* gene of the first let: behind those of the parameters */
    void *names;   /* owned: its own; see names.h */
};

/** A let, a function or a least as it is written, its words parted by single blanks. */
struct genome_statement {
    char *name, *text; /* owned; the first name that it defines, or "" */
    size_t *need;      /* owned: the statements whose names it uses */
    size_t needs;
    int line;
    bool joined; /* stands on the line of the one before it */
};

/** Closed interval of an input: constants of the file's table. */
struct genome_range {
    bool given;
    size_t lo, hi;
};

struct genome_file {
    char *path; /* owned */
    int format; /* 1 or GENOME_FORMAT */
    struct genome_note *note;
    size_t notes, note_room;
    const struct segment_kind *segment; /* NULL when the inputs are not nodes */
    enum corner_order order;
    bool face;    /* xi and eta are inputs behind the nodes and the slave node, outputs are rows of any length */
    char **input; /* owned */
    size_t inputs, input_room;
    struct genome_range *range; /* owned: by input */
    size_t range_room;
    struct genome_constant *constant;
    size_t constants, constant_room;
    struct genome_statement *statement; /* owned */
    size_t statements, statement_room;
    struct genome_expr *let; /* of numbers: what the statements say, expanded */
    size_t lets, let_room;
    size_t (*exchange)[2]; /* owned: symbols */
    size_t exchanges, exchange_room;
    struct genome_function *function; /* owned */
    size_t functions, function_room;
    struct genome_expr *require, *least; /* owned; without names */
    size_t requires, require_room, leasts, least_room;
    struct genome_file *region; /* owned: the text of the region block, or NULL */
    struct genome *genome;
    size_t genomes, genome_room;
    void *names, *constant_names; /* owned; see names.h */
};

/** Read and check a file.  Returns NULL with *d filled ("file:line:column: error: ...") on malformed text. */
struct genome_file *genome_read(const char *path, struct diag *d);
/** The same from `size` characters of text; `path` is used in diagnostics only. */
struct genome_file *genome_parse(const char *path, const char *text, size_t size, struct diag *d);
/** A let or a function, read as if it stood behind the file's. */
bool genome_read_statement(struct genome_file *f, const char *text, struct diag *d);
/** Statement k with a suffix to all names of the file that statements define.  Caller frees. */
char *genome_statement_suffixed(const struct genome_file *f, size_t k, const char *suffix);
/** The statement that defines a name, or NULL. */
const struct genome_statement *genome_find_statement(const struct genome_file *f, const char *name);
struct genome_file *genome_file_new(const char *path);
void genome_file_free(struct genome_file *f);

/** Print; genome_parse of what is printed gives the same program. */
void genome_print(const struct genome_file *f, FILE *stream);
/** Print what the genomes and requires need. */
void genome_print_needed(const struct genome_file *f, FILE *stream);

/** Index of a symbol (inputs, then lets) or -1. */
long genome_find_symbol(const struct genome_file *f, const char *name);
const char *genome_symbol_name(const struct genome_file *f, size_t k);
/** Index of a constant of the given decimal text, added if new. */
size_t genome_add_constant(struct genome_file *f, const char *text);
/** Append; text is copied. */
void genome_add_note(struct genome_note **note, size_t *n, size_t *room, const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
/** Text of the first note of that key, or NULL. */
const char *genome_find_note(const struct genome_note *note, size_t n, const char *key);
struct genome *genome_add(struct genome_file *f, const char *name);
void genome_add_input(struct genome_file *f, const char *name);
/** Inputs that are the nodes of a segment and a slave node. */
void genome_add_segment(struct genome_file *f, const struct segment_kind *kind, enum corner_order order);
/** Give an input's interval as decimal texts, lo <= hi. */
void genome_add_range(struct genome_file *f, size_t input, const char *lo, const char *hi);
/** Append an expression that is > 0 on the region. Copies `length` genes. */
void genome_add_require(struct genome_file *f, const int *gene, size_t length);
/** Append a named value; its name must be new. Copies `length` genes. */
void genome_add_let(struct genome_file *f, const char *name, const int *gene, size_t length);
/** Append a let or a function as it is written; takes what the statement owns. */
void genome_add_statement(struct genome_file *f, struct genome_statement s);
/** The symbol of the region that tells an input: the value of its name, for xC of a segment that of Cx; or -1. */
long genome_region_symbol(const struct genome_file *f, size_t input);
/** The statement that defines a symbol that is no input. */
size_t genome_statement_of(const struct genome_file *f, size_t symbol);
/** `head` and an expression, words parted by single blanks.  Caller frees. */
char *genome_expr_text(const struct genome_file *f, const char *head, const struct genome_expr *e);
void genome_free_function(struct genome_function *x);
/** Two symbols that exchanging xi and eta exchanges. */
void genome_add_exchange(struct genome_file *f, size_t a, size_t b);
/** Index of a function or -1. */
long genome_find_function(const struct genome_file *f, const char *name);
/** From two numbers to two. */
bool genome_function_of_pair(const struct genome_function *x);
/** Append an output of a genome: genome_add_expr(&g->out, &g->outs, &g->out_room, ...). Copies `length` genes. */
void genome_add_expr(struct genome_expr **e, size_t *n, size_t *room, const char *name, const int *gene, size_t length);

#endif
