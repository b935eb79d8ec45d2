/* C text of the program that was proved; see c_text.h. */
#include "c_text.h"

#include "../genome/text.h"
#include "../program/dialects.h"

#include <stdlib.h>
#include <string.h>

enum { WIDTH = 117 };

void c_print(const char *text, enum precision precision, const char *name, FILE *out)
{
    const bool f = precision == PRECISION_FLOAT;
    for (; *text; text++) {
        if (*text != '@') {
            fputc(*text, out);
            continue;
        }
        text++;
        fputs(*text == 'R'   ? (f ? "float" : "double")
              : *text == 'F' ? (f ? "f" : "")
              : *text == 'D' ? (f ? "footpoint_detail_f_" : "footpoint_detail_")
              : *text == 'G' ? (f ? "_F" : "")
              : *text == 'I' ? (f ? "unsigned int" : "unsigned long long")
              : *text == 'B' ? (f ? "31" : "63")
              : *text == 'Z' ? (f ? "1.1754944e-38f" : "2.2250738585072014e-308")
                             : name,
              out);
    }
}

/* ---- statements ---- */

static struct printer *print_program(const struct unit *u, const struct function *f, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    const struct dialect *d = !single ? &c_double : f->scaled ? &c_relative : &c_float;
    return c_statements(u->file, f->genome, f->program, d, out);
}

void c_print_statements(const struct unit *u, const struct function *f, FILE *out)
{
    printer_free(print_program(u, f, out));
}

bool c_scales_status(const struct unit *u, const struct function *f)
{
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        if (d->verdict != POLE_FREE && unit_threshold(u, d) > 0.0 && unit_degree(u, f, d) != 0)
            return true;
    }
    return false;
}

/* "@Dbelow(D, LEAST)", where the proof knows how near 0 is too near; of a segment LEAST goes with its size.  Of
 * functions of scalars D must be a normal number at least. */
static char *nearness_text(const struct unit *u, const struct function *f, const struct denominator *d,
                           const char *text)
{
    const double least = unit_threshold(u, d);
    const int degree = least > 0.0 ? unit_degree(u, f, d) : 0;
    if (degree)
        return new_format("@Dbelow(%s, %.4e@F * @Dpower(xA, xB, %d)) | ", text, least, degree);
    if (least > 0.0)
        return new_format("@Dbelow(%s, %.4e@F) | ", text, least);
    return u->file->segment ? new_text("", 0) : new_format("@Dbelow(%s, @Z) | ", text);
}

void c_print_flaw(const struct unit *u, const struct function *f, bool poles, FILE *out)
{
    const bool segment = u->file->segment != NULL;
    const enum precision precision = u->options.precision;
    struct printer *r = print_program(u, f, NULL);
    struct memory *m = memory_open();
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        if (!segment && d->verdict == POLE_FREE)
            continue;
        char *text = printer_text(r, d->op, LEVEL_SUM);
        char *nearness = poles && d->verdict != POLE_FREE ? nearness_text(u, f, d, text) : new_text("", 0);
        char *range = new_format(segment ? "@Doutside(%s) | " : "@Dinfinite(%s) | ", text);
        c_print(nearness, precision, "", m->stream);
        c_print(range, precision, "", m->stream);
        free(range);
        free(nearness);
        free(text);
    }
    for (size_t i = 0; i < f->program->ops && segment; i++)
        if (f->program->op[i].kind == OP_PDIV) {
            char *text = printer_text(r, f->program->op[i].b, LEVEL_SUM),
                 *range = new_format("@Dinfinite(%s) | ", text);
            c_print(range, precision, "", m->stream);
            free(range);
            free(text);
        }
    char *flaw = memory_close(m);
    c_print("    const @I flaw = ", precision, "", out);
    if (*flaw)
        flaw[strlen(flaw) - strlen(" | ")] = '\0';
    print_broken(*flaw ? flaw : "0", 40, WIDTH, "\n        ", NULL, out);
    fputs(";\n", out);
    free(flaw);
    printer_free(r);
}

void c_print_loop_note(const struct function *f, FILE *out)
{
    bool roots = false, chooses = false;
    for (size_t i = 0; i < f->program->ops; i++) {
        const enum op_kind kind = f->program->op[i].kind;
        roots = roots || kind == OP_SQRT;
        chooses = chooses || kind == OP_MIN || kind == OP_MAX || kind == OP_PDIV;
    }
    fprintf(out, " Vectorises with -O3%s%s%s.", roots || chooses ? " and" : "", roots ? " -fno-math-errno" : "",
            chooses ? " -fno-trapping-math" : "");
}

void c_print_unused(const struct unit *u, const struct function *f, FILE *out)
{
    bool *reads = function_reads(f);
    for (size_t i = 0; i < u->file->inputs; i += u->file->segment ? 3 : 1) {
        char vector[4];
        if (u->file->segment && !(reads[i] || reads[i + 1] || reads[i + 2])) {
            segment_vector_name(u->file->segment, i / 3, vector);
            fprintf(out, "    (void)%s;\n", vector);
        } else if (!u->file->segment && !reads[i])
            fprintf(out, "    (void)in_%s;\n", u->file->input[i]);
    }
    free(reads);
}
