/* The dialects of C: in double, in float, and in float with coordinates relative to the segment. */
#include "dialects.h"

#include "../base/text.h"

#include <stdlib.h>
#include <string.h>

/* Writes input zA as xA[2]. */
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

/* Writes a coordinate relative to the segment as yA[2]; normals stay. */
static char *relative_text(const struct genome_file *f, size_t k)
{
    char *text = input_text(f, k);
    if (f->segment && text[0] == 'x')
        text[0] = 'y';
    return text;
}

/* A constant operand has the variable `zero` added to it or is not const, so that gcc's front end does not see its
 * value. Otherwise gcc would reverse the comparison, and later passes would miss that c < x ? c : x is a single
 * instruction. */
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

/* In float, both choices of a protected quotient come before its division, so that no branch is left. */
#define FLOAT_QUOTIENT "(($b3 == 0.0f ? 1.0f : $a3) / ($b3 == 0.0f ? 1.0f : $b3))"

const struct dialect c_double =
    DIALECT("double", OF_DOUBLE, "%s%s", "%s(%s.0 / %s.0)", input_text, "($b1 == 0.0 ? 1.0 : $a1 / $b1)");
#define FLOAT(input) DIALECT("float", OF_FLOAT, "%s%sf", "%s(float)(%s.0 / %s.0)", input, FLOAT_QUOTIENT)
const struct dialect c_float = FLOAT(input_text), c_relative = FLOAT(relative_text);

/* ---- statements ---- */

/* Receives a statement; constants that gcc must not see become `zero + constant`. */
static void take_statement(void *to, const char *name, long output, const char *text)
{
    enum { WIDTH = 117 };
    struct c_code *c = to;
    const struct genome_file *f = c->printer->file;
    const bool constant = text[strspn(text, "-.0123456789f/ ()")] == '\0';
    const bool zero = constant && output < 0 && program_hides_constants(f), negative = zero && *text == '-';
    const char *before = output < 0 || f->face ? "" : f->segment ? "*" : "*out_";
    struct c_statement s = {output >= 0         ? NULL
                            : constant && !zero ? ""
                                                : "const ",
                            new_joined(before, name, ""), NULL, output, zero};
    struct memory *m = memory_open();
    if (zero)
        fprintf(m->stream, "zero %c ", negative ? '-' : '+');
    const size_t column = strlen("    ") +
                          (s.declares ? strlen(s.declares) + strlen(c->printer->dialect->type) + 1 : 0) +
                          strlen(s.name) + strlen(" = ") + (zero ? strlen("zero + ") : 0);
    print_broken(text + negative, column, WIDTH, "\n        ", NULL, m->stream);
    s.value = memory_close(m);
    APPEND(c->statement, c->statements, c->room) = s;
}

struct c_code c_code_new(const struct genome_file *f, const struct genome *genome, const struct program *p,
                         const struct dialect *d)
{
    struct c_code c = {.printer = printer_new(f, genome, p, d)};
    printer_run(c.printer, take_statement, &c);
    return c;
}

struct printer *c_code_clear(struct c_code *c)
{
    for (size_t i = 0; i < c->statements; i++) {
        free(c->statement[i].name);
        free(c->statement[i].value);
    }
    free(c->statement);
    return c->printer;
}

int c_statement_print(const struct c_code *c, size_t i, FILE *out)
{
    const struct c_statement *s = &c->statement[i];
    return fprintf(out, "    %s%s%s%s = %s", s->declares ? s->declares : "",
                   s->declares ? c->printer->dialect->type : "", s->declares ? " " : "", s->name, s->value);
}

struct printer *c_statements(const struct genome_file *f, const struct genome *genome, const struct program *p,
                             const struct dialect *d, FILE *out)
{
    struct c_code c = c_code_new(f, genome, p, d);
    for (size_t i = 0; out && i < c.statements; i++) {
        c_statement_print(&c, i, out);
        fputs(";\n", out);
    }
    return c_code_clear(&c);
}
