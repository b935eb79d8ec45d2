/* Text of the search: nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, segments of any size, with a status;
 *   NAME_n:   NAME_at for many pairs, from columns of coordinates. */
#include "header_segment.h"

#include "../genome/text.h"
#include "c_text.h"
#include "header_float.h"
#include "header_helpers.h"
#include "templates.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { WIDTH = 118 };

/* Marks the operations whose NaN or infinity makes xi or eta so. */
static bool *mark_carriers(const struct program *p)
{
    bool *carries = new_array(p->ops, sizeof *carries);
    for (size_t i = 0; i < p->outputs; i++)
        carries[p->output[i]] = true;
    for (size_t i = p->ops; i-- > 0;) {
        const struct op *o = &p->op[i];
        if (!carries[i] || o->a < 0 || o->kind == OP_MIN || o->kind == OP_MAX || o->kind == OP_PDIV)
            continue;
        carries[o->a] = true;
        if (o->b >= 0 && o->kind != OP_DIV)
            carries[o->b] = true;
    }
    return carries;
}

bool search_hides_poles(const struct function *f)
{
    const struct program *p = f->program;
    bool *carries = mark_carriers(p), hides = false;
    for (size_t k = 0; k < f->evidence->denominators; k++) {
        const struct denominator *d = &f->evidence->denominator[k];
        bool seen = d->verdict == POLE_FREE;
        for (size_t i = 0; i < p->ops && !seen; i++)
            seen = carries[i] && p->op[i].kind == OP_DIV && p->op[i].b == d->op;
        hides = hides || !seen;
    }
    free(carries);
    return hides;
}

static const char *real_name(const struct unit *u)
{
    return u->options.precision == PRECISION_FLOAT ? "float" : "double";
}

/* "FUNCTION(const double xA[3], ..., const double xS[3], LAST)". */
static void print_head(const struct unit *u, const char *function, const char *last, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    struct memory *m = memory_open();
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(m->stream, "const %s %s[3],", real_name(u), name);
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

/* "xA, xB, ..., xS"; caller frees. */
static char *vector_names(const struct unit *u)
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

/* The search and NAME_at, which calls it: xi and eta, and whether the denominators are what NAME asks of them. */
static void print_at(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("footpoint_detail_%s", f->name), *flaw = c_flaw(u, f, search_hides_poles(f));
    c_print("FOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    print_head(u, head, "REAL *xi,REAL *eta", out);
    fputs("{\n", out);
    single_print_inputs(u, f, out);
    c_print_statements(u, f, out);
    c_print_unused(u, f, out);
    char *last = new_format("    return %s;", flaw);
    c_print_broken(last, out);
    fputs("}\n\n", out);
    free(last);
    free(flaw);
    free(head);
    head = new_format("FOOTPOINT_FN void %s_at", f->name);
    print_head(u, head, "REAL *xi,REAL *eta", out);
    fprintf(out, "{\n    (void)footpoint_detail_%s(%s, xi, eta);\n}\n", f->name, vectors);
    free(head);
}

/* Corners into the assumed order, and (u,v) found there back to the caller's. */
static void print_ordered_search(const struct unit *u, const struct function *f, FILE *out)
{
    const bool shorter = u->file->order == CORNERS_NEAREST_SHORTER;
    c_print("        const int k = footpoint_detail_nearest_corner(x, xS)", u->options.precision, out);
    c_print(shorter ? ", mirror = footpoint_detail_mirrored(x, k);\n" : ";\n", u->options.precision, out);
    c_print("        REAL_BITS ", u->options.precision, out);
    fprintf(out, "flaw = footpoint_detail_%s(\n            x[k], ", f->name);
    fputs(shorter ? "x[(k + (mirror ? 3 : 1)) & 3], x[(k + 2) & 3], x[(k + (mirror ? 1 : 3)) & 3], xS, &u, &v);\n"
                  : "x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, &u, &v);\n",
          out);
    c_print("        footpoint_detail_turn_back(k, ", u->options.precision, out);
    fputs(shorter ? "mirror ? v : u, mirror ? u : v, &xi, &eta);\n" : "u, v, &xi, &eta);\n", out);
}

static void print_search(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *gap = new_format("        flaw |= footpoint_detail_%s_gap(x, xi, eta, ", u->file->segment->name);
    char *least = helpers_least_name(u);
    if (u->file->order == CORNERS_ANY) {
        const bool fits = strlen(f->name) + strlen(vectors) + 70 <= WIDTH;
        c_print("        REAL_BITS ", u->options.precision, out);
        fprintf(out, "flaw = footpoint_detail_%s(%s%s, &xi, &eta);\n", f->name, fits ? "" : "\n            ", vectors);
    } else
        print_ordered_search(u, f, out);
    c_print(gap, u->options.precision, out);
    fprintf(out, "%s, &g);\n", least);
    free(least);
    free(gap);
}

/* The same search once more with a segment that is about 1 long; or what is wrong with the nodes, which is so at once of
 * a search that depends on the unit of length: without nodes there is no length. */
static void print_again(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    char *text =
        new_format("        status = turn++ ? FOOTPOINT_ERR_DEGENERATE : footpoint_detail_scale(x, %zu, %zu, y, "
                   "&exponent);\n",
                   helpers_scalable(f, k) ? strlen(k->nodes) : 0, segment_vectors(k) + 1);
    c_print(text, u->options.precision, out);
    fputs("        if (status != FOOTPOINT_OK)\n            return status;\n        ", out);
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "%s%s = y[%zu]", i ? ", " : "", name, i);
    }
    fputs(";\n", out);
    free(text);
}

