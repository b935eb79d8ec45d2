/* C as dialects: in double, in float, and in float of coordinates relative to the segment. */
#include "dialects.h"

#include "../base/text.h"

#include <stdlib.h>
#include <string.h>

/* xA[2] is input zA. */
static char *input_text(const struct genome_file *f, size_t k)
{
    char vector[4];
    if (!f->segment)
        return new_format("in_%s", f->input[k]);
    if (k >= segment_inputs(f->segment)) /* xi, eta of a face */
        return new_text(f->input[k], strlen(f->input[k]));
    segment_vector_name(f->segment, k / 3, vector);
    return new_format("%s[%d]", vector, (int)(k % 3));
}

/* The same of coordinates that are relative to the segment: yA[2]; normals stay what they are. */
static char *relative_text(const struct genome_file *f, size_t k)
{
    char *text = input_text(f, k);
    if (f->segment && text[0] == 'x')
        text[0] = 'y';
    return text;
}

/* A variable that is a constant has `zero` added to it, or is not const, so that gcc's front end does not see through it: it
 * would turn a comparison round, and later passes would not find the one instruction that c < x ? c : x is. */
#define OF_DOUBLE(gene, text, value, slope, derivative, c, ...) [OP_##gene] = {c "($a0)", LEVEL_NAME},
#define OF_FLOAT(gene, text, value, slope, derivative, c, ...) [OP_##gene] = {c "f($a0)", LEVEL_NAME},
#define DIALECT(real, unary, decimal_format, quotient_format, input_function, protected_quotient)                      \
    {                                                                                                                  \
        .op = {DIALECT_ARITHMETIC, UNARY(unary)[OP_MIN] = {"($a1 < $b1 ? $a1 : $b1)", LEVEL_NAME},                     \
               [OP_MAX] = {"($a1 > $b1 ? $a1 : $b1)", LEVEL_NAME}, [OP_PDIV] = {protected_quotient, LEVEL_NAME}},      \
        .second = {{"(!($a1 >= $b1) ? $a1 : $b1)", LEVEL_NAME}, {"(!($a1 <= $b1) ? $a1 : $b1)", LEVEL_NAME}},          \
        .open = "(", .close = ")", .decimal = decimal_format, .quotient = quotient_format, .input = input_function,    \
        .type = real                                                                                                   \
    }

/* In float both choices of a protected quotient are made before it divides: no branch is left. */
#define FLOAT_QUOTIENT "(($b3 == 0.0f ? 1.0f : $a3) / ($b3 == 0.0f ? 1.0f : $b3))"

const struct dialect c_double =
    DIALECT("double", OF_DOUBLE, "%s%s", "%s(%s.0 / %s.0)", input_text, "($b1 == 0.0 ? 1.0 : $a1 / $b1)");
#define FLOAT(input) DIALECT("float", OF_FLOAT, "%s%sf", "%s(float)(%s.0 / %s.0)", input, FLOAT_QUOTIENT)
const struct dialect c_float = FLOAT(input_text), c_relative = FLOAT(relative_text);

/* ---- statements ---- */

struct target {
    const struct genome_file *file;
    const char *type;
    FILE *out; /* NULL: none */
};

static void write_c(void *to, const char *name, long output, const char *text)
{
    enum { WIDTH = 117 };
    const struct target *t = to;
    const bool constant = text[strspn(text, "-.0123456789f/ ()")] == '\0';
    if (!t->out)
        return;
    const bool hidden = constant && output < 0 && program_hides_constants(t->file), negative = *text == '-';
    char *head = hidden             ? new_format("    const %s %s = zero %c ", t->type, name, negative ? '-' : '+')
                 : output < 0       ? new_format("    %s%s %s = ", constant ? "" : "const ", t->type, name)
                 : t->file->face    ? new_format("    %s = ", name)
                 : t->file->segment ? new_format("    *%s = ", name)
                                    : new_format("    *out_%s = ", name);
    fputs(head, t->out);
    print_broken(text + (hidden && negative), strlen(head), WIDTH, "\n        ", NULL, t->out);
    fputs(";\n", t->out);
    free(head);
}

struct printer *c_statements(const struct genome_file *f, const struct genome *genome, const struct program *p,
                             const struct dialect *d, FILE *out)
{
    struct target t = {f, d->type, out};
    struct printer *r = printer_new(f, genome, p, d);
    printer_run(r, write_c, &t);
    return r;
}
