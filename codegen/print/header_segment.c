/* Text of the search: nodes as a mesh has them to xi, eta and the gap.  For a genome NAME of a segment,
 *   NAME_at:  xi and eta by straight-line code, corners in the order that the scene assumes, nothing checked;
 *   NAME:     xi, eta and the signed gap (9), corners in any order, segments of any size, with a status;
 *   NAME_n:   NAME_at for many pairs, from columns of coordinates. */
#include "header_segment.h"

#include "../genome/text.h"
#include "c_text.h"
#include "header_float.h"
#include "header_helpers.h"

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

/* Vectors and what comes last, four parameters a line. */
static void print_arguments(const struct segment_kind *k, const char *function, const char *last,
                            enum precision precision, FILE *out)
{
    const int column = fprintf(out, "%s(", function);
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        c_print("const @R @N[3],", precision, name, out);
        if (i % 4 == 3)
            fprintf(out, "\n%*s", column, "");
        else
            fputc(' ', out);
    }
    c_print(last, precision, "", out);
    fputs(")\n", out);
}

/* "xA, xB, ..., xS" */
static void print_vectors(const struct segment_kind *k, FILE *out)
{
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "%s%s", i ? ", " : "", name);
    }
}

/* "BEFOREFUNCTION(xA, ..., xS, LAST);" */
static void print_call(const struct unit *u, const char *before, const char *function, const char *last, FILE *out)
{
    fprintf(out, "%s%s(", before, function);
    print_vectors(u->file->segment, out);
    fprintf(out, ", %s);\n", last);
}

/* NAME_at, and what it is made of: xi and eta, and whether the denominators are what NAME asks of them. */
static void print_at(const struct unit *u, const struct function *f, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct operations *ops = &f->code.ops;
    char *head = new_format("footpoint_detail_%s", f->name);
    c_print("\n/* xi and eta of @N_at; the highest bit is set where a denominator is too near 0 or too large. */\n"
            "FOOTPOINT_PART @I\n",
            precision, f->name, out);
    print_arguments(u->file->segment, head, "@R *xi, @R *eta", precision, out);
    free(head);
    fputs("{\n", out);
    single_print_inputs(u, f, out);
    c_print_statements(u, f, out);
    c_print_unused(u, f, out);
    c_print_flaw(u, f, search_hides_poles(f), out);
    fputs("    return flaw;\n}\n", out);
    fprintf(out, "\n/* %ld mul, %ld div, %ld add, %ld sqrt.  xi, eta dimensionless; nothing checked. */\n", ops->mul,
            ops->div, ops->add, ops->sqrt);
    head = new_format("FOOTPOINT_FN void %s_at", f->name);
    print_arguments(u->file->segment, head, "@R *xi, @R *eta", precision, out);
    free(head);
    fputs("{\n", out);
    print_call(u, "    (void)footpoint_detail_", f->name, "xi, eta", out);
    fputs("}\n", out);
}

/* Corners into the assumed order, and (u,v) found there back to the caller's.  `call` begins the call. */
static void print_ordered_call(const struct unit *u, const char *call, FILE *out)
{
    static const char nearest[] = "        k = @Dnearest_corner(x, xS);\n";
    static const char shorter[] =
        "        mirror = @Dsquare_distance(x[k], x[(k + 3) & 3]) >\n"
        "                 @Dsquare_distance(x[k], x[(k + 1) & 3]);\n"
        "        @N(x[k], x[(k + (mirror ? 3 : 1)) & 3], x[(k + 2) & 3], x[(k + (mirror ? 1 : 3)) & 3], xS, &u, &v);\n"
        "        w = mirror ? v : u;\n"
        "        v = mirror ? u : v;\n"
        "        u = w;\n";
    static const char back[] = "        xi = k == 0 ? u : k == 1 ? -v : k == 2 ? -u : v;\n"
                               "        eta = k == 0 ? v : k == 1 ? u : k == 2 ? -v : -u;\n";
    const enum corner_order order = u->file->order;
    const enum precision precision = u->options.precision;
    if (order == CORNERS_ANY) {
        print_call(u, "        ", call, "&xi, &eta", out);
        return;
    }
    c_print(nearest, precision, "", out);
    c_print(order == CORNERS_NEAREST ? "        @N(x[k], x[(k + 1) & 3], x[(k + 2) & 3], x[(k + 3) & 3], xS, &u, &v);\n"
                                     : shorter,
            precision, call, out);
    fputs(back, out);
}

/* The vectors as an array. */
static void print_vector_array(const struct unit *u, FILE *out)
{
    char *head = new_format("        const @R *const x[%zu] = {", segment_vectors(u->file->segment) + 1);
    c_print(head, u->options.precision, "", out);
    print_vectors(u->file->segment, out);
    fputs("};\n", out);
    free(head);
}

/* What is wrong with the nodes, or the same search once more with a segment that is about 1 long. */
static void print_again(const struct unit *u, bool scalable, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    const size_t vectors = segment_vectors(k) + 1;
    char *text = scalable ? new_format("        status = turn++ ? FOOTPOINT_ERR_DEGENERATE : @Dscale(x, %zu, %zu, y, "
                                       "&exponent);\n        if (status != FOOTPOINT_OK)\n            return status;\n",
                                       strlen(k->nodes), vectors)
                          : new_format("        return @Dfinite(x, %zu) ? FOOTPOINT_ERR_DEGENERATE : "
                                       "FOOTPOINT_ERR_NOT_FINITE;\n",
                                       vectors);
    c_print(text, u->options.precision, "", out);
    free(text);
    for (size_t i = 0; i < vectors && scalable; i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "        %s = y[%zu];\n", name, i);
    }
}

