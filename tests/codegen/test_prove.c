/* The proof, by polynomials and by points: accepted and refused code. */
#include "../../codegen/compile/compile.h"
#include "../../codegen/prove/prove.h"

#include <ctype.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { WIDE = 130, ROOM = 8000 };

/* Begins a genome file over x y z and, if wide, more inputs than the comparison of polynomials accepts. */
static void begin_genome(char text[ROOM], bool wide)
{
    size_t n = (size_t)sprintf(text, "footpoint-genome 1\ninput x y z");
    for (int i = 0; wide && i < WIDE; i++)
        n += (size_t)sprintf(text + n, " w%d", i);
    sprintf(text + n, "\n");
}

/* Adds an output that reads all inputs to genome and code. */
static void add_wide(char genome[ROOM], char code[ROOM], bool wide)
{
    size_t g = strlen(genome), c = strlen(code);
    if (!wide)
        return;
    g += (size_t)sprintf(genome + g, "wide =");
    c += (size_t)sprintf(code + c, "*out_wide = ");
    for (int i = 0; i < WIDE; i++) {
        g += (size_t)sprintf(genome + g, i + 1 < WIDE ? " + w%d" : " w%d\n", i);
        c += (size_t)sprintf(code + c, i + 1 < WIDE ? "in_w%d + " : "in_w%d;\n", i);
    }
}

enum answer { PROVED, REFUSED, UNREADABLE };

static enum answer ask(const struct genome_file *f, const char *code, struct proof *how, struct diag *d)
{
    struct program *p = program_read(f, &f->genome[0], code, d);
    const bool good = p && prove_equal(f, &f->genome[0], p, how, d);
    const enum answer answer = !p ? UNREADABLE : good ? PROVED : REFUSED;
    program_free(p);
    return answer;
}

/* Compares `r = expression` with code that sets *out_r in both ways, which must agree. */
static enum answer compare(const char *expression, const char *code)
{
    enum answer answer[2];
    for (int wide = 0; wide < 2; wide++) {
        char genome[ROOM], text[ROOM] = "";
        struct diag d = {0};
        struct proof how;
        begin_genome(genome, wide);
        strcat(genome, "genome g\n");
        add_wide(genome, text, wide);
        snprintf(genome + strlen(genome), ROOM - strlen(genome), "r = %s\nend\n", expression);
        snprintf(text + strlen(text), ROOM - strlen(text), "%s", code);
        struct genome_file *f = genome_parse("test", genome, strlen(genome), &d);
        if (!f)
            fail_msg("%s", d.text);
        answer[wide] = ask(f, text, &how, &d);
        if (answer[wide] == PROVED) {
            assert_int_equal(how.exact, !wide);
            assert_int_equal(how.points, 2);
            assert_true(how.log2_failure < -100);
        }
        genome_file_free(f);
    }
    assert_int_equal(answer[0], answer[1]);
    return answer[0];
}

