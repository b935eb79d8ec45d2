/* Words of genome text: parted by blanks, without comments, which begin with # and end with the line. */
#ifndef FOOTPOINT_WORDS_H
#define FOOTPOINT_WORDS_H

#include <stdbool.h>
#include <stddef.h>

/** Where a word of text that was made from a file's stands in the file. */
struct word_place {
    size_t offset;
    int line, column;
};

struct words {
    const char *at, *end; /* unread text */
    const char *line_start;
    int line;
    const char *word; /* the current word; length 0 at the end */
    size_t length;
    int word_line, word_column;
    const char *text; /* whose places are given; NULL: lines and columns are those of the text */
    const struct word_place
        *place; /* not owned; of the current word or one before it in the same line, others follow */
};

struct words words_of(const char *text, size_t size);
/** The same of text made from a file's: `place` tells in order where all its words stand there, its newlines, too, and its
 *  end. */
struct words words_placed(const char *text, size_t size, const struct word_place *place);
/** The next word; with `same_line`, stops before a newline and returns false there. */
bool words_next(struct words *w, bool same_line);
/** Goes to the next word without reading it; its length stays 0. */
bool words_find(struct words *w, bool same_line);
bool word_is(const struct words *w, const char *text);
/** Copy of the word; false if it has `size` characters or more, or a NUL. */
bool word_copy(const struct words *w, char *text, size_t size);

#endif
