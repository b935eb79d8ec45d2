/* Reads the emitted statements back: operations in order, every form of text, and refusals. */
#include "../../codegen/compile/compile.h"
#include "../support/genome_text.h"

static const char two_outputs[] = "footpoint-genome 1\ninput x y\ngenome g\nr = x\ns = y\nend\n";
static const char one_output[] = "footpoint-genome 1\ninput x y\nlet z = x\ngenome g\nr = x\nend\n";
static const char segment[] = "footpoint-genome 1\ninput xA yA zA xB yB zB xC yC zC xD yD zD xS yS zS\n"
                              "segment quad4 any\ngenome g\nxi = xS\neta = yS\nend\n";

static void operations_are_read_in_order(void **state)
{
    (void)state;
    static const char text[] = "    const double t1 = in_x * in_x + 2.5;\n"
                               "    const double u1 = -(7.0 / 3.0) * t1;\n"
                               "    *out_r = u1 - sqrt(in_y) / t1;\n"
                               "    *out_s = u1;\n";
    static const struct op expected[] = {
        {.kind = OP_INPUT, .a = -1, .b = -1, .input = 0},
        {.kind = OP_INPUT, .a = -1, .b = -1, .input = 1},
        {.kind = OP_MUL, .a = 0, .b = 0, .input = -1, .squared = true},
        {.kind = OP_CONSTANT, .a = -1, .b = -1, .input = 0},
        {.kind = OP_ADD, .a = 2, .b = 3, .input = -1},
        {.kind = OP_CONSTANT, .a = -1, .b = -1, .input = 1, .quotient = true},
        {.kind = OP_NEG, .a = 5, .b = -1, .input = -1},
        {.kind = OP_MUL, .a = 6, .b = 4, .input = -1},
        {.kind = OP_SQRT, .a = 1, .b = -1, .input = -1},
        {.kind = OP_DIV, .a = 8, .b = 4, .input = -1},
        {.kind = OP_SUB, .a = 7, .b = 9, .input = -1},
    };
    static const struct {
        const char *name;
        int op, first;
        long output;
    } statement[] = {{"t1", 4, 2, -1}, {"u1", 7, 5, -1}, {"r", 10, 8, 0}, {"s", 7, 11, 1}};
    struct genome_file *f = parse(two_outputs);
    struct program *p = read_program(f, 0, text);
    assert_int_equal(p->ops, sizeof expected / sizeof *expected);
    for (size_t i = 0; i < p->ops; i++) {
        const struct op *a = &p->op[i], *b = &expected[i];
        if (a->kind != b->kind || a->a != b->a || a->b != b->b || a->input != b->input || a->quotient != b->quotient ||
            a->squared != b->squared)
            fail_msg("operation %zu: %d(%d, %d)", i, (int)a->kind, a->a, a->b);
    }
    assert_int_equal(p->statements, 4);
    for (size_t i = 0; i < 4; i++) {
        assert_string_equal(p->statement[i].name, statement[i].name);
        assert_int_equal(p->statement[i].op, statement[i].op);
        assert_int_equal(p->statement[i].first, statement[i].first);
        assert_int_equal(p->statement[i].output, statement[i].output);
    }
    assert_int_equal(p->inputs, 2);
    assert_int_equal(p->outputs, 2);
    assert_int_equal(p->output[0], 10);
    assert_int_equal(p->output[1], 7);
    char *constant[2] = {fmpq_get_str(NULL, 10, &p->constant[0]), fmpq_get_str(NULL, 10, &p->constant[1])};
    assert_string_equal(constant[0], "5/2");
    assert_string_equal(constant[1], "7/3");
    flint_free(constant[0]);
    flint_free(constant[1]);
    program_free(p);
    genome_file_free(f);
}

/* Prints the value of `r` as a prefix expression, which shows precedence. */
static void print_op(const struct program *p, int op, char *text)
{
    static const char *const name[] = {
        [OP_NEG] = "neg",   [OP_ADD] = "+",   [OP_SUB] = "-",   [OP_MUL] = "*",   [OP_DIV] = "/",
        [OP_SQRT] = "sqrt", [OP_ABS] = "abs", [OP_MIN] = "min", [OP_MAX] = "max", [OP_PDIV] = "%"};
    const struct op *o = &p->op[op];
    if (o->kind == OP_INPUT)
        strcat(text, o->input ? "y" : "x");
    else if (o->kind == OP_CONSTANT) {
        char *value = fmpq_get_str(NULL, 10, &p->constant[o->input]);
        strcat(text, value);
        flint_free(value);
    } else {
        strcat(strcat(text, name[o->kind]), " ");
        print_op(p, o->a, text);
        if (o->b >= 0) {
            strcat(text, " ");
            print_op(p, o->b, text);
        }
    }
}

