/* Text under construction, for all code that prints. */
#ifndef FOOTPOINT_TEXT_H
#define FOOTPOINT_TEXT_H

#include "base.h"

/** Returns formatted text. The caller frees it. */
char *new_format(const char *format, ...) __attribute__((format(printf, 1, 2)));

/** Returns the text in capital letters. The caller frees it. */
char *new_capitals(const char *text);

/** Returns a, b and c concatenated. The caller frees it. */
char *new_joined(const char *a, const char *b, const char *c);

/** Text that grows at its end; NULL while it is empty. */
struct growing {
    char *text; /* owned */
    size_t size, room;
};
void growing_add(struct growing *g, const char *more);

/** A stream into memory; exits like new_array. */
struct memory {
    FILE *stream;
    char *text;
    size_t size;
};
struct memory *memory_open(void);
/** Closes the stream and returns its text. The caller frees it. */
char *memory_close(struct memory *m);

/** Prints text that starts at column `column`, broken at blanks before column `width`. `broken` ends a line and begins
 *  the next; `inside` breaks a word too long for a line (NULL: left long). Returns the number of breaks. */
size_t print_broken(const char *text, size_t column, size_t width, const char *broken, const char *inside, FILE *out);

#endif
