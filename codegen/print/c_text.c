/* Prints the C text of the proved program; see c_text.h. */
#include "c_text.h"

#include "../base/text.h"
#include "../program/dialects.h"
#include "templates.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 117 };

static const struct dialect *dialect_of(const struct unit *u, const struct function *f)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    return !single ? &c_double : f->scaled ? &c_relative : &c_float;
}

struct c_code c_code_of(const struct unit *u, const struct function *f)
{
    return c_code_new(u->file, f->genome, f->program, dialect_of(u, f));
}

void c_print_packed(const struct c_code *c, const bool *wanted, FILE *out)
{
    size_t column = 0;       /* of the line in progress */
    const char *open = NULL; /* first words of its declaration */
    for (size_t i = 0; i < c->statements; i++) {
        const struct c_statement *s = &c->statement[i];
        if (wanted && !wanted[i])
            continue;
        const bool short_one = !strchr(s->value, '\n');
        const size_t more = strlen(", ") + strlen(s->name) + strlen(" = ") + strlen(s->value);
        if (open && s->declares && strcmp(open, s->declares) == 0 && short_one && column + more <= WIDTH) {
            column += (size_t)fprintf(out, ", %s = %s", s->name, s->value);
            continue;
        }
        fputs(column ? ";\n" : "", out);
        column = (size_t)c_statement_print(c, i, out);
        open = short_one ? s->declares : NULL;
    }
    fputs(column ? ";\n" : "", out);
}

/* Returns true if a statement sets the value of a needed operation. */
static bool sets_needed(const struct program *p, const struct printer *r, const bool *needed,
                        const struct c_statement *s)
{
    for (size_t i = p->inputs; s->declares && i < p->ops; i++)
        if (needed[i] && r->name[i] && strcmp(s->name, r->name[i]) == 0)
            return true;
    return false;
}

struct printer *c_print_needed(const struct unit *u, const struct function *f, const bool *needed, FILE *out)
{
    struct c_code c = c_code_of(u, f);
    bool *wanted = new_array(c.statements, sizeof *wanted);
    for (size_t i = 0; i < c.statements; i++)
        wanted[i] = sets_needed(f->program, c.printer, needed, &c.statement[i]);
    c_print_packed(&c, wanted, out);
    free(wanted);
    return c_code_clear(&c);
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

/* Returns "below(D, LEAST)" if the proof has a threshold near 0, which on a segment is multiplied by its size.  In functions of scalars
 * D must at least be a normal number and have its sign. */
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

/* Prints the tests of denominator d: within the range and, with `poles`, not too near 0. */
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
    struct printer *r = c_statements(u->file, f->genome, f->program, dialect_of(u, f), NULL);
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
