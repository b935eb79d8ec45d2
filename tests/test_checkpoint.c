/* Checkpoints and logs: what is read is what was written, anything else is refused in one line; an island goes on from
 * its saved state as if nothing had been, and no state that it is given breaks it. */
#include "../evolve/checkpoint.h"
#include "../evolve/island.h"
#include "../evolve/run_log.h"
#include "../evolve/stream.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

/* ---- files ---- */

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

static void write_checkpoint(void)
{
    struct checkpoint_writer w;
    struct diag d;
    assert_true(checkpoint_begin(&w, path, facts, 3, &d));
    checkpoint_section(&w, "first", 5);
    checkpoint_section(&w, "", 0);
    checkpoint_section(&w, "\0\n\377", 3);
    assert_true(checkpoint_commit(&w, &d));
}

static void write_bytes(const char *data, size_t n)
{
    FILE *f = fopen(path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(data, 1, n, f), n);
    assert_int_equal(fclose(f), 0);
}

static void read_is_what_was_written(void **state)
{
    (void)state;
    struct checkpoint c;
    struct diag d;
    char value[8];
    write_checkpoint();
    assert_true(checkpoint_read(&c, path, &d));
    assert_string_equal(c.facts, facts);
    assert_int_equal(c.sections, 3);
    assert_int_equal(c.section[0].bytes, 5);
    assert_memory_equal(c.section[0].data, "first", 5);
    assert_int_equal(c.section[1].bytes, 0);
    assert_int_equal(c.section[2].bytes, 3);
    assert_memory_equal(c.section[2].data, "\0\n\377", 3);
    assert_true(checkpoint_fact(c.facts, "seed", value, sizeof value));
    assert_string_equal(value, "77");
    assert_true(checkpoint_fact(c.facts, "empty", value, sizeof value) && !*value);
    assert_true(checkpoint_fact(c.facts, "last", value, 4));
    assert_string_equal(value, "x y");
    assert_false(checkpoint_fact(c.facts, "last", value, 3));
    assert_false(checkpoint_fact(c.facts, "see", value, sizeof value));
    assert_false(checkpoint_fact(c.facts, "x", value, sizeof value));
    checkpoint_free(&c);
}

static void refused(const char *data, size_t n)
{
    struct checkpoint c;
    struct diag d;
    write_bytes(data, n);
    assert_false(checkpoint_read(&c, path, &d));
    assert_int_equal(d.code, EXIT_INPUT);
    assert_null(strchr(d.text, '\n'));
    assert_memory_equal(d.text, path, strlen(path));
}

static void cut_or_flipped_is_refused(void **state)
{
    (void)state;
    size_t n;
    struct diag d;
    write_checkpoint();
    char *text = read_text(path, &n, &d);
    for (size_t i = 0; i < n; i++)
        refused(text, i);
    for (size_t i = 0; i < 8 * n; i++) {
        text[i / 8] = (char)(text[i / 8] ^ 1 << i % 8);
        refused(text, n);
        text[i / 8] = (char)(text[i / 8] ^ 1 << i % 8);
    }
    free(text);
}

/* Sealed well, but nonsense inside. */
static void malformed_inside_is_refused(void **state)
{
    (void)state;
    static const char *const body[] = {
        "footpoint-checkpoint 1",
        "footpoint-checkpoint 1\n",
        "footpoint-checkpoint 2 0 0\n",
        "footpoint-checkpoint 1 1 0\n",
        "footpoint-checkpoint 1 -1 0\n",
        "footpoint-checkpoint 1 18446744073709551615 0\n",
        "footpoint-checkpoint 1 99999999999999999999 0\n",
        "footpoint-checkpoint 1 0 1\n",
        "footpoint-checkpoint 1 0 18446744073709551615\n12345678",
        "footpoint-checkpoint 1 0 1\n\377\377\377\377\377\377\377\377",
        "footpoint-checkpoint 1 0 0\nrest",
        "footpoint-checkpoint 1 0 1\n\1\1\1\1\1\1\1\1x",
    };
    for (size_t i = 0; i < sizeof body / sizeof *body; i++) {
        char text[256], hex[65];
        sha256_hex(body[i], strlen(body[i]), hex);
        const int n = snprintf(text, sizeof text, "%s%s\n", body[i], hex);
        refused(text, (size_t)n);
    }
}

