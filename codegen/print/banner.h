/* What printed code says of itself: where it comes from, its operations, its proof and its errors. */
#ifndef FOOTPOINT_BANNER_H
#define FOOTPOINT_BANNER_H

#include "../compile/compiled_file.h"

/** Lines that begin with " *", the inside of a C comment. */
void banner_print(const struct unit *u, FILE *out);

/** The same as comments of another language: `mark` begins a line, none is longer than `width`. */
void banner_print_as(const struct unit *u, const char *mark, size_t width, FILE *out);

#endif