static void print_checked(const struct unit *u, const struct function *f, FILE *out)
{
    const enum precision precision = u->options.precision;
    const enum corner_order order = u->file->order;
    const struct segment_kind *k = u->file->segment;
    const bool scalable = helpers_scalable(f, k);
    char *head = new_format("FOOTPOINT_FN int %s", f->name);
    char *call = new_format("flaw = footpoint_detail_%s", f->name), *least = helpers_least_name(u);
    fputs("\n/* loc = {xi, eta}, gap along the unit normal at the foot point (mesh length, > 0 open); both untouched "
          "on error.\n * Returns FOOTPOINT_OK, FOOTPOINT_ERR_NOT_FINITE or FOOTPOINT_ERR_DEGENERATE: no normal there, "
          "or no number. */\n",
          out);
    print_arguments(k, head, "@R loc[2], @R *gap", precision, out);
    c_print(order == CORNERS_ANY       ? "{\n    @R xi, eta, g"
            : order == CORNERS_NEAREST ? "{\n    @R xi, eta, g, u, v"
                                       : "{\n    @R xi, eta, g, u, v, w",
            precision, "", out);
    if (scalable)
        fprintf(out, ", y[%zu][3]", segment_vectors(k) + 1);
    fputs(scalable ? ";\n    int exponent = 0, turn = 0, status" : "", out);
    fputs(order == CORNERS_ANY ? "" : scalable ? ", k" : ";\n    int k", out);
    fputs(order == CORNERS_ANY || order == CORNERS_NEAREST ? ";\n" : ", mirror;\n", out);
    fputs("    for (;;) {\n", out);
    print_vector_array(u, out);
    c_print("        @I flaw;\n", precision, "", out);
    print_ordered_call(u, call, out);
    c_print(k->surface ? "        flaw |= @D@N_gap(x, xi, eta, "
                       : "        flaw |= @Dgap(xA, xB, xC, xD, xS, xi, eta, ",
            precision, k->name, out);
    c_print("@N, &g);\n        if (!(flaw >> @B))\n            break;\n", precision, least, out);
    print_again(u, scalable, out);
    fputs("    }\n    loc[0] = xi;\n    loc[1] = eta;\n", out);
    c_print(scalable ? "    *gap = turn ? ldexp@F(g, exponent) : g;\n" : "    *gap = g;\n", precision, "", out);
    fputs("    return FOOTPOINT_OK;\n}\n", out);
    free(least);
    free(call);
    free(head);
}

/* NAME_sure: NAME, and whether its answer is as good as the banner says. */
static void print_sure(const struct unit *u, const struct function *f, FILE *out)
{
    struct memory *m = memory_open();
    print_vectors(u->file->segment, m->stream);
    char *vectors = memory_close(m), *head = new_format("FOOTPOINT_FN int %s_sure", f->name);
    char *worst = single_worst_name(f);
    fprintf(out,
            "\n/* Largest error of xi and eta on the samples held out. */\n#define %s %.3ef\n\n"
            "/* As %s, but FOOTPOINT_ERR_DOMAIN unless it is sure that a foot point is as near to the answer as\n"
            " * that, and that no point of the segment is nearer to S. */\n",
            worst, f->measured->worst, f->name);
    print_arguments(u->file->segment, head, "@R loc[2], @R *gap", u->options.precision, out);
    single_print_sure(f, vectors, out);
    free(worst);
    free(vectors);
    free(head);
}

/* One vector of pair i from its columns, two declarations a line: "xA[3] = {x[0][i], x[1][i], x[2][i]}". */
static void print_gathered(const struct unit *u, FILE *out)
{
    const size_t vectors = segment_vectors(u->file->segment) + 1;
    for (size_t k = 0; k < vectors; k++) {
        char name[4];
        segment_vector_name(u->file->segment, k, name);
        if (k % 2 == 0)
            c_print("        const @R ", u->options.precision, "", out);
        fprintf(out, "%s[3] = {x[%zu][i], x[%zu][i], x[%zu][i]}%s", name, 3 * k, 3 * k + 1, 3 * k + 2,
                k % 2 == 0 && k + 1 < vectors ? ", " : ";\n");
    }
}

/* The loop over columns.  FOOTPOINT_LOOP inlines what it calls, without which it would not vectorise. */
static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *kind = u->file->segment;
    const enum precision precision = u->options.precision;
    c_print("\n/* @N_at for n pairs.\n * x[3 k + i] is the column of coordinate i of ", precision, f->name, out);
    fputs(*kind->normals ? "vector k (" : "node k (", out);
    for (size_t k = 0; k <= segment_vectors(kind); k++) {
        char name[4];
        segment_vector_name(kind, k, name);
        fprintf(out, "%s%s", k ? ", " : "", *kind->normals ? name : name + 1);
    }
    fputs("); xi and eta overlap nothing else.\n *", out);
    c_print_loop_note(f, out);
    char *loop = new_format(" */\nFOOTPOINT_LOOP void @N_n(size_t n, const @R *const x[%zu],\n"
                            "    @R *FOOTPOINT_RESTRICT xi, @R *FOOTPOINT_RESTRICT eta)\n"
                            "{\n    size_t i;\n    for (i = 0; i < n; i++) {\n",
                            segment_inputs(kind));
    c_print(loop, precision, f->name, out);
    free(loop);
    print_gathered(u, out);
    char *at = new_format("%s_at", f->name);
    print_call(u, "        ", at, "&xi[i], &eta[i]", out);
    free(at);
    fputs("    }\n}\n", out);
}

void search_print(const struct unit *u, const struct function *f, FILE *out)
{
    print_at(u, f, out);
    print_checked(u, f, out);
    if (single_checks(u) && isfinite(f->measured->worst))
        print_sure(u, f, out);
    print_loop(u, f, out);
}
