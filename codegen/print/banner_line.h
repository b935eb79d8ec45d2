/* Lines of a banner, each " *   key:   words", which go on below where they get long. */
#ifndef FOOTPOINT_BANNER_LINE_H
#define FOOTPOINT_BANNER_LINE_H

#include <stdio.h>

struct banner_line {
    FILE *out;
    int column;
};

/** Begins a line about the file: " * key:". */
struct banner_line banner_about_file(const char *key, FILE *out);
/** Begins a line about a function, whose text is aligned with that of others. */
struct banner_line banner_about_function(const char *key, FILE *out);

/** Adds text, which breaks at spaces alone; nothing in it ends the comment or opens another. */
void banner_add(struct banner_line *l, const char *format, ...) __attribute__((format(printf, 2, 3)));
void banner_end(struct banner_line *l);

#endif
