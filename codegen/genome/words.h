/* Words of genome text, separated by blanks, without comments, which extend from # to the end of the line. */
#ifndef FOOTPOINT_WORDS_H
#define FOOTPOINT_WORDS_H

#include <stdbool.h>
#include <stddef.h>

/** Position in the file of a word of translated text. */
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
    const char *text;               /* text whose positions are given; NULL: lines and columns are this text's own */
    const struct word_place *place; /* not owned; of the current word or an earlier word of the line; others follow */
};

struct words words_of(const char *text, size_t size);
/** Returns the words of translated text. place: positions in the file of all words and newlines and of the end, in
 *  order. */
struct words words_placed(const char *text, size_t size, const struct word_place *place);
/** Reads the next word. With `same_line`, stops before a newline and returns false. */
bool words_next(struct words *w, bool same_line);
/** Advances to the next word without reading it; its length stays 0. */
bool words_find(struct words *w, bool same_line);
bool word_is(const struct words *w, const char *text);
/** Copies the word. Returns false if it has `size` characters or more, or contains a NUL. */
bool word_copy(const struct words *w, char *text, size_t size);

#endif
