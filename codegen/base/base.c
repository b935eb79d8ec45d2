/* Diagnostics, values of options and memory; see base.h. */
#include "base.h"

#include <ctype.h>
#include <errno.h>
#include <sha256.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

bool diag_at(struct diag *d, const char *file, int line, int column, const char *format, ...)
{
    char where[300], what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    if (line > 0 && column > 0)
        snprintf(where, sizeof where, "%.200s:%d:%d", file, line, column);
    else if (line > 0)
        snprintf(where, sizeof where, "%.200s:%d", file, line);
    else
        snprintf(where, sizeof where, "%.200s", file);
    d->code = EXIT_INPUT;
    snprintf(d->text, sizeof d->text, "%.210s: error: %.280s", where, what);
    return false;
}

bool text_whole(const char *text, unsigned long long *value)
{
    char *rest;
    errno = 0;
    *value = strtoull(text, &rest, 10);
    return isdigit((unsigned char)text[0]) && !*rest && errno == 0;
}

int text_word(const char *text, const char *const *words)
{
    for (int i = 0; words[i]; i++)
        if (strcmp(text, words[i]) == 0)
            return i;
    return -1;
}

bool diag_system(struct diag *d, const char *file, const char *what)
{
    const char *reason = strerror(errno);
    diag_at(d, file, 0, 0, "%s: %s", what, reason);
    d->code = EXIT_SYSTEM;
    return false;
}

bool stdout_written(struct diag *d)
{
    errno = 0;
    if (fflush(stdout) == 0 && !ferror(stdout))
        return true;
    if (errno == 0) /* it failed earlier, when the buffer overflowed */
        errno = EIO;
    return diag_system(d, "standard output", "cannot write");
}

int exit_status(bool good, struct diag *d)
{
    if (good && stdout_written(d))
        return EXIT_DONE;
    fprintf(stderr, "%s\n", d->text);
    return (int)d->code;
}

static void out_of_memory(size_t n, size_t size)
{
    fprintf(stderr, "error: out of memory (%zu elements of %zu bytes)\n", n, size);
    exit(EXIT_SYSTEM);
}

void *new_array(size_t n, size_t size)
{
    void *p = calloc(n ? n : 1, size);
    if (!p)
        out_of_memory(n, size);
    return p;
}

struct arena_array {
    struct arena_array *before;
    max_align_t item[];
};

void *arena_array(struct arena *a, size_t n, size_t size)
{
    if (n > (SIZE_MAX - sizeof *a->last) / size)
        out_of_memory(n, size);
    struct arena_array *array = new_array(1, sizeof *array + n * size);
    array->before = a->last;
    a->last = array;
    return array->item;
}

void arena_free(struct arena *a)
{
    while (a->last) {
        struct arena_array *array = a->last;
        a->last = array->before;
        free(array);
    }
}

void grow_array(void *array, size_t n, size_t *room, size_t size)
{
    void *p;
    if (n < *room)
        return;
    const size_t more = *room ? 2 * *room : 16;
    memcpy(&p, array, sizeof p);
    p = more > SIZE_MAX / size ? NULL : realloc(p, more * size);
    if (!p)
        out_of_memory(more, size);
    memset((char *)p + *room * size, 0, (more - *room) * size);
    memcpy(array, &p, sizeof p);
    *room = more;
}

char *new_text(const char *text, size_t n)
{
    char *copy = new_array(n + 1, 1);
    memcpy(copy, text, n);
    return copy;
}

char *read_text(const char *path, size_t *size, struct diag *d)
{
    FILE *f = fopen(path, "rb");
    char *text = NULL;
    size_t n = 0, room = 0;
    if (!f) {
        diag_system(d, path, "cannot open");
        return NULL;
    }
    for (;;) {
        while (room < n + 4096)
            grow_array(&text, room, &room, 1);
        const size_t got = fread(text + n, 1, room - n - 1, f);
        n += got;
        if (got == 0)
            break;
    }
    if (ferror(f)) {
        diag_system(d, path, "cannot read");
        fclose(f);
        free(text);
        return NULL;
    }
    fclose(f);
    text[n] = '\0';
    *size = n;
    return text;
}

void sha256_hex(const void *data, size_t size, char hex[65])
{
    SHA256Data(data, size, hex);
}
