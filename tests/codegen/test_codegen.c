/* Codegen: allowed and forbidden simplifications, operation counts, and proofs that refuse wrong code. */
#include "../../codegen/base/random.h"
#include "../../codegen/compile/compile.h"
#include "../../codegen/program/evaluate.h"
#include "../../codegen/prove/prove.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Returns true if the statements, read back, are proved to equal the file's first genome. */
static bool proved(const struct genome_file *f, const char *statements, struct diag *d)
{
    struct proof how;
    struct program *p = program_read(f, &f->genome[0], statements, d);
    const bool good = p && prove_equal(f, &f->genome[0], p, &how, d);
    program_free(p);
    return good;
}

/* Compiles `r = expression` over inputs x y z, proves it, and returns the statement that sets r, without temporaries if
 * possible. The caller must free it. */
static char *compile(const char *expression, struct operations *ops)
{
    char text[4000];
    struct diag d = {0};
    struct compiled c;
    struct compile_options o = compile_defaults();
    o.effort = 20;
    snprintf(text, sizeof text, "footpoint-genome 1\ninput x y z\ngenome g\nr = %s\nend\n", expression);
    struct genome_file *f = genome_parse("test", text, strlen(text), &d);
    if (!f || !compile_genome(f, &f->genome[0], &o, &c, &d) || !proved(f, c.text, &d))
        fail_msg("%s: %s", expression, d.text);
    genome_file_free(f);
    if (ops)
        *ops = c.ops;
    program_free(c.program);
    return c.text;
}

static void check(const char *expression, const char *statement)
{
    char *text = compile(expression, NULL);
    const char *found = strstr(text, "*out_r = ");
    assert_non_null(found);
    char *got = strdup(found + strlen("*out_r = "));
    *strrchr(got, ';') = '\0';
    assert_string_equal(got, statement);
    free(got);
    free(text);
}

static void rules_simplify_exactly(void **state)
{
    (void)state;
    check("- x x", "0.0");
    check("* 0 / x y", "0.0");
    check("/ x x", "1.0");
    check("% x x", "1.0");
    check("% x 0", "1.0");
    check("% * 6 x 2", "3.0 * in_x");
    check("* 2 x", "2.0 * in_x");                       /* may fuse with an addition; x + x where additions are cheap */
    check("% 0 x", "(in_x == 0.0 ? 1.0 : 0.0 / in_x)"); /* 1 at x = 0: protected division keeps its meaning */
    check("% * x y x", "(in_x == 0.0 ? 1.0 : t1 / in_x)");
    check("+ 1.25 * 2 0.125", "1.5");
    check("- + x y + y x", "0.0");
    check("- * + x y + x y + * x x + * 2 * x y * y y", "0.0"); /* an identity found by value */
    check("min x x", "in_x");
    check("min 2 -3", "-3.0");
    check("max 2 -3", "2.0");
    check("sqrt 2.25", "1.5");
    check("abs neg * 3 x", "3.0 * fabs(in_x)");
    check("neg neg x", "in_x");
    check("/ 1 / 1 x", "in_x");
    check("/ 7 3", "(7.0 / 3.0)");
}

/* A clamp never turns NaN into a number, and its constants are variables. */
static void clamps_keep_nan(void **state)
{
    (void)state;
    char *text = compile("max -1 min 1 x", NULL);
    assert_string_equal(text, "    double u1 = 1.0;\n"
                              "    const double t1 = (u1 < in_x ? u1 : in_x);\n"
                              "    double u2 = -1.0;\n"
                              "    const double t2 = (!(t1 <= u2) ? t1 : u2);\n"
                              "    *out_r = t2;\n");
    free(text);
}

static void operations_are_few(void **state)
{
    (void)state;
    static const struct {
        const char *expression;
        long mul, div;
    } known[] = {
        {"+ * x y * x z", 1, 0},                         /* x (y + z) */
        {"+ * * x y z + * * x y y * x y", 2, 0},         /* x y (z + y + 1) */
        {"* * * * * * * x x x x x x x x", 3, 0},         /* x^8 */
        {"+ + + 1 * x 2 * * x x 3 * * * x x x 4", 3, 0}, /* Horner: 1 + x (2 + x (3 + 4 x)) */
        {"+ * 0.35 x * 0.35 y", 1, 0},                   /* a coefficient taken out */
        {"+ / x z / y z", 0, 1},                         /* (x + y) / z */
        {"* / x z / y z", 2, 1},                         /* x y / (z z) */
        {"- * 0.25 + x y * 0.25 + x y", 0, 0},
        {"+ * - 1 x y * + 1 x z", 1, 0},                                     /* y + z + x (z - y) */
        {"+ + + * * x x x * 3 * x x * 3 x + - * y y * * 2 y z * z z", 3, 0}, /* (x + 1)^3 + (y - z)^2 - 1 */
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        struct operations ops;
        free(compile(known[i].expression, &ops));
        if (ops.mul != known[i].mul || ops.div != known[i].div)
            fail_msg("%s: %ld mul, %ld div", known[i].expression, ops.mul, ops.div);
    }
}

