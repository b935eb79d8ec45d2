/* C text; see c_code.h.  In double the statements are the proved text itself; in float they are printed from the
 * program that was read from it. */
#include "c_code.h"

#include "dialects.h"
#include "text.h"

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
                             : name,
              out);
    }
}

/* ---- statements ---- */

struct target {
    const struct genome_file *file;
    FILE *out;
};

static void write_float(void *to, const char *name, long output, const char *text)
{
    const struct target *t = to;
    const bool constant = text[strspn(text, "-.0123456789ef")] == '\0'; /* see constant_name of phrase.c */
    char *head = output < 0         ? new_format("    %sfloat %s = ", constant ? "" : "const ", name)
                 : t->file->segment ? new_format("    *%s = ", name)
                                    : new_format("    *out_%s = ", name);
    fputs(head, t->out);
    print_broken(text, strlen(head), WIDTH, "\n        ", NULL, t->out);
    fputs(";\n", t->out);
    free(head);
}

static void write_nothing(void *to, const char *name, long output, const char *text)
{
    (void)to;
    (void)name;
    (void)output;
    (void)text;
}

static struct printer *run_printer(const struct unit *u, const struct function *f, write_statement *write, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    struct target t = {u->file, out};
    struct printer *r = printer_new(u->file, f->genome, f->program,
                                    !single     ? &c_double
                                    : f->scaled ? &c_relative
                                                : &c_float);
    printer_run(r, write, &t);
    return r;
}

void c_print_statements(const struct unit *u, const struct function *f, FILE *out)
{
    if (u->options.precision == PRECISION_FLOAT)
        printer_free(run_printer(u, f, write_float, out));
    else
        fputs(f->code.emission.text, out);
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

void c_print_status(const struct unit *u, const struct function *f, FILE *out)
{
    const enum precision precision = u->options.precision;
    struct printer *r = run_printer(u, f, write_nothing, out);
    const char *joint = "    const @R flaw = @Dflaw(";
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        if (d->verdict == POLE_FREE)
            continue;
        char *text = printer_text(r, d->op, LEVEL_SUM);
        const double threshold = unit_threshold(u, d);
        c_print(joint, precision, "", out);
        print_broken(text, 32, WIDTH - 20, "\n            ", NULL, out);
        const int degree = threshold > 0.0 ? unit_degree(u, f, d) : 0;
        fputs(degree ? ",\n            " : ", ", out);
        fprintf(out, threshold > 0.0 ? "%.4e" : "%.1f", threshold);
        char *power = degree ? new_format("@F * @Dpower(xA, xB, %d))", degree) : new_text("@F)", 3);
        c_print(power, precision, "", out);
        free(power);
        joint = " +\n        @Dflaw(";
        free(text);
    }
    c_print(";\n    return (int)(flaw <= 0.0@F ? flaw : (@R)FOOTPOINT_ERR_DEGENERATE);\n", precision, "", out);
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
