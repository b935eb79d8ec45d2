/* Prints a generated header.  It is self-contained: no include but <math.h> and <stddef.h>, C99 to C++17 and CUDA,
 * every name prefixed.  A genome NAME of scalars becomes NAME:    outputs through pointers; returns a status if a
 * denominator may be 0; NAME_n:  the same for arrays; for those of a segment see header_segment.c. */
#include "header.h"

#include "../genome/text.h"
#include "banner.h"
#include "c_text.h"
#include "header_float.h"
#include "header_helpers.h"
#include "header_segment.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static void print_banner(const struct unit *u, FILE *out)
{
    struct memory *m = memory_open();
    banner_print(u, m->stream);
    char *text = memory_close(m);
    text[0] = '/';
    fprintf(out, "%s */\n", text);
    free(text);
}

static void print_macros(const char *prefix, FILE *out)
{
    static const char macros[] =
        "#ifndef FOOTPOINT_FN\n#ifdef __CUDACC__\n"
        "#define FOOTPOINT_FN static __host__ __device__ __forceinline__\n#else\n"
        "#define FOOTPOINT_FN static inline\n#endif\n#endif\n"
        "#ifndef FOOTPOINT_PART /* before parts of functions: inlined, so that what nobody asks for is not computed "
        "*/\n"
        "#if defined(__GNUC__) && !defined(__CUDACC__)\n"
        "#define FOOTPOINT_PART static inline __attribute__((always_inline))\n#else\n"
        "#define FOOTPOINT_PART FOOTPOINT_FN\n#endif\n#endif\n"
        "#ifndef FOOTPOINT_LOOP /* before loops over arrays: what they call is inlined, whatever its size */\n"
        "#if defined(__GNUC__) && !defined(__CUDACC__)\n"
        "#define FOOTPOINT_LOOP __attribute__((flatten)) FOOTPOINT_FN\n#else\n"
        "#define FOOTPOINT_LOOP FOOTPOINT_FN\n#endif\n#endif\n"
        "#ifndef FOOTPOINT_RESTRICT\n"
        "#if defined(__GNUC__) || defined(_MSC_VER) || defined(__CUDACC__)\n"
        "#define FOOTPOINT_RESTRICT __restrict\n#else\n"
        "#define FOOTPOINT_RESTRICT\n#endif\n#endif\n"
        "#ifndef __CUDACC_RTC__\n#include <math.h>\n#include <stddef.h>\n#endif\n\n";
    static const char *const status[] = {"OK", "ERR_NOT_FINITE", "ERR_DEGENERATE"};
    char *guard = new_text(prefix, strlen(prefix));
    for (char *c = guard; *c; c++)
        *c = (char)toupper((unsigned char)*c);
    fprintf(out, "#ifndef %s_H\n#define %s_H\n\n%s", guard, guard, macros);
    for (int i = 0; i < 3; i++)
        fprintf(out, "#ifndef FOOTPOINT_%s\n#define FOOTPOINT_%s %d\n#endif\n", status[i], status[i], i);
    free(guard);
}

/* What every status rests on: the bits of numbers, as -ffast-math leaves integers alone. */
static void print_bits(enum precision precision, FILE *out)
{
    const bool f = precision == PRECISION_FLOAT;
    char *text =
        new_format("\n#ifndef FOOTPOINT_DETAIL_BITS@G\n#define FOOTPOINT_DETAIL_BITS@G\n"
                   "/* Statuses are told by the bits of numbers: -ffast-math leaves integers alone.  Those of infinity "
                   "are above all\n"
                   " * others', those of NaN above these.  What the functions below find stands in the highest bit of "
                   "a result. */\n"
                   "FOOTPOINT_PART @I @Dbits(@R x)\n"
                   "{\n"
                   "    union {\n        @R number;\n        @I bits;\n    } both;\n"
                   "    both.number = x;\n"
                   "    return both.bits;\n"
                   "}\n\n"
                   "/* Unless %s <= |x| < %s: room for products of what x is made of, and half of all exponents. */\n"
                   "FOOTPOINT_PART @I @Doutside(@R x)\n"
                   "{\n"
                   "    return 2 * @Dbits(x) - ((@I)%d << %d);\n"
                   "}\n\n"
                   "/* If |x| < least. */\n"
                   "FOOTPOINT_PART @I @Dbelow(@R x, @R least)\n"
                   "{\n"
                   "    return (@Dbits(x) & ~(@I)0 >> 1) - @Dbits(least);\n"
                   "}\n\n"
                   "/* If x is infinite or NaN. */\n"
                   "FOOTPOINT_PART @I @Dinfinite(@R x)\n"
                   "{\n"
                   "    return (@Dbits(x) & ~(@I)0 >> 1) + ((@I)1 << %d);\n"
                   "}\n#endif\n",
                   f ? "2^-96" : "2^-512", f ? "2^32" : "2^512", f ? 31 : 511, f ? 24 : 53, f ? 23 : 52);
    c_print(text, precision, "", out);
    free(text);
}

