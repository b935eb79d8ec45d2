/* Words of genome text: parted by blanks, without comments, which begin with # and end with the line. */
#ifndef FOOTPOINT_WORDS_H
#define FOOTPOINT_WORDS_H

#include <stdbool.h>
#include <stddef.h>

struct words {
    const char *at, *end; /* unread text */
    const char *line_start;
    int line;
    const char *word; /* the current word; length 0 at the end */
    size_t length;
    int word_line, word_column;
};

struct words words_of(const char *text, size_t size);
/** The next word; with `same_line`, stops before a newline and returns false there. */
bool words_next(struct words *w, bool same_line);
bool word_is(const struct words *w, const char *text);
/** Copy of the word; false if it has `size` characters or more, or a NUL. */
bool word_copy(const struct words *w, char *text, size_t size);

#endif
