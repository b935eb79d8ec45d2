/* C text of the program that was proved; see c_text.h. */
#include "c_text.h"

#include "../base/text.h"
#include "../program/dialects.h"
#include "templates.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 117 };

static struct printer *print_program(const struct unit *u, const struct function *f, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    const struct dialect *d = !single ? &c_double : f->scaled ? &c_relative : &c_float;
    return c_statements(u->file, f->genome, f->program, d, out);
}

/* The length of "    const double " or the like at the beginning of a declaration; 0 of another statement. */
static size_t declaration(const char *text, enum precision precision)
{
    const char *type = precision == PRECISION_FLOAT ? "float " : "double ";
    const size_t indent = strspn(text, " "), constant = strncmp(text + indent, "const ", 6) == 0 ? 6 : 0;
    const bool declares = strncmp(text + indent + constant, type, strlen(type)) == 0;
    return declares ? indent + constant + strlen(type) : 0;
}

/* Statements of one line each, but for long ones; declarations of one type join in a line as long as it has room. */
static void print_packed(const char *text, enum precision precision, FILE *out)
{
    size_t column = 0, open = 0; /* of the line that goes on; the length of what begins its declaration */
    for (const char *end; *text; text = end + 2) {
        end = strstr(text, ";\n");
        const size_t n = (size_t)(end - text), type = declaration(text, precision);
        const bool short_one = memchr(text, '\n', n) == NULL;
        if (open && open == type && short_one && column + 2 + n - type <= WIDTH) {
            column += (size_t)fprintf(out, ", %.*s", (int)(n - type), text + type);
            continue;
        }
        fprintf(out, "%s%.*s", column ? ";\n" : "", (int)n, text);
        column = n;
        open = short_one ? type : 0;
    }
    fputs(column ? ";\n" : "", out);
}

void c_print_statements(const struct unit *u, const struct function *f, FILE *out)
{
    struct memory *m = memory_open();
    printer_free(print_program(u, f, m->stream));
    char *text = memory_close(m);
    print_packed(text, u->options.precision, out);
    free(text);
}

/* Whether the statement at `text` sets the value of an operation that is needed. */
static bool sets_needed(const struct program *p, const struct printer *r, const bool *needed, const char *text,
                        size_t type)
{
    for (size_t i = 0; type && i < p->ops; i++) {
        const size_t n = r->name[i] && needed[i] && i >= p->inputs ? strlen(r->name[i]) : 0;
        if (n && strncmp(text + type, r->name[i], n) == 0 && text[type + n] == ' ')
            return true;
    }
    return false;
}

struct printer *c_print_needed(const struct unit *u, const struct function *f, const bool *needed, FILE *out)
{
    struct memory *m = memory_open(), *few = memory_open();
    struct printer *r = print_program(u, f, m->stream);
    char *text = memory_close(m);
    for (const char *t = text, *end; *t; t = end + 2) {
        end = strstr(t, ";\n");
        if (sets_needed(f->program, r, needed, t, declaration(t, u->options.precision)))
            fprintf(few->stream, "%.*s;\n", (int)(end - t), t);
    }
    free(text);
    text = memory_close(few);
    print_packed(text, u->options.precision, out);
    free(text);
    return r;
}

bool c_scales_status(const struct unit *u, const struct function *f)
{
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        if (!denominator_is_safe(d) && unit_threshold(u, d) > 0.0 && unit_degree(u, f, d) != 0)
            return true;
    }
    return false;
}

/* "below(D, LEAST)", where the proof knows how near 0 is too near; of a segment LEAST goes with its size.  Of
 * functions of scalars D must be a normal number at least, and have its sign. */
static char *nearness_text(const struct unit *u, const struct function *f, const struct denominator *d,
                           const char *text)
{
    const double least = unit_threshold(u, d);
    const int degree = least > 0.0 ? unit_degree(u, f, d) : 0;
    if (degree)
        return new_format("footpoint_detail_below(%s, %.4e * footpoint_detail_power(xA, xB, %d)) | ", text, least,
                          degree);
    if (least > 0.0)
        return new_format("footpoint_detail_below(%s, %.4e) | ", text, least);
    if (u->file->segment)
        return new_text("", 0);
    return d->sign == 0 ? new_format("footpoint_detail_below(%s, REAL_MIN) | ", text)
           : d->sign > 0
               ? new_format("footpoint_detail_below(%s, REAL_MIN) | footpoint_detail_bits(%s) | ", text, text)
               : new_format("footpoint_detail_below(%s, REAL_MIN) | footpoint_detail_bits(-(%s)) | ", text, text);
}

/* The tests of denominator d: that it is not too near 0, with `poles`, and within the range. */
static void print_denominator(const struct unit *u, const struct function *f, const struct denominator *d,
                              const char *text, bool poles, FILE *out)
{
    const bool segment = u->file->segment != NULL;
    if (!segment && denominator_is_safe(d))
        return;
    if (poles && !denominator_is_safe(d)) {
        char *nearness = nearness_text(u, f, d, text);
        c_print(nearness, u->options.precision, out);
        free(nearness);
    }
    char *range = new_format(segment ? "footpoint_detail_outside(%s) | " : "footpoint_detail_infinite(%s) | ", text);
    c_print(range, u->options.precision, out);
    free(range);
}

char *c_flaw(const struct unit *u, const struct function *f, bool poles)
{
    struct memory *m = memory_open();
    struct printer *r = print_program(u, f, NULL);
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        char *text = printer_text(r, d->op, LEVEL_SUM);
        print_denominator(u, f, d, text, poles, m->stream);
        free(text);
    }
    for (size_t i = 0; i < f->program->ops && u->file->segment; i++)
        if (f->program->op[i].kind == OP_PDIV) {
            char *text = printer_text(r, f->program->op[i].b, LEVEL_SUM),
                 *range = new_format("footpoint_detail_infinite(%s) | ", text);
            c_print(range, u->options.precision, m->stream);
            free(range);
            free(text);
        }
    printer_free(r);
    char *flaw = memory_close(m);
    if (!*flaw) {
        free(flaw);
        return new_joined("0", "", "");
    }
    flaw[strlen(flaw) - strlen(" | ")] = '\0';
    return flaw;
}

void c_print_broken(const char *text, FILE *out)
{
    print_broken(text, 0, WIDTH, "\n        ", NULL, out);
    fputc('\n', out);
}

void c_print_unused(const struct unit *u, const struct function *f, FILE *out)
{
    const struct segment_kind *kind = u->file->segment;
    bool *reads = program_reads(f->program), begun = false;
    for (size_t i = 0; i < u->file->inputs; i += kind ? 3 : 1) {
        char vector[4];
        if (reads[i] || (kind && (reads[i + 1] || reads[i + 2])))
            continue;
        if (kind)
            segment_vector_name(kind, i / 3, vector);
        fprintf(out, "%s(void)%s%s", begun ? ", " : "    ", kind ? "" : "in_", kind ? vector : u->file->input[i]);
        begun = true;
    }
    fputs(begun ? ";\n" : "", out);
    free(reads);
}
