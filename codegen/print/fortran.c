/* Prints Fortran 2008 in free form; see fortran.h.  The order of operations equals the C text's: both languages associate from left
 * to right, and Fortran compilers must honour parentheses. */
#include "fortran.h"

#include "../base/text.h"
#include "../program/dialect.h"
#include "banner.h"

#include <stdlib.h>
#include <string.h>
#include <strings.h>

enum { MOST_NAME = 63, MOST_CONTINUATIONS = 255, WIDTH = 130, LONGEST = 6000 };

/* ---- expressions ---- */

static char *input_text(const struct genome_file *f, size_t k)
{
    char vector[4];
    if (!f->segment)
        return new_format("in_%s", f->input[k]);
    segment_vector_name(f->segment, k / 3, vector);
    return new_format("%s(%d)", vector, (int)(k % 3) + 1);
}

#define OF_FORTRAN(gene, text, value, slope, derivative, c, fortran, ...) [OP_##gene] = {fortran, LEVEL_NAME},
/* merge() evaluates both values, so a protected quotient must not divide by 0 in the value that it drops. */
#define DIALECT(quotient_format)                                                                                       \
    {                                                                                                                  \
        .op = {DIALECT_ARITHMETIC, UNARY(OF_FORTRAN)[OP_MIN] = {"merge($a0, $b0, $a0 < $b0)", LEVEL_NAME},             \
               [OP_MAX] = {"merge($a0, $b0, $a0 > $b0)", LEVEL_NAME},                                                  \
               [OP_PDIV] = {"(merge(1.0_wp, $a0, $b0 == 0.0_wp) / merge(1.0_wp, $b0, $b0 == 0.0_wp))", LEVEL_NAME}},   \
        .open = "(", .close = ")", .decimal = "%s%s_wp", .quotient = quotient_format, .input = input_text,             \
        .longest = LONGEST                                                                                             \
    }

static const struct dialect fortran_double = DIALECT("%s(%s.0_wp / %s.0_wp)"),
                            fortran_float = DIALECT("%sreal(%s.0_real64 / %s.0_real64, wp)");

/* ---- statements ---- */

struct target {
    const struct genome_file *file;
    FILE *names, *code;
    bool too_long;
};

static void print_statement(struct target *t, const char *head, const char *text)
{
    fputs(head, t->code);
    const size_t breaks = print_broken(text, strlen(head), WIDTH, " &\n        ", "&\n&", t->code);
    fputc('\n', t->code);
    t->too_long = t->too_long || breaks > MOST_CONTINUATIONS;
}

static void write_fortran(void *to, const char *name, long output, const char *text)
{
    struct target *t = to;
    char *head = new_format("    %s%s = ", output < 0 || t->file->segment ? "" : "out_", name);
    if (output < 0)
        fprintf(t->names, " %s", name);
    print_statement(t, head, text);
    free(head);
}

/* Prints "    real(wp) :: t1, t2, ..." from " t1 t2 ...", on several lines if necessary. */
static void print_declarations(char *names, FILE *out)
{
    size_t column = 0;
    char *rest;
    for (char *name = strtok_r(names, " ", &rest); name; name = strtok_r(NULL, " ", &rest)) {
        const bool fits = column > 0 && column + strlen(name) + 2 <= WIDTH;
        if (!fits)
            column = (size_t)fprintf(out, column ? "\n    real(wp) :: %s" : "    real(wp) :: %s", name) - (column > 0);
        else
            column += (size_t)fprintf(out, ", %s", name);
    }
    fputs(column ? "\n" : "", out);
}

/* Prints status = 0, or -2 if a denominator is too near 0, not finite, or has the wrong sign. */
static void print_status(const struct unit *u, const struct function *f, struct printer *r, struct target *t)
{
    struct memory *m = memory_open();
    fputs("merge(0, -2", m->stream);
    const char *joint = ", ";
    for (size_t i = 0; i < f->evidence->denominators; i++) {
        const struct denominator *d = &f->evidence->denominator[i];
        if (denominator_is_safe(d))
            continue;
        const double least = unit_threshold(u, d);
        const char *size = d->sign == 0 || least > 0 ? "abs" : d->sign > 0 ? "" : "-";
        char *text = printer_text(r, d->op, LEVEL_SUM);
        fprintf(m->stream, "%s%s(%s) > %.4e_wp .and. abs(%s) <= huge(1.0_wp)", joint, size, text, least, text);
        joint = " .and. ";
        free(text);
    }
    fputc(')', m->stream);
    char *text = memory_close(m);
    print_statement(t, "    status = ", text);
    free(text);
}

