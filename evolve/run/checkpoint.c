/* Checkpoint files; see checkpoint.h. */
#include "checkpoint.h"

#include <ctype.h>
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { SIZE_BYTES = 8, SEAL = 65 /* digits and a line feed */ };
static const char magic[] = "footpoint-checkpoint ";

static void put(struct checkpoint_writer *w, const void *data, size_t bytes)
{
    SHA256Update(&w->sum, data, bytes);
    fwrite(data, 1, bytes, w->file.stream);
}

bool checkpoint_begin(struct checkpoint_writer *w, const char *path, const char *facts, size_t sections, struct diag *d)
{
    char line[96];
    if (!outfile_open(&w->file, path, d))
        return false;
    SHA256Init(&w->sum);
    const int n = snprintf(line, sizeof line, "%s%d %zu %zu\n", magic, CHECKPOINT_FORMAT, strlen(facts), sections);
    put(w, line, (size_t)n);
    put(w, facts, strlen(facts));
    return true;
}

void checkpoint_section(struct checkpoint_writer *w, const void *data, size_t bytes)
{
    unsigned char size[SIZE_BYTES];
    for (int i = 0; i < SIZE_BYTES; i++)
        size[i] = (unsigned char)((uint64_t)bytes >> (8 * i));
    put(w, size, sizeof size);
    put(w, data, bytes);
}

bool checkpoint_commit(struct checkpoint_writer *w, struct diag *d)
{
    char hex[SHA256_DIGEST_STRING_LENGTH];
    SHA256End(&w->sum, hex);
    fprintf(w->file.stream, "%s\n", hex);
    return outfile_commit(&w->file, d);
}

static bool sealed(const char *text, size_t size)
{
    char hex[65];
    if (size <= SEAL || text[size - 1] != '\n')
        return false;
    sha256_hex(text, size - SEAL, hex);
    return memcmp(hex, text + size - SEAL, SEAL - 1) == 0;
}

/* A number of the first line, and the one character after it. */
static bool read_number(const char **text, char after, size_t *value)
{
    char *rest;
    if (!isdigit((unsigned char)**text))
        return false;
    errno = 0;
    const unsigned long long v = strtoull(*text, &rest, 10);
    *value = (size_t)v;
    *text = rest + 1;
    return errno == 0 && *rest == after;
}

static bool read_sections(struct checkpoint *c, const unsigned char *at, const unsigned char *end)
{
    if (c->sections > (size_t)(end - at) / SIZE_BYTES)
        return false;
    c->section = new_array(c->sections, sizeof *c->section);
    for (size_t i = 0; i < c->sections; i++) {
        uint64_t bytes = 0;
        if (end - at < SIZE_BYTES)
            return false;
        for (int k = SIZE_BYTES; k-- > 0;)
            bytes = bytes << 8 | at[k];
        at += SIZE_BYTES;
        if (bytes > (uint64_t)(end - at))
            return false;
        c->section[i] = (struct checkpoint_part){at, (size_t)bytes};
        at += bytes;
    }
    return at == end;
}

static bool read_parts(struct checkpoint *c, const char *path, size_t size, struct diag *d)
{
    const char *at = c->text + sizeof magic - 1;
    size_t format, facts;
    if (size < sizeof magic || memcmp(c->text, magic, sizeof magic - 1) != 0)
        return diag_at(d, path, 0, 0, "no checkpoint");
    if (!read_number(&at, ' ', &format))
        return diag_at(d, path, 0, 0, "checkpoint is cut or damaged");
    if (format != CHECKPOINT_FORMAT)
        return diag_at(d, path, 0, 0, "checkpoint of format %zu; this program reads %d", format, CHECKPOINT_FORMAT);
    if (!sealed(c->text, size))
        return diag_at(d, path, 0, 0, "checkpoint is cut or damaged");
    const char *end = c->text + size - SEAL;
    if (!read_number(&at, ' ', &facts) || !read_number(&at, '\n', &c->sections) || at > end ||
        facts > (size_t)(end - at))
        return diag_at(d, path, 0, 0, "checkpoint is cut or damaged");
    c->facts = new_text(at, facts);
    return read_sections(c, (const unsigned char *)at + facts, (const unsigned char *)end) ||
           diag_at(d, path, 0, 0, "checkpoint is cut or damaged");
}

bool checkpoint_read(struct checkpoint *c, const char *path, struct diag *d)
{
    size_t size;
    *c = (struct checkpoint){.text = read_text(path, &size, d)};
    if (!c->text)
        return false;
    if (read_parts(c, path, size, d))
        return true;
    checkpoint_free(c);
    return false;
}

void checkpoint_free(struct checkpoint *c)
{
    free(c->text);
    free(c->facts);
    free(c->section);
    *c = (struct checkpoint){0};
}

bool checkpoint_fact(const char *facts, const char *key, char *value, size_t n)
{
    const size_t length = strlen(key);
    for (const char *line = facts; *line;) {
        const size_t end = strcspn(line, "\n");
        if (end > length && memcmp(line, key, length) == 0 && line[length] == ' ') {
            const size_t size = end - length - 1;
            if (size >= n)
                return false;
            memcpy(value, line + length + 1, size);
            value[size] = '\0';
            return true;
        }
        line += end + (line[end] == '\n');
    }
    return false;
}