static void equal_code_is_proved(void **state)
{
    (void)state;
    static const char *const known[][2] = {
        {"+ * x y * x z", "*out_r = in_x * (in_y + in_z);"},
        {"- * x x * y y", "*out_r = (in_x - in_y) * (in_x + in_y);"},
        {"0.05", "*out_r = 0.05;"},
        {"* -0.35 x", "*out_r = -(7.0 / 20.0) * in_x;"},
        {"- x x", "*out_r = 0.0;"},
        {"/ x x", "*out_r = 1.0;"},
        {"+ / x z / y z", "*out_r = (in_x + in_y) / in_z;"},
        {"+ / 1 - x y / 1 + x y", "*out_r = (in_x + in_x) / (in_x * in_x - in_y * in_y);"},
        {"/ x / y / z + x 1", "*out_r = in_x * in_z / ((in_x + 1.0) * in_y);"},
        {"abs * -3 x", "*out_r = 3.0 * fabs(in_x);"},
        {"* abs - x y abs - * 2 y * 2 x", "const double t = fabs(in_y - in_x);\n*out_r = 2.0 * t * t;"},
        {"abs -2.5", "*out_r = 2.5;"},
        {"min 0e300 1e300", "*out_r = 0.0;"},
        {"sqrt * 1e150 1e150", "*out_r = 1.0e150;"},
        {"min x - y z", "const double t = in_y - in_z;\n*out_r = (t < in_x ? t : in_x);"},
        {"max * 2 x + x y", "const double u = in_x + in_x;\nconst double v = in_y + in_x;\n*out_r = (u > v ? u : v);"},
        {"min x x", "*out_r = in_x;"},
        {"max 2 -3", "*out_r = 2.0;"},
        {"min + x 2 + x -3", "const double u = in_x + 2.0;\nconst double v = in_x - 3.0;\n*out_r = (u < v ? u : v);"},
        {"sqrt 2.25", "*out_r = 1.5;"},
        {"sqrt - + x 4 x", "*out_r = 2.0;"},
        {"sqrt / * 9 x x", "*out_r = 3.0;"},
        {"sqrt 2", "*out_r = sqrt(2.0);"},
        {"sqrt + * x x + * y y * 2 * x y", "const double t = in_x + in_y;\n*out_r = sqrt(t * t);"},
        {"/ 1 sqrt * x + y z", "*out_r = 1.0 / sqrt(in_x * in_y + in_z * in_x);"},
        {"% x y", "*out_r = (in_y == 0.0 ? 1.0 : in_x / in_y);"},
        {"% * 2 x * 4 y", "const double u = 0.5 * in_x;\n*out_r = (in_y == 0.0 ? 1.0 : u / in_y);"},
        {"% x x", "*out_r = 1.0;"},
        {"% - x 1 - * 2 x 2",
         "const double t = in_x - 1.0;\nconst double u = 0.5 * t;\n*out_r = (t == 0.0 ? 1.0 : u / t);"},
        {"% x 4", "*out_r = 0.25 * in_x;"},
        {"% x - y y", "*out_r = 1.0;"},
        {"% 0 x", "*out_r = (in_x == 0.0 ? 1.0 : 0.0 / in_x);"},
        {"min sqrt abs x max y % z x",
         "const double t = (in_x == 0.0 ? 1.0 : in_z / in_x);\nconst double u = (t > in_y ? t : in_y);\n"
         "const double v = sqrt(fabs(in_x));\n*out_r = (u < v ? u : v);"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const enum answer answer = compare(known[i][0], known[i][1]);
        if (answer != PROVED)
            fail_msg("%s is not %s (%d)", known[i][0], known[i][1], (int)answer);
    }
}

static void different_code_is_refused(void **state)
{
    (void)state;
    static const char *const known[][2] = {
        {"+ * x y * x z", "*out_r = in_x * (in_y - in_z);"},
        {"0.1", "*out_r = 0.1000000000000000055511151231257827;"},
        {"/ x y", "*out_r = in_y / in_x;"},
        {"/ 1 3", "*out_r = 0.3333333333333333;"},
        {"abs * -3 x", "*out_r = -3.0 * fabs(in_x);"},
        {"abs x", "*out_r = in_x;"},
        {"abs x", "*out_r = sqrt(in_x * in_x);"}, /* true, but not a rule of any pass */
        {"* abs x abs y", "*out_r = fabs(in_x * in_y);"},
        {"min x y", "*out_r = (in_x > in_y ? in_x : in_y);"},
        {"min x y", "*out_r = (in_x < in_z ? in_x : in_z);"},
        {"min x y", "*out_r = in_x;"},
        {"max 2 -3", "*out_r = -3.0;"},
        {"max x -1000000000", "*out_r = in_x;"}, /* equal on most of the range */
        {"sqrt 2.25", "*out_r = -1.5;"},
        {"* sqrt x sqrt x", "*out_r = in_x;"},
        {"sqrt 2", "*out_r = 1.4142135623730951;"},
        {"% x y", "*out_r = in_x / in_y;"},
        {"% * x y y", "*out_r = in_x;"},
        {"% 0 x", "*out_r = 0.0;"},
        {"% x y", "const double u = -in_y;\n*out_r = (u == 0.0 ? 1.0 : in_x / u);"},
        {"x", "*out_r = in_x / 0.0;"},
        {"x", "*out_r = in_x * (in_y - in_y) / (in_z - in_z);"},
    };
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const enum answer answer = compare(known[i][0], known[i][1]);
        if (answer != REFUSED)
            fail_msg("%s and %s (%d)", known[i][0], known[i][1], (int)answer);
    }
}

