/* Splits genome text into words; see words.h. */
#include "words.h"

#include <string.h>

struct words words_of(const char *text, size_t size)
{
    return (struct words){.at = text, .end = text + size, .line_start = text, .line = 1};
}

struct words words_placed(const char *text, size_t size, const struct word_place *place)
{
    struct words w = words_of(text, size);
    w.text = text;
    w.place = place;
    return w;
}

/* Advances to the next word, past blanks, comments and, unless `same_line`, newlines. */
static void skip(struct words *w, bool same_line)
{
    for (;; w->at++) {
        if (w->at < w->end && *w->at == '#')
            while (w->at < w->end && *w->at != '\n')
                w->at++;
        if (w->at == w->end)
            return;
        if (*w->at == '\n') {
            if (same_line)
                return;
            w->line++;
            w->line_start = w->at + 1;
        } else if (*w->at != ' ' && *w->at != '\t' && *w->at != '\r')
            return;
    }
}

/* Finds the position of the current word. Words of a note have the position of their line. */
static void find_place(struct words *w)
{
    const size_t offset = (size_t)(w->word - w->text);
    while (w->place->offset < offset && w->place[1].offset <= offset)
        w->place++;
    w->word_line = w->place->line;
    w->word_column = w->place->column + (int)(offset - w->place->offset);
}

bool words_find(struct words *w, bool same_line)
{
    skip(w, same_line);
    w->length = 0;
    w->word = w->at;
    w->word_line = w->line;
    w->word_column = (int)(w->at - w->line_start) + 1;
    if (w->text)
        find_place(w);
    return w->at < w->end && !(same_line && *w->at == '\n');
}

bool words_next(struct words *w, bool same_line)
{
    if (!words_find(w, same_line))
        return false;
    if (*w->at == ',')
        w->at++;
    else
        while (w->at < w->end && (*w->at == '\0' || !strchr(" \t\r\n#,", *w->at))) /* a NUL in a word is rejected
                                                                                    * later */
            w->at++;
    w->length = (size_t)(w->at - w->word);
    return true;
}

bool word_is(const struct words *w, const char *text)
{
    return w->length == strlen(text) && memcmp(w->word, text, w->length) == 0;
}

bool word_copy(const struct words *w, char *text, size_t size)
{
    if (w->length >= size || memchr(w->word, '\0', w->length))
        return false;
    memcpy(text, w->word, w->length);
    text[w->length] = '\0';
    return true;
}
