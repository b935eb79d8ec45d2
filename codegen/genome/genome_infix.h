/* Version 3 of genome text: translates infix expressions to the prefix words of version 2. */
#ifndef FOOTPOINT_GENOME_INFIX_H
#define FOOTPOINT_GENOME_INFIX_H

#include "../base/base.h"
#include "words.h"

/** Text of version 2, and the positions of its words in the file. */
struct prefix_text {
    char *text; /* owned */
    size_t size;
    struct word_place *place; /* owned; of each word and each newline, in order */
    size_t places, place_room;
};

/** Translates the lines of a file that follow its version line, from `w` on. Returns false if an expression is
 *  malformed; *d then names file, line and column. The caller frees *to in both cases. */
bool infix_to_prefix(struct words w, const char *path, struct prefix_text *to, struct diag *d);
void prefix_text_free(struct prefix_text *t);

#endif