/* Ten-term cubics of the form (41), (42) with invented coefficients: both together in at most 25 multiplications. */
static void ten_term_cubics_take_25_products(void **state)
{
    (void)state;
    static const char text[] =
        "footpoint-genome 1\ninput xC yC zC xD yD xS yS zS\ngenome g\n"
        "xi = + + + + + + + + + * 0.35 yD * 1.7 xS * -0.4 yS * 0.9 * xC yS * 0.11 * yC yS * 0.23 * xC * yC yS\n"
        "     * 0.3 * xC * xS yS * 0.7 * * xC xC yD * 0.6 * * xD xD yS * 0.5 * yD * xS xS\n"
        "eta = + + + + + + + + + 0.1 * 1.3 xC * 0.45 yD * -0.44 yS * 0.91 * xC yS * 0.12 * yC * yD yD\n"
        "     * 0.24 * yC * yS yS * 0.31 * xC * yD yS * 0.71 * yC * xS yS * 0.62 * yD * xS yS\nend\n";
    struct diag d = {0};
    struct compiled c;
    struct compile_options o = compile_defaults();
    o.effort = 20;
    struct genome_file *f = genome_parse("pair", text, sizeof text - 1, &d);
    assert_non_null(f);
    assert_true(compile_genome(f, &f->genome[0], &o, &c, &d));
    assert_true(proved(f, c.text, &d));
    assert_true(c.ops.mul <= 25);
    compiled_free(&c);
    genome_file_free(f);
}

/* Multiples of a quotient that other values share have its numerator as their unit. */
static void multiples_of_a_quotient_share_it(void **state)
{
    (void)state;
    static const char *const texts[] = {
        "footpoint-genome 1\ninput x y\nlet r = / 1.00007 y\nlet a = * * r x 4\nlet b = * 4 r\ngenome g\n"
        "p = - a r\nq = - b * r + 1 * a min b 1.3\nend\n",
        "footpoint-genome 1\ninput x s d\nlet e = * x x\nlet i = / 1 e\nlet k = * 0.7 * x i\ngenome g\n"
        "r = + - * e - d * s k * - x i - d k * i k\nend\n"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++)
        for (long effort = 0; effort <= 20; effort += 20) {
            struct diag d = {0};
            struct compiled c;
            struct compile_options o = compile_defaults();
            o.effort = effort;
            struct genome_file *f = genome_parse("shared", texts[k], strlen(texts[k]), &d);
            assert_non_null(f);
            assert_true(compile_genome(f, &f->genome[0], &o, &c, &d));
            if (!proved(f, c.text, &d))
                fail_msg("%s\n%s", d.text, c.text);
            compiled_free(&c);
            genome_file_free(f);
        }
}

/* Proofs find a wrong sign, operand or constant in the emitted text. */
static void wrong_code_is_refused(void **state)
{
    (void)state;
    static const char text[] = "footpoint-genome 1\ninput x y z\ngenome g\nr = + * x + y 0.3 / sqrt z + y 2\nend\n";
    struct diag d = {0};
    struct compiled c;
    struct compile_options o = compile_defaults();
    o.effort = 20;
    struct genome_file *f = genome_parse("proof", text, sizeof text - 1, &d);
    assert_true(compile_genome(f, &f->genome[0], &o, &c, &d));
    assert_true(proved(f, c.text, &d));
    size_t refused = 0, tried = 0;
    for (char *at = c.text; *at; at++) {
        const char kept = *at;
        const char *swap = strchr("+--+*//*34x-yz", kept);
        if (!swap || at[-1] == 't' || strncmp(at, "*out", 4) == 0)
            continue;
        *at = kept == '+'   ? '-'
              : kept == '-' ? '+'
              : kept == '*' ? '/'
              : kept == '/' ? '*'
              : kept == 'x' ? 'y'
              : kept == 'y' ? 'x'
              : kept == '3' ? '4'
                            : kept;
        if (*at != kept) {
            tried++;
            refused += !proved(f, c.text, &d);
        }
        *at = kept;
    }
    assert_true(tried >= 6);
    assert_int_equal(refused, tried);
    compiled_free(&c);
    genome_file_free(f);
}

