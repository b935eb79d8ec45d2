/* Genome text: a small straight-line program with named inputs, named values (`let`), functions and any number of
 * genomes.
 *
 *     footpoint-genome 3                   the format and its version: the first words of the file
 *     # comment                            anywhere, to the end of the line
 *     note scene quad4                     provenance: a key and the rest of the line; any number
 *     segment quad4 any                    the inputs are nodes of a segment and the slave node: a kind of segment_kind.h
 *                                          and the order of corners assumed: any | nearest | nearest-shorter
 *     face quad4                           instead: nodes and slave node in any order, then xi and eta, a place on the
 *                                          segment
 *     input x y                            names of inputs, in order, without a segment; may be repeated
 *     range xC -0.5 2                      closed interval of an input; at most one for each
 *     range D 0 1 0 1 -0.3 0.3, xS 0 1     the same of a vector of inputs: of xD, yD and zD; and of another
 *     region ... end                       lines that compute the inputs from other numbers; see below
 *     let c1 = B - A                       a value: one expression of inputs and earlier values; here a vector
 *     let c11 = dot(c1, c1)                a number
 *     function step u v vector w -> un j   a function: from numbers and a vector to two values of its body
 *         let j = c11 + u*v
 *         let un = dot(w, c1)/j
 *     end
 *     let ju = derivative(j, xC)           the derivative of a value by another
 *     let u2 j2 = step(0.5, 2*c11, S - A)  the values of a function
 *     let p = c11*xS, q = c11*yS           several lets in a line
 *     exchange u2 c11                      of a frame: exchanging xi and eta swaps the two numbers
 *     least c11                            of a frame: an expression whose least value on samples bounds the region
 *     require xC - xD, 5 - abs(u2)         expressions that are > 0 on the region; any number
 *     genome fast                          a function to emit
 *     note training_xi genes 5 mean 1e-3   the function's provenance
 *     xi = 0.05*c1x + yA                   an output: one expression; any number
 *     eta = u2, gap = 3*u2                 outputs in a line
 *     end
 *
 *     file       = "footpoint-genome" "3" { line | function | genome }
 *     line       = note | input | segment | face | region | list
 *     list       = ( range | let | exchange | least | require ) { "," item }      an item is a line without its first word
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
 * Sums and products group from the left: a - b + c is (a - b) + c. A minus directly before a number is the number's sign; any
 * other minus is neg: -a*b is neg(a)*b. / is the quotient, % the protected quotient, which is 1 if the divisor is 0. A NAME
 * has letters, digits and underscores, at most 63; it must not begin with a digit or be an operator or keyword. A SYMBOL is
 * the name of an input or of an earlier let. A NUMBER is decimal, optionally with an exponent (1e-3), and exact: 0.05 means
 * 1/20.
 *
 * Each line above is one line of the file, with two exceptions. An incomplete expression continues in the next line: a
 * parenthesis is open, or its last word is "=" or an operator. A list or a row continues after a comma. Otherwise an
 * expression ends with its line, or before a comma outside parentheses. Blanks separate words; the marks
 * + - * / % ( ) , = in an expression need no blanks.
 *
 * Version 2, which programs write, has the same lines with prefix expressions. A reader translates version 3 to version 2:
 * the expression tree, each operator before its operands.
 *
 *     expression = OP2 expression expression | OP1 expression | SYMBOL | NUMBER
 *     OP2        = "+" | "-" | "*" | "/" | "%" | OF2           let u = * - + a 1 b neg c      (a + 1 - b)*-c
 *     OP1        = "neg" | "sqrt" | "abs"                      let u2 j2 = step 0.5 * 2 c11 - S A
 *
 * In version 2, the operands of a function, of derivative and of a row follow each other without parentheses and commas.
 * Blanks separate all words but the comma. An expression is complete when its stack count reaches 1 (a binary operator counts
 * -1, a unary operator 0, a leaf +1). It may extend over several lines; only the next argument or, in a list, a comma may
 * follow on its line.
 *
 * A value is a number or a vector of three. + - and neg accept either; * also a number and a vector in any order; dot and
 * cross two vectors; everything else, including exchange, require and outputs, only numbers. The components of a vector e
 * are the numbers ex ey ez. The type of a let follows from its expression; "vector" declares vector parameters of a function.
 *
 * A function has its own names: its parameters and the lets of its body. The body may use everything before the function,
 * including other functions. A let that calls it stands for its body with arguments substituted for parameters; the names
 * after "->" are its values. A file has at most GENOME_FUNCTIONS functions. The reader expands all lets to lets of numbers,
 * with at most GENOME_MOST genes in all.
 *
 * derivative(y, x) is dy/dx, where x is an input or a let and varies independently: only y depends on it. At most one of the
 * two may be a vector; then so is the result. y must be differentiable: no minima, maxima, magnitudes or protected quotients.
 *
 * A file with `face` has any number of outputs, each a row of values. A genome may declare which expressions are > 0 where it
 * answers (`require`); elsewhere its function returns a status.
 *
 * A file with `segment` has exactly the inputs of that kind (quad4: xA yA zA ... xD yD zD xS yS zS), the components of the
 * vectors A, B, ..., S and, for unit normals, nA, nB, ...; each of its genomes must have the outputs xi and eta. Bounds and
 * verdicts of a header hold on the region: the box of the ranges, restricted to points at which all `require`s are > 0.
 *
 * A region block has its own names: inputs with ranges, and a let for each of the file's inputs (for a segment, for each of
 * its vectors, or an input) that computes it. The region is the set of inputs computed from points in these ranges,
 * restricted by the requires of block and file. The file's requires may use the block's values unless the file defines the
 * same name. An intermediate value that equals one of the block's other lets, up to a factor, is enclosed by it as well:
 * alternative forms tighten bounds.
 *
 * Version 1 is version 2 without vectors and lists. "vector", "face", "derivative", "least", "region", "dot" and "cross" are
 * ordinary names, `input` lines also name the inputs of a segment, and the body of a function consists of lets of the file:
 *
 *     function newton u v un vn            newton of a pair (a,b) has the values of un and vn with u = a and v = b */
