/* Prints the banners of code: its origin and, above each function, operations, proof and errors. */
#ifndef FOOTPOINT_BANNER_H
#define FOOTPOINT_BANNER_H

#include "../compile/compiled_file.h"

/** Print a C comment about the file, and about a function of it. */
void banner_print_file(const struct unit *u, FILE *out);
void banner_print_function(const struct unit *u, const struct function *f, FILE *out);

/** Prints the same as comments of another language, about the file if `f` is NULL.  `mark` begins each line, which is at most
 *  `width` long. */
void banner_print_as(const struct unit *u, const struct function *f, const char *mark, size_t width, FILE *out);

#endif
