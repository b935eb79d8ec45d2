/* Statements and their order: the text of a schedule, names, counts, and dependences. */
#include "../../codegen/schedule/lower.h"
#include "../../codegen/schedule/scales.h"
#include "../support/graph_text.h"

/* Statements, one space between them. */
struct statement_row {
    const char *genome, *expected;
    long mul, add, div, sqrt, compare;
};

static struct cost_model costs(const char *name)
{
    struct cost_model m;
    struct diag d;
    assert_true(cost_model_find(name, &m, &d));
    return m;
}

static void check_statements(const struct statement_row *row, size_t rows)
{
    const struct cost_model model = costs("throughput");
    size_t wrong = 0;
    for (size_t i = 0; i < rows; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f);
        struct schedule *s = scaled_schedule(g, &model, SCALES_KEPT, NULL);
        struct lowered e;
        lower(f, s, &e);
        char *code = row_code(f, e.program);
        program_free(read_program(f, 0, code)); /* the prover reads this text */
        char text[1000] = "";
        for (const char *line = strtok(code, "\n"); line; line = strtok(NULL, "\n")) {
            strcat(text, *text ? " " : "");
            strcat(text, line + strspn(line, " "));
        }
        if (strcmp(text, row[i].expected) != 0 || e.ops.mul != row[i].mul || e.ops.add != row[i].add ||
            e.ops.div != row[i].div || e.ops.sqrt != row[i].sqrt || e.ops.compare != row[i].compare) {
            print_message("%s\n  expected %s\n  made     %s (%ld, %ld, %ld, %ld, %ld)\n", row[i].genome,
                          row[i].expected, text, e.ops.mul, e.ops.add, e.ops.div, e.ops.sqrt, e.ops.compare);
            wrong++;
        }
        program_free(e.program);
        free(code);
        schedule_free(s);
        dag_free(g);
        genome_file_free(f);
    }
    assert_int_equal(wrong, 0);
}

static void statements_are_as_expected(void **state)
{
    (void)state;
    static const struct statement_row row[] = {
        {"+ x y", "*out_r = in_x + in_y;", 0, 1, 0, 0, 0},
        {"- x y", "*out_r = in_x - in_y;", 0, 1, 0, 0, 0},
        {"neg x", "*out_r = -in_x;", 0, 0, 0, 0, 0},
        {"* x y", "*out_r = in_x * in_y;", 1, 0, 0, 0, 0},
        {"* x + y z", "*out_r = in_x * (in_y + in_z);", 1, 1, 0, 0, 0},
        {"/ x y", "*out_r = in_x / in_y;", 0, 0, 1, 0, 0},
        {"/ 1 x", "*out_r = 1.0 / in_x;", 0, 0, 1, 0, 0},
        {"/ x + y z", "*out_r = in_x / (in_y + in_z);", 0, 1, 1, 0, 0},
        /* constants: exact decimals, otherwise quotients, which do not count as operations */
        {"* 0.25 x", "*out_r = 0.25 * in_x;", 1, 0, 0, 0, 0},
        {"/ x 3", "*out_r = (1.0 / 3.0) * in_x;", 1, 0, 0, 0, 0},
        {"7", "*out_r = 7.0;", 0, 0, 0, 0, 0},
        {"- x x", "*out_r = 0.0;", 0, 0, 0, 0, 0},
        /* functions */
        {"abs x", "*out_r = fabs(in_x);", 0, 0, 0, 0, 1},
        {"sqrt x", "*out_r = sqrt(in_x);", 0, 0, 0, 1, 0},
        /* a value that is used twice has a name; a short value that is used once has no name */
        {"* + x y + x y", "const double t1 = in_x + in_y; *out_r = t1 * t1;", 1, 1, 0, 0, 0},
        {"genome g\nr = * x y\nq = + 1 * x y", "const double t1 = in_x * in_y; *out_r = t1; *out_q = t1 + 1.0;", 1, 1,
         0, 0, 0},
        {"* x x", "*out_r = in_x * in_x;", 1, 0, 0, 0, 0},
        /* a divisor that several values need is inverted once */
        {"genome g\nr = / x z\nq = / y z", "const double t1 = 1.0 / in_z; *out_r = in_x * t1; *out_q = in_y * t1;", 2,
         0, 1, 0, 0},
        /* equal coefficients of a sum are taken out together */
        {"+ x + * 3 y * 3 z", "*out_r = in_x + 3.0 * (in_y + in_z);", 1, 2, 0, 0, 0},
    };
    check_statements(row, sizeof row / sizeof *row);
}