/* ---- changes of correct code ---- */

struct tally {
    const struct genome_file *file;
    char *code; /* owned: changed in place or into `changed` */
    char *changed;
    size_t tried, proved;
};

static void try_changed(struct tally *t, const char *code)
{
    struct diag d = {0};
    struct proof how;
    t->tried++;
    if (ask(t->file, code, &how, &d) == PROVED) {
        t->proved++;
        print_message("proved: %s\n", code);
    }
}

static void try_letter(struct tally *t, size_t at, char letter)
{
    const char kept = t->code[at];
    t->code[at] = letter;
    try_changed(t, t->code);
    t->code[at] = kept;
}

/* Tries the code without the characters from..to. */
static void try_without(struct tally *t, size_t from, size_t to)
{
    const size_t size = strlen(t->code);
    memcpy(t->changed, t->code, from);
    memcpy(t->changed + from, t->code + to, size - to + 1);
    try_changed(t, t->changed);
}

/* Returns the end of the term that begins at `at`. */
static size_t term_end(const char *code, size_t at)
{
    int depth = 0;
    for (; depth > 0 || !strchr(");", code[at]); at++) {
        depth += (code[at] == '(') - (code[at] == ')');
        if (depth == 0 && code[at] == ' ' && strchr("+-", code[at + 1]))
            break;
    }
    return at;
}

/* Tries every sign turned, every digit of a constant raised, every name replaced by every other, every term dropped. */
static void change(struct tally *t)
{
    const char *code = t->code;
    for (size_t i = 1; code[i]; i++) {
        const bool name = isalpha((unsigned char)code[i - 1]) || code[i - 1] == '_';
        if (code[i] == '+' || (code[i] == '-' && code[i + 1] == ' '))
            try_letter(t, i, code[i] == '+' ? '-' : '+');
        else if (code[i] == '-')
            try_letter(t, i, ' ');
        else if (code[i] == '*' && code[i + 1] == ' ')
            try_letter(t, i, '/');
        else if (code[i] == '/')
            try_letter(t, i, '*');
        else if (isdigit((unsigned char)code[i]) && !name && !isalnum((unsigned char)code[i - 1]))
            try_letter(t, i, code[i] == '9' ? '1' : (char)(code[i] + 1));
        else if (code[i] == '<' || code[i] == '>')
            try_letter(t, i, code[i] == '<' ? '>' : '<');
        if (strncmp(code + i - 1, "_x", 2) == 0 && strchr(" );*,+-/", code[i + 1])) {
            try_letter(t, i, 'y');
            try_letter(t, i, 'z');
        }
        if (code[i - 1] == ' ' && strchr("+-", code[i]) && code[i + 1] == ' ')
            try_without(t, i, term_end(code, i + 2));
    }
}

static void every_change_is_found(void **state)
{
    (void)state;
    static const char *const expression[] = {
        "+ * x + y 0.3 * - z 0.75 * y x",        "- * * x x * x y + * 2 * x * y z * 3.5 * z z",
        "+ * x + y 0.3 / - z 2 + * y x 2",       "/ - 1 * x y + / x y / - z x + z 3",
        "+ min x * 2 y max - y z abs - z * x 3", "+ sqrt + z * x x % - x y + z 1",
        "- sqrt / x + y 0.5 min sqrt z + x 1",
    };
    size_t tried = 0;
    for (size_t i = 0; i < sizeof expression / sizeof *expression; i++)
        for (int wide = 0; wide < (i % 2 ? 1 : 2); wide++) {
            char genome[ROOM], no_code[ROOM] = "";
            struct diag d = {0};
            struct compiled c;
            struct compile_options options = compile_defaults();
            struct proof how;
            options.effort = 0;
            begin_genome(genome, wide);
            strcat(genome, "genome g\n");
            add_wide(genome, no_code, wide);
            snprintf(genome + strlen(genome), ROOM - strlen(genome), "r = %s\nend\n", expression[i]);
            struct genome_file *f = genome_parse("test", genome, strlen(genome), &d);
            assert_non_null(f);
            assert_true(compile_genome(f, &f->genome[0], &options, &c, &d));
            const size_t size = strlen(c.text);
            struct tally t = {.file = f, .code = c.text, .changed = new_array(size + 1, 1)};
            assert_int_equal(ask(f, t.code, &how, &d), PROVED);
            change(&t);
            assert_int_equal(t.proved, 0);
            tried += t.tried;
            free(t.changed);
            compiled_free(&c);
            genome_file_free(f);
        }
    assert_true(tried > 300);
}

