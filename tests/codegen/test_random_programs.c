/* Codegen on random programs like those of searches: named values that share divisors, protected quotients, nested
 * minima and maxima, constants close to 1. Each compiled program is proved equal.
 *   random_programs_are_proved [COUNT [FIRST]]    COUNT programs, from number FIRST on; 20000 with FOOTPOINT_LONG */
#include "../../codegen/base/text.h"
#include "../../codegen/compile/compile.h"
#include "../../codegen/prove/prove.h"
#include "../support/long_cases.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static uint64_t count = 60, first = 1;

/* A program under construction. */
struct writer {
    uint64_t state;
    struct growing text;
    const char *const *input; /* names, ended by NULL */
    int inputs, lets;
    const char *own;                   /* a constant that recurs */
    enum { TREES, SUMS, STEPS } style; /* of outputs; in STEPS, each named value is one operation on others */
    const char *operators;             /* choices, one letter each; see write_operation */
};

static const char *const familiar[] = {"1", "-1", "2", "0.5", "0.25", "4", "-3", "0.1", "1.00003", "1.16612"};

static unsigned below(struct writer *w, unsigned n)
{
    uint64_t z = w->state += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return (unsigned)((z ^ z >> 31) % n);
}

/* Writes a constant; every other one is the program's own, so that coefficients meet. */
static void write_constant(struct writer *w)
{
    char number[32];
    if (below(w, 2))
        snprintf(number, sizeof number, " %s", w->own);
    else if (below(w, 4) > 0)
        snprintf(number, sizeof number, " %s", familiar[below(w, sizeof familiar / sizeof *familiar)]);
    else
        snprintf(number, sizeof number, " %s%u.%08u", below(w, 2) ? "-" : "", below(w, 3), 1 + below(w, 99999999));
    growing_add(&w->text, number);
}

static void write_leaf(struct writer *w)
{
    char name[16];
    if (below(w, 6) == 0) {
        write_constant(w);
        return;
    }
    if (w->style != TREES && w->lets > 0 && below(w, 3) == 0) /* the value that all others share */
        snprintf(name, sizeof name, " v0");
    else if (w->lets > 0 && below(w, 5) < 3)
        snprintf(name, sizeof name, " v%u", below(w, (unsigned)w->lets));
    else
        snprintf(name, sizeof name, " %s", w->input[below(w, (unsigned)w->inputs)]);
    growing_add(&w->text, name);
}

static void write_expression(struct writer *w, unsigned depth);

/* Writes an operator and its operands. */
static void write_operation(struct writer *w, unsigned depth)
{
    const char letter = w->operators[below(w, (unsigned)strlen(w->operators))];
    if (letter == 'c') { /* a clamp */
        growing_add(&w->text, " max -1.2 min 1.2");
        write_expression(w, depth);
    } else if (letter == 's' || letter == 'a' || letter == 'n') {
        growing_add(&w->text, letter == 's' ? " sqrt" : letter == 'a' ? " abs" : " neg");
        write_expression(w, depth);
    } else if (letter == 'k') { /* a multiple */
        growing_add(&w->text, " *");
        write_constant(w);
        write_expression(w, depth);
    } else {
        const char name[] = {' ', letter, '\0'};
        growing_add(&w->text, letter == '<' ? " min" : letter == '>' ? " max" : name);
        write_expression(w, depth);
        write_expression(w, depth);
    }
}

/* Writes an expression at most `depth` operations deep. */
static void write_expression(struct writer *w, unsigned depth)
{
    if (depth == 0 || below(w, 5) == 0)
        write_leaf(w);
    else
        write_operation(w, depth - 1);
}

/* Writes a sum of products of leaves, like the result of multiplying out. */
static void write_sum(struct writer *w)
{
    for (unsigned terms = 1 + below(w, 4); terms > 0; terms--) {
        growing_add(&w->text, terms == 1 ? "" : below(w, 2) ? " +" : " -");
        for (unsigned factors = 1 + below(w, 3); factors > 1; factors--) {
            growing_add(&w->text, " *");
            write_leaf(w);
        }
        if (below(w, 3) == 0) {
            growing_add(&w->text, " *");
            write_constant(w);
        }
        write_leaf(w);
    }
}

/* Writes a value that deserves a name: a quotient by a leaf or by a sum, a multiple, a product or a choice. */
static void write_named(struct writer *w)
{
    const unsigned form = w->lets == 0 ? 0 : w->style == SUMS ? below(w, 8) : 2 + below(w, 6);
    if (form < 2) {
        growing_add(&w->text, " /");
        if (below(w, 2))
            write_constant(w);
        else
            write_leaf(w);
        if (w->style == STEPS || below(w, 2))
            write_leaf(w);
        else
            write_sum(w);
    } else if (form < 5) {
        growing_add(&w->text, " *");
        write_constant(w);
        write_leaf(w);
    } else if (form == 5) {
        growing_add(&w->text, " *");
        write_leaf(w);
        write_leaf(w);
    } else
        write_operation(w, w->style == STEPS ? below(w, 2) : below(w, 3));
}