static void every_form_is_read(void **state)
{
    (void)state;
    static const char *const form[][2] = {
        {"in_x - in_y - 1.0", "- - x y 1"},
        {"in_x - (in_y - 1.0)", "- x - y 1"},
        {"in_x / in_y / 2.0 * in_x", "* / / x y 2 x"},
        {"-in_x * in_y - -in_x", "- * neg x y neg x"},
        {"in_x + in_y * in_x + 0.25", "+ + x * y x 1/4"},
        {"((in_x + in_y) * (in_x - 1.0))", "* + x y - x 1"},
        {"(1.0 / 3.0) * (-7.0 / 11.0)", "* 1/3 -7/11"},
        {"(1.0 / 3.0 * in_x)", "* / 1 3 x"},
        {"sqrt(in_x + 1.0) * fabs(-in_x)", "* sqrt + x 1 abs neg x"},
        {"(in_x < in_y ? in_x : in_y)", "min x y"},
        {"(in_x > -2.0 ? in_x : -2.0) + 1.0", "+ max x neg 2 1"},
        {"(in_x < (1.0 / 3.0)\n        ? in_x : (1.0\n / 3.0))", "min x 1/3"},
        {"(!(in_x >= in_y) ? in_x : in_y)", "min x y"},
        {"(!(in_x <= 2.0) ? in_x : 2.0)", "max x 2"},
        {"(in_y == 0.0 ? 1.0 : in_x / in_y)", "% x y"},
        {"2.0 * (in_y == 0.0 ? 1.0 : -0.5 / in_y)", "* 2 % neg 1/2 y"},
        {"1.25e-3 * in_x", "* 1/800 x"},
    };
    struct genome_file *f = parse(one_output);
    for (size_t i = 0; i < sizeof form / sizeof *form; i++) {
        char text[200], got[200] = "";
        snprintf(text, sizeof text, "*out_r = %s;\n", form[i][0]);
        struct program *p = read_program(f, 0, text);
        print_op(p, p->output[0], got);
        assert_string_equal(got, form[i][1]);
        program_free(p);
    }
    genome_file_free(f);
}

static void check_refused(const char *genome, const char *text)
{
    struct diag d = {0};
    struct genome_file *f = parse(genome);
    struct program *p = program_read(f, &f->genome[0], text, &d);
    if (p || !strstr(d.text, "cannot read") || strchr(d.text, '\n'))
        fail_msg("'%s' was read: %s", text, d.text);
    genome_file_free(f);
}

static void foreign_text_is_refused(void **state)
{
    (void)state;
    static const char *const value[] = {
        "",
        "2",
        "1 / 3",
        "3 * in_x",
        "1.",
        ".5",
        "1.0f",
        "0x1.8p0",
        "1e5",
        "1.0e99999",
        "in_w",
        "in_z", /* a let is not an input */
        "x",
        "t1",
        "xA[0]",
        "in_x +",
        "in_x + + in_y",
        "in_x in_y",
        "--in_x",
        "in_x --in_y",
        "(in_x",
        "in_x)",
        "((in_x)",
        "()",
        "sqrt in_x",
        "sqrt()",
        "cbrt(in_x)",
        "cos(in_x)",
        "(in_x < in_y ? in_y : in_x)",
        "(in_x < in_y ? in_x : in_x)",
        "(in_x > in_y ? in_x : in_yy)",
        "(in_x <= in_y ? in_x : in_y)",
        "(!(in_x < in_y) ? in_x : in_y)",
        "(!(in_x <= in_y) ? in_y : in_x)",
        "(!(in_x <= in_y ? in_x : in_y)",
        "(!in_x <= in_y ? in_x : in_y)",
        "(!(in_y == 0.0) ? 1.0 : in_x / in_y)",
        "in_x < in_y ? in_x : in_y",
        "(in_y == 1.0 ? 1.0 : in_x / in_y)",
        "(in_y == 0.0 ? 2.0 : in_x / in_y)",
        "(in_y == 0.0 ? 1.0 : in_x / in_x)",
        "(in_y == 0.0 ? 1.0 : in_x * in_y)",
        "(in_y == 0.0 ? 1.0 : in_y)",
        "(in_x < in_y ? i n_x : in_y)",
        "in_x, in_y",
        "in_x = in_y",
        "in_x / * in_y",
    };
    char text[200];
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        snprintf(text, sizeof text, "    *out_r = %s;\n", value[i]);
        check_refused(one_output, text);
    }
    check_refused(one_output, "");
    check_refused(one_output, "*out_r = in_x");
    check_refused(one_output, "*out_r = in_x;\n*out_r = in_x;\n");
    check_refused(one_output, "*r = in_x;\n");
    check_refused(one_output, "out_r = in_x;\n");
    check_refused(one_output, "double t1 = in_x;\n*out_r = in_x;\n");
    check_refused(one_output, "double t1 = -in_x;\n*out_r = in_x;\n");
    check_refused(one_output, "double t1 = 1.0 + 1.0;\n*out_r = in_x;\n");
    check_refused(one_output, "const t1 = 1.0;\n*out_r = in_x;\n");
    check_refused(one_output, "const double t1 = in_x;\nconst double t1 = in_y;\n*out_r = t1;\n");
    check_refused(one_output, "const double in_x = in_y;\n*out_r = in_x;\n");
    check_refused(one_output, "const double t1 = t1;\n*out_r = t1;\n");
    check_refused(two_outputs, "*out_r = in_x;\n");
    check_refused(two_outputs, "*out_s = in_x;\n*out_r = in_y;\n");
    check_refused(one_output, "const double t1 = zero + 1.0;\n*out_r = t1;\n"); /* segments' functions have it */
    check_refused(segment, "const double u1 = zero + xA[0];\n*xi = u1;\n*eta = u1;\n");
    check_refused(segment, "const double u1 = zero 1.0;\n*xi = u1;\n*eta = u1;\n");
    check_refused(segment, "*xi = zero + 1.0;\n*eta = 1.0;\n");
    check_refused(segment, "*xi = xA[3];\n*eta = yS;\n");
    check_refused(segment, "*xi = xE[0];\n*eta = xS[1];\n");
    check_refused(segment, "*xi = in_xA;\n*eta = xS[1];\n");
    check_refused(segment, "*out_xi = xA[0];\n*out_eta = xS[1];\n");
}

