/* Lines of C; see header_lines.h. */
#include "header_lines.h"

#include "../../base/text.h"
#include "../c_text.h"
#include "../header_sizes.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 118 };

const char *lines_real(const struct unit *u)
{
    return u->options.precision == PRECISION_FLOAT ? "float" : "double";
}

void lines_print_head(const struct unit *u, const char *function, const char *last, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    struct memory *m = memory_open();
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(m->stream, "const %s %s[3],", lines_real(u), name);
    }
    c_print(last, u->options.precision, m->stream);
    fputs(")", m->stream);
    char *parameters = memory_close(m);
    const int begin = fprintf(out, "%s(", function);
    size_t column = (size_t)begin;
    for (const char *p = parameters; *p;) {
        const size_t n = p[strcspn(p, ",")] ? strcspn(p, ",") + 1 : strlen(p);
        if (column + 1 + n > WIDTH) {
            fprintf(out, "\n%*s", begin, "");
            column = (size_t)begin;
        } else if (p > parameters)
            column += fputc(' ', out) == ' ';
        fwrite(p, 1, n, out);
        column += n;
        p += n;
    }
    fputc('\n', out);
    free(parameters);
}

char *lines_vectors(const struct unit *u)
{
    const struct segment_kind *k = u->file->segment;
    struct memory *m = memory_open();
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(m->stream, "%s%s", i ? ", " : "", name);
    }
    return memory_close(m);
}

static char *rows_text(const char *name, size_t count)
{
    struct memory *m = memory_open();
    for (size_t k = 0; k < count; k++)
        fprintf(m->stream, "%s%s[%zu]", k ? ", " : "", name, k);
    return memory_close(m);
}

char *lines_rows(const struct unit *u, const char *name)
{
    return rows_text(name, segment_vectors(u->file->segment) + 1);
}

static char *columns_text(size_t vectors)
{
    struct memory *m = memory_open();
    for (size_t k = 0; k < vectors; k++)
        fprintf(m->stream, "%s{x[%zu][i], x[%zu][i], x[%zu][i]}",
                k == 0  ? ""
                : k % 3 ? ", "
                        : ",\n            ",
                3 * k, 3 * k + 1, 3 * k + 2);
    return memory_close(m);
}

static char *parameters_text(const struct unit *u)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i <= segment_vectors(u->file->segment); i++) {
        char name[4];
        segment_vector_name(u->file->segment, i, name);
        fprintf(m->stream, "%sconst %s %s[3]", i ? ", " : "", lines_real(u), name);
    }
    return memory_close(m);
}

bool lines_straight(const struct unit *u)
{
    const struct segment_kind *k = u->file->segment;
    return k->bilinear || strcmp(k->name, "tri3") == 0;
}

/* Returns "reach * reach" for power 2, and so on. */
static char *power_text(const char *base, int power)
{
    char *text = new_format("%s", base);
    for (int i = 1; i < power; i++) {
        char *longer = new_format("%s * %s", text, base);
        free(text);
        text = longer;
    }
    return text;
}

void words_add(struct words *w, const char *word, char *text)
{
    APPEND(w->word, w->n, w->room) = (struct placeholder){word, text};
    APPEND(w->word, w->n, w->room) = (struct placeholder){NULL, NULL};
    w->n--;
}

void words_add_net(struct words *w, const char *net, const char *type, const char *room, const char *turns,
                   const char *access)
{
    words_add(w, "NET", new_format("%s", net));
    words_add(w, "TRIPLE", new_format("%s", type));
    words_add(w, "ROOM", new_format("%s", room));
    words_add(w, "THREE", new_format("%s", turns));
    words_add(w, "OF", new_format("%s%s", access ? access : "", access ? "of" : ""));
    words_add(w, "ABSOLUTE",
              new_format(access                       ? "footpoint_detail_absolute"
                         : strcmp(type, "float") == 0 ? "fabsf"
                                                      : "fabs"));
    words_add(w, "INTO", new_format("%s%s", access ? access : "", access ? "into" : ""));
}

void words_set(struct words *w, const char *word, char *text)
{
    for (size_t i = 0; i < w->n; i++)
        if (strcmp(w->word[i].word, word) == 0) {
            free((char *)(uintptr_t)w->word[i].text);
            w->word[i].text = text;
        }
}

void words_clear(struct words *w)
{
    for (size_t i = 0; i < w->n; i++)
        free((char *)(uintptr_t)w->word[i].text);
    free(w->word);
}

struct words lines_words(const struct unit *u, const struct function *f, const struct function *search)
{
    const struct segment_kind *k = u->file->segment;
    const size_t n = segment_vectors(k) + 1, scaled = search ? lines_scaled_nodes(u, search) : 0;
    struct words w = {NULL, 0, 0};
    words_add(&w, "KIND", new_format("%s", k->name));
    words_add(&w, "PREFIX", new_format("%s", u->options.prefix));
    words_add(&w, "SHAPE", new_format("%s", k->triangle ? "triangle" : "square"));
    words_add(&w, "EDGES",
              new_format("%s", k->triangle ? "1 to 3 edge AB, BC, CA, 4 to 6 corner A, B, C"
                                           : "1 to 4 edge AB, BC, CD, DA, 5 to 8 corner A, B, C, D"));
    words_add(&w, "REACH_TO_GROWTH", power_text("reach", k->growth));
    words_add(&w, "VECTORS", new_format("%zu", n));
    words_add(&w, "SEGMENT_VECTORS", new_format("%zu", n - 1));
    words_add(&w, "NODES", new_format("%zu", strlen(k->nodes)));
    words_add(&w, "CORNERS", new_format("%zu", k->corners));
    words_add(&w, "COORDINATES", new_format("%zu", 3 * n));
    words_add(&w, "NODE_PARAMETERS", parameters_text(u));
    words_add(&w, "NODE_NAMES", lines_vectors(u));
    words_add(&w, "COLUMNS", columns_text(n));
    words_add(&w, "ROWS", rows_text("p", n));
    words_add(&w, "SEGMENT_ROWS", rows_text("c", n - 1));
    words_add(&w, "VECTOR_ROWS", rows_text("x", n));
    words_add(&w, "LEAST_SIZE", sizes_least_name(u));
    words_add(&w, "NAME", new_format("%s", f ? f->name : "NAME"));
    words_add(&w, "SCALED_NODES", new_format("%zu", scaled));
    words_add(&w, "SCALABLE", new_format("%d", scaled > 0));
    return w;
}

void lines_print_kind(const struct unit *u, const char *kind, const char *guard, const char *const *names, FILE *out)
{
    char *whole = guard ? new_format("FOOTPOINT_%s_%s", kind, guard) : NULL;
    struct words w = lines_words(u, NULL, NULL);
    words_set(&w, "KIND", new_format("%s", kind));
    templates_print(whole, names, u->options.precision, w.word, out);
    words_clear(&w);
    free(whole);
}

void lines_print_templates(const struct unit *u, const char *guard, const char *const *names, FILE *out)
{
    lines_print_kind(u, u->file->segment->name, guard, names, out);
}

size_t lines_scaled_nodes(const struct unit *u, const struct function *f)
{
    return sizes_scalable(f, u->file->segment) ? strlen(u->file->segment->nodes) : 0;
}