/* Returns the program with a given number; the caller must free it. */
static char *random_program(uint64_t number)
{
    static const char *const operators[] = {"++--***k", "++--***/k", "+-**//k",      "+-**/k<>",
                                            "+-**/%%k", "+-**%<>ck", "+-*/%<>csank", "+-**//%<>k"};
    static const char *const few[] = {"x", "y", NULL}, *const some[] = {"x", "y", "s", "d", "t", NULL},
                             *const nodes[] = {"xA", "yA", "zA", "xB", "yB", "zB", "xC",
                                               "yC", "zC", "xS", "yS", "zS", NULL};
    static const char *const heads[] = {"input x y\n", "input x y s d t\n",
                                        "input xA yA zA xB yB zB xC yC zC xS yS zS\nsegment tri3 any\n"};
    const char *const *const inputs[] = {few, some, nodes};
    struct writer w = {.state = number * 3};
    const unsigned form = below(&w, 7) % 3, lets = below(&w, 9), outputs = form == 2 ? 2 : 1 + below(&w, 3);
    w.own = familiar[below(&w, sizeof familiar / sizeof *familiar)];
    w.style = below(&w, 4) % 3;
    char head[32];
    w.input = inputs[form];
    while (w.input[w.inputs])
        w.inputs++;
    growing_add(&w.text, "footpoint-genome 1\n");
    growing_add(&w.text, heads[form]);
    w.operators = operators[below(&w, sizeof operators / sizeof *operators)];
    for (; (unsigned)w.lets < lets; w.lets++) {
        snprintf(head, sizeof head, "let v%d =", w.lets);
        growing_add(&w.text, head);
        if (w.style == TREES)
            write_operation(&w, below(&w, 3));
        else
            write_named(&w);
        growing_add(&w.text, "\n");
    }
    growing_add(&w.text, "genome g\n");
    for (unsigned k = 0; k < outputs; k++) {
        snprintf(head, sizeof head, "%s =", form == 2 ? (k == 0 ? "xi" : "eta") : k == 0 ? "p" : k == 1 ? "q" : "r");
        growing_add(&w.text, head);
        if (w.style != TREES && below(&w, 3) > 0)
            write_sum(&w);
        else
            write_operation(&w, w.style == STEPS ? below(&w, 2) : 1 + below(&w, 5));
        growing_add(&w.text, "\n");
    }
    growing_add(&w.text, "end\n");
    return w.text.text;
}

/* Compiles a program and returns true; a failure must have a message. */
static bool compile(const char *text, uint64_t number)
{
    static const char *const model[] = {"throughput", "throughput", "throughput", "operations", "paper"};
    static const long effort[] = {0, 0, 0, 1, 5};
    struct diag d = {0};
    struct compiled c;
    struct proof how;
    struct compile_options o = compile_defaults();
    struct genome_file *f = genome_parse("random", text, strlen(text), &d);
    if (!f)
        fail_msg("%s\n%s", d.text, text);
    cost_model_find(model[number % 5], &o.cost, &d);
    o.effort = effort[number / 5 % 5];
    const bool compiled = compile_genome(f, &f->genome[0], &o, &c, &d);
    if (compiled) {
        if (!prove_equal(f, &f->genome[0], c.program, &how, &d))
            fail_msg("program %llu: %s\n%s%s", (unsigned long long)number, d.text, text, c.text);
        compiled_free(&c);
    } else if (!strstr(d.text, "always 0") && !strstr(d.text, "always negative"))
        fail_msg("program %llu: %s\n%s", (unsigned long long)number, d.text, text);
    genome_file_free(f);
    return compiled;
}

static void random_programs_are_proved(void **state)
{
    (void)state;
    uint64_t compiled = 0;
    for (uint64_t number = first; number < first + count; number++) {
        char *text = random_program(number);
        compiled += compile(text, number);
        free(text);
    }
    assert_true(10 * compiled >= 9 * count);
}

int main(int argc, char **argv)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(random_programs_are_proved)};
    count = (uint64_t)long_cases((long)count, 20000);
    if (argc > 1)
        count = strtoull(argv[1], NULL, 10);
    if (argc > 2)
        first = strtoull(argv[2], NULL, 10);
    return cmocka_run_group_tests_name("random programs", tests, NULL, NULL);
}