static void segments_have_their_inputs(void **state)
{
    (void)state;
    struct genome_file *f = parse(segment);
    struct program *p = read_program(f, 0, "*xi = xA[2];\n*eta = xS[1] + xD[0];\n");
    assert_int_equal(p->output[0], 2);
    assert_int_equal(p->op[p->output[1]].a, 13);
    assert_int_equal(p->op[p->output[1]].b, 9);
    program_free(p);
    p = read_program(f, 0, "const double u1 = zero - 0.5;\n*xi = (u1 > xA[2] ? u1 : xA[2]);\n*eta = 1.0;\n");
    assert_int_equal(p->op[p->output[0]].kind, OP_MAX);
    assert_int_equal(p->op[p->op[p->output[0]].a].kind, OP_NEG);
    program_free(p);
    genome_file_free(f);
}

/* Long chains and deep nesting, at least a megabyte each, take time in proportion and no stack. */
static void long_and_deep_text_is_read(void **state)
{
    (void)state;
    const size_t n = getenv("FOOTPOINT_LONG") ? 200000 : 50000;
    static const char *const part[][3] = {
        {"in_y + ", "in_x", ""}, {"(", "in_x", " + in_y)"}, {"-(", "in_x", ")"}, {"sqrt(fabs(", "in_x", "))"}};
    const size_t operations[] = {n, n, n, 2 * n};
    struct genome_file *f = parse(one_output);
    for (size_t k = 0; k < sizeof part / sizeof *part; k++) {
        char *text = new_array(20 * n, 1), *at = text + sprintf(text, "*out_r = ");
        for (size_t i = 0; i < n; i++)
            at += sprintf(at, "%s", part[k][0]);
        at += sprintf(at, "%s", part[k][1]);
        for (size_t i = 0; i < n; i++)
            at += sprintf(at, "%s", part[k][2]);
        sprintf(at, ";\n");
        struct program *p = read_program(f, 0, text);
        assert_int_equal(p->ops, operations[k] + 2);
        program_free(p);
        free(text);
    }
    genome_file_free(f);
}

/* The emitter's counts equal the counts of the text. */
static void counts_match_the_text(void **state)
{
    (void)state;
    struct diag d = {0};
    struct genome_file *f = genome_read("evolve/genomes/paper-quad4.gen", &d);
    assert_non_null(f);
    struct compile_options options = compile_defaults();
    options.effort = 0;
    for (size_t g = 0; g < f->genomes; g++) {
        struct compiled c;
        long n[OP_KINDS] = {0};
        assert_true(compile_genome(f, &f->genome[g], &options, &c, &d));
        struct program *p = read_program(f, g, c.text);
        for (size_t i = 0; i < p->ops; i++)
            n[p->op[i].kind]++;
        assert_int_equal(n[OP_MUL], c.ops.mul);
        assert_int_equal(n[OP_DIV] + n[OP_PDIV], c.ops.div);
        assert_int_equal(n[OP_ADD] + n[OP_SUB], c.ops.add);
        assert_int_equal(n[OP_SQRT], c.ops.sqrt);
        assert_int_equal(n[OP_MIN] + n[OP_MAX] + n[OP_ABS] + n[OP_PDIV], c.ops.compare);
        assert_int_equal(p->statements, (size_t)c.ops.temporaries + p->outputs);
        program_free(p);
        compiled_free(&c);
    }
    genome_file_free(f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations_are_read_in_order), cmocka_unit_test(every_form_is_read),
        cmocka_unit_test(foreign_text_is_refused),      cmocka_unit_test(segments_have_their_inputs),
        cmocka_unit_test(long_and_deep_text_is_read),   cmocka_unit_test(counts_match_the_text),
    };
    return cmocka_run_group_tests_name("program", tests, NULL, NULL);
}
