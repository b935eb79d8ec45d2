/* What printed code says of itself: where it comes from, and above each function its operations, proof and errors. */
#ifndef FOOTPOINT_BANNER_H
#define FOOTPOINT_BANNER_H

#include "../compile/compiled_file.h"

/** A comment of C about the file, and one about a function of it. */
void banner_print_file(const struct unit *u, FILE *out);
void banner_print_function(const struct unit *u, const struct function *f, FILE *out);

/** The same as comments of another language, about the file if `f` is NULL: `mark` begins a line, none is longer than
 *  `width`. */
void banner_print_as(const struct unit *u, const struct function *f, const char *mark, size_t width, FILE *out);

#endif
