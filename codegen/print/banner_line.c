/* Prints lines of a banner; see banner_line.h. */
#include "banner_line.h"

#include "../base/text.h"

#include <ctype.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 118, KEY = 16 };

/* Prints text that neither ends the comment nor opens another. */
static int print_safely(const char *text, size_t n, FILE *out)
{
    int column = (int)n;
    for (size_t i = 0; i < n; i++) {
        fputc(isprint((unsigned char)text[i]) ? text[i] : '?', out);
        if (i + 1 < n && ((text[i] == '*' && text[i + 1] == '/') || (text[i] == '/' && text[i + 1] == '*')))
            column += fputc(' ', out) == ' ';
    }
    return column;
}

struct banner_line banner_about_file(const char *key, FILE *out)
{
    struct banner_line l = {out, fprintf(out, " * ")};
    l.column += print_safely(key, strlen(key), out) + fprintf(out, ":");
    return l;
}

struct banner_line banner_about_function(const char *key, FILE *out)
{
    struct banner_line l = {out, fprintf(out, " *   ")};
    const int n = print_safely(key, strlen(key), out) + fprintf(out, ":");
    l.column += n + fprintf(out, "%*s", n < KEY - 1 ? KEY - 1 - n : 0, "");
    return l;
}

static void add_word(struct banner_line *l, const char *word, size_t n)
{
    if (l->column + 1 + (int)n > WIDTH)
        l->column = fprintf(l->out, "\n *    ") - 1;
    fputc(' ', l->out);
    l->column += 1 + print_safely(word, n, l->out);
}

void banner_add(struct banner_line *l, const char *format, ...)
{
    va_list arguments;
    struct memory *m = memory_open();
    va_start(arguments, format);
    vfprintf(m->stream, format, arguments);
    va_end(arguments);
    char *text = memory_close(m);
    for (const char *word = text + strspn(text, " "); *word; word += strspn(word, " ")) {
        const size_t n = strcspn(word, " ");
        add_word(l, word, n);
        word += n;
    }
    free(text);
}

void banner_end(struct banner_line *l)
{
    fputc('\n', l->out);
}