static const char *const genomes[] = {
    "* + x y + x y",
    "max + * x x y min x * y z",
    "min max x * y y + a max b * c sqrt + 1 * x x",
    "% * x + y z + x a",
    "/ + * a b * c d + / 1 x / 1 + 1 * y y",
    "let s = + * x x * y y\nlet t = sqrt + 1 s\nlet m = max * s z min t / a t\ngenome g\nr = / s t\nq = m\nu = % t m",
    "let n = abs - x y\nlet m = max n 1\ngenome g\nr = * n min m 2\nq = + * m m * a sqrt m",
};

/* No value precedes its operands or uses an operand of a later stage. Choices are in odd stages, arithmetic in even
 * stages. Each used value occurs once. */
static void operands_precede_their_uses(void **state)
{
    (void)state;
    const char *const names[] = {"throughput", "paper", "operations"};
    for (size_t i = 0; i < sizeof genomes / sizeof *genomes * 3; i++) {
        const struct cost_model model = costs(names[i % 3]);
        struct genome_file *f = row_file(genomes[i / 3]);
        struct dag *g = row_graph(f);
        struct schedule *s = scaled_schedule(g, &model, SCALES_SINGLE, NULL);
        int *uses = dag_uses(g);
        bool *done = new_array(g->nodes, sizeof *done);
        size_t used = 0;
        for (size_t n = 0; n < g->nodes; n++)
            used += uses[n] > 0;
        assert_int_equal(s->n, used);
        for (size_t k = 0; k < s->n; k++) {
            const int n = s->order[k];
            const struct node *node = &g->node[n];
            assert_true(uses[n] > 0 && !done[n]);
            assert_int_equal(s->stage[n] % 2, node_chooses(node));
            assert_true(k == 0 || s->stage[s->order[k - 1]] <= s->stage[n]);
            for (size_t j = 0; j < node->edges; j++)
                assert_true(done[node->edge[j].node] && s->stage[node->edge[j].node] <= s->stage[n]);
            done[n] = true;
        }
        free(done);
        free(uses);
        schedule_free(s);
        dag_free(g);
        genome_file_free(f);
    }
}

/* The operand of the root, on which a long chain waits, comes first although it is named last. */
static void long_chains_start_early(void **state)
{
    (void)state;
    const struct cost_model model = costs("throughput");
    static const char *const genome[] = {
        "genome g\nr = + x y\nq = / 1 sqrt / 1 sqrt + 1 * z z",
        "genome g\nr = / 1 sqrt / 1 sqrt + 1 * z z\nq = + x y",
    };
    for (int i = 0; i < 2; i++) {
        struct genome_file *f = row_file(genome[i]);
        struct dag *g = row_graph(f);
        struct schedule *s = scaled_schedule(g, &model, SCALES_KEPT, NULL);
        size_t square = 0, sum = 0;
        for (size_t k = 0; k < s->n; k++) {
            if (g->node[s->order[k]].kind == NODE_PRODUCT)
                square = k;
            if (s->order[k] == g->output[i].node)
                sum = k;
        }
        assert_int_equal(g->node[s->order[sum]].kind, NODE_SUM);
        assert_true(square < sum);
        schedule_free(s);
        dag_free(g);
        genome_file_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(statements_are_as_expected),
        cmocka_unit_test(operands_precede_their_uses),
        cmocka_unit_test(long_chains_start_early),
    };
    return cmocka_run_group_tests_name("schedule", tests, NULL, NULL);
}
