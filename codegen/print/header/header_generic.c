/* Templates of C++; see header_generic.h. Their text is the text of C in double, with T for double and T(0.5) for
 * 0.5. */
#include "header_generic.h"

#include "../../base/text.h"
#include "../../program/dialects.h"
#include "../banner_line.h"
#include "../c_text.h"
#include "header_closest.h"
#include "header_lines.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 117 };

static const char *const beginning =
    "\n#ifndef FOOTPOINT_HD /* before functions: what compilers for devices want */\n"
    "#ifdef __CUDACC__\n"
    "#define FOOTPOINT_HD __host__ __device__\n"
    "#elif defined(__HIP__) || defined(__HIPCC__) /* clang, before or without HIP's own words */\n"
    "#define FOOTPOINT_HD __attribute__((host, device))\n"
    "#else\n"
    "#define FOOTPOINT_HD\n"
    "#endif\n"
    "#endif\n"
    "#if !defined(__CUDACC_RTC__) && !defined(__HIPCC_RTC__)\n"
    "#include <cmath>\n"
    "#endif\n"
    "\n#ifndef FOOTPOINT_GENERIC\n"
    "#define FOOTPOINT_GENERIC\n"
    "/* T must have T(double), + - * / += -=, the unary -, comparisons, and sqrt and fabs in its namespace. */\n"
    "template <class T> FOOTPOINT_HD inline T footpoint_generic_sqrt(const T &x)\n"
    "{\n"
    "    using std::sqrt;\n"
    "    return sqrt(x);\n"
    "}\n"
    "template <class T> FOOTPOINT_HD inline T footpoint_generic_fabs(const T &x)\n"
    "{\n"
    "    using std::fabs;\n"
    "    return fabs(x);\n"
    "}\n"
    "#endif\n";

/* ---- words ---- */

/* Returns "const T xA[3], ..., const T xS[3]". */
static char *parameters_text(const struct unit *u, const char *type)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i <= segment_vectors(u->file->segment); i++) {
        char name[4];
        segment_vector_name(u->file->segment, i, name);
        fprintf(m->stream, "%sconst %s %s[3]", i ? ", " : "", type, name);
    }
    return memory_close(m);
}

static void add(struct words *w, const char *word, const char *text)
{
    words_add(w, word, new_text(text, strlen(text)));
}

/* Returns the words that turn C text into templates. */
static struct words type_words(void)
{
    struct words w = {NULL, 0, 0};
    add(&w, "REAL", "T");
    add(&w, "double", "T");
    add(&w, "REAL_NUMBER", "T");
    add(&w, "FOOTPOINT_FN", "template <class T> FOOTPOINT_HD inline");
    add(&w, "FOOTPOINT_PART", "template <class T> FOOTPOINT_HD inline");
    add(&w, "detail", "generic");
    add(&w, "sqrt", "footpoint_generic_sqrt");
    add(&w, "fabs", "footpoint_generic_fabs");
    return w;
}

/* Adds the words about a kind, and about a function unless it is NULL. */
static void add_kind(struct words *w, const struct unit *u, const struct function *f)
{
    add(w, "KIND", u->file->segment->name);
    words_add(w, "VECTORS", new_format("%zu", segment_vectors(u->file->segment) + 1));
    words_add(w, "NODE_NAMES", lines_vectors(u));
    words_add(w, "NODE_PARAMETERS", parameters_text(u, "T"));
    add(w, "GENERIC", f ? f->name : "");
}

static void print_templates(const struct unit *u, const struct function *f, const char *const *name, FILE *out)
{
    struct words w = type_words();
    add_kind(&w, u, f);
    templates_print(NULL, name, PRECISION_DOUBLE, w.word, out);
    words_clear(&w);
}

/* ---- statements ---- */

/* Returns a statement as one line, without the variable `zero`. */
static char *statement_text(const struct c_statement *s)
{
    const char *sign = s->zero && s->value[strlen("zero ")] == '-' ? "-" : "";
    char *text = new_format("    %s%s%s = %s%s;", s->declares ? s->declares : "", s->declares ? "T " : "", s->name,
                            sign, s->value + (s->zero ? strlen("zero + ") : 0));
    for (char *end; (end = strchr(text, '\n')) != NULL;) {
        const char *rest = end + 1 + strspn(end + 1, " ");
        *end = ' ';
        memmove(end + 1, rest, strlen(rest) + 1);
    }
    return text;
}

static void print_statement(const struct c_statement *s, FILE *out)
{
    struct words w = type_words();
    struct memory *m = memory_open();
    char *text = statement_text(s);
    c_print_words(text, w.word, m->stream);
    free(text);
    text = memory_close(m);
    print_broken(text, 0, WIDTH, "\n        ", NULL, out);
    fputc('\n', out);
    free(text);
    words_clear(&w);
}

/* Prints the body of NAME_at, or of a function of scalars. */
static void print_body(const struct unit *u, const struct function *f, FILE *out)
{
    struct c_code code = c_code_new(u->file, f->genome, f->program, &c_double);
    fputs("{\n", out);
    for (size_t i = 0; i < code.statements; i++)
        print_statement(&code.statement[i], out);
    c_print_unused(u, f, out);
    fputs("}\n", out);
    printer_free(c_code_clear(&code));
}

/* ---- functions ---- */

/* Returns "(T in_x, T in_y, T *out_r)". */
static char *scalars_text(const struct unit *u, const struct function *f)
{
    struct memory *m = memory_open();
    for (size_t i = 0; i < u->file->inputs; i++)
        fprintf(m->stream, "%sT in_%s", i ? ", " : "", u->file->input[i]);
    for (size_t i = 0; i < f->genome->outs; i++)
        fprintf(m->stream, "%sT *out_%s", i + u->file->inputs ? ", " : "", f->genome->out[i].name);
    return memory_close(m);
}

