/* Cost models: the built-in models, and files, valid and refused. */
#include "../../codegen/graph/cost.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#define GOOD "footpoint-costs 1\nmul 1\nadd 1\ndiv 7.9\nsqrt 9.1\ncompare 1.2\n"

static char path[64];

static int setup(void **state)
{
    (void)state;
    snprintf(path, sizeof path, "/tmp/test_cost.XXXXXX");
    const int file = mkstemp(path);
    return file < 0 ? -1 : close(file);
}

static int teardown(void **state)
{
    (void)state;
    return unlink(path);
}

static bool read_costs(const char *text, size_t size, struct cost_model *m, struct diag *d)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
    return cost_model_find(path, m, d);
}

/* `where` is "line:column". */
static void refuses_text(const char *text, size_t size, const char *where, const char *message)
{
    const struct cost_model before = {.name = "before", .div = 3};
    struct cost_model m = before;
    struct diag d = {0};
    char expected[300];
    snprintf(expected, sizeof expected, "%s:%s: error: %s", path, where, message);
    assert_false(read_costs(text, size, &m, &d));
    assert_string_equal(d.text, expected);
    assert_int_equal(d.code, EXIT_INPUT);
    assert_memory_equal(&m, &before, sizeof m);
}

static void refuses(const char *text, const char *where, const char *message)
{
    refuses_text(text, strlen(text), where, message);
}

static void built_in_models_are_known(void **state)
{
    (void)state;
    static const char *const name[] = {"throughput", "operations", "paper"};
    struct cost_model m;
    struct diag d;
    for (size_t i = 0; i < 3; i++) {
        assert_true(cost_model_find(name[i], &m, &d));
        assert_string_equal(m.name, name[i]);
        assert_true(m.mul > 0 && m.add > 0 && m.div >= m.mul && m.sqrt >= m.mul && m.compare > 0);
    }
}

static void unknown_models_are_refused(void **state)
{
    (void)state;
    struct cost_model m;
    struct diag d;
    assert_false(cost_model_find("fast", &m, &d));
    assert_string_equal(d.text,
                        "fast: error: must be throughput, operations, paper or a cost file: No such file or directory");
    assert_int_equal(d.code, EXIT_SYSTEM);
    assert_false(cost_model_find("/tmp", &m, &d));
    assert_string_equal(d.text, "/tmp: error: cannot read: Is a directory");
    assert_int_equal(d.code, EXIT_SYSTEM);
}

static void valid_files_are_read(void **state)
{
    (void)state;
    struct cost_model m;
    struct diag d = {0};
    assert_true(read_costs(GOOD, strlen(GOOD), &m, &d));
    assert_string_equal(m.name, strrchr(path, '/') + 1);
    assert_true(m.mul == 1 && m.add == 1 && m.div == 7.9 && m.sqrt == 9.1 && m.compare == 1.2);
    const char *text =
        "footpoint-costs 1 # of what\r\n# free\n\n\tchain  0 # of old\r\ncompare 0\nsqrt 1e9\ndiv +1e-3\n"
        "  add .5\nmul 2.";
    assert_true(read_costs(text, strlen(text), &m, &d));
    assert_true(m.mul == 2 && m.add == 0.5 && m.div == 1e-3 && m.sqrt == 1e9 && m.compare == 0);
}

static void wrong_versions_are_refused(void **state)
{
    (void)state;
    refuses("", "1:1", "not a cost file: the first word must be 'footpoint-costs'");
    refuses("\nfootpoint-costs 1\n", "1:1", "not a cost file: the first word must be 'footpoint-costs'");
    refuses("footpoint-genome 1\n", "1:1", "not a cost file: the first word must be 'footpoint-costs'");
    refuses("footpoint-costs\n", "1:16", "format version '' is not supported; this program reads version 1");
    refuses("footpoint-costs 2\n", "1:17", "format version '2' is not supported; this program reads version 1");
    refuses("footpoint-costs 1 2\n", "1:19", "unexpected '2' after the version");
}

#define START "footpoint-costs 1\nmul 1\n"

static void wrong_keys_are_refused(void **state)
{
    (void)state;
    refuses(START "fma 1\n", "3:1", "unknown key 'fma'");
    refuses(START "Add 1\n", "3:1", "unknown key 'Add'");
    refuses(START "\x01\xff 1\n", "3:1", "unknown key '?\?'");
    refuses(START "add 1\n mul 1\n", "4:2", "key 'mul' is given twice");
    refuses("footpoint-costs 1\nmul 1\nadd 1\ndiv 7.9\nsqrt 9.1\nchain 0\n", "7:1", "key 'compare' is missing");
    refuses("footpoint-costs 1\n", "2:1", "key 'mul' is missing");
    refuses("footpoint-costs 1", "1:18", "key 'mul' is missing");
    refuses(START "a23456789b23456789c23456789d23456789e23456789 1\n", "3:1",
            "unknown key 'a23456789b23456789c23456789d23456789e234...'");
    refuses_text(GOOD "\0add 1\n", sizeof GOOD + 6, "7:1", "text contains a NUL character");
    refuses_text(START "add\0 1\n", sizeof START + 6, "3:1", "text contains a NUL character");
}

static void wrong_numbers_are_refused(void **state)
{
    (void)state;
    static const char *const malformed[] = {"x", "nan", "inf", "0x10", "1.2.3", "1e", "--1", "1.0f"};
    static const char *const outside[] = {"-1", "-1e-300", "1e999", "1.1e9"};
    char text[100], message[100];
    for (size_t i = 0; i < sizeof malformed / sizeof *malformed; i++) {
        snprintf(text, sizeof text, START "div  %s\n", malformed[i]);
        snprintf(message, sizeof message, "'%s' must be a decimal number", malformed[i]);
        refuses(text, "3:6", message);
    }
    for (size_t i = 0; i < sizeof outside / sizeof *outside; i++) {
        snprintf(text, sizeof text, START "div  %s\n", outside[i]);
        snprintf(message, sizeof message, "cost '%s' must be between 0 and 1e9", outside[i]);
        refuses(text, "3:6", message);
    }
    refuses(START "add\n", "3:4", "expected a number");
    refuses(START "add # 1\n", "3:8", "expected a number");
    refuses(START "add 1,5\n", "3:6", "unexpected ',' after the number");
    refuses(START "add 1 2\n", "3:7", "unexpected '2' after the number");
    refuses(START "chain 1\n", "3:7", "'chain' must be 0, not '1': costs of the longest chain are no longer supported");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(built_in_models_are_known), cmocka_unit_test(unknown_models_are_refused),
        cmocka_unit_test(valid_files_are_read),      cmocka_unit_test(wrong_versions_are_refused),
        cmocka_unit_test(wrong_keys_are_refused),    cmocka_unit_test(wrong_numbers_are_refused)};
    return cmocka_run_group_tests_name("cost", tests, setup, teardown);
}
