/* The third version of genome text: expressions in infix, which become the prefix words of version 2. */
#ifndef FOOTPOINT_GENOME_INFIX_H
#define FOOTPOINT_GENOME_INFIX_H

#include "../base/base.h"
#include "words.h"

/** Text of version 2, and where its words stand in the file that was read. */
struct prefix_text {
    char *text; /* owned */
    size_t size;
    struct word_place *place; /* owned; in order, of each word and each newline */
    size_t places, place_room;
};

/** Translates the lines of a file from `w` on, all that follows the line of its version.  The caller frees *to, also if
 *  an expression is malformed: then the result is false and *d tells file, line and column. */
bool infix_to_prefix(struct words w, const char *path, struct prefix_text *to, struct diag *d);
void prefix_text_free(struct prefix_text *t);

#endif