static void print_head(const struct unit *u, const struct function *f, FILE *out)
{
    char *parameters = u->file->segment ? parameters_text(u, "T") : scalars_text(u, f),
         *head = new_format("template <class T> FOOTPOINT_HD inline void %s%s(%s%s)", f->name,
                            u->file->segment ? "_at" : "", parameters, u->file->segment ? ", T *xi, T *eta" : "");
    print_broken(head, 0, WIDTH, "\n        ", NULL, out);
    fputc('\n', out);
    free(parameters);
    free(head);
}

/* Prints NAME for float, which calls the C header's in double. */
static void print_float(const struct unit *u, const struct function *f, FILE *out)
{
    struct words w = {NULL, 0, 0};
    add_kind(&w, u, f);
    words_add(&w, "FLOAT_PARAMETERS", parameters_text(u, "float"));
    words_add(&w, "VECTOR_ROWS", lines_rows(u, "x"));
    add(&w, "ROUNDED", f->name);
    add(&w, "IN_DOUBLE", f->name);
    add(&w, "FLOAT_MAX", "3.4e38");
    templates_print(NULL, (const char *const[]){"generic_float", NULL}, PRECISION_DOUBLE, w.word, out);
    words_clear(&w);
}

/* Returns true if NAME exists, which needs the surface of the kind. */
static bool has_gap(const struct unit *u)
{
    return u->file->segment && closest_exists(u) && !*u->file->segment->normals;
}

static void print_function(const struct unit *u, const struct function *f, FILE *out)
{
    const struct operations *ops = &f->code.ops;
    fprintf(out, "\n/* %s\n", f->name);
    struct banner_line l = banner_about_function("operations", out);
    banner_add(&l, "%ld mul, %ld div, %ld add, %ld sqrt, %ld compare", ops->mul, ops->div, ops->add, ops->sqrt,
               ops->compare);
    banner_end(&l);
    fputs(" */\n", out);
    print_head(u, f, out);
    print_body(u, f, out);
    if (!has_gap(u))
        return;
    print_templates(u, f, (const char *const[]){"generic_search", NULL}, out);
    if (u->options.precision == PRECISION_DOUBLE)
        print_float(u, f, out);
}

/* ---- the file ---- */

static void print_banner(const struct unit *u, FILE *out)
{
    const char *name = strrchr(u->file->path, '/') ? strrchr(u->file->path, '/') + 1 : u->file->path;
    fprintf(out, "/* GENERATED by footpoint-codegen " FOOTPOINT_VERSION ". DO NOT EDIT.\n");
    struct banner_line l = banner_about_file("command", out);
    banner_add(&l, "%s", u->options.command);
    banner_end(&l);
    l = banner_about_file("genomes", out);
    banner_add(&l, "%s, sha256 %s", name, u->sha256);
    banner_end(&l);
    if (u->file->segment)
        fprintf(out,
                " *\n * NAME_at:  xi and eta in numbers of type T, corners in order \"%s\", nothing checked; in double "
                "the bits of\n"
                " *           NAME_at of %s.h, whose banner has ranges and errors.\n",
                corner_order_name(u->file->order), u->options.prefix);
    if (has_gap(u))
        fprintf(
            out,
            " * NAME:     xi, eta and the gap: NAME_at and a step of Newton's method, after which derivatives that T\n"
            " *           carries are the foot point's, within the error of NAME_at.  Returns FOOTPOINT_UNPROVED.  In\n"
            " *           %s it is NAME of %s.h, with its status and promise%s.\n",
            u->options.precision == PRECISION_FLOAT ? "float" : "double", u->options.prefix,
            u->options.precision == PRECISION_FLOAT ? ""
                                                    : ";\n *           in float that answer, rounded, or "
                                                      "FOOTPOINT_ERR_DOMAIN if it is outside the range of float");
    fputs(" */\n", out);
}

/* Prints the surface of a kind. */
static void print_helpers(const struct unit *u, FILE *out)
{
    const struct segment_kind *k = u->file->segment;
    fputs("\n#ifndef FOOTPOINT_GENERIC_PRODUCTS\n#define FOOTPOINT_GENERIC_PRODUCTS", out);
    print_templates(u, NULL, (const char *const[]){"products", "weighted", NULL}, out);
    fputs("#endif\n", out);
    char *kind = new_capitals(k->name), *surface = new_format("%s%s", k->name, k->bilinear ? "_surface" : "");
    fprintf(out, "\n#ifndef FOOTPOINT_GENERIC_%s\n#define FOOTPOINT_GENERIC_%s", kind, kind);
    print_templates(u, NULL, (const char *const[]){surface, "generic_step", NULL}, out);
    fputs("#endif\n", out);
    free(surface);
    free(kind);
}

bool generic_print(const struct unit *u, FILE *out, struct diag *d)
{
    if (u->file->face)
        return diag_at(d, u->file->path, 0, 0, "functions at a place of a face are printed in C alone");
    char *guard = new_capitals(u->options.prefix);
    print_banner(u, out);
    fprintf(out, "#ifndef %s_HPP\n#define %s_HPP\n", guard, guard);
    if (u->file->segment)
        fprintf(out, "\n#include \"%s.h\"\n", u->options.prefix);
    fputs(beginning, out);
    if (has_gap(u))
        print_helpers(u, out);
    for (size_t i = 0; i < u->file->genomes; i++)
        print_function(u, &u->function[i], out);
    fputs("\n#endif\n", out);
    free(guard);
    return true;
}
