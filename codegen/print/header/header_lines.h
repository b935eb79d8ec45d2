/* Lines of C that the functions over a segment share. */
#ifndef FOOTPOINT_HEADER_LINES_H
#define FOOTPOINT_HEADER_LINES_H

#include "../../compile/compiled_file.h"
#include "../templates.h"

/** "double" or "float". */
const char *lines_real(const struct unit *u);

/** "FUNCTION(const double xA[3], ..., const double xS[3], LAST)", broken where it gets long; `last` with REAL for the type,
 *  no blanks behind commas. */
void lines_print_head(const struct unit *u, const char *function, const char *last, FILE *out);

/** "xA, xB, ..., xS"; caller frees. */
char *lines_vectors(const struct unit *u);

/** "NAME[0], NAME[1], ...", one of each vector; caller frees. */
char *lines_rows(const struct unit *u, const char *name);

/** Whether its edges are straight: of bilinear segments and flat triangles. */
bool lines_straight(const struct unit *u);

/** Words of templates, ended by a word NULL.  Texts are owned. */
struct words {
    struct placeholder *word; /* owned */
    size_t n, room;
};
void words_add(struct words *w, const char *word, char *text); /* takes the text */
void words_set(struct words *w, const char *word, char *text); /* in place of the one before; takes the text */
void words_clear(struct words *w);

/** Returns words about the kind: KIND, PREFIX; SHAPE, "square" or "triangle"; EDGES for contracts;
 *  VECTORS, the slave node included, SEGMENT_VECTORS, without it, NODES, CORNERS, COORDINATES, of all vectors;
 *  NODE_PARAMETERS, "const double xA[3], ..."; NODE_NAMES, "xA, ..., xS"; COLUMNS, what p, the vectors of pair i, is made
 *  of: "{x[0][i], x[1][i], x[2][i]}, ..."; ROWS, "p[0], p[1], ...", VECTOR_ROWS, "x[0], ...", and SEGMENT_ROWS,
 *  "c[0], ...", without the slave node; LEAST_SIZE, see sizes_least_name().  About a function, unless it is NULL: NAME;
 *  SCALED_NODES, how many vectors another unit of length changes, and SCALABLE, whether it changes any, in the search that NAME begins with. */
struct words lines_words(const struct unit *u, const struct function *f, const struct function *search);

/** Prints templates that belong to no function, with these words.
 *  @param[in] guard  of an include guard FOOTPOINT_<KIND>_<guard>; NULL: there is none
 *  @param[in] names  templates, ended by NULL */
void lines_print_templates(const struct unit *u, const char *guard, const char *const *names, FILE *out);

/** The same with another KIND than the segment's. */
void lines_print_kind(const struct unit *u, const char *kind, const char *guard, const char *const *names, FILE *out);

/** How many vectors another unit of length changes: none of a search that depends on it. */
size_t lines_scaled_nodes(const struct unit *u, const struct function *f);

#endif