static void a_failed_write_leaves_the_last(void **state)
{
    (void)state;
    struct checkpoint_writer w;
    struct checkpoint c;
    struct diag d;
    write_checkpoint();
    assert_true(checkpoint_begin(&w, path, "seed 1\n", 1, &d));
    checkpoint_section(&w, "new", 3);
    fclose(w.file.stream);
    w.file.stream = fopen("/dev/full", "wb");
    fputc('x', w.file.stream);
    assert_false(checkpoint_commit(&w, &d));
    assert_int_equal(d.code, EXIT_SYSTEM);
    assert_true(checkpoint_read(&c, path, &d));
    assert_string_equal(c.facts, facts);
    checkpoint_free(&c);
    assert_false(checkpoint_begin(&w, "/nowhere/file", facts, 0, &d));
    assert_string_equal(d.text, "/nowhere/file: error: cannot write: No such file or directory");
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

/* ---- islands ---- */

enum { SAMPLES = 300, TARGET = 2, MAX_LENGTH = 21 };

struct fixture {
    struct genome_file *program;
    struct columns table; /* x, y, x y + 0.5 */
    struct judge *judge;
    struct gene_set genes;
    struct plan plan;
    struct goal goal;
};

static int setup(void **state)
{
    static int symbol[] = {GENE_SYMBOL, GENE_SYMBOL + 1}, operation[] = {GENE_ADD, GENE_SUB, GENE_MUL}, constant[21];
    struct fixture *f = new_array(1, sizeof *f);
    f->program = genome_file_new("test");
    f->table = columns_new(SAMPLES, TARGET + 1);
    for (size_t i = 0; i < SAMPLES; i++) {
        const double x = sin((double)i), y = cos(3.0 * (double)i);
        columns_at(&f->table, 0)[i] = x;
        columns_at(&f->table, 1)[i] = y;
        columns_at(&f->table, TARGET)[i] = sqrt(2 + x) * y + 0.5;
    }
    for (int k = 0; k <= 20; k++) {
        char text[16];
        snprintf(text, sizeof text, "%.1f", (k - 10) / 10.0);
        constant[k] = -1 - (int)genome_add_constant(f->program, text);
    }
    f->genes = (struct gene_set){symbol, 2, constant, 21, operation, 3};
    f->judge = judge_new(f->program, &f->table, NORM_MEAN);
    f->plan = (struct plan){.seed = 4, .population = 40, .selection = SELECT_TOURNAMENT, .migrants = 4};
    f->goal = (struct goal){.target = TARGET, .max_length = MAX_LENGTH, .genes = &f->genes};
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    judge_free(f->judge);
    columns_free(&f->table);
    genome_file_free(f->program);
    free(f);
    return 0;
}

static void steps(struct island *is, int n)
{
    while (n-- > 0)
        island_step(is);
}

static void same_state(const struct island *a, const struct island *b)
{
    const size_t n = island_state_size(a);
    unsigned char *p = new_array(n, 1), *q = new_array(n, 1);
    assert_int_equal(island_state_size(b), n);
    island_save(a, p);
    island_save(b, q);
    assert_memory_equal(p, q, n);
    free(p);
    free(q);
}

static void an_island_goes_on_from_its_state(void **state)
{
    const struct fixture *f = *state;
    struct island *a = island_new(&f->plan, &f->goal, f->judge), *b = island_new(&f->plan, &f->goal, f->judge);
    unsigned char *saved = new_array(island_state_size(a), 1);
    island_start(a, NULL);
    steps(a, 7);
    island_save(a, saved);
    assert_true(island_load(b, saved));
    same_state(a, b);
    assert_true(island_evaluations(b) == island_evaluations(a));
    steps(a, 20);
    steps(b, 20);
    same_state(a, b);
    const size_t ints = island_report_size(a);
    int *report = new_array(ints, sizeof *report), at = 1;
    assert_int_equal(island_report_size(b), ints);
    island_report(a, report);
    for (int k = 0; k < report[0]; k++) {
        const size_t length = (size_t)report[at];
        assert_int_equal(gene_span(report + at + 1, length), length);
        at += 1 + report[at];
    }
    assert_int_equal(at, ints);
    free(report);
    free(saved);
    island_free(a);
    island_free(b);
}

/* Bytes of a state changed at random: taken or refused, but an island that refuses is as it was, and one that takes
 * goes on. */
static void no_state_breaks_an_island(void **state)
{
    const struct fixture *f = *state;
    struct island *a = island_new(&f->plan, &f->goal, f->judge), *b = island_new(&f->plan, &f->goal, f->judge);
    const size_t n = island_state_size(a), people = 16 + f->plan.population * (16 + MAX_LENGTH * sizeof(int));
    unsigned char *saved = new_array(n, 1), *bad = new_array(n, 1);
    gsl_rng *rng = stream_new();
    int taken = 0;
    stream_key(rng, 9, 0, 0, 0);
    island_start(a, NULL);
    steps(a, 3);
    island_save(a, saved);
    for (int k = 0; k < 400; k++) {
        memcpy(bad, saved, n);
        const int changes = 1 + k % 3;
        for (int i = 0; i < changes; i++)
            bad[gsl_rng_uniform_int(rng, k % 2 == 0 ? people : n)] ^= (unsigned char)(1 << gsl_rng_uniform_int(rng, 8));
        assert_true(island_load(b, saved));
        if (island_load(b, bad)) {
            steps(b, 2);
            taken++;
        } else {
            same_state(a, b);
        }
    }
    assert_true(taken < 400);
    gsl_rng_free(rng);
    free(saved);
    free(bad);
    island_free(a);
    island_free(b);
}

int main(void)
{
    const struct CMUnitTest files[] = {
        cmocka_unit_test(read_is_what_was_written),        cmocka_unit_test(cut_or_flipped_is_refused),
        cmocka_unit_test(malformed_inside_is_refused),     cmocka_unit_test(a_failed_write_leaves_the_last),
        cmocka_unit_test(a_log_goes_on_where_its_mark_is),
    };
    const struct CMUnitTest islands[] = {
        cmocka_unit_test_setup_teardown(an_island_goes_on_from_its_state, setup, teardown),
        cmocka_unit_test_setup_teardown(no_state_breaks_an_island, setup, teardown),
    };
    const int failed = cmocka_run_group_tests_name("checkpoint", files, setup_folder, teardown_folder);
    return failed + cmocka_run_group_tests_name("island states", islands, NULL, NULL);
}