#ifndef FOOTPOINT_GENOME_H
#define FOOTPOINT_GENOME_H

#include "../base/base.h"
#include "genes.h"
#include "segment_kind.h"

#define GENOME_FORMAT 2 /* version written; 1 and 3 are read, too */

/** A gene is an int. 0..GENE_OPERATORS-1: operators. GENE_SYMBOL+k: symbol k (inputs, then lets, in file order).
 *  GENE_LOCAL+k: in the body of a function, number k of its parameters and lets; in a require, symbol k of the file's
 *  region. -1-k: constant k of the file's table. */
#define GENE(name, ...) GENE_##name,
enum gene_operator {
    GENES_OF_TWO(GENE) GENES_OF_ONE(GENE) /* GENE_PDIV: 1 where the divisor is 0 */
    GENE_OPERATORS,
    GENE_FUNCTION = 16, /* + k, unary: function k of the file; only in sets of genes */
    GENE_SYMBOL = 64,
    GENE_LOCAL = 1 << 29
};
enum { GENOME_FUNCTIONS = GENE_SYMBOL - GENE_FUNCTION, GENOME_MOST = 1 << 22 };

/** Gene of a function of one number. */
#define GENE_UNARY(k) (GENE_OPERATORS - UNARIES + (k))

/** Returns the number of operands of a gene: 2, 1 or 0. */
int gene_arity(int gene);
/** Returns the text of an operator gene: "+", "min", ... */
const char *gene_name(int gene);
/** Returns the operator with this text, or -1. */
int gene_of_name(const char *name);
/** Returns the length of the subtree that starts at gene[0], where stack counts add up to 1 (Tokui and Iba). Returns 0
 *  if the `n` genes do not contain a whole subtree. */
size_t gene_span(const int *gene, size_t n);
/** Evaluates an expression in prefix form from its last gene to its first, so that operands precede their operators.
 *  @param[in] value  returns the value of a gene from the values of its operands; -1 stands for a missing operand
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
    int line; /* line in the file, from 1; 0 if made by a program */
};

/** A provenance line. */
struct genome_note {
    char *key, *text; /* owned */
};

/** Corner order that a genome of a segment assumes. */
enum corner_order {
    CORNERS_ANY,            /* as in the mesh */
    CORNERS_NEAREST,        /* A is the corner nearest to the slave node */
    CORNERS_NEAREST_SHORTER /* and |AD| <= |AB| */
};

/** Returns "any", "nearest", "nearest-shorter". */
const char *corner_order_name(enum corner_order order);

struct genome {
    char *name;               /* owned */
    struct genome_note *note; /* owned */
    size_t notes, note_room;
    struct genome_expr *out; /* owned */
    size_t outs, out_room;
    int line;
};

/** A constant keeps its decimal text, from which exact arithmetic reads it. */
struct genome_constant {
    char *text; /* owned */
    double value;
};

/** A parameter or a result of a function: the gene of a number, or of the first component of a vector. */
struct genome_value {
    bool vector;
    int gene;
};

/** A function, with its body expanded to lets of numbers. */
struct genome_function {
    char *name;                              /* owned */
    struct genome_value *parameter, *result; /* owned */
    size_t parameters, parameter_room, results, result_room;
    struct genome_expr *let; /* owned */
    size_t lets, let_room;
    int first_let; /* gene of the first let, after the parameters' genes */
    void *names;   /* owned: the function's own names; see names.h */
};

