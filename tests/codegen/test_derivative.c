/* Derivatives in genome text agree with calculus, and faces read back as they are printed. */
#include "../../codegen/base/text.h"
#include "../../codegen/graph/from_genome.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

/* Lets that end with s, and the value of s. */
static const struct row {
    const char *lets, *expected;
} row[] = {
    {"let s = derivative x x\n", "1"},
    {"let s = derivative y x\n", "0"},
    {"let v = + * 3 x y\nlet s = derivative v x\n", "3"},
    {"let v = - y * x x\nlet s = derivative v x\n", "* -2 x"},
    {"let v = neg * * x x x\nlet s = derivative v x\n", "* -3 * x x"},
    {"let v = / y x\nlet s = derivative v x\n", "neg / y * x x"},
    {"let v = / + x y - x y\nlet s = derivative v x\n", "/ * -2 y * - x y - x y"},
    {"let v = / x y\nlet s = derivative v x\n", "/ 1 y"},
    {"let v = sqrt + 1 * x x\nlet s = derivative v x\n", "/ x sqrt + 1 * x x"},
    /* of lets, of derivatives, by a let, and of minima of other values */
    {"let v = * x y\nlet w = * v + v x\nlet s = derivative w x\n", "+ * 2 * x * y y * 2 * x y"},
    {"let v = * x * x x\nlet w = derivative v x\nlet s = derivative w x\n", "* 6 x"},
    {"let v = * x y\nlet w = * v + v x\nlet s = derivative w v\n", "+ * 2 * x y x"},
    {"let v = + min y z * x x\nlet s = derivative v x\n", "* 2 x"},
};

static struct genome_file *parse(const char *head, const char *lets, const char *outputs, struct diag *d)
{
    char *text = new_format("footpoint-genome 2\n%s\n%sgenome g\n%s\nend\n", head, lets, outputs);
    struct genome_file *f = genome_parse("text", text, strlen(text), d);
    free(text);
    return f;
}

/* Checks that all outputs are 0. */
static void expect_zero(const char *head, const char *lets, const char *outputs)
{
    struct diag d = {0};
    struct genome_file *f = parse(head, lets, outputs, &d);
    if (!f)
        fail_msg("%s: %s", lets, d.text);
    struct dag *g = simplify_genome(f, &f->genome[0], KEEP_ALL, &d);
    assert_non_null(g);
    for (size_t i = 0; i < g->outputs; i++)
        if (g->output[i].coef != ZERO)
            fail_msg("%s: not 0: %s", lets, outputs);
    dag_free(g);
    genome_file_free(f);
}

static void derivatives_are_those_of_calculus(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        char *output = new_format("r = - s %s", row[i].expected);
        expect_zero("input x y z", row[i].lets, output);
        free(output);
    }
}

static void vectors_have_derivatives(void **state)
{
    (void)state;
    static const char lets[] = "let r = + * * xi eta - B A * xi C\n"
                               "let a = derivative r xi\n"
                               "let ab = derivative a eta\n"
                               "let rr = dot r r\n"
                               "let g = derivative rr C\n";
    expect_zero("face tri3", lets, "p = - a + * eta - B A C\nq = - ab - B A - g * 2 * xi r");
}

static void refusals_name_the_place(void **state)
{
    (void)state;
    static const struct {
        const char *lets, *message;
    } wrong[] = {
        {"let v = min x y\nlet s = derivative v x\n", "text:4:1: error: 'min' is not differentiable everywhere"},
        {"let s = derivative x 2\n", "text:3:22: error: '2' is not a value"},
        {"let s = derivative x\n", "text:3:21: error: expected a value"},
        {"let s = derivative x y z\n", "text:3:24: error: unexpected 'z'"},
        {"function f u -> s\n    let s = derivative u x\nend\n",
         "text:4:13: error: 'derivative' must not be inside a function"},
        {"let derivative = x\n", "text:3:5: error: keyword 'derivative' must not be used as a name"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        struct diag d = {0};
        assert_null(parse("input x y z", wrong[i].lets, "r = x", &d));
        assert_string_equal(d.text, wrong[i].message);
    }
    struct diag d = {0};
    assert_null(parse("face tri3", "let s = derivative A B\n", "r = xi", &d));
    assert_string_equal(d.text, "text:3:22: error: a vector has no derivative by the vector 'B'");
    assert_null(parse("face nothing", "", "r = xi", &d));
    assert_string_equal(d.text, "text:2:6: error: unknown segment kind 'nothing'");
}

static char *print(const struct genome_file *f)
{
    struct memory *m = memory_open();
    genome_print(f, m->stream);
    return memory_close(m);
}

static void faces_read_back(void **state)
{
    (void)state;
    struct diag d = {0};
    struct genome_file *f = parse("face quad4", "let r = * xi - B A\nlet a = derivative r xi\n",
                                  "require xi - 1 xi\nr_xi = a\nlong = - S A - S B - S C - S D * eta a\n"
                                  "    * xi a neg a r\nlast = 1",
                                  &d);
    if (!f)
        fail_msg("%s", d.text);
    assert_int_equal(f->genome[0].outs, 2 + 3 + 24 + 1);
    assert_string_equal(f->genome[0].out[1].name, "require[1]");
    assert_string_equal(f->genome[0].out[28].name, "long[23]");
    char *first = print(f);
    struct genome_file *again = genome_parse("text", first, strlen(first), &d);
    if (!again)
        fail_msg("%s\n%s", d.text, first);
    char *second = print(again);
    assert_string_equal(first, second);
    free(first);
    free(second);
    genome_file_free(again);
    genome_file_free(f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(derivatives_are_those_of_calculus),
        cmocka_unit_test(vectors_have_derivatives),
        cmocka_unit_test(refusals_name_the_place),
        cmocka_unit_test(faces_read_back),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
