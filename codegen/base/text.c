/* Formatted, collected and wrapped text; see text.h. */
#include "text.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

char *new_format(const char *format, ...)
{
    va_list arguments, again;
    va_start(arguments, format);
    va_copy(again, arguments);
    const int n = vsnprintf(NULL, 0, format, arguments);
    char *text = new_array((size_t)n + 1, 1);
    vsnprintf(text, (size_t)n + 1, format, again);
    va_end(arguments);
    va_end(again);
    return text;
}

char *new_capitals(const char *text)
{
    char *copy = new_text(text, strlen(text));
    for (char *c = copy; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    return copy;
}

char *new_joined(const char *a, const char *b, const char *c)
{
    const size_t x = strlen(a), y = strlen(b), z = strlen(c);
    char *t = new_array(x + y + z + 1, 1);
    memcpy(t, a, x);
    memcpy(t + x, b, y);
    memcpy(t + x + y, c, z);
    return t;
}

void growing_add(struct growing *g, const char *more)
{
    const size_t n = strlen(more);
    while (g->room < g->size + n + 1)
        grow_array(&g->text, g->room, &g->room, 1);
    memcpy(g->text + g->size, more, n + 1);
    g->size += n;
}

static void fail_without_memory(void)
{
    fprintf(stderr, "error: out of memory (a stream)\n");
    exit(EXIT_SYSTEM);
}

struct memory *memory_open(void)
{
    struct memory *m = new_array(1, sizeof *m);
    m->stream = open_memstream(&m->text, &m->size);
    if (!m->stream)
        fail_without_memory();
    return m;
}

char *memory_close(struct memory *m)
{
    const bool good = !ferror(m->stream) && fclose(m->stream) == 0;
    char *text = m->text;
    free(m);
    if (!good)
        fail_without_memory();
    return text;
}

static size_t last_line(const char *text)
{
    const char *newline = strrchr(text, '\n');
    return strlen(newline ? newline + 1 : text);
}

size_t print_broken(const char *text, size_t column, size_t width, const char *broken, const char *inside, FILE *out)
{
    size_t breaks = 0;
    while (*text) {
        const size_t n = *text == ' ' ? 1 + strcspn(text + 1, " ") : strcspn(text, " ");
        const size_t room = width > column ? width - column : 1;
        if (n > room && column > last_line(broken)) {
            fputs(broken, out);
            column = last_line(broken);
            breaks++;
            text += *text == ' ';
            continue;
        }
        const size_t part = n > room && inside ? room : n;
        fwrite(text, 1, part, out);
        column += part;
        text += part;
        if (part < n) {
            fputs(inside, out);
            column = last_line(inside);
            breaks++;
        }
    }
    return breaks;
}
