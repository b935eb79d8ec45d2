/* Lines of C that the functions over a segment share. */
#ifndef FOOTPOINT_HEADER_LINES_H
#define FOOTPOINT_HEADER_LINES_H

#include "../../compile/compiled_file.h"
#include "../templates.h"

/** Returns "double" or "float". */
const char *lines_real(const struct unit *u);

/** Prints "FUNCTION(const double xA[3], ..., const double xS[3], LAST)", broken if it gets long. `last` uses REAL for
 *  the type and has no blanks after commas. */
void lines_print_head(const struct unit *u, const char *function, const char *last, FILE *out);

/** Returns "xA, xB, ..., xS"; the caller must free it. */
char *lines_vectors(const struct unit *u);

/** Returns "NAME[0], NAME[1], ...", an element for each vector; the caller must free it. */
char *lines_rows(const struct unit *u, const char *name);

/** Returns true if the kind has straight edges: bilinear segments and flat triangles. */
bool lines_straight(const struct unit *u);

/** Words of templates; the last word is NULL. The texts are owned. */
struct words {
    struct placeholder *word; /* owned */
    size_t n, room;
};
void words_add(struct words *w, const char *word, char *text); /* adds a word; owns the text */

/* Adds the words of patch_net.h: the beginning of its names, the type of coordinates, whose arrays are `room` long and take `turns`
 * turns of a loop, and the beginning of the functions that read and write them, which are the arrays themselves if it is NULL. */
void words_add_net(struct words *w, const char *net, const char *type, const char *room, const char *turns,
                   const char *access);
void words_set(struct words *w, const char *word, char *text); /* replaces the text of a word; owns the new text */
void words_clear(struct words *w);

/** Returns words about the kind and, unless it is NULL, about a function.
 *  KIND, PREFIX; SHAPE: "square" or "triangle"; EDGES: for contracts;
 *  VECTORS: number of vectors, with the slave node; SEGMENT_VECTORS: without it; NODES, CORNERS; COORDINATES: of all
 *    vectors;
 *  NODE_PARAMETERS: "const double xA[3], ..."; NODE_NAMES: "xA, ..., xS";
 *  COLUMNS: the vectors p of pair i, "{x[0][i], x[1][i], x[2][i]}, ...";
 *  ROWS: "p[0], p[1], ..."; VECTOR_ROWS: "x[0], ..."; SEGMENT_ROWS: "c[0], ...", without the slave node;
 *  LEAST_SIZE: see sizes_least_name().
 *  Of a function: NAME; SCALED_NODES: how many vectors a unit of length changes in the search that starts NAME;
 *    SCALABLE: whether it changes any. */
struct words lines_words(const struct unit *u, const struct function *f, const struct function *search);

/** Prints templates that belong to no function, with these words.
 *  @param[in] guard  suffix of an include guard FOOTPOINT_<KIND>_<guard>; NULL: no guard
 *  @param[in] names  templates; the last is NULL */
void lines_print_templates(const struct unit *u, const char *guard, const char *const *names, FILE *out);

/** Prints the same for another KIND than the segment's. */
void lines_print_kind(const struct unit *u, const char *kind, const char *guard, const char *const *names, FILE *out);

/** Returns how many vectors a unit of length changes; 0 if the search depends on the unit. */
size_t lines_scaled_nodes(const struct unit *u, const struct function *f);

#endif
