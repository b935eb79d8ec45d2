/* Text of the search: nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, segments of any size, with a status;
 *   NAME_n:   NAME_at for many pairs, from columns of coordinates;
 * and of faces that have it NAME_closest, see header_closest.h. */
#include "header_segment.h"

#include "../genome/text.h"
#include "c_text.h"
#include "header_closest.h"
#include "header_float.h"
#include "header_lines.h"
#include "header_sizes.h"
#include "templates.h"

#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* The search and NAME_at, which calls it: xi and eta, and whether the denominators are what NAME asks of them. */
static void print_at(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    char *head = new_format("footpoint_detail_%s", f->name), *flaw = c_flaw(u, f, search_hides_poles(f));
    c_print("FOOTPOINT_PART REAL_BITS\n", u->options.precision, out);
    lines_print_head(u, head, "REAL *xi,REAL *eta", out);
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
    lines_print_head(u, head, "REAL *xi,REAL *eta", out);
    fprintf(out, "{\n    (void)footpoint_detail_%s(%s, xi, eta);\n}\n", f->name, vectors);
    free(head);
}

static void print_checked(const struct unit *u, const struct function *f, const char *vectors, FILE *out)
{
    const enum precision precision = u->options.precision;
    const size_t n = segment_vectors(u->file->segment) + 1;
    const char *real = lines_real(u), *any = u->file->order == CORNERS_ANY ? "" : ", u, v";
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    fputc('\n', out);
    lines_print_head(u, head, "REAL loc[2],REAL *gap", out);
    fprintf(out, "{\n    %s y[%zu][3], xi, eta, g%s;\n", real, n, any);
    fputs("    int exponent = 0, turn = 0, status;\n    for (;;) {\n", out);
    fprintf(out, "        const %s *const x[%zu] = {%s};\n", real, n, vectors);
    lines_print_search(u, f, vectors, "        ", out);
    char *least = sizes_least_name(u), *gap = new_format("footpoint_detail_%s_gap", u->file->segment->name);
    fputs("        flaw |= ", out);
    c_print(gap, precision, out);
    fprintf(out, "(x, xi, eta, %s, &g);\n", least);
    free(gap);
    free(least);
    c_print("        if (!(flaw >> REAL_TOP))\n"
            "            return footpoint_detail_answer(xi, eta, g, exponent, loc, gap);\n",
            precision, out);
    lines_print_again(u, f, out);
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
    lines_print_head(u, head, "REAL loc[2],REAL *gap", out);
    single_print_sure(f, vectors, out);
    free(worst);
    free(head);
}

/* The loop over columns.  FOOTPOINT_LOOP inlines what it calls, without which it would not vectorise. */
static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    const char *real = lines_real(u);
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
    char *vectors = lines_vectors(u);
    const struct placeholder own[] = {{"VECTORS", vectors}, {NULL, NULL}};
    templates_print(NULL, (const char *const[]){"contract", NULL}, u->options.precision, own, out);
    if (closest_exists(u))
        closest_print_contract(u, out);
    free(vectors);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    char *vectors = lines_vectors(u);
    print_at(u, f, vectors, out);
    print_checked(u, f, vectors, out);
    if (single_checks(u) && isfinite(f->measured->worst))
        print_sure(u, f, vectors, out);
    print_loop(u, f, out);
    if (closest_exists(u))
        closest_print(u, f, vectors, out);
    free(vectors);
}
