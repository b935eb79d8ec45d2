/* Genome text of version 3: infix expressions read as their prefix forms, and refusals point to the wrong word. */
#include "../../codegen/genome/genome.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

static const char infix[] = "footpoint-genome 3 # infix\n"
                            "note scene -made up- # not a comment, (\n"
                            "segment tri3 any\n"
                            "range A 0 1 -2 1e-3 0 1, xS 0 1,\n"
                            "    B 0 1 0 1 0 1\n"
                            "region\n"
                            "input vector A vector ex vector ey t xi eta\n"
                            "let B=ex, C = ey + t*ex\n"
                            "let S = xi*B + eta*C\n"
                            "require 1 - (xi + eta)\n"
                            "end\n"
                            "let ab = B - A, # a comment\n"
                            "\n"
                            "    ac =\n"
                            "    C - A\n"
                            "function step u vector w -> un normal\n"
                            "    let normal = cross(w,\n"
                            "        ab)\n"
                            "    let un = dot(u*w, normal), two=2\n"
                            "end\n"
                            "let r n = step(-xS/2, -S + (ab -\n"
                            "    2*ac))\n"
                            "let slope = derivative(r, S)\n"
                            "exchange abx acx\n"
                            "least abs(r) % 3, min(r, max(-1, -abx))\n"
                            "require 0.5 - abs(t - xi)\n"
                            "genome one\n"
                            "note error 1*2\n"
                            "xi = r, eta = sqrt(slopex*slopex +\n"
                            "    1)\n"
                            "end\n";

static const char prefix[] = "footpoint-genome 2\n"
                             "note scene -made up- # not a comment, (\n"
                             "segment tri3 any\n"
                             "range A 0 1 -2 1e-3 0 1, xS 0 1, B 0 1 0 1 0 1\n"
                             "region\n"
                             "input vector A vector ex vector ey t xi eta\n"
                             "let B = ex, C = + ey * t ex\n"
                             "let S = + * xi B * eta C\n"
                             "require - 1 + xi eta\n"
                             "end\n"
                             "let ab = - B A, ac = - C A\n"
                             "function step u vector w -> un normal\n"
                             "    let normal = cross w ab\n"
                             "    let un = dot * u w normal, two = 2\n"
                             "end\n"
                             "let r n = step / neg xS 2 + neg S - ab * 2 ac\n"
                             "let slope = derivative r S\n"
                             "exchange abx acx\n"
                             "least % abs r 3, min r max -1 neg abx\n"
                             "require - 0.5 abs - t xi\n"
                             "genome one\n"
                             "note error 1*2\n"
                             "xi = r\n"
                             "eta = sqrt + * slopex slopex 1\n"
                             "end\n";

static char *print_text(const char *text)
{
    struct diag d = {.text = ""};
    char *printed;
    size_t size;
    struct genome_file *f = genome_parse("text", text, strlen(text), &d);
    assert_string_equal(d.text, "");
    assert_non_null(f);
    FILE *stream = open_memstream(&printed, &size);
    genome_print(f, stream);
    fclose(stream);
    genome_file_free(f);
    return printed;
}

static void assert_same(const char *a, const char *b)
{
    char *of_a = print_text(a), *of_b = print_text(b), *again = print_text(of_a);
    assert_string_equal(of_a, of_b);
    assert_string_equal(of_a, again);
    free(of_a);
    free(of_b);
    free(again);
}

static void infix_prints_as_prefix(void **state)
{
    (void)state;
    assert_same(infix, prefix);
}

/* Commas separate the values of a row and of requires; another output may follow in the line. */
static void commas_separate_rows(void **state)
{
    (void)state;
    assert_same("footpoint-genome 3\nface tri3\ngenome g\nrequire 1 - xi, eta\n"
                "p = A - xi*B, -xi, -(2*eta),\n    3, q = C\nr = 1\nend\n",
                "footpoint-genome 2\nface tri3\ngenome g\nrequire - 1 xi eta\n"
                "p = - A * xi B neg xi neg * 2 eta 3\nq = C\nr = 1\nend\n");
}

static void precedence_is_usual(void **state)
{
    (void)state;
    static const char *const same[][2] = {
        {"a - b + c", "+ - a b c"},
        {"a - (b + c)", "- a + b c"},
        {"a/b*c % d", "% * / a b c d"},
        {"a/(b*c)", "/ a * b c"},
        {"a + b*c - d", "- + a * b c d"},
        {"(a + b)*(c - d)", "* + a b - c d"},
        {"-a*b + c", "+ * neg a b c"},
        {"-(a*b)", "neg * a b"},
        {"a - -b", "- a neg b"},
        {"a*-b*c", "* * a neg b c"},
        {"--a", "neg neg a"},
        {"-2*a", "* -2 a"},
        {"- 2*a", "* neg 2 a"},
        {"a-1", "- a 1"},
        {"a -1", "- a 1"},
        {"a - -1", "- a -1"},
        {"1e-3*a-2.5E+1", "- * 1e-3 a 2.5E+1"},
        {"1e3-a", "- 1e3 a"},
        {".5*a", "* .5 a"},
        {"((a))", "a"},
        {"min(a, max(b, c + 1))", "min a max b + c 1"},
        {"sqrt(abs(a - b)*2)", "sqrt * abs - a b 2"},
        {"neg(a)", "neg a"},
        {"a +\nb\n", "+ a b"},
        {"(a\n+ b\n)", "+ a b"},
    };
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        char text[2][200];
        for (int k = 0; k < 2; k++)
            snprintf(text[k], sizeof text[k], "footpoint-genome %d\ninput a b c d\nlet r = %s\n", 3 - k, same[i][k]);
        assert_same(text[0], text[1]);
    }
}