/** A let, a function or a least as written, its words separated by single blanks. */
struct genome_statement {
    char *name, *text; /* owned; the first name that it defines, or "" */
    size_t *need;      /* owned: statements whose names it uses */
    size_t needs;
    int line;
    bool joined; /* is on the line of the previous statement */
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
    const struct segment_kind *segment; /* NULL if the inputs are not nodes */
    enum corner_order order;
    bool face;    /* xi and eta are inputs after the nodes and the slave node; outputs are rows of any length */
    char **input; /* owned */
    size_t inputs, input_room;
    struct genome_range *range; /* owned: indexed by input */
    size_t range_room;
    struct genome_constant *constant;
    size_t constants, constant_room;
    struct genome_statement *statement; /* owned */
    size_t statements, statement_room;
    struct genome_expr *let; /* of numbers: the expanded statements */
    size_t lets, let_room;
    size_t (*exchange)[2]; /* owned: symbols */
    size_t exchanges, exchange_room;
    struct genome_function *function; /* owned */
    size_t functions, function_room;
    struct genome_expr *require, *least; /* owned; unnamed */
    size_t requires, require_room, leasts, least_room;
    struct genome_file *region; /* owned: text of the region block, or NULL */
    struct genome *genome;
    size_t genomes, genome_room;
    void *names, *constant_names; /* owned; see names.h */
};

/** Reads and checks a file. Returns NULL, with *d filled ("file:line:column: error: ..."), if the text is malformed. */
struct genome_file *genome_read(const char *path, struct diag *d);
/** Reads `size` characters of text; `path` is used only in diagnostics. */
struct genome_file *genome_parse(const char *path, const char *text, size_t size, struct diag *d);
/** Reads a let or a function as if it followed the file's statements. */
bool genome_read_statement(struct genome_file *f, const char *text, struct diag *d);
/** Returns statement k with a suffix appended to all names that statements define. The caller frees it. */
char *genome_statement_suffixed(const struct genome_file *f, size_t k, const char *suffix);
/** Returns the statement that defines a name, or NULL. */
const struct genome_statement *genome_find_statement(const struct genome_file *f, const char *name);
struct genome_file *genome_file_new(const char *path);
void genome_file_free(struct genome_file *f);

/** Prints the file. genome_parse of the output gives the same program. */
void genome_print(const struct genome_file *f, FILE *stream);
/** Prints only the statements that the genomes and requires need. */
void genome_print_needed(const struct genome_file *f, FILE *stream);

/** Returns the index of a symbol (inputs, then lets), or -1. */
long genome_find_symbol(const struct genome_file *f, const char *name);
const char *genome_symbol_name(const struct genome_file *f, size_t k);
/** Returns the index of a constant with this decimal text, which is added if it is new. */
size_t genome_add_constant(struct genome_file *f, const char *text);
/** Appends a note; the text is copied. */
void genome_add_note(struct genome_note **note, size_t *n, size_t *room, const char *key, const char *format, ...)
    __attribute__((format(printf, 5, 6)));
/** Returns the text of the first note with this key, or NULL. */
const char *genome_find_note(const struct genome_note *note, size_t n, const char *key);
struct genome *genome_add(struct genome_file *f, const char *name);
void genome_add_input(struct genome_file *f, const char *name);
/** Makes the inputs the nodes of a segment and a slave node. */
void genome_add_segment(struct genome_file *f, const struct segment_kind *kind, enum corner_order order);
/** Sets an input's interval from decimal texts, lo <= hi. */
void genome_add_range(struct genome_file *f, size_t input, const char *lo, const char *hi);
/** Appends an expression that must be > 0 on the region. Copies `length` genes. */
void genome_add_require(struct genome_file *f, const int *gene, size_t length);
/** Appends a named value; its name must be new. Copies `length` genes. */
void genome_add_let(struct genome_file *f, const char *name, const int *gene, size_t length);
/** Appends a let or a function as written; takes over the statement's memory. */
void genome_add_statement(struct genome_file *f, struct genome_statement s);
/** Returns the region's symbol for an input: the value with its name or, for xC of a segment, Cx. Returns -1 if the
 *  region has no such value. */
long genome_region_symbol(const struct genome_file *f, size_t input);
/** Returns the statement that defines a symbol; the symbol must not be an input. */
size_t genome_statement_of(const struct genome_file *f, size_t symbol);
/** Returns `head` and an expression, words separated by single blanks. The caller frees it. */
char *genome_expr_text(const struct genome_file *f, const char *head, const struct genome_expr *e);
void genome_free_function(struct genome_function *x);
/** Adds two symbols that swap when xi and eta do. */
void genome_add_exchange(struct genome_file *f, size_t a, size_t b);
/** Returns the index of a function, or -1. */
long genome_find_function(const struct genome_file *f, const char *name);
/** Returns true if a function maps two numbers to two or more. */
bool genome_function_of_pair(const struct genome_function *x);
/** Appends an output of a genome: genome_add_expr(&g->out, &g->outs, &g->out_room, ...). Copies `length` genes. */
void genome_add_expr(struct genome_expr **e, size_t *n, size_t *room, const char *name, const int *gene, size_t length);

#endif