static void print_power(enum precision precision, FILE *out)
{
    c_print("\n#ifndef FOOTPOINT_DETAIL_POWER@G\n#define FOOTPOINT_DETAIL_POWER@G\n"
            "/* |AB| to the power n: what goes as that is compared with what it is for |AB| = 1. */\n"
            "FOOTPOINT_FN @R @Dpower(const @R a[3], const @R b[3], int n)\n"
            "{\n"
            "    const @R x = b[0] - a[0], y = b[1] - a[1], z = b[2] - a[2], square = x * x + y * y + z * z;\n"
            "    @R power = n & 1 ? sqrt@F(square) : 1.0@F;\n"
            "    int i;\n"
            "    for (i = n < 0 ? -n : n; i > 1; i -= 2)\n"
            "        power *= square;\n"
            "    return n < 0 ? 1.0@F / power : power;\n"
            "}\n#endif\n",
            precision, "", out);
}

/* "double in_x, double in_y, double *out_r", a few a line; of an array function pointers. */
static void print_parameters(const struct unit *u, const struct function *f, bool array, FILE *out)
{
    const enum precision precision = u->options.precision;
    const struct genome *g = f->genome;
    const size_t inputs = u->file->inputs, n = inputs + g->outs, line = array ? 3 : 5;
    for (size_t i = 0; i < n; i++) {
        const char *name = i < inputs ? u->file->input[i] : g->out[i - inputs].name;
        fputs(i == 0 ? "" : i % line ? ", " : ",\n    ", out);
        c_print(i < inputs ? (array ? "const @R *in_@N" : "@R in_@N")
                : array    ? "@R *FOOTPOINT_RESTRICT out_@N"
                           : "@R *out_@N",
                precision, name, out);
    }
    if (array && function_has_poles(f))
        fputs(",\n    int *FOOTPOINT_RESTRICT status", out);
}

static void print_one(const struct unit *u, const struct function *f, FILE *out)
{
    const bool poles = function_has_poles(f);
    const struct operations *ops = &f->code.ops;
    fprintf(out, "\n/* %ld mul, %ld div, %ld add, %ld sqrt.%s */\n", ops->mul, ops->div, ops->add, ops->sqrt,
            poles ? "  FOOTPOINT_ERR_DEGENERATE where a denominator is 0, or too near it to tell, or\n"
                    " * not finite (the outputs are written all the same); FOOTPOINT_OK elsewhere."
                  : "");
    fprintf(out, "FOOTPOINT_FN %s %s(", poles ? "int" : "void", f->name);
    print_parameters(u, f, false, out);
    fputs(")\n{\n", out);
    c_print_statements(u, f, out);
    c_print_unused(u, f, out);
    if (poles) {
        c_print_flaw(u, f, true, out);
        c_print("    return flaw >> @B ? FOOTPOINT_ERR_DEGENERATE : FOOTPOINT_OK;\n", u->options.precision, "", out);
    }
    fputs("}\n", out);
}

static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    fputs("\n/* The same for n points; outputs overlap nothing else. ", out);
    c_print_loop_note(f, out);
    fprintf(out, " */\nFOOTPOINT_LOOP void %s_n(size_t n,\n    ", f->name);
    print_parameters(u, f, true, out);
    fprintf(out, ")\n{\n    size_t i;\n    for (i = 0; i < n; i++)\n        %s%s(",
            function_has_poles(f) ? "status[i] = " : "", f->name);
    for (size_t i = 0; i < u->file->inputs; i++)
        fprintf(out, "in_%s[i],%s", u->file->input[i], (i + 1) % 5 ? " " : "\n            ");
    for (size_t i = 0; i < f->genome->outs; i++)
        fprintf(out, "%s&out_%s[i]", i ? ", " : "", f->genome->out[i].name);
    fputs(");\n}\n", out);
}

/* Rows of inputs, outputs and their tolerances, for those who want to test a build of theirs. */
static void print_points(const struct unit *u, const struct function *f, FILE *out)
{
    struct memory *m = memory_open();
    const int rows = evidence_print_points(u->file, f->genome, f->program, f->evidence, m->stream);
    char *text = memory_close(m);
    if (rows)
        fprintf(out,
                "\n#ifdef FOOTPOINT_TEST_POINTS /* inputs, exact outputs rounded, and how far off the code may be */\n"
                "static const double %s_points[][%zu] = {\n%s};\n#endif\n",
                f->name, u->file->inputs + 2 * f->genome->outs, text);
    free(text);
}

void header_print(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    bool status = false, scales = false;
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *f = &u->function[i];
        status = status || u->file->segment || function_has_poles(f);
        scales = scales || (u->file->segment && search_hides_poles(f) && c_scales_status(u, f));
    }
    print_banner(u, out);
    print_macros(u->options.prefix, out);
    if (single_checks(u))
        fputs("#ifndef FOOTPOINT_ERR_DOMAIN\n#define FOOTPOINT_ERR_DOMAIN 3\n#endif\n", out);
    if (status)
        print_bits(precision, out);
    if (scales)
        print_power(precision, out);
    if (u->file->segment)
        helpers_print(u, out);
    if (u->options.samples)
        single_print_helpers(u->file->segment, single_checks(u), out);
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *f = &u->function[i];
        if (u->file->segment)
            search_print(u, f, out);
        else {
            print_one(u, f, out);
            print_loop(u, f, out);
        }
        if (precision == PRECISION_DOUBLE)
            print_points(u, f, out);
    }
    fprintf(out, "\n#endif\n");
}