static void refusals_point_to_the_word(void **state)
{
    (void)state;
    static const char *const bad[][2] = {
        {"let r = a +", "4:1: error: expected an operand at the end of the file"},
        {"let r =\nlet s = a", "4:1: error: expected an operand before 'let'"},
        {"let r = a * / b", "3:13: error: expected an operand before '/'"},
        {"let r = + a b", "3:9: error: expected an operand before '+'"},
        {"let r = - a b", "3:13: error: expected an operator before 'b'"},
        {"let r = (a + b", "4:1: error: expected ')' at the end of the file"},
        {"let r = f(a", "4:1: error: expected ')' at the end of the file"},
        {"let r = a + b)", "3:14: error: ')' needs '('"},
        {"let r = (a, b)", "3:11: error: ',' must not be inside grouping parentheses"},
        {"let r = a(b)*2", "3:13: error: unexpected '*'"},
        {"let r = 2*f(b)", "3:11: error: 'f' must not be called inside an expression"},
        {"let r = f(b)", "3:9: error: unknown gene 'f'"},
        {"let r = 2*derivative(a, b)", "3:11: error: 'derivative' must not be called inside an expression"},
        {"let r = min(a)", "3:14: error: expected two operands before ')'"},
        {"let r = abs(a, b)", "3:17: error: expected one operand before ')'"},
        {"let r = max a b", "3:9: error: 'max' needs '(' and its operands"},
        {"let r = sqrt", "3:9: error: 'sqrt' needs '(' and its operands"},
        {"let r = ()", "3:10: error: expected an operand before ')'"},
        {"let r = a = b", "3:11: error: expected an operator before '='"},
        {"let r s + b", "3:9: error: '+' must be a name"},
        {"let r", "3:6: error: expected '=' after 'r'"},
        {"let r = a,", "4:1: error: let needs a name"},
        {"let r = a +\n   2*(b - u)", "4:11: error: unknown gene 'u'"},
        {"let r = 1.2.3*a", "3:9: error: '1.2.3' must be a decimal number"},
        {"let r = a^2", "3:9: error: unknown gene 'a^2'"},
        {"require a > b", "3:11: error: expected an operator before '>'"},
        {"let v = e + 1", "3:11: error: '+' of a vector and a number"},
        {"let v = dot(e, 2*a)", "3:9: error: 'dot' of a vector and a number"},
        {"range a 0 -x", "3:11: error: '-x' must be a decimal number"},
        {"least a b", "3:9: error: expected an operator before 'b'"},
        {"genome g\nr - a\nend", "4:1: error: expected '=' after 'r'"},
        {"genome g\nr = a, b\nend", "4:8: error: unexpected gene 'b' after a complete expression"},
        {"genome g\nr = a,\nend", "5:1: error: expected an operand before 'end'"},
        {"genome g\nr = a", "5:1: error: genome 'g' has no 'end'"},
        {"frob a*b", "3:1: error: unknown keyword 'frob'"},
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        char text[200], wanted[200];
        struct diag d;
        snprintf(text, sizeof text, "footpoint-genome 3\ninput a b vector e\n%s\n", bad[i][0]);
        snprintf(wanted, sizeof wanted, "frame:%s", bad[i][1]);
        assert_null(genome_parse("frame", text, strlen(text), &d));
        assert_string_equal(d.text, wanted);
    }
}

/* Neither parentheses nor signs nor operators of the right need a deep stack of calls. */
static void deep_expressions_need_no_deep_stack(void **state)
{
    (void)state;
    enum { N = 100000 };
    static const char *const begin[] = {"(", "-", "1+(", "1+", "abs("}, *const end[] = {")", "", ")", "", ")"};
    char *text = malloc(10 * N);
    for (size_t k = 0; k < sizeof begin / sizeof *begin; k++) {
        struct diag d;
        char *to = stpcpy(text, "footpoint-genome 3\ninput a\ngenome g\nr = ");
        for (int i = 0; i < N; i++)
            to = stpcpy(to, begin[k]);
        *to++ = 'a';
        for (int i = 0; i < N; i++)
            to = stpcpy(to, end[k]);
        to = stpcpy(to, "\nend\n");
        struct genome_file *f = genome_parse("deep", text, (size_t)(to - text), &d);
        assert_non_null(f);
        assert_int_equal(f->genome[0].out[0].length, k == 0 ? 1 : k == 1 || k == 4 ? N + 1 : 2 * N + 1);
        genome_file_free(f);
    }
    free(text);
}

/* Every truncation and thousands of mutations of a text end in a program or in one line. */
static void hostile_text_is_refused_in_one_line(void **state)
{
    (void)state;
    const size_t length = sizeof infix - 1;
    uint64_t seed = 1;
    char text[sizeof infix];
    for (size_t n = 0; n < length + 20000; n++) {
        struct diag d = {0};
        const size_t size = n < length ? n : length;
        memcpy(text, infix, sizeof infix);
        for (int k = 0; n >= length && k < 3; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            static const char letters[] = "+-*/%(),= \n#x1.e\0\xff";
            text[(seed >> 33) % size] = letters[(seed >> 20) % (sizeof letters - 1)];
        }
        struct genome_file *f = genome_parse("hostile", text, size, &d);
        assert_true(f || (d.code == EXIT_INPUT && strncmp(d.text, "hostile:", 8) == 0 && !strchr(d.text, '\n')));
        genome_file_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(infix_prints_as_prefix),
        cmocka_unit_test(commas_separate_rows),
        cmocka_unit_test(precedence_is_usual),
        cmocka_unit_test(refusals_point_to_the_word),
        cmocka_unit_test(deep_expressions_need_no_deep_stack),
        cmocka_unit_test(hostile_text_is_refused_in_one_line),
    };
    return cmocka_run_group_tests_name("infix", tests, NULL, NULL);
}
