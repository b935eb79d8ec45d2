/* Prints lines of a banner, each " *   key:   words", which are continued below if they get long. */
#ifndef FOOTPOINT_BANNER_LINE_H
#define FOOTPOINT_BANNER_LINE_H

#include <stdio.h>

struct banner_line {
    FILE *out;
    int column;
};

/** Begins a line about the file: " * key:". */
struct banner_line banner_about_file(const char *key, FILE *out);
/** Begins a line about a function, with its text aligned to the other lines. */
struct banner_line banner_about_function(const char *key, FILE *out);

/** Adds text, which breaks only at spaces and neither ends the comment nor opens another. */
void banner_add(struct banner_line *l, const char *format, ...) __attribute__((format(printf, 2, 3)));
void banner_end(struct banner_line *l);

#endif
