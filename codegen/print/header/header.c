/* Prints a generated header.  It is self-contained: it includes only <math.h> and <stddef.h>, compiles as C99 to C++17 and CUDA,
 * and prefixes every name.  A genome NAME of scalars becomes NAME, with outputs through pointers and a status if a
 * denominator may be 0, and NAME_n, the same for arrays; for genomes of a segment see header_segment.c. */
#include "header.h"

#include "../../base/text.h"
#include "../banner.h"
#include "../c_text.h"
#include "../templates.h"
#include "header_along.h"
#include "header_float.h"
#include "header_helpers.h"
#include "header_place.h"
#include "header_segment.h"

#include <stdlib.h>
#include <string.h>

/* Prints the include guard PREFIX_H; PREFIX_PLACE_H for functions at a place of a face with the names of a search. */
static void print_guard(const struct unit *u, FILE *out)
{
    char *guard = new_capitals(u->options.prefix);
    const char *const place = u->file->face && u->options.face_prefix ? "_PLACE" : "";
    fprintf(out, "#ifndef %s%s_H\n#define %s%s_H\n", guard, place, guard, place);
    free(guard);
}

/* Prints "double in_x, double in_y, double *out_r", several a line; for an array function pointers. */
static void print_parameters(const struct unit *u, const struct function *f, bool array, FILE *out)
{
    const char *real = u->options.precision == PRECISION_FLOAT ? "float" : "double";
    const struct genome *g = f->genome;
    const size_t inputs = u->file->inputs, n = inputs + g->outs, line = array ? 3 : 5;
    for (size_t i = 0; i < n; i++) {
        fputs(i == 0 ? "" : i % line ? ", " : ",\n    ", out);
        if (i < inputs)
            fprintf(out, "%s%s %sin_%s", array ? "const " : "", real, array ? "*" : "", u->file->input[i]);
        else
            fprintf(out, "%s *%sout_%s", real, array ? "FOOTPOINT_RESTRICT " : "", g->out[i - inputs].name);
    }
    if (array && function_is_guarded(f))
        fputs(",\n    int *FOOTPOINT_RESTRICT status", out);
}

static void print_one(const struct unit *u, const struct function *f, FILE *out)
{
    const bool poles = function_is_guarded(f);
    fprintf(out, "FOOTPOINT_FN %s %s(", poles ? "int" : "void", f->name);
    print_parameters(u, f, false, out);
    fputs(")\n{\n", out);
    struct c_code code = c_code_of(u, f);
    c_print_packed(&code, NULL, out);
    printer_free(c_code_clear(&code));
    c_print_unused(u, f, out);
    if (poles) {
        const char *top = u->options.precision == PRECISION_FLOAT ? "31" : "63";
        char *flaw = c_flaw(u, f, true);
        char *last = new_format("    return FOOTPOINT_ERR_DEGENERATE * (int)((%s) >> %s);", flaw, top);
        c_print_broken(last, out);
        free(last);
        free(flaw);
    }
    fputs("}\n", out);
}

static void print_loop(const struct unit *u, const struct function *f, FILE *out)
{
    fprintf(out, "\nFOOTPOINT_LOOP void %s_n(size_t n,\n    ", f->name);
    print_parameters(u, f, true, out);
    fprintf(out, ")\n{\n    size_t i;\n    for (i = 0; i < n; i++)\n        %s%s(",
            function_is_guarded(f) ? "status[i] = " : "", f->name);
    for (size_t i = 0; i < u->file->inputs; i++)
        fprintf(out, "in_%s[i],%s", u->file->input[i], (i + 1) % 5 ? " " : "\n            ");
    for (size_t i = 0; i < f->genome->outs; i++)
        fprintf(out, "%s&out_%s[i]", i ? ", " : "", f->genome->out[i].name);
    fputs(");\n}\n", out);
}

/* Prints the contract of functions of scalars, once for all genomes. */
static void print_contract(const struct unit *u, FILE *out)
{
    bool poles = false;
    for (size_t i = 0; i < u->file->genomes; i++)
        poles = poles || function_is_guarded(&u->function[i]);
    fprintf(
        out,
        "\n/* NAME:    outputs of one point%s.\n"
        " * NAME_n:  the same for n points; outputs overlap nothing else. */\n",
        poles
            ? "; of functions that return a status, FOOTPOINT_ERR_DEGENERATE where a denominator is 0, or\n"
              " *          too near it to tell, or not finite (the outputs are written all the same), else FOOTPOINT_OK"
            : "");
}

/* Prints each helper that is called. */
static void print_helpers(const struct unit *u, FILE *out)
{
    const enum precision precision = u->options.precision;
    const bool segment = u->file->segment != NULL;
    bool status = segment, scales = false;
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *f = &u->function[i];
        status = status || function_is_guarded(f);
        scales = scales || (segment && !u->file->face && c_scales_status(u, f));
    }
    templates_print(NULL, (const char *const[]){"macros", NULL}, precision, NULL, out);
    if (status)
        templates_print("FOOTPOINT_DETAIL_BITS", (const char *const[]){"bits", NULL}, precision, NULL, out);
    if (scales)
        templates_print("FOOTPOINT_DETAIL_POWER", (const char *const[]){"power", NULL}, precision, NULL, out);
    if (precision == PRECISION_FLOAT)
        single_print_helpers(u, out);
    if (u->file->face)
        place_print_helpers(u, out);
    else if (segment)
        helpers_print(u, out);
}

void header_print(const struct unit *u, FILE *out)
{
    banner_print_file(u, out);
    print_guard(u, out);
    print_helpers(u, out);
    if (u->file->segment && !u->file->face)
        search_print_contract(u, out);
    else if (!u->file->segment)
        print_contract(u, out);
    for (size_t i = 0; i < u->file->genomes && u->file->segment && !u->file->face; i++)
        search_print_bare(u, &u->function[i], out);
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *f = &u->function[i];
        fputc('\n', out);
        banner_print_function(u, f, out);
        if (u->file->face)
            place_print(u, f, out);
        else if (u->file->segment)
            search_print(u, f, out);
        else {
            print_one(u, f, out);
            print_loop(u, f, out);
        }
    }
    if (!u->file->face)
        along_print(u, out);
    templates_print(NULL, (const char *const[]){"ending", NULL}, u->options.precision, NULL, out);
    fputs("\n#endif\n", out);
}
