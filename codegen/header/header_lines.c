/* Lines of C; see header_lines.h. */
#include "header_lines.h"

#include "../genome/text.h"
#include "../print/c_text.h"
#include "../print/templates.h"
#include "header_sizes.h"

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

char *lines_rows(const struct unit *u, const char *name)
{
    struct memory *m = memory_open();
    for (size_t k = 0; k <= segment_vectors(u->file->segment); k++)
        fprintf(m->stream, "%s%s[%zu]", k ? ", " : "", name, k);
    return memory_close(m);
}

char *lines_columns(const struct unit *u)
{
    struct memory *m = memory_open();
    for (size_t k = 0; k <= segment_vectors(u->file->segment); k++)
        fprintf(m->stream, "%s{x[%zu][i], x[%zu][i], x[%zu][i]}",
                k == 0  ? ""
                : k % 3 ? ", "
                        : ",\n            ",
                3 * k, 3 * k + 1, 3 * k + 2);
    return memory_close(m);
}

size_t lines_scaled_nodes(const struct unit *u, const struct function *f)
{
    return sizes_scalable(f, u->file->segment) ? strlen(u->file->segment->nodes) : 0;
}

/* Corners into the assumed order, and (u,v) found there back to the caller's. */
static void print_ordered_search(const struct unit *u, const struct function *f, const char *results,
                                 const char *indent, FILE *out)
{
    const bool shorter = u->file->order == CORNERS_NEAREST_SHORTER;
    fputs(indent, out);
    c_print("const int k = footpoint_detail_nearest_corner(x, xS)", u->options.precision, out);
    c_print(shorter ? ", mirror = footpoint_detail_mirrored(x, k);\n" : ";\n", u->options.precision, out);
    fputs(indent, out);
    c_print("REAL_BITS ", u->options.precision, out);
    fprintf(out, "flaw = footpoint_detail_%s(\n%s    x[k], ", f->name, indent);
    fputs(shorter ? "x[(k + (mirror ? 3 : 1)) & 3], x[(k + 2) & 3], x[(k + (mirror ? 1 : 3)) & 3], xS, &u, &v);\n"
                  : "x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, &u, &v);\n",
          out);
    fputs(indent, out);
    c_print("footpoint_detail_turn_back(k, ", u->options.precision, out);
    fprintf(out, "%s, %s);\n", shorter ? "mirror ? v : u, mirror ? u : v" : "u, v", results);
}

void lines_print_search(const struct unit *u, const struct function *f, const char *vectors, const char *results,
                        const char *indent, FILE *out)
{
    if (u->file->order != CORNERS_ANY) {
        print_ordered_search(u, f, results, indent, out);
        return;
    }
    const bool fits = strlen(f->name) + strlen(vectors) + 70 <= WIDTH;
    fputs(indent, out);
    c_print("REAL_BITS ", u->options.precision, out);
    fprintf(out, "flaw = footpoint_detail_%s(", f->name);
    if (!fits)
        fprintf(out, "\n%s    ", indent);
    fprintf(out, "%s, %s);\n", vectors, results);
}
