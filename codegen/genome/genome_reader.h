/* The reader of genome text. Words and names, expressions, lets, functions, and the lines of a file have a file
 * each. */
#ifndef FOOTPOINT_GENOME_READER_H
#define FOOTPOINT_GENOME_READER_H

#include "genome.h"
#include "names.h"
#include "words.h"

/** Operators on vectors, and the genes of vectors: GENE_VECTOR + k is the vector that begins with symbol k. */
enum { GENE_DOT = GENE_OPERATORS, GENE_CROSS, GENE_VECTOR = 1 << 30 };

/** A gene of an expression as written. */
struct node {
    int gene;
    bool vector;   /* type of the subexpression that begins here */
    size_t second; /* index of the second operand */
    int line, column;
};

/** Component `component` of the expression at node `at`; component -1: the gene `at`. */
struct task {
    size_t at;
    int component;
};

struct genome_reader {
    struct genome_file *file;
    struct diag *d;
    struct words w;
    struct genome_function *function; /* not owned; function whose body is being read, or NULL */
    struct node *node;                /* owned: the expression as written */
    size_t nodes, node_room;
    int *gene; /* owned: the expression, or a component of it */
    size_t genes, gene_room;
    size_t total;      /* genes of all lets */
    struct task *task; /* owned: still to be expanded */
    size_t tasks, task_room;
    size_t *need; /* owned: statements whose names this line uses */
    size_t needs, need_room;
    bool alone;      /* a single statement, which may follow genomes */
    bool joined;     /* not the first item of a list */
    bool in_region;  /* reading the lines of a region block */
    bool in_require; /* reading a require of the file, which may use the region's values */
};

/** Fills the diagnostic; %s in the format is the current word. */
bool reader_fail(struct genome_reader *r, const char *format);
/** Fills the diagnostic; %s is a text of `length` characters. */
bool reader_fail_text(struct genome_reader *r, const char *format, const char *text, size_t length);

/** Frees everything that the reader owns, except the file. */
void reader_free(struct genome_reader *r);

bool next_word(struct genome_reader *r, bool same_line);
bool end_of_line(struct genome_reader *r);
/** Checks for a comma or the end of the line; the comma stays unread. */
bool end_of_item(struct genome_reader *r);
/** Reads a comma if it comes next, and returns whether it did. */
bool next_is_comma(struct genome_reader *r);
/** Reads the items of a line, separated by commas. */
bool read_list(struct genome_reader *r, bool (*read_item)(struct genome_reader *));

/** Fills the diagnostic with the position of the current word, which is %s in the format. */
bool word_fail(const struct words *w, const char *format, const char *path, struct diag *d);
/** Returns true if a word is a keyword or operator of a format version. */
bool word_is_keyword(const struct words *w, int format);
bool word_is_operator(const struct words *w, int format, int *gene);
const char *operator_name(int gene);
int operator_arity(int gene);

/** Reads the current word as a name: neither keyword nor operator, and for the second function also new. */
bool read_name(struct genome_reader *r, char name[NAME_ROOM]);
bool read_new_name(struct genome_reader *r, char name[NAME_ROOM]);
/** Returns the meaning of a name, the function's own names first, then the file's; NULL if it is undefined. */
const struct name *find_name(struct genome_reader *r, const char *text);
/** Reads a decimal number as a constant. */
bool looks_like_number(const struct genome_reader *r);
bool read_number(struct genome_reader *r, int *gene);

/** Reads the current word as operator, number or value. */
bool read_gene(struct genome_reader *r, int *gene);
/** Reads the next word, the name of a number. */
bool read_symbol(struct genome_reader *r, int *gene);
/** Reads an expression into the node array. Unless `more` is set, it must end its line or its item of a list.
 *  @param[in] name  name of the value, for messages */
bool read_expression(struct genome_reader *r, const char *name, bool more);
/** Checks that only a comma follows on the line; the comma stays unread. */
bool end_of_expression(struct genome_reader *r);
/** Expands a component of the expression read, or its number, into the gene array. */
bool expand(struct genome_reader *r, int component);
/** Expands the expression, which must be a number. */
bool expand_number(struct genome_reader *r, const char *name);

/** Appends to the gene array. */
void put_gene(struct genome_reader *r, int gene);

/** A name to be defined. */
struct target {
    char name[NAME_ROOM];
    int line, column;
};
/** Defines a name, and the names of a vector's components. */
bool add_name(struct genome_reader *r, const struct target *t, bool vector, int gene);
/** Appends a keyword and the words from `start` to the current position as a statement; its name is empty if it defines
 *  none. */
void add_statement(struct genome_reader *r, const char *keyword, const char *name, const char *start, int line);

/** Appends the gene array as a let of the function or the file; sets *gene to its gene. */
bool add_number(struct genome_reader *r, const char *name, int line, int *gene);

/** Finds the gene of the derivative of a number by a number; both must be symbols. Adds lets "TARGET.LET", a name that
 *  no text can use. */
bool derive(struct genome_reader *r, int of, int by, const char *target, int line, int *gene);

/** Reads an item of a line "let ...", or a "function ...", after the keyword. */
bool read_let(struct genome_reader *r);
bool read_function(struct genome_reader *r);

#endif
