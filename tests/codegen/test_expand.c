/* Forms of the same values: multiplied out, with common denominators, with one division for several. */
#include "../../codegen/passes/expand.h"
#include "../support/graph_text.h"

static struct dag *expand(const struct dag *g)
{
    return shape_dissolve(g, &(struct policy){.dissolve = 1}, NULL);
}

static struct dag *expand_nothing(const struct dag *g)
{
    return shape_dissolve(g, &(struct policy){0}, NULL);
}

static struct dag *expand_but_differences(const struct dag *g)
{
    return shape_dissolve(g, &(struct policy){.dissolve = 1, .differences = true}, NULL);
}

static struct dag *combine(const struct dag *g)
{
    return shape_combine(g, &(struct policy){.combine = 1}, NULL);
}

static void sums_are_multiplied_out(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"* a + b c", "a*b + a*c", 2, 1, 0},
        {"* + a b + c d", "a*c + a*d + b*c + b*d", 4, 3, 0},
        {"* + x y - x y", "x^2 - y^2", 2, 1, 0},
        {"* + x 1 + x 1", "2*(0.5 + x + 0.5*x^2)", 3, 2, 0},
        {"* + x 1 * + x 1 + x 1", "3*((1.0 / 3.0) + x + x^2 + (1.0 / 3.0)*x^3)", 5, 3, 0},
        {"* - x 1 + 1 + x * x x", "-1 + x^3", 2, 1, 0},
        {"- * + x y + x y * - x y - x y", "4*x*y", 2, 0, 0},
        {"* x + 1 * x + 2 * x x", "x + 2*x^2 + x^4", 5, 2, 0},
        /* inside a quotient, numerator and divisor each */
        {"/ * a + b c d", "t1 = 1/d; r = t1*a*b + t1*a*c", 4, 1, 1},
        {"/ 1 * x + y z", "1/(x*y + x*z)", 2, 1, 1},
        /* inside functions */
        {"sqrt * a + b c", "sqrt(a*b + a*c)", 2, 1, 0},
        {"max x * y + x 1", "max(x,x*y + y)", 1, 1, 0},
        /* nothing to multiply out */
        {"+ * a b * c d", NULL, 0, 0, 0},
        {"* a * b c", NULL, 0, 0, 0},
        {"sqrt + x y", NULL, 0, 0, 0},
        {"* sqrt + x y z", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(expand, row);
}

/* One policy dissolves nothing; another keeps differences of inputs, which are exact. */
static void policies_limit_expansion(void **state)
{
    (void)state;
    static const struct graph_row none[] = {
        {"* a + b c", NULL, 0, 0, 0},
        {"* + x y - x y", NULL, 0, 0, 0},
        {"+ 1 * x + 2 x", NULL, 0, 0, 0},
    };
    static const struct graph_row differences[] = {
        {"* a - b c", NULL, 0, 0, 0},
        {"* - a b - c d", NULL, 0, 0, 0},
        {"* a + b c", "a*b + a*c", 2, 1, 0},
        {"* - a b + c d", "t1 = a - b; r = c*t1 + d*t1", 2, 2, 0},
    };
    CHECK_GRAPHS(expand_nothing, none);
    CHECK_GRAPHS(expand_but_differences, differences);
}

static void denominators_are_combined(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"+ / a b / c d", "(a*d + b*c)/(b*d)", 3, 1, 1},
        {"+ / a b / c b", "(a + c)/b", 0, 1, 1},
        {"+ a / b c", "(a*c + b)/c", 1, 1, 1},
        {"- / 1 x / 1 y", "-(x - y)/(x*y)", 1, 1, 1},
        {"+ / 1 x / 1 * x y", "(1 + y)/(x*y)", 1, 1, 1},
        {"+ / a * x x / b x", "(a + b*x)/(x^2)", 2, 1, 1},
        /* quotients inside quotients disappear */
        {"/ a + b / c d", "a*d/(b*d + c)", 2, 1, 1},
        {"/ + 1 / x y - 1 / x y", "-(x + y)/(x - y)", 0, 2, 1},
        {"/ 1 + / 1 x / 1 y", "x*y/(x + y)", 1, 1, 1},
        /* inside a function, but not through it */
        {"sqrt + / a b / c b", "sqrt((a + c)/b)", 0, 1, 1},
        {"+ sqrt / a b sqrt / c b", NULL, 0, 0, 0},
        /* nothing to combine */
        {"/ a b", NULL, 0, 0, 0},
        {"+ * a b c", NULL, 0, 0, 0},
        {"/ + a b c", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(combine, row);
}

static void divisions_are_joined(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"genome g\nr = / 1 x\nq = / 1 y", "t1 = 1/(x*y); r = t1*y; q = t1*x", 3, 0, 1},
        {"genome g\nr = / a x\nq = / b y", "t1 = 1/(x*y); r = t1*a*y; q = t1*b*x", 5, 0, 1},
        {"genome g\nr = / 1 x\nq = / 1 * 2 y", "t1 = 1/(x*y); r = t1*y; q = 0.5*t1*x", 4, 0, 1},
        {"+ / a x / b y", "t1 = 1/(x*y); r = t1*a*y + t1*b*x", 5, 1, 1},
        /* a single quotient, and quotients that already share a division */
        {"/ a x", NULL, 0, 0, 0},
        {"genome g\nr = / a x\nq = / b x", NULL, 0, 0, 0},
        {"genome g\nr = / x y\nq = sqrt x", NULL, 0, 0, 0},
        /* a division that waits for another has its own level */
        {"/ a + b / c d", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(shape_join, row);
}

/* Coordinates of a four-node segment as differences only, or otherwise. */
static void relative_coordinates_are_recognised(void **state)
{
    static const struct {
        const char *xi;
        bool relative;
    } row[] = {
        {"- xA xB", true},         {"* - xA xS - yC yD", true},
        {"- * 2 xA * 2 xB", true}, {"+ * - xA xB - xC xD 1", true},
        {"+ xA xB", false},        {"- xA yB", false},
        {"- xA * 0.5 xB", false},  {"- + xA xB + xC xD", false},
        {"* xA - xB xC", false},   {"sqrt xA", false},
        {"+ 1 - xA xB", true},     {"+ 1 xA", false},
    };
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        char text[300];
        struct diag d = {0};
        snprintf(text, sizeof text, "footpoint-genome 2\nsegment quad4 any\ngenome g\nxi = %s\neta = 1\nend\n",
                 row[i].xi);
        struct genome_file *f = genome_parse("test", text, strlen(text), &d);
        if (!f)
            fail_msg("%s", d.text);
        struct dag *g = row_graph(f);
        if (shape_is_relative(g, f->segment) != row[i].relative)
            fail_msg("%s: expected %d", row[i].xi, row[i].relative);
        dag_free(g);
        genome_file_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sums_are_multiplied_out),
        cmocka_unit_test(policies_limit_expansion),
        cmocka_unit_test(denominators_are_combined),
        cmocka_unit_test(divisions_are_joined),
        cmocka_unit_test(relative_coordinates_are_recognised),
    };
    return cmocka_run_group_tests_name("expand", tests, NULL, NULL);
}
