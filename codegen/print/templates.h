/* Prints C text of headers in double or in float: the files of templates/, and text in the same style. */
#ifndef FOOTPOINT_TEMPLATES_H
#define FOOTPOINT_TEMPLATES_H

#include "../compile/compiled_file.h"

/** A word of a template, and its replacement. */
struct placeholder {
    const char *word, *text;
};

/** Prints `text`, C with REAL for the type of real numbers and with the words beginning with REAL_ in templates.c, the type's
 *  properties.  In float, constants and functions of math.h get their f, and names of helpers another beginning. */
void c_print(const char *text, enum precision precision, FILE *out);

/** Prints `text` in double with one's own words, as templates_print does. */
void c_print_words(const char *text, const struct placeholder *own, FILE *out);

/** Prints templates/NAME.h for each name, without its first paragraph.  Names end with NULL.  The include guard around them is
 *  `guard` in capitals, in float with _F at its end, unless it is NULL.  `own`, or NULL, ends with a word NULL; a part of an
 *  identifier between underscores is a word, too.  The text of REAL_NUMBER, if there is this word, converts numbers with a
 *  fraction: T makes T(0.5) of 0.5. */
void templates_print(const char *guard, const char *const *name, enum precision precision,
                     const struct placeholder *own, FILE *out);

/** Lines of a template between a line WITH_word and a line END_word.  They are printed once for each pass, in which the words of the
 *  pass, ended by a word NULL, are replaced, too.  Without passes they are left out. */
struct block {
    const char *word;
    size_t passes;
    const struct placeholder *const *pass; /* NULL: without words */
};

/** Prints a template.  Blocks, or NULL, end with a word NULL.  A line that consists of a word of `own` is replaced by the lines of
 *  that word's text. */
void templates_print_blocks(const char *name, enum precision precision, const struct placeholder *own,
                            const struct block *block, FILE *out);

#endif
