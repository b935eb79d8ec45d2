/* The schedule of a graph whose form is settled: the scale of each value, order of operands, distributed products,
 * shared multiples. */
#include "../../codegen/schedule/balance.h"
#include "../../codegen/schedule/distribute.h"
#include "../../codegen/schedule/lower.h"
#include "../../codegen/schedule/scales.h"
#include "../../codegen/schedule/share_multiples.h"
#include "../support/graph_text.h"

static struct cost_model costs(const char *name)
{
    struct cost_model m;
    struct diag d;
    assert_true(cost_model_find(name, &m, &d));
    return m;
}

/* Counts multiplications with every value as in the graph, and with the scales that a search finds. */
static void scales_save_products(void **state)
{
    (void)state;
    static const struct {
        const char *genome;
        long kept, scaled;
    } row[] = {
        /* (2 x + y) a is 2 (x + y/2) a in the graph */
        {"* a + * 2 x y", 3, 2},
        {"sqrt + * 2 x y", 2, 1},
        {"* + * 2 x y + * 3 z a", 4, 3},
        {"genome g\nr = * a + * 3 x y\nq = * b + * 3 x y", 5, 3},
        /* a mean of four, squared: 1/16 once, at its use */
        {"let m = * 0.25 + + x y + z a\ngenome g\nr = * m m", 2, 2},
        /* a coefficient that several products share moves to their common factor */
        {"genome g\nr = * b * * 3 x - y z\nq = * c * * 3 x - y z", 6, 5},
        /* an inverse that several values use takes their coefficient */
        {"genome g\nr = * 3 / x z\nq = * 3 / y z", 4, 2},
        /* nothing to gain */
        {"* a + x y", 1, 1},
        {"+ * 2 x * 3 y", 2, 2},
        {"* x * y z", 2, 2},
        {"* 3 x", 1, 1},
        {"+ x + y z", 0, 0},
    };
    const struct cost_model model = costs("throughput");
    size_t wrong = 0;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f);
        long mul[3];
        char *text[3];
        for (int k = 0; k < 3; k++) {
            struct schedule *s = scaled_schedule(g, &model, (enum scale_search)k, NULL);
            struct lowered e;
            lower(f, s, &e);
            mul[k] = e.ops.mul;
            text[k] = row_code(f, e.program);
            program_free(e.program);
            for (size_t n = 0; k == 0 && n < g->nodes; n++)
                assert_int_equal(s->scale[n], ONE);
            schedule_free(s);
        }
        if (mul[0] != row[i].kept || mul[1] != row[i].scaled || mul[2] > mul[1]) {
            print_message("%s\n  %ld multiplications\n%s  %ld in scales\n%s  %ld in groups\n%s", row[i].genome, mul[0],
                          text[0], mul[1], text[1], mul[2], text[2]);
            wrong++;
        }
        for (int k = 0; k < 3; k++)
            free(text[k]);
        dag_free(g);
        genome_file_free(f);
    }
    assert_int_equal(wrong, 0);
}

/* In a chain from left to right, the operand that is ready first comes first. */
static void ready_operands_come_first(void **state)
{
    (void)state;
    static const struct {
        const char *genome, *expected;
    } row[] = {
        {"+ sqrt x + abs y z", "*out_r = in_z + fabs(in_y) + sqrt(in_x);\n"},
        {"+ / 1 y + sqrt x z", "*out_r = in_z + 1.0 / in_y + sqrt(in_x);\n"},
        {"* sqrt x y", "*out_r = in_y * sqrt(in_x);\n"},
        {"- sqrt x y", "*out_r = -(in_y - sqrt(in_x));\n"},
    };
    const struct cost_model model = costs("throughput");
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f);
        struct lowered e;
        balance_order(g);
        struct schedule *s = scaled_schedule(g, &model, SCALES_KEPT, NULL);
        lower(f, s, &e);
        char *code = row_code(f, e.program);
        assert_string_equal(code + strspn(code, " "), row[i].expected);
        check_values(f, g);
        program_free(e.program);
        free(code);
        schedule_free(s);
        dag_free(g);
        genome_file_free(f);
    }
}

static struct dag *distribute(const struct dag *g)
{
    const struct cost_model model = costs("throughput");
    struct dag *made = dag_copy(g);
    distribute_products(made, &model);
    return made;
}

static void products_are_distributed(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        /* a (1 + x) and a (1 - x): one multiplication for two */
        {"genome g\nr = * a + x 1\nq = * a - x 1", "t1 = a*x; r = a + t1; q = -a + t1", 1, 2, 0},
        {"genome g\nr = * a x\nq = * a + 1 x", "t1 = a*x; r = t1; q = a + t1", 1, 1, 0},
        {"genome g\nr = * x x\nq = * x + 1 x", "t1 = x^2; r = t1; q = x + t1", 1, 1, 0},
        /* a (x + 1) + b (x + 1) is already shared; a (x + 1) + b (x - 1) is a - b + x (a + b) */
        {"+ * a + x 1 * b - x 1", "a - b + x*(a + b)", 1, 3, 0},
        /* a (x + 3) costs a multiplication in either form */
        {"genome g\nr = * a + x 1\nq = * b + x 1", NULL, 0, 0, 0},
        {"* a + x 1", NULL, 0, 0, 0},
        {"genome g\nr = * a x\nq = * a + 3 x", NULL, 0, 0, 0},
        {"genome g\nr = * a + x y\nq = * a - x y", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(distribute, row);
}

static struct dag *take_multiples(const struct dag *g)
{
    const struct cost_model model = costs("throughput");
    struct schedule *s = scaled_schedule(g, &model, SCALES_KEPT, NULL);
    size_t saved;
    struct dag *made = multiples_taken(s, &saved);
    assert_true(!made || saved > 0);
    schedule_free(s);
    return made;
}

static void multiples_share_a_product(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        /* 3 x and 3 x y: the second is y times the first */
        {"genome g\nr = + a * 3 x\nq = + b * * 3 x y", "t1 = 3*x; r = t1 + a; q = t1*y + b", 2, 2, 0},
        {"genome g\nr = + a * 3 x\nq = + b * * 5 x y", NULL, 0, 0, 0},
        {"genome g\nr = + a x\nq = + b * x y", NULL, 0, 0, 0},
        {"genome g\nr = + a * 3 x\nq = + b * * 3 y z", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(take_multiples, row);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(scales_save_products),
        cmocka_unit_test(ready_operands_come_first),
        cmocka_unit_test(products_are_distributed),
        cmocka_unit_test(multiples_share_a_product),
    };
    return cmocka_run_group_tests_name("scales", tests, NULL, NULL);
}
