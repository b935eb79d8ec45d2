/* C as dialects: in double, in float, and in float of coordinates relative to the segment. */
#include "dialects.h"

#include "../genome/text.h"

#include <stdlib.h>

static char *constant_text(const fmpq *value, enum level *level, bool single)
{
    bool negative;
    char *num, *den, *text;
    split_constant(value, &negative, &num, &den);
    const char *sign = negative ? "-" : "";
    if (den)
        text = new_format(single ? "%s(float)(%s.0 / %s.0)" : "%s(%s.0 / %s.0)", sign, num, den);
    else
        text = new_format("%s%s%s", sign, num, single ? "f" : "");
    *level = negative ? LEVEL_MINUS : LEVEL_NAME;
    free(num);
    free(den);
    return text;
}

static char *double_constant(const fmpq *value, enum level *level)
{
    return constant_text(value, level, false);
}

static char *float_constant(const fmpq *value, enum level *level)
{
    return constant_text(value, level, true);
}

/* xA[2] is input zA. */
static char *input_text(const struct genome_file *f, size_t k)
{
    char vector[4];
    if (!f->segment)
        return new_format("in_%s", f->input[k]);
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

/* Both choices of a protected quotient are made before it divides: no branch is left. */
#define DIALECT(suffix, constant_function, input_function)                                                             \
    {                                                                                                                  \
        .op = {[OP_NEG] = {"-$a3", LEVEL_MINUS},                                                                       \
               [OP_ADD] = {"$a0 + $b2", LEVEL_SUM},                                                                    \
               [OP_SUB] = {"$a0 - $b2", LEVEL_SUM},                                                                    \
               [OP_MUL] = {"$a1 * $b3", LEVEL_PRODUCT},                                                                \
               [OP_DIV] = {"$a1 / $b3", LEVEL_PRODUCT},                                                                \
               [OP_SQRT] = {"sqrt" suffix "($a0)", LEVEL_NAME},                                                        \
               [OP_ABS] = {"fabs" suffix "($a0)", LEVEL_NAME},                                                         \
               [OP_MIN] = {"($a1 < $b1 ? $a1 : $b1)", LEVEL_NAME},                                                     \
               [OP_MAX] = {"($a1 > $b1 ? $a1 : $b1)", LEVEL_NAME},                                                     \
               [OP_PDIV] = {"(($b3 == 0.0" suffix " ? 1.0" suffix " : $a3) / ($b3 == 0.0" suffix " ? 1.0" suffix       \
                            " : $b3))",                                                                                \
                            LEVEL_NAME}},                                                                              \
        .open = "(", .close = ")", .constant = constant_function, .input = input_function                              \
    }

const struct dialect c_double = DIALECT("", double_constant, input_text);
const struct dialect c_float = DIALECT("f", float_constant, input_text);
const struct dialect c_relative = DIALECT("f", float_constant, relative_text);
