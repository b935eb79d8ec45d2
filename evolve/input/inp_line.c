/* Lines of Abaqus and CalculiX input files. A file is read whole and cut into lines in place. *INCLUDE pushes another
 * file on a stack, so that nesting needs no recursion. Rules common to both codes: a line that begins with ** is a
 * comment, with * a keyword line, which the next line continues if it ends with a comma; every other line contains data
 * in fields between commas. Case and blanks matter only in file names. A part's text is read again from its file for
 * each instance. */
#include "inp.h"

#include "../../codegen/base/text.h"

#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>

enum { MAX_INCLUDES = 10000, MAX_REAL = 63, MAX_NOTES = 20 };

struct inp_shown inp_show(struct inp_text t)
{
    struct inp_shown shown;
    snprintf(shown.s, sizeof shown.s, "%.*s%s", t.n > 40 ? 40 : (int)t.n, t.s, t.n > 40 ? "..." : "");
    for (char *c = shown.s; *c; c++)
        if (!isprint((unsigned char)*c))
            *c = '?';
    return shown;
}

bool inp_fail(const struct inp_lines *l, struct inp_place at, const char *format, ...)
{
    char what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    return diag_at(l->d, l->file[at.file].path, at.line, 0, "%s", what);
}

void inp_note(struct inp_lines *l, struct inp_place at, const char *format, ...)
{
    char what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    char *line = new_format("%s:%d: note: %s\n", l->file[at.file].path, at.line, what);
    if (l->noted < MAX_NOTES && !(l->notes && strstr(l->notes, line))) {
        char *all = new_format("%s%s", l->notes ? l->notes : "", line);
        free(l->notes);
        l->notes = all;
        l->noted++;
    }
    free(line);
}

/* Removes outer blanks, then one pair of quotes. */
static struct inp_text strip(struct inp_text t)
{
    while (t.n > 0 && isspace((unsigned char)t.s[0])) {
        t.s++;
        t.n--;
    }
    while (t.n > 0 && isspace((unsigned char)t.s[t.n - 1]))
        t.n--;
    if (t.n > 1 && t.s[0] == '"' && t.s[t.n - 1] == '"') {
        t.s++;
        t.n -= 2;
    }
    return t;
}

/* Cuts the text before the first `separator` outside quotes from *rest, with the separator. */
static struct inp_text cut(struct inp_text *rest, char separator)
{
    size_t n = 0;
    for (bool quoted = false; n < rest->n && (quoted || rest->s[n] != separator); n++)
        quoted ^= rest->s[n] == '"';
    const struct inp_text t = {rest->s, n};
    n += n < rest->n;
    rest->s += n;
    rest->n -= n;
    return t;
}

bool inp_equals(struct inp_text t, const char *word)
{
    for (size_t i = 0; i < t.n; i++)
        if (!isspace((unsigned char)t.s[i]) && toupper((unsigned char)t.s[i]) != toupper((unsigned char)*word++))
            return false;
    return *word == '\0';
}

bool inp_number(struct inp_text t, int *number)
{
    long value = 0;
    size_t i = t.n > 0 && t.s[0] == '+';
    if (i == t.n)
        return false;
    for (; i < t.n; i++) {
        if (!isdigit((unsigned char)t.s[i]))
            return false;
        value = 10 * value + (t.s[i] - '0');
        if (value > INT_MAX)
            return false;
    }
    *number = (int)value;
    return value > 0;
}

bool inp_real(struct inp_text t, double *x)
{
    char text[MAX_REAL + 1], *end;
    if (t.n == 0 || t.n > MAX_REAL)
        return false;
    for (size_t i = 0; i < t.n; i++) {
        const char c = t.s[i];
        if (c == 'x' || c == 'X' || c == '(' || isspace((unsigned char)c))
            return false;
        text[i] = c == 'd' || c == 'D' ? 'e' : c;
    }
    text[t.n] = '\0';
    *x = strtod(text, &end);
    return *end == '\0';
}

