/* Checkpoints and logs: files read back as written; anything else is refused in one line. */
#include "../../evolve/run/checkpoint.h"
#include "../../evolve/run/run_log.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/footpoint-test-XXXXXX", path[64];

static int setup_folder(void **state)
{
    (void)state;
    if (!mkdtemp(folder))
        return -1;
    snprintf(path, sizeof path, "%s/file", folder);
    return 0;
}

static int teardown_folder(void **state)
{
    (void)state;
    unlink(path);
    return rmdir(folder);
}

static const char facts[] = "version 0\nseed 77\nempty \nlast x y";

static const char *const part[] = {"first", "", "\0\n\377"};
static const size_t bytes[] = {5, 0, 3};

static void write_bytes(const char *data, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(data, 1, n, f), n);
    assert_int_equal(fclose(f), 0);
}

/* Builds the file in memory; sections are inserted from the last to the first. The caller owns it. */
static char *make_checkpoint(size_t *size)
{
    struct checkpoint c = checkpoint_new(facts, bytes, 3);
    char *file = new_array(c.size, 1);
    for (size_t i = 3; i-- > 0;) {
        unsigned char section[5 + CHECKPOINT_SEAL];
        assert_int_equal(c.section[i].bytes, bytes[i]);
        memcpy(section, part[i], bytes[i]);
        checkpoint_seal(section, bytes[i]);
        memcpy(file + c.section[i].place, section, bytes[i] + CHECKPOINT_SEAL);
    }
    memcpy(file, c.head, c.head_bytes);
    *size = c.size;
    checkpoint_free(&c);
    return file;
}

static void check(const struct checkpoint *c)
{
    struct diag d;
    assert_string_equal(c->facts, facts);
    assert_int_equal(c->sections, 3);
    for (size_t i = 0; i < 3; i++) {
        unsigned char *data = checkpoint_section(c, path, i, &d);
        assert_non_null(data);
        assert_int_equal(c->section[i].bytes, bytes[i]);
        assert_memory_equal(data, part[i], bytes[i]);
        free(data);
    }
}

static void files_read_back(void **state)
{
    (void)state;
    struct checkpoint c, other;
    struct diag d;
    char value[8];
    size_t n;
    char *file = make_checkpoint(&n);
    write_bytes(file, n);
    assert_true(checkpoint_read(&c, path, &d));
    check(&c);
    assert_true(checkpoint_take(&other, path, c.head, &d));
    check(&other);
    assert_true(checkpoint_fact(c.facts, "seed", value, sizeof value));
    assert_string_equal(value, "77");
    assert_true(checkpoint_fact(c.facts, "empty", value, sizeof value) && !*value);
    assert_true(checkpoint_fact(c.facts, "last", value, 4));
    assert_string_equal(value, "x y");
    assert_false(checkpoint_fact(c.facts, "last", value, 3));
    assert_false(checkpoint_fact(c.facts, "see", value, sizeof value));
    assert_false(checkpoint_fact(c.facts, "x", value, sizeof value));
    checkpoint_free(&c);
    checkpoint_free(&other);
    free(file);
}

/* Checks that the head or a section is refused. */
static void refused(const char *data, size_t n)
{
    struct checkpoint c;
    struct diag d = {.code = EXIT_DONE};
    write_bytes(data, n);
    if (checkpoint_read(&c, path, &d)) {
        bool good = true;
        for (size_t i = 0; good && i < c.sections; i++) {
            unsigned char *section = checkpoint_section(&c, path, i, &d);
            good = section != NULL;
            free(section);
        }
        assert_false(good);
        checkpoint_free(&c);
    }
    assert_int_equal(d.code, EXIT_INPUT);
    assert_null(strchr(d.text, '\n'));
    assert_memory_equal(d.text, path, strlen(path));
}

static void cut_or_flipped_is_refused(void **state)
{
    (void)state;
    size_t n;
    char *text = make_checkpoint(&n);
    for (size_t i = 0; i < n; i++)
        refused(text, i);
    for (size_t i = 0; i < 8 * n; i++) {
        text[i / 8] = (char)(text[i / 8] ^ 1 << i % 8);
        refused(text, n);
        text[i / 8] = (char)(text[i / 8] ^ 1 << i % 8);
    }
    free(text);
}

/* Valid checksums do not hide invalid contents. */
static void malformed_inside_is_refused(void **state)
{
    (void)state;
    static const char *const body[] = {
        "footpoint-checkpoint 2",
        "footpoint-checkpoint 2\n",
        "footpoint-checkpoint 1 0 0\n",
        "footpoint-checkpoint 2 1 0\n",
        "footpoint-checkpoint 2 -1 0\n",
        "footpoint-checkpoint 2 18446744073709551615 0\n",
        "footpoint-checkpoint 2 99999999999999999999 0\n",
        "footpoint-checkpoint 2 0 1\n",
        "footpoint-checkpoint 2 0 18446744073709551615\n12345678",
        "footpoint-checkpoint 2 0 1\n\377\377\377\377\377\377\377\377",
        "footpoint-checkpoint 2 0 2\n\377\377\377\377\377\377\377\177\377\377\377\377\377\377\377\377",
        "footpoint-checkpoint 2 0 0\nrest",
        "footpoint-checkpoint 2 0 1\n\1\1\1\1\1\1\1\1x",
    };
    for (size_t i = 0; i < sizeof body / sizeof *body; i++) {
        char text[256], hex[65];
        sha256_hex(body[i], strlen(body[i]), hex);
        const int n = snprintf(text, sizeof text, "%s%s\n", body[i], hex);
        refused(text, (size_t)n);
    }
}

static void add_rows(struct run_log *l, uint64_t from, uint64_t to)
{
    for (uint64_t g = from; g < to; g++) {
        const struct log_row row = {g, 5 + g, 100 * g, 1.0 / (double)(g + 1), INFINITY};
        run_log_add(l, 3, "tier", "xi", 1, &row);
    }
}

static void a_log_goes_on_where_its_mark_is(void **state)
{
    (void)state;
    struct run_log l;
    struct diag d;
    size_t n, again;
    assert_true(run_log_open(&l, path, &d));
    add_rows(&l, 1, 9);
    run_log_close(&l);
    char *whole = read_text(path, &n, &d);
    assert_true(run_log_open(&l, path, &d));
    add_rows(&l, 1, 5);
    const struct log_mark mark = run_log_mark(&l);
    add_rows(&l, 5, 7);
    run_log_close(&l);
    assert_true(run_log_continue(&l, path, &mark, &d));
    add_rows(&l, 5, 9);
    assert_true(run_log_sync(&l, &d));
    run_log_close(&l);
    char *text = read_text(path, &again, &d);
    assert_int_equal(again, n);
    assert_memory_equal(text, whole, n);
    text[mark.bytes - 2]++;
    write_bytes(text, n);
    assert_false(run_log_continue(&l, path, &mark, &d));
    assert_int_equal(d.code, EXIT_INPUT);
    write_bytes(whole, mark.bytes - 1);
    assert_false(run_log_continue(&l, path, &mark, &d));
    free(text);
    free(whole);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(files_read_back),
        cmocka_unit_test(cut_or_flipped_is_refused),
        cmocka_unit_test(malformed_inside_is_refused),
        cmocka_unit_test(a_log_goes_on_where_its_mark_is),
    };
    return cmocka_run_group_tests_name("checkpoint", tests, setup_folder, teardown_folder);
}
