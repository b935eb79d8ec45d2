/* The reader of genome text, in parts: words and names here, expressions, lets, functions, and the lines of a file,
 * each in its own file. */
#ifndef FOOTPOINT_GENOME_READER_H
#define FOOTPOINT_GENOME_READER_H

#include "genome.h"
#include "names.h"
#include "words.h"

/** Operators on vectors, and the first gene of vectors: GENE_VECTOR + k is the one that begins with symbol k. */
enum { GENE_DOT = GENE_OPERATORS, GENE_CROSS, GENE_VECTOR = 1 << 30 };

/** A gene of an expression as it is written. */
struct node {
    int gene;
    bool vector;   /* the value of what begins here */
    size_t second; /* where the second operand begins */
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
    struct genome_function *function; /* not owned; whose body is read, or NULL */
    struct node *node;                /* owned: the expression as it is written */
    size_t nodes, node_room;
    int *gene; /* owned: the expression, or a component of it */
    size_t genes, gene_room;
    size_t total;      /* genes of all lets */
    struct task *task; /* owned: what is still to be expanded */
    size_t tasks, task_room;
    size_t *need; /* owned: the statements whose names this line uses */
    size_t needs, need_room;
    bool alone;      /* a statement by itself, which may follow genomes */
    bool joined;     /* an item of a list that is not its first */
    bool in_region;  /* the lines of a region block */
    bool in_require; /* of the file: the region's values have names, too */
};

/** Fills the diagnostic; %s in the format is the current word. */
bool reader_fail(struct genome_reader *r, const char *format);
/** The same with a text of `length` characters in the place of the word. */
bool reader_fail_text(struct genome_reader *r, const char *format, const char *text, size_t length);

/** What the reader owns, but the file. */
void reader_free(struct genome_reader *r);

bool next_word(struct genome_reader *r, bool same_line);
bool end_of_line(struct genome_reader *r);
/** A comma, or the end of the line; the comma is still to be read. */
bool end_of_item(struct genome_reader *r);
/** Whether a comma comes next; it is read then. */
bool next_is_comma(struct genome_reader *r);
/** The items of a line, of which commas part all but the first. */
bool read_list(struct genome_reader *r, bool (*read_item)(struct genome_reader *));

/** Fills the diagnostic with the place of the current word, which is %s in the format. */
bool word_fail(const struct words *w, const char *format, const char *path, struct diag *d);
/** Keywords and operators of a version of the format. */
bool word_is_keyword(const struct words *w, int format);
bool word_is_operator(const struct words *w, int format, int *gene);
const char *operator_name(int gene);
int operator_arity(int gene);

/** The current word as a name that is neither keyword nor operator, or one that is new, too. */
bool read_name(struct genome_reader *r, char name[NAME_ROOM]);
bool read_new_name(struct genome_reader *r, char name[NAME_ROOM]);
/** What a name that is used stands for: the function's first, then the file's; NULL if it is nothing. */
const struct name *find_name(struct genome_reader *r, const char *text);
/** A decimal number as a constant. */
bool looks_like_number(const struct genome_reader *r);
bool read_number(struct genome_reader *r, int *gene);

/** The operator, number or value that the current word is. */
bool read_gene(struct genome_reader *r, int *gene);
/** The next word, the name of a number. */
bool read_symbol(struct genome_reader *r, int *gene);
/** An expression, to the node array.  Unless `more` may follow, it ends its line or its item of a list.
 *  @param[in] name  whose it is, for messages */
bool read_expression(struct genome_reader *r, const char *name, bool more);
/** Nothing but a comma follows on its line; the comma is still to be read. */
bool end_of_expression(struct genome_reader *r);
/** A component of the expression that was read, or its number, to the gene array. */
bool expand(struct genome_reader *r, int component);
/** The expression must be a number; it is expanded. */
bool expand_number(struct genome_reader *r, const char *name);

/** Appends to the gene array. */
void put_gene(struct genome_reader *r, int gene);

/** A name to be defined. */
struct target {
    char name[NAME_ROOM];
    int line, column;
};
/** Says what the name, and the names of a vector's components, stand for from here on. */
bool add_name(struct genome_reader *r, const struct target *t, bool vector, int gene);
/** Appends a keyword and the words from `start` to here as a statement; its name is empty if it defines none. */
void add_statement(struct genome_reader *r, const char *keyword, const char *name, const char *start, int line);

/** Appends what is in the gene array as a let of the function or the file; its gene. */
bool add_number(struct genome_reader *r, const char *name, int line, int *gene);

/** The gene of the derivative of a number by a number, both of them symbols; on the way lets are added, "TARGET.LET", which
 *  no text can name. */
bool derive(struct genome_reader *r, int of, int by, const char *target, int line, int *gene);

/** An item of a line "let ...", and a "function ...", behind the keyword. */
bool read_let(struct genome_reader *r);
bool read_function(struct genome_reader *r);

#endif