/* Prints declarations and then statements in order. */
static void print_body(const struct unit *u, const struct function *f, bool status, struct target *t, FILE *out)
{
    const bool single = u->options.precision == PRECISION_FLOAT;
    struct memory *names = memory_open(), *code = memory_open();
    t->names = names->stream;
    t->code = code->stream;
    struct printer *r = printer_new(u->file, f->genome, f->program, single ? &fortran_float : &fortran_double);
    printer_run(r, write_fortran, t);
    if (status)
        print_status(u, f, r, t);
    printer_free(r);
    char *declared = memory_close(names), *text = memory_close(code);
    print_declarations(declared, out);
    fputs(text, out);
    free(declared);
    free(text);
}

/* ---- subroutines ---- */

/* Prints statements that read unused parameters, which avoids warnings. */
static void print_unused(const struct unit *u, const struct function *f, FILE *out)
{
    bool *reads = program_reads(f->program);
    for (size_t i = 0; i < u->file->inputs; i += u->file->segment ? 3 : 1) {
        char vector[4];
        if (u->file->segment && !(reads[i] || reads[i + 1] || reads[i + 2])) {
            segment_vector_name(u->file->segment, i / 3, vector);
            fprintf(out, "    associate (unused => %s)\n    end associate\n", vector);
        } else if (!u->file->segment && !reads[i])
            fprintf(out, "    associate (unused => in_%s)\n    end associate\n", u->file->input[i]);
    }
    free(reads);
}

/* Returns names for a statement, " in_x, in_y", after `before`. */
static char *list_names(const char *before, const struct unit *u, const struct genome *g, bool inputs, bool outputs)
{
    struct memory *m = memory_open();
    const char *joint = "";
    fputs(before, m->stream);
    for (size_t i = 0; inputs && i < u->file->inputs; i++, joint = ", ")
        fprintf(m->stream, "%sin_%s", joint, u->file->input[i]);
    for (size_t i = 0; outputs && i < g->outs; i++, joint = ", ")
        fprintf(m->stream, "%sout_%s", joint, g->out[i].name);
    return memory_close(m);
}

static void print_list(struct target *t, const char *before, const struct unit *u, const struct genome *g, bool inputs,
                       bool outputs, const char *after)
{
    char *list = list_names("", u, g, inputs, outputs), *all = new_format("%s%s", list, after);
    if (*list)
        print_statement(t, before, all);
    free(list);
    free(all);
}

/* Prints "xA(3), xB(3), ..., xS(3)". */
static void print_vectors(const struct segment_kind *k, const char *shape, FILE *out)
{
    for (size_t i = 0; i <= segment_vectors(k); i++) {
        char name[4];
        segment_vector_name(k, i, name);
        fprintf(out, "%s%s%s", i ? ", " : "", name, shape);
    }
}

static void print_subroutine(const struct unit *u, const struct function *f, struct target *t, FILE *out)
{
    const bool segment = u->file->segment != NULL, status = !segment && function_is_guarded(f);
    fputc('\n', out);
    banner_print_as(u, f, "  !", WIDTH, out);
    fputs(segment  ? "  ! xi, eta dimensionless; nothing checked.\n"
          : status ? "  ! status: -2 where a denominator is 0, or too near it to tell, or not finite; else 0.\n"
                   : "",
          out);
    t->code = out;
    if (segment) {
        fprintf(out, "  pure subroutine %s_at(", f->name);
        print_vectors(u->file->segment, "", out);
        fputs(", xi, eta)\n    real(wp), intent(in) :: ", out);
        print_vectors(u->file->segment, "(3)", out);
        fputs("\n    real(wp), intent(out) :: xi, eta\n", out);
    } else {
        char *head = new_format("  pure elemental subroutine %s(", f->name);
        print_list(t, head, u, f->genome, true, true, status ? ", status)" : ")");
        print_list(t, "    real(wp), intent(in) :: ", u, f->genome, true, false, "");
        print_list(t, "    real(wp), intent(out) :: ", u, f->genome, false, true, "");
        fputs(status ? "    integer, intent(out) :: status\n" : "", out);
        free(head);
    }
    print_body(u, f, status, t, out);
    print_unused(u, f, out);
    fprintf(out, "  end subroutine %s%s\n", f->name, segment ? "_at" : "");
}

