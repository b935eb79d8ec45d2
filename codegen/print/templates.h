/* C text of headers in double or in float: the files of templates/, and text that is written as these are. */
#ifndef FOOTPOINT_TEMPLATES_H
#define FOOTPOINT_TEMPLATES_H

#include "../compile/compiled_file.h"

/** A word of a template, and what is printed instead. */
struct placeholder {
    const char *word, *text;
};

/** Prints `text`, C with REAL for the type of real numbers and the words beginning with REAL_ of templates.c, which are
 *  the type's properties: in float constants and functions of math.h get their f, and names of helpers another
 *  beginning. */
void c_print(const char *text, enum precision precision, FILE *out);

/** Prints templates/NAME.h for each name, from below its first paragraph.  Names end with NULL; about them stands the
 *  include guard, in capitals and in float with _F at its end, unless it is NULL.  `own`, or NULL, ends with a word NULL;
 *  a part of an identifier between underscores is a word, too. */
void templates_print(const char *guard, const char *const *name, enum precision precision,
                     const struct placeholder *own, FILE *out);

/** Lines of a template between a line WITH_word and a line END_word.  They are printed once for each pass, whose words,
 *  ended by a word NULL, are known there, too.  Without passes they are left out. */
struct block {
    const char *word;
    size_t passes;
    const struct placeholder *const *pass; /* NULL: no words */
};

/** Prints one template.  Blocks, or NULL, end with a word NULL.  A line that is nothing but a word of `own` stands for the
 *  lines of that word's text. */
void templates_print_blocks(const char *name, enum precision precision, const struct placeholder *own,
                            const struct block *block, FILE *out);

#endif