/* Random genomes with shared parts are proved and never cost more than their genes. */
static void random_genomes_never_cost_more(void **state)
{
    (void)state;
    const int genomes = getenv("FOOTPOINT_LONG") ? 300 : 120;
    uint64_t seed = 7;
    for (int n = 0; n < genomes; n++) {
        char text[4000];
        size_t size = 0;
        long missing = 1, operators = 0;
        const int length = 5 + n % 120;
        for (int k = 0; missing > 0; k++) {
            seed = seed * 6364136223846793005u + 1442695040888963407u;
            const unsigned r = (unsigned)(seed >> 40);
            const bool leaf = k >= length || (missing == 1 && k > 3 ? r % 8 == 0 : r % 2 == 0);
            static const char *const leaves[] = {"x", "y", "z", "0.05", "-1.25", "2"};
            static const char *const genes[] = {"+", "-", "*", "%"};
            size +=
                (size_t)snprintf(text + size, sizeof text - size, " %s", leaf ? leaves[r / 16 % 6] : genes[r / 16 % 4]);
            missing += leaf ? -1 : 1;
            operators += !leaf;
        }
        struct operations ops;
        free(compile(text, &ops));
        assert_true(ops.mul + ops.div + ops.add <= operators + 2);
    }
}

/* Evaluates the outputs of a segment's function at a random face, moved by a whole number of edges. Coordinates are
 * multiples of 2^-32, so up to 2^21 they and their differences are doubles, but their sums are not. */
static void evaluate_moved(const struct program *p, uint64_t seed, double shift, double out[2])
{
    double *value = new_array(p->ops, sizeof *value), *input = new_array(p->inputs, sizeof *input);
    point_constants(p, value);
    for (size_t i = 0; i < p->inputs; i++)
        input[i] = shift + (double)(random_next(&seed) >> 31) * 0x1p-32 - 1;
    point_double(p, input, NULL, value);
    for (size_t k = 0; k < 2; k++)
        out[k] = value[p->output[k]];
    free(value);
    free(input);
}

static void check_far(const struct genome_file *f, size_t k, const struct cost_model *cost)
{
    struct diag d = {0};
    struct compiled c;
    struct compile_options o = compile_defaults();
    o.effort = getenv("FOOTPOINT_LONG") ? 500 : 0;
    o.cost = *cost;
    assert_true(compile_genome(f, &f->genome[k], &o, &c, &d));
    for (uint64_t seed = 1; seed <= 50; seed++) {
        double near[2], far[2];
        evaluate_moved(c.program, seed, 0, near);
        evaluate_moved(c.program, seed, 1.5e6, far);
        if (memcmp(near, far, sizeof near) != 0)
            fail_msg("%s, %s, cost %s: %a %a, far away %a %a", f->path, f->genome[k].name, cost->name, near[0], near[1],
                     far[0], far[1]);
    }
    compiled_free(&c);
}

/* Differences of nodes come first, whatever the cost of operations, so a face a million edges away loses no digit. */
static void far_faces_lose_nothing(void **state)
{
    (void)state;
    static const char *const genomes[] = {"quad4", "tri3"};
    static const char *const known[] = {"paper", "codegen/costs/sse2.costs", "codegen/costs/avx2.costs",
                                        "codegen/costs/avx512.costs"};
    static const struct cost_model own[] = {{"dear mul", 9, 1, 1, 1, 1}, {"free add", 1, 0, 8, 12, 1}};
    const size_t n = sizeof known / sizeof *known;
    const bool all = getenv("FOOTPOINT_LONG") != NULL;
    for (size_t g = 0; g < (all ? 2 : 1); g++) {
        char path[40];
        struct diag d;
        snprintf(path, sizeof path, "evolve/genomes/%s.gen", genomes[g]);
        struct genome_file *f = genome_read(path, &d);
        for (size_t i = 0; i < n + sizeof own / sizeof *own; i++) {
            struct cost_model cost;
            if (i < n)
                assert_true(cost_model_find(known[i], &cost, &d));
            else
                cost = own[i - n];
            for (size_t k = 0; k < (all && f->genomes > 4 ? 4 : 1); k++)
                check_far(f, k, &cost);
        }
        genome_file_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rules_simplify_exactly),
        cmocka_unit_test(clamps_keep_nan),
        cmocka_unit_test(operations_are_few),
        cmocka_unit_test(ten_term_cubics_take_25_products),
        cmocka_unit_test(wrong_code_is_refused),
        cmocka_unit_test(random_genomes_never_cost_more),
        cmocka_unit_test(multiples_of_a_quotient_share_it),
        cmocka_unit_test(far_faces_lose_nothing),
    };
    return cmocka_run_group_tests_name("codegen", tests, NULL, NULL);
}
