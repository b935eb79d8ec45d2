/* Checkpoint files; see checkpoint.h. */
#include "checkpoint.h"

#include <ctype.h>
#include <endian.h>
#include <errno.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { SIZE_BYTES = 8, FIRST_LINE = 96 };
static const char magic[] = "footpoint-checkpoint ";

void checkpoint_seal(unsigned char *data, size_t bytes)
{
    char hex[65];
    sha256_hex(data, bytes, hex);
    memcpy(data + bytes, hex, CHECKPOINT_SEAL - 1);
    data[bytes + CHECKPOINT_SEAL - 1] = '\n';
}

/* Returns true if the seal after these bytes matches them. */
static bool sealed(const void *data, size_t bytes)
{
    const unsigned char *seal = (const unsigned char *)data + bytes;
    char hex[65];
    sha256_hex(data, bytes, hex);
    return memcmp(hex, seal, CHECKPOINT_SEAL - 1) == 0 && seal[CHECKPOINT_SEAL - 1] == '\n';
}

/* Computes the place of each section from the lengths. Returns false on overflow. */
static bool place_sections(struct checkpoint *c)
{
    c->size = c->head_bytes;
    for (size_t i = 0; i < c->sections; i++) {
        struct checkpoint_part *part = &c->section[i];
        if (part->bytes > INT64_MAX - CHECKPOINT_SEAL - c->size)
            return false;
        part->place = c->size;
        c->size += part->bytes + CHECKPOINT_SEAL;
    }
    return true;
}

struct checkpoint checkpoint_new(const char *facts, const size_t *bytes, size_t sections)
{
    char line[FIRST_LINE];
    const size_t text = strlen(facts);
    const size_t n = (size_t)snprintf(line, sizeof line, "%s%d %zu %zu\n", magic, CHECKPOINT_FORMAT, text, sections);
    const size_t sealed_bytes = n + text + sections * SIZE_BYTES;
    struct checkpoint c = {.head = new_array(sealed_bytes + CHECKPOINT_SEAL, 1),
                           .head_bytes = sealed_bytes + CHECKPOINT_SEAL,
                           .facts = new_text(facts, text),
                           .sections = sections,
                           .section = new_array(sections, sizeof *c.section)};
    char *at = c.head + n + text;
    memcpy(c.head, line, n);
    memcpy(c.head + n, facts, text);
    for (size_t i = 0; i < sections; i++) {
        const uint64_t stored = htole64(bytes[i]);
        c.section[i].bytes = bytes[i];
        memcpy(at + i * SIZE_BYTES, &stored, SIZE_BYTES);
    }
    checkpoint_seal((unsigned char *)c.head, sealed_bytes);
    place_sections(&c);
    return c;
}

static bool damaged(const char *path, struct diag *d)
{
    return diag_at(d, path, 0, 0, "checkpoint is truncated or damaged");
}

/* Reads a number of the first line and the character that follows it. */
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

/* Reads the first line: the length of the facts and of the whole head, which must have at most `most` bytes. */
static bool read_first(struct checkpoint *c, const char *path, const char *text, size_t most, size_t *facts,
                       struct diag *d)
{
    const char *at = text + sizeof magic - 1;
    size_t format;
    if (strncmp(text, magic, sizeof magic - 1) != 0)
        return diag_at(d, path, 0, 0, "no checkpoint");
    if (!read_number(&at, ' ', &format))
        return damaged(path, d);
    if (format != CHECKPOINT_FORMAT)
        return diag_at(d, path, 0, 0, "checkpoint has format %zu; this program reads %d", format, CHECKPOINT_FORMAT);
    if (!read_number(&at, ' ', facts) || !read_number(&at, '\n', &c->sections) || *facts > most ||
        c->sections > most / SIZE_BYTES)
        return damaged(path, d);
    c->head_bytes = (size_t)(at - text) + *facts + c->sections * SIZE_BYTES + CHECKPOINT_SEAL;
    return c->head_bytes <= most || damaged(path, d);
}

