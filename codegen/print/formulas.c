/* Prints infix and LaTeX; see formulas.h.  Infix uses only syntax that Python, SymPy, Maxima and FORM read alike: names, + - * /,
 * parentheses, functions, and constants as quotients of integers, which only Python rounds. */
#include "formulas.h"

#include "../base/text.h"
#include "../program/dialect.h"
#include "banner.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

static char *plain_input(const struct genome_file *f, size_t k)
{
    return new_text(f->input[k], strlen(f->input[k]));
}

static char *infix_constant(const fmpq *value, enum level *level)
{
    char *text = fmpq_get_str(NULL, 10, value), *copy = new_text(text, strlen(text));
    *level = text[0] == '-' ? LEVEL_MINUS : strchr(text, '/') ? LEVEL_PRODUCT : LEVEL_NAME;
    flint_free(text);
    return copy;
}

#define OF_INFIX(gene, text, ...) [OP_##gene] = {text "($a0)", LEVEL_NAME},
static const struct dialect infix = {.op = {[OP_NEG] = {"-$a3", LEVEL_MINUS},
                                            [OP_ADD] = {"$a0 + $b2", LEVEL_SUM},
                                            [OP_SUB] = {"$a0 - $b2", LEVEL_SUM},
                                            [OP_MUL] = {"$a1*$b3", LEVEL_PRODUCT},
                                            [OP_DIV] = {"$a1/$b3", LEVEL_PRODUCT},
                                            UNARY(OF_INFIX)[OP_MIN] = {"min($a0, $b0)", LEVEL_NAME},
                                            [OP_MAX] = {"max($a0, $b0)", LEVEL_NAME},
                                            [OP_PDIV] = {"pdiv($a0, $b0)", LEVEL_NAME}},
                                     .open = "(",
                                     .close = ")",
                                     .constant = infix_constant,
                                     .input = plain_input,
                                     .bare = true};

/* ---- LaTeX ---- */

/* Returns x, \xi, x_{1}, \mathrm{abc}, \mathrm{abc}_{12}, \mathrm{a\_1}: letters and then digits make a subscript. */
static char *latex_name(const char *plain)
{
    static const char *const greek[] = {"alpha", "beta",  "gamma", "delta", "epsilon", "zeta",  "eta", "theta",
                                        "iota",  "kappa", "mu",    "nu",    "xi",      "pi",    "rho", "sigma",
                                        "tau",   "phi",   "chi",   "psi",   "omega",   "lambda"};
    size_t letters = 0;
    while (isalpha((unsigned char)plain[letters]))
        letters++;
    const size_t digits = strspn(plain + letters, "0123456789");
    struct memory *m = memory_open();
    const bool simple = letters && !plain[letters + digits];
    bool is_greek = false;
    for (size_t i = 0; i < sizeof greek / sizeof *greek; i++)
        is_greek = is_greek || (strlen(greek[i]) == letters && strncmp(plain, greek[i], letters) == 0);
    if (simple && letters == 1)
        fputc(plain[0], m->stream);
    else if (simple)
        fprintf(m->stream, is_greek ? "\\%.*s" : "\\mathrm{%.*s}", (int)letters, plain);
    else {
        fputs("\\mathrm{", m->stream);
        for (const char *c = plain; *c; c++)
            fprintf(m->stream, *c == '_' ? "\\%c" : "%c", *c);
        fputc('}', m->stream);
    }
    if (simple && digits)
        fprintf(m->stream, "_{%s}", plain + letters);
    return memory_close(m);
}

static char *latex_input(const struct genome_file *f, size_t k)
{
    return latex_name(f->input[k]);
}

static char *latex_constant(const fmpq *value, enum level *level)
{
    bool negative;
    char *num, *den, *text;
    split_constant(value, &negative, &num, &den);
    char *whole = strchr(num, '.');
    if (whole && strcmp(whole, ".0") == 0)
        *whole = '\0';
    text = den ? new_format("%s\\frac{%s}{%s}", negative ? "-" : "", num, den)
               : new_format("%s%s", negative ? "-" : "", num);
    *level = negative ? LEVEL_MINUS : den ? LEVEL_ATOM : LEVEL_NAME;
    free(num);
    free(den);
    return text;
}

#define OF_LATEX(gene, text, value, slope, derivative, c, fortran, latex, ...) [OP_##gene] = {latex, LEVEL_ATOM},
static const struct dialect latex = {
    .op = {[OP_NEG] = {"-$a3", LEVEL_MINUS},
           [OP_ADD] = {"$a0 + $b2", LEVEL_SUM},
           [OP_SUB] = {"$a0 - $b2", LEVEL_SUM},
           [OP_MUL] = {"$a1 \\cdot $b3", LEVEL_PRODUCT},
           [OP_DIV] = {"\\frac{$a0}{$b0}", LEVEL_ATOM},
           UNARY(OF_LATEX)[OP_MIN] = {"\\min\\left($a0, $b0\\right)", LEVEL_ATOM},
           [OP_MAX] = {"\\max\\left($a0, $b0\\right)", LEVEL_ATOM},
           [OP_PDIV] = {"\\begin{cases} 1 & $b0 = 0 \\\\ \\frac{$a0}{$b0} & \\text{otherwise} \\end{cases}",
                        LEVEL_SUM}},
    .square = {"$a4^{2}", LEVEL_ATOM},
    .open = "\\left(",
    .close = "\\right)",
    .constant = latex_constant,
    .input = latex_input,
    .name = latex_name,
    .bare = true};

/* ---- files ---- */

enum { WIDTH = 200 }; /* of comments */

struct target {
    FILE *out;
    bool latex, begun;
};

static void write_formula(void *to, const char *name, long output, const char *text)
{
    struct target *t = to;
    (void)output;
    fprintf(t->out, t->latex ? "%s%s &= %s" : "%s%s = %s\n", t->latex && t->begun ? " \\\\\n" : "", name, text);
    t->begun = true;
}

static bool check_outputs(const struct genome_file *f, const struct genome *g, struct diag *d)
{
    for (size_t i = 0; i < g->outs; i++) {
        const long k = genome_find_symbol(f, g->out[i].name);
        if (k >= 0 && (size_t)k < f->inputs)
            return diag_at(d, f->path, g->out[i].line, 1,
                           "output '%s' has the name of an input, which a formula cannot tell", g->out[i].name);
    }
    return true;
}

bool formulas_print(const struct unit *u, bool as_latex, FILE *out, struct diag *d)
{
    if (as_latex)
        banner_print_as(u, NULL, "%", WIDTH, out);
    for (size_t i = 0; i < u->file->genomes; i++) {
        const struct function *f = &u->function[i];
        struct target t = {out, as_latex, false};
        if (!check_outputs(u->file, f->genome, d))
            return false;
        if (as_latex)
            banner_print_as(u, f, "%", WIDTH, out);
        fputs(as_latex ? "\\begin{align}\n" : i ? "\n" : "", out);
        struct printer *r = printer_new(u->file, f->genome, f->program, as_latex ? &latex : &infix);
        printer_run(r, write_formula, &t);
        printer_free(r);
        fputs(as_latex ? "\n\\end{align}\n" : "", out);
    }
    return true;
}
