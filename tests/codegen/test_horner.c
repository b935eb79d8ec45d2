/* Factors taken out: Horner's rule for several variables, and factors over the rationals. */
#include "../../codegen/passes/expand.h"
#include "../../codegen/passes/horner.h"
#include "../support/graph_text.h"

static struct dag *horner(const struct dag *g)
{
    return horner_factor(g, &(struct policy){0}, NULL);
}

static struct dag *horner_plain(const struct dag *g)
{
    return horner_factor(g, &(struct policy){.plain = true}, NULL);
}

static void factors_are_taken_out(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"+ * a b * a c", "a*(b + c)", 1, 1, 0},
        {"- * a b * a c", "a*(b - c)", 1, 1, 0},
        {"+ * a b a", "a*(1 + b)", 1, 1, 0},
        /* powers: one at a time from the inside */
        {"+ * x * x x + * 2 * x x x", "x*(1 + x*(2 + x))", 2, 2, 0},
        {"+ 1 + x + * x x * x * x x", "1 + x*(1 + x*(1 + x))", 2, 3, 0},
        {"+ * x x * y * x * x x", "x^2*(1 + x*y)", 3, 1, 0},
        {"+ 3 * 5 * * x x * x x", "5*(0.6 + x^4)", 4, 1, 0},
        {"+ * x * x * x x * x x", "x^2*(1 + x^2)", 3, 1, 0},
        /* the factor of most terms comes out first */
        {"+ * x y + * x z + * x a * b y", "b*y + x*(a + y + z)", 2, 3, 0},
        {"+ * a * b c + * a * b d * a x", "a*(b*(c + d) + x)", 2, 2, 0},
        /* the factored rest may be a factor of other terms */
        {"+ * a c + * a d + * b c * b d", "(a + b)*(c + d)", 1, 2, 0},
        /* coefficients stay with their terms */
        {"+ * * 2 x y * * 3 x z", "2*x*(y + 1.5*z)", 3, 1, 0},
        /* inside functions and divisors */
        {"sqrt + * x y * x z", "sqrt(x*(y + z))", 1, 1, 0},
        {"/ 1 + * x y * x z", "1/(x*(y + z))", 1, 1, 1},
        /* a sum that is a term of only one other sum becomes part of it */
        {"let s = + * a b c\ngenome g\nr = + s * a d", "a*(b + d) + c", 1, 2, 0},
        /* nothing in common */
        {"+ x y", NULL, 0, 0, 0},
        {"+ * a b * c d", NULL, 0, 0, 0},
        {"* + a b + a c", NULL, 0, 0, 0},
        {"+ 1 * x x", NULL, 0, 0, 0},
        {"+ sqrt x sqrt y", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(horner, row);
}

/* Nothing is factored if the policy forbids it. */
static void policies_forbid_factoring(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"+ * a b * a c", NULL, 0, 0, 0},
        {"+ * x * x x + * 2 * x x x", NULL, 0, 0, 0},
        {"let s = + * a b c\ngenome g\nr = + s * a d", "a*b + a*d + c", 2, 2, 0},
    };
    CHECK_GRAPHS(horner_plain, row);
}

/* a b + a c + b d, factored by a, by b, or not at all: the policy's decisions are recorded and can be overruled. */
static void choices_are_recorded_and_overruled(void **state)
{
    (void)state;
    static const char *const expected[] = {"a*b + a*c + b*d", "a*(b + c) + b*d", "a*c + b*(a + d)"};
    struct record record = {0};
    struct genome_file *f = row_file("+ + * a b * a c * b d");
    struct dag *g = row_graph(f);
    bool met[3] = {false};
    dag_free(horner_factor(g, &(struct policy){0}, &record));
    assert_true(record.decisions > 0);
    assert_int_equal(record.decision[0].alternatives, 3);
    for (size_t i = 0; i < 3; i++) {
        struct policy p = {0};
        policy_choose(&p, (struct choice){record.decision[0].key, record.alternative[i]});
        struct dag *made = horner_factor(g, &p, NULL);
        char *text = graph_text(f, made);
        for (size_t k = 0; k < 3; k++)
            met[k] |= strcmp(text, expected[k]) == 0;
        check_values(f, made);
        free(text);
        dag_free(made);
        policy_clear(&p);
    }
    assert_true(met[0] && met[1] && met[2]);
    record_clear(&record);
    dag_free(g);
    genome_file_free(f);
}

static void sums_are_factored_over_the_rationals(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"- * x x * y y", "(x + y)*(x - y)", 1, 2, 0},
        {"- * x x 1", "(-1 + x)*(1 + x)", 1, 2, 0},
        {"+ + * x x * * 2 x y * y y", "(x + y)^2", 1, 1, 0},
        {"- * x * x x 1", "(-1 + x)*(1 + x + x^2)", 2, 3, 0},
        {"+ + * x x * 5 x 6", "(2 + x)*(3 + x)", 1, 2, 0},
        {"+ * a c + * a d + * b c * b d", "(a + b)*(c + d)", 1, 2, 0},
        {"+ * x x x", "x*(1 + x)", 1, 1, 0},
        /* quotients cancel common factors */
        {"/ - * x x * y y + x y", "x - y", 0, 1, 0},
        {"/ + * x x * x y + * x z x", "(x + y)/(1 + z)", 0, 2, 1},
        /* irreducible over the rationals */
        {"+ * x x * y y", NULL, 0, 0, 0},
        {"- * x x 2", NULL, 0, 0, 0},
        {"+ x y", NULL, 0, 0, 0},
        {"+ 1 + x * x x", NULL, 0, 0, 0},
        {"/ + x y + x z", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(shape_factor, row);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(factors_are_taken_out),
        cmocka_unit_test(policies_forbid_factoring),
        cmocka_unit_test(choices_are_recorded_and_overruled),
        cmocka_unit_test(sums_are_factored_over_the_rationals),
    };
    return cmocka_run_group_tests_name("horner", tests, NULL, NULL);
}