static void print_checked(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    const enum precision precision = u->options.precision;
    const size_t n = segment_vectors(u->file->segment) + 1;
    const char *real = real_name(u), *any = u->file->order == CORNERS_ANY ? "" : ", u, v";
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    fputc('\n', out);
    print_head(u, head, "REAL loc[2],REAL *gap", out);
    fprintf(out, "{\n    %s y[%zu][3], xi, eta, g%s;\n", real, n, any);
    fputs("    int exponent = 0, turn = 0, status;\n    for (;;) {\n", out);
    fprintf(out, "        const %s *const x[%zu] = {%s};\n", real, n, vectors);
    print_search(u, f, vectors, out);
    c_print("        if (!(flaw >> REAL_TOP))\n"
            "            return footpoint_detail_answer(xi, eta, g, exponent, loc, gap);\n",
            precision, out);
    print_again(u, f, out);
    fputs("    }\n}\n", out);
    free(head);
}

/* NAME_sure: NAME, and whether its answer is as good as the banner says. */
static void print_sure(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("FOOTPOINT_FN int %s_sure", f->name), *worst = single_worst_name(f);
    fprintf(
        out,
        "\n/* As %s, but FOOTPOINT_ERR_DOMAIN unless it is sure that a foot point is as near to the answer as the\n"
        " * largest error of xi and eta on the samples held out, and that no point of the segment is nearer to S. */\n"
        "#define %s %.3ef\n",
        f->name, worst, f->measured->worst);
    print_head(u, head, "REAL loc[2],REAL *gap", out);
    single_print_sure(f, vectors, out);
    free(worst);
    free(head);
}

/* The loop over columns.  FOOTPOINT_LOOP inlines what it calls, without which it would not vectorise. */
static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    const char *real = real_name(u);
    const size_t vectors = segment_vectors(u->file->segment) + 1;
    fputc('\n', out);
    const int column = fprintf(out, "FOOTPOINT_LOOP void %s_n(", f->name);
    fprintf(out, "size_t n, const %s *const x[%zu],\n%*s%s *FOOTPOINT_RESTRICT xi, %s *FOOTPOINT_RESTRICT eta)\n", real,
            3 * vectors, column, "", real, real);
    fprintf(out, "{\n    size_t i;\n    for (i = 0; i < n; i++) {\n        const %s p[%zu][3] = {", real, vectors);
    for (size_t k = 0; k < vectors; k++)
        fprintf(out, "%s{x[%zu][i], x[%zu][i], x[%zu][i]}",
                k == 0  ? ""
                : k % 3 ? ", "
                        : ",\n            ",
                3 * k, 3 * k + 1, 3 * k + 2);
    fprintf(out, "};\n        %s_at(", f->name);
    for (size_t k = 0; k < vectors; k++)
        fprintf(out, "p[%zu], ", k);
    fputs("&xi[i], &eta[i]);\n    }\n}\n", out);
}

void search_print_contract(const struct unit *u, FILE *out)
{
    char *vectors = vector_names(u);
    const struct placeholder own[] = {{"VECTORS", vectors}, {NULL, NULL}};
    templates_print(NULL, (const char *const[]){"contract", NULL}, u->options.precision, own, out);
    free(vectors);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    char *vectors = vector_names(u);
    print_at(u, f, vectors, out);
    print_checked(u, f, vectors, out);
    if (single_checks(u) && isfinite(f->measured->worst))
        print_sure(u, f, vectors, out);
    print_loop(u, f, out);
    free(vectors);
}