/* Parses the head at c->head, of c->head_bytes. */
static bool read_head(struct checkpoint *c, size_t facts)
{
    const size_t lengths = c->head_bytes - CHECKPOINT_SEAL - c->sections * SIZE_BYTES;
    const char *at = c->head + lengths;
    if (!sealed(c->head, c->head_bytes - CHECKPOINT_SEAL))
        return false;
    c->facts = new_text(c->head + lengths - facts, facts);
    c->section = new_array(c->sections, sizeof *c->section);
    for (size_t i = 0; i < c->sections; i++, at += SIZE_BYTES) {
        uint64_t stored;
        memcpy(&stored, at, SIZE_BYTES);
        c->section[i].bytes = (size_t)le64toh(stored);
    }
    return place_sections(c);
}

static bool read_file(struct checkpoint *c, const char *path, FILE *f, struct diag *d)
{
    char line[FIRST_LINE] = "";
    size_t facts = 0;
    struct stat s;
    if (fstat(fileno(f), &s) != 0)
        return diag_system(d, path, "cannot read");
    const size_t size = S_ISREG(s.st_mode) ? (size_t)s.st_size : 0;
    line[fread(line, 1, sizeof line - 1, f)] = '\0';
    if (ferror(f))
        return diag_system(d, path, "cannot read");
    if (!read_first(c, path, line, size, &facts, d))
        return false;
    c->head = new_array(c->head_bytes, 1);
    rewind(f);
    if (fread(c->head, 1, c->head_bytes, f) != c->head_bytes && ferror(f))
        return diag_system(d, path, "cannot read");
    return (read_head(c, facts) && c->size == size) || damaged(path, d);
}

bool checkpoint_read(struct checkpoint *c, const char *path, struct diag *d)
{
    *c = (struct checkpoint){0};
    FILE *f = fopen(path, "rb");
    if (!f)
        return diag_system(d, path, "cannot open");
    const bool good = read_file(c, path, f, d);
    fclose(f);
    if (!good)
        checkpoint_free(c);
    return good;
}

bool checkpoint_take(struct checkpoint *c, const char *path, const char *head, struct diag *d)
{
    size_t facts = 0;
    *c = (struct checkpoint){0};
    if (!read_first(c, path, head, SIZE_MAX, &facts, d))
        return false;
    c->head = new_text(head, c->head_bytes);
    return read_head(c, facts) || damaged(path, d);
}

unsigned char *checkpoint_section(const struct checkpoint *c, const char *path, size_t i, struct diag *d)
{
    const struct checkpoint_part *part = &c->section[i];
    const size_t bytes = part->bytes + CHECKPOINT_SEAL;
    FILE *f = fopen(path, "rb");
    if (!f) {
        diag_system(d, path, "cannot open");
        return NULL;
    }
    unsigned char *data = new_array(bytes + 1, 1);
    bool good = fseeko(f, (off_t)part->place, SEEK_SET) == 0;
    good = (good && (fread(data, 1, bytes, f) == bytes || !ferror(f))) || diag_system(d, path, "cannot read");
    good = good && (sealed(data, part->bytes) || damaged(path, d));
    fclose(f);
    data[part->bytes] = '\0';
    if (good)
        return data;
    free(data);
    return NULL;
}

void checkpoint_free(struct checkpoint *c)
{
    free(c->head);
    free(c->facts);
    free(c->section);
    *c = (struct checkpoint){0};
}

bool checkpoint_fact(const char *facts, const char *key, char *value, size_t n)
{
    const size_t length = strlen(key);
    for (const char *line = facts; *line; line += strcspn(line, "\n"), line += *line == '\n')
        if (strncmp(line, key, length) == 0 && line[length] == ' ') {
            const size_t size = strcspn(line + length + 1, "\n");
            if (size < n)
                snprintf(value, n, "%.*s", (int)size, line + length + 1);
            return size < n;
        }
    return false;
}