/* Returns the index of a file, which is added if it is new. */
static size_t file_index(struct inp_lines *l, const char *path, const struct stat *status)
{
    for (size_t f = 0; f < l->files; f++)
        if (l->file[f].device == status->st_dev && l->file[f].inode == status->st_ino)
            return f;
    APPEND(l->file, l->files, l->file_room) =
        (struct inp_file){new_text(path, strlen(path)), status->st_dev, status->st_ino};
    return l->files - 1;
}

/* Pushes a text on the stack. Returns false with the diagnostic filled if it is not text. */
static bool open_text(struct inp_lines *l, char *text, size_t size, size_t f)
{
    const char newline = !memchr(text, '\n', size) && memchr(text, '\r', size) ? '\r' : '\n';
    APPEND(l->open, l->depth, l->open_room) = (struct inp_open){text, text, text + size, newline, false, {(int)f, 0}};
    const char *nul = memchr(text, '\0', size);
    if (nul) {
        struct inp_place at = {(int)f, 1};
        for (const char *c = text; c < nul; c++)
            at.line += *c == newline;
        return inp_fail(l, at, "not a text file: it contains a NUL byte");
    }
    if (size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        l->open[l->depth - 1].at += 3;
    return true;
}

/* Opens a file on top of the stack; `name` is its name in the current line, or NULL for the model itself. */
static bool push(struct inp_lines *l, const char *path, const struct inp_text *name)
{
    struct stat status = {0};
    const bool found = stat(path, &status) == 0 && (!name || S_ISREG(status.st_mode));
    size_t size = 0;
    char *text = found || !name ? read_text(path, &size, l->d) : NULL;
    if (!text)
        return name ? inp_fail(l, l->place, "cannot read included file '%s'", inp_show(*name).s) : false;
    const size_t f = file_index(l, path, &status);
    for (size_t i = 0; i < l->depth; i++)
        if (l->open[i].place.file == (int)f) {
            free(text);
            return inp_fail(l, l->place, "file '%s' must not include itself, directly or through others",
                            inp_show(*name).s);
        }
    return open_text(l, text, size, f);
}

bool inp_open(struct inp_lines *l, const char *path, struct diag *d)
{
    *l = (struct inp_lines){.d = d};
    return push(l, path, NULL);
}

void inp_close(struct inp_lines *l)
{
    while (l->depth > 0)
        free(l->open[--l->depth].text);
    for (size_t i = 0; i < l->files; i++)
        free(l->file[i].path);
    free(l->file);
    free(l->open);
    free(l->parameter);
    free(l->notes);
}

/* Returns the path of a name in the folder of a file; the caller frees it. */
static char *beside(const char *file, struct inp_text name)
{
    const char *slash = strrchr(file, '/');
    const int folder = slash && name.s[0] != '/' ? (int)(slash - file) + 1 : 0;
    return new_format("%.*s%.*s", folder, file, (int)name.n, name.s);
}

bool inp_include(struct inp_lines *l, struct inp_text name)
{
    enum { MAX_NAME = 4096 };
    if (name.n == 0)
        return inp_fail(l, l->place, "included file has no name");
    if (name.n > MAX_NAME)
        return inp_fail(l, l->place, "cannot read included file '%s'", inp_show(name).s);
    if (l->includes++ == MAX_INCLUDES)
        return inp_fail(l, l->place, "at most %d files may be included", MAX_INCLUDES);
    char *path = beside(l->file[0].path, name);
    if (access(path, F_OK) != 0) {
        free(path);
        path = beside(l->file[l->place.file].path, name);
    }
    const bool done = push(l, path, &name);
    free(path);
    return done;
}

struct inp_mark inp_here(const struct inp_lines *l)
{
    const struct inp_open *f = &l->open[l->depth - 1];
    return (struct inp_mark){f->place, (size_t)(f->at - f->text)};
}

bool inp_go_to(struct inp_lines *l, struct inp_mark mark)
{
    size_t size = 0;
    if (l->includes++ == MAX_INCLUDES)
        return inp_fail(l, l->place, "at most %d files may be included and instances made", MAX_INCLUDES);
    char *text = read_text(l->file[mark.place.file].path, &size, l->d);
    if (!text || !open_text(l, text, size, (size_t)mark.place.file))
        return false;
    struct inp_open *f = &l->open[l->depth - 1];
    f->at = mark.offset < size ? text + mark.offset : f->end;
    f->place = mark.place;
    f->again = true;
    return true;
}

void inp_go_back(struct inp_lines *l)
{
    free(l->open[--l->depth].text);
}

/* Reads the next line of a file that is neither blank nor a comment, without outer blanks. Returns false at the end. */
static bool take_line(struct inp_open *f, struct inp_text *line)
{
    while (f->at < f->end) {
        const char *start = f->at, *newline = memchr(start, f->newline, (size_t)(f->end - start));
        const char *stop = newline ? newline : f->end;
        f->at = newline ? newline + 1 : f->end;
        f->place.line++;
        while (start < stop && isspace((unsigned char)*start))
            start++;
        while (start < stop && isspace((unsigned char)stop[-1]))
            stop--;
        *line = (struct inp_text){start, (size_t)(stop - start)};
        if (line->n > 0 && !(line->n > 1 && start[0] == '*' && start[1] == '*'))
            return true;
    }
    return false;
}

static bool ends_with_comma(struct inp_text line)
{
    return line.n > 0 && line.s[line.n - 1] == ',';
}

/* Splits a keyword line and its continuations into keyword and parameters. */
static void split_keyword(struct inp_lines *l, struct inp_open *f, struct inp_text line)
{
    struct inp_text rest = line, word = cut(&rest, ',');
    size_t n = 0;
    for (size_t i = 1; i < word.n && n < sizeof l->keyword - 1; i++)
        if (!isspace((unsigned char)word.s[i]))
            l->keyword[n++] = (char)toupper((unsigned char)word.s[i]);
    l->keyword[n] = '\0';
    l->parameters = 0;
    for (;;) {
        while (rest.n > 0) {
            struct inp_parameter p = {.value = cut(&rest, ',')};
            p.key = strip(cut(&p.value, '='));
            p.value = strip(p.value);
            APPEND(l->parameter, l->parameters, l->parameter_room) = p;
        }
        const struct inp_open before = *f;
        const bool continued = ends_with_comma(line) && take_line(f, &line);
        if (!continued || line.s[0] == '*') {
            *f = before;
            return;
        }
        rest = line;
    }
}

bool inp_next(struct inp_lines *l)
{
    while (l->depth > 0) {
        struct inp_open *f = &l->open[l->depth - 1];
        struct inp_text line;
        if (!take_line(f, &line)) {
            if (f->again)
                return inp_fail(l, l->place, "the part changed while it was read");
            inp_go_back(l);
            continue;
        }
        l->place = f->place;
        if (line.s[0] != '*') {
            l->kind = INP_DATA;
            l->rest = line;
            l->continues = ends_with_comma(line);
            return true;
        }
        split_keyword(l, f, line);
        l->kind = INP_KEYWORD;
        if (strcmp(l->keyword, "INCLUDE") != 0)
            return true;
        struct inp_text name;
        if (!inp_parameter(l, "INPUT", &name))
            return inp_fail(l, l->place, "*INCLUDE needs INPUT=");
        if (!inp_include(l, name))
            return false;
    }
    l->kind = INP_END;
    return true;
}

bool inp_parameter(const struct inp_lines *l, const char *key, struct inp_text *value)
{
    for (size_t i = 0; i < l->parameters; i++)
        if (inp_equals(l->parameter[i].key, key)) {
            *value = l->parameter[i].value;
            return true;
        }
    return false;
}

bool inp_field(struct inp_lines *l, struct inp_text *field)
{
    if (l->rest.n == 0)
        return false;
    *field = strip(cut(&l->rest, ','));
    return true;
}