/* ---- messages ---- */

static void wrong_genomes_are_refused(void **state)
{
    (void)state;
    struct genome_file *f;
    struct diag d = {0};
    struct proof how;
    static const char zero[] = "footpoint-genome 1\ninput x y\ngenome g\nr = / x - * y y * y y\nend\n";
    f = genome_parse("zero.gen", zero, sizeof zero - 1, &d);
    assert_int_equal(ask(f, "*out_r = in_x;", &how, &d), REFUSED);
    assert_string_equal(d.text, "zero.gen:3:1: error: genome 'g' divides by a value that is always 0");
    genome_file_free(f);

    static const char one[] = "footpoint-genome 1\ninput x\ngenome g\nr = + x 1\nend\n";
    f = genome_parse("one.gen", one, sizeof one - 1, &d);
    assert_int_equal(ask(f, "*out_r = in_x + 2.0;", &how, &d), REFUSED);
    assert_string_equal(d.text, "one.gen:3:1: error: internal error: code made for genome 'g' does not equal it");
    genome_file_free(f);
}

/* (x + 1)^(2^n), in lets and the same statements. Powers are not multiplied out, so the degree does not matter until
 * there are too many variables; then every prime may be too small. */
static void high_degrees_are_proved(void **state)
{
    (void)state;
    static const struct {
        int squarings;
        bool wide;
        enum answer answer;
    } known[] = {{50, false, PROVED}, {50, true, PROVED}, {500, true, PROVED}, {1100, true, REFUSED}};
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        const int n = known[k].squarings;
        char *genome = new_array(2 * ROOM + 100 * (size_t)n, 1), *code = new_array(2 * ROOM + 100 * (size_t)n, 1);
        begin_genome(genome, known[k].wide);
        strcat(genome, "let a0 = + x 1\n");
        strcat(code, "const double a0 = in_x + 1.0;\n");
        size_t g = strlen(genome), c = strlen(code);
        for (int i = 1; i <= n; i++) {
            g += (size_t)sprintf(genome + g, "let a%d = * a%d a%d\n", i, i - 1, i - 1);
            c += (size_t)sprintf(code + c, "const double a%d = a%d * a%d;\n", i, i - 1, i - 1);
        }
        strcat(genome, "genome g\n");
        add_wide(genome, code, known[k].wide);
        sprintf(genome + strlen(genome), "r = + 1 * * + x y y a%d\nend\n", n);
        sprintf(code + strlen(code), "*out_r = (in_y + in_x) * a%d * in_y + 1.0;\n", n);
        struct diag d = {0};
        struct proof how = {0};
        struct genome_file *f = genome_parse("power.gen", genome, strlen(genome), &d);
        assert_non_null(f);
        assert_int_equal(ask(f, code, &how, &d), known[k].answer);
        assert_int_equal(how.exact, !known[k].wide);
        if (known[k].answer == REFUSED)
            assert_non_null(strstr(d.text, "is too high to prove its code equal"));
        genome_file_free(f);
        free(genome);
        free(code);
    }
}

static void proofs_are_described(void **state)
{
    (void)state;
    char text[120];
    const struct proof exact = {.exact = true, .points = 2, .bits = 128, .log2_failure = -110};
    const struct proof points = {.points = 2, .bits = 1024, .log2_failure = -110.5};
    proof_print(&exact, text);
    assert_string_equal(text, "proved equal to the genome as rational functions over Q");
    proof_print(&points, text);
    assert_string_equal(text,
                        "equal to the genome at 2 random points modulo a 1024-bit prime: chance of error below 2^-110");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_code_is_proved),    cmocka_unit_test(different_code_is_refused),
        cmocka_unit_test(every_change_is_found),   cmocka_unit_test(wrong_genomes_are_refused),
        cmocka_unit_test(high_degrees_are_proved), cmocka_unit_test(proofs_are_described),
    };
    return cmocka_run_group_tests_name("prove", tests, NULL, NULL);
}