/* ---- names ---- */

static int compare_names(const void *a, const void *b)
{
    return strcasecmp(*(char *const *)a, *(char *const *)b);
}

/* Sorts names and refuses long names, and names that differ only in case. */
static bool check_list(const struct unit *u, char **name, size_t n, int line, struct diag *d)
{
    qsort(name, n, sizeof *name, compare_names);
    for (size_t i = 0; i < n; i++) {
        if (strlen(name[i]) > MOST_NAME)
            return diag_at(d, u->file->path, line, line ? 1 : 0, "'%s' is longer than a name in Fortran", name[i]);
        if (i > 0 && compare_names(&name[i - 1], &name[i]) == 0)
            return diag_at(d, u->file->path, line, line ? 1 : 0, "Fortran takes '%s' and '%s' for one name",
                           name[i - 1], name[i]);
    }
    return true;
}

static bool check_names(const struct unit *u, struct diag *d)
{
    const struct genome_file *f = u->file;
    size_t n = 0;
    char **name = new_array(f->genomes + f->inputs + 1, sizeof *name);
    name[n++] = new_format("%s", u->options.prefix);
    for (size_t i = 0; i < f->genomes; i++)
        name[n++] = new_format("%s%s", u->function[i].name, f->segment ? "_at" : "");
    for (size_t i = 0; i < f->inputs && !f->segment; i++)
        name[n++] = new_format("in_%s", f->input[i]);
    bool good = check_list(u, name, n, 0, d);
    for (size_t i = 0; good && !f->segment && i < f->genomes; i++) {
        const struct genome *g = &f->genome[i];
        char **out = new_array(g->outs, sizeof *out);
        for (size_t k = 0; k < g->outs; k++)
            out[k] = new_format("out_%s", g->out[k].name);
        good = check_list(u, out, g->outs, g->line, d);
        for (size_t k = 0; good && k < g->outs; k++)
            good = !bsearch(&out[k], name, n, sizeof *name, compare_names) ||
                   diag_at(d, f->path, g->line, 1, "Fortran takes '%s' for two names", out[k]);
        for (size_t k = 0; k < g->outs; k++)
            free(out[k]);
        free(out);
    }
    for (size_t i = 0; i < n; i++)
        free(name[i]);
    free(name);
    return good;
}

bool fortran_print(const struct unit *u, FILE *out, struct diag *d)
{
    const struct genome_file *f = u->file;
    const char *prefix = u->options.prefix;
    if (f->face)
        return diag_at(d, f->path, 0, 0, "functions at a place of a face are printed in C alone");
    if (!check_names(u, d))
        return false;
    banner_print_as(u, NULL, "!", WIDTH, out);
    fprintf(out,
            "module %s\n"
            "  use, intrinsic :: iso_fortran_env, only: %s\n"
            "  implicit none\n"
            "  private\n",
            prefix, u->options.precision == PRECISION_FLOAT ? "wp => real32, real64" : "wp => real64");
    for (size_t i = 0; i < f->genomes; i++)
        fprintf(out, "  public :: %s%s\n", u->function[i].name, f->segment ? "_at" : "");
    fputs("contains\n", out);
    for (size_t i = 0; i < f->genomes; i++) {
        struct target t = {.file = f};
        print_subroutine(u, &u->function[i], &t, out);
        if (t.too_long)
            return diag_at(d, f->path, f->genome[i].line, 1,
                           "genome '%s' needs a statement of more than %d continuation lines in Fortran",
                           f->genome[i].name, MOST_CONTINUATIONS);
    }
    fprintf(out, "end module %s\n", prefix);
    return true;
}
