/* Islands: the same seed has the same result; known targets are found; seeds and guests survive everything worse. */
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/fit/fits.h"
#include "../../evolve/genotype/line_program.h"
#include "../../evolve/island/island.h"
#include "../../evolve/island/population.h"
#include "../support/genome_text.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 500, X = GENE_SYMBOL + 3, Y, TARGET = 5, MAX_LENGTH = 26 };

struct fixture {
    struct genome_file *program;
    struct columns table; /* a, b, c, x = a / c, y = b / c; xi = x y + 0.5 for the paper's trees; eta = x - y */
    struct objective *objective;
    struct fits *fits;
    struct fitting hooks;
    struct gene_set genes;
};

static int setup(void **state)
{
    static int symbol[] = {X, Y}, operation[] = {GENE_ADD, GENE_SUB, GENE_MUL}, constant[21];
    struct fixture *f = new_array(1, sizeof *f);
    gsl_rng *rng = stream_new();
    stream_key(rng, 11, 0, 0, 0);
    f->table = columns_new(SAMPLES, TARGET + 2);
    for (size_t i = 0; i < SAMPLES; i++) {
        const double x = 2 * gsl_rng_uniform(rng) - 1, y = 2 * gsl_rng_uniform(rng) - 1;
        columns_at(&f->table, 0)[i] = columns_at(&f->table, 3)[i] = x;
        columns_at(&f->table, 1)[i] = columns_at(&f->table, 4)[i] = y;
        columns_at(&f->table, 2)[i] = 1;
        columns_at(&f->table, TARGET)[i] = x * y + 0.5;
        columns_at(&f->table, TARGET + 1)[i] = x - y;
    }
    for (int k = 0; k <= 20; k++)
        constant[k] = decimal_gene((k - 10) / 10.0);
    f->program = parse("footpoint-genome 1\ninput a b c\nlet x = / a c\nlet y = / b c\n");
    f->genes = (struct gene_set){symbol, 2, constant, 21, operation, 3, 0};
    f->objective = objective_new(f->program, &f->table, NORM_MEAN);
    f->objective->decimal = true;
    f->fits = fits_new(f->objective);
    f->hooks = fits_hooks(f->fits);
    gsl_rng_free(rng);
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    fits_free(f->fits);
    objective_free(f->objective);
    columns_free(&f->table);
    genome_file_free(f->program);
    free(f);
    return 0;
}

static struct goal goal_of(const struct fixture *f, enum breeding breeding, uint64_t place)
{
    return (struct goal){.program = breeding == BREED_FRONT,
                         .column = TARGET,
                         .last = -1,
                         .max_length = MAX_LENGTH,
                         .genes = &f->genes,
                         .place = place,
                         .fit = &f->hooks};
}

/* Returns a rough start for a breeding, or the target: x y, then x y + 0.5; for programs with eta. */
static struct genes known(enum breeding breeding, bool rough)
{
    static int paper[2][5] = {{GENE_ADD, GENE_MUL, X, Y, 0}, {GENE_MUL, X, Y}};
    static int program[2][11] = {{LINE_GENE + 1, LINE_GENE + 2, GENE_MUL, X, Y, GENE_ADD, LINE_GENE, 0, GENE_SUB, X, Y},
                                 {LINE_GENE, LINE_GENE + 1, GENE_MUL, X, Y, GENE_SUB, X, Y}};
    paper[0][4] = program[0][7] = decimal_gene(0.5);
    return breeding == BREED_PAPER ? (struct genes){paper[rough], rough ? 3 : 5}
                                   : (struct genes){program[rough], rough ? 8 : 11};
}

/* Makes a plan; the paper's breeding has its roulette and costs, and no parsimony. */
static struct plan plan_of(enum breeding breeding, uint64_t seed, size_t population)
{
    struct plan p = plan_default();
    p.breeding = breeding;
    if (breeding == BREED_PAPER) {
        p.selection = SELECT_ROULETTE;
        p.prices = (struct prices){.add = 0, .div = 1};
        p.parsimony = 0;
    }
    p.seed = seed;
    p.population = population;
    p.migrants = population / 10;
    return p;
}

static uint64_t structure(const struct fixture *f, enum breeding breeding, const struct genes *t)
{
    uint64_t hash;
    if (breeding == BREED_PAPER) {
        struct counter *c = counter_new();
        hash = count_operations(c, t, NULL).hash;
        counter_free(c);
    } else {
        struct lines_counter *c = lines_counter_new(f->objective->rules);
        hash = count_lines(c, t, -1).hash;
        lines_counter_free(c);
    }
    return hash;
}

/* Checks that a report agrees with the front, that errors fall as costs rise, and that no member occurs twice. */
static void check_front(const struct fixture *f, enum breeding breeding, const struct island *is, const int *report)
{
    const struct front *front = is->front;
    const int *at = report + 1;
    double last = INFINITY;
    assert_int_equal(report[0], front_count(front));
    for (int k = 0; k < report[0]; k++) {
        const struct member *m = front_member(front, (size_t)k);
        struct genes t;
        double error;
        at = island_reported(at, &t, &error);
        assert_true(genes_equal(&t, &m->genes) && error == m->error);
        assert_true(t.length <= MAX_LENGTH &&
                    (breeding == BREED_PAPER ? gene_span(t.gene, t.length) == t.length
                                             : lines_valid(f->objective->rules, t.gene, t.length)));
        assert_true(m->error < last);
        const double found = breeding == BREED_PAPER ? objective_tree_error(f->objective, &t, TARGET, INFINITY)
                                                     : objective_error(f->objective, &t, -1, INFINITY);
        assert_true(found == m->error);
        last = m->error;
        for (int i = 0; i < k; i++)
            assert_true(structure(f, breeding, &front_member(front, (size_t)i)->genes) != structure(f, breeding, &t));
    }
    assert_int_equal(at - report, island_report_size(is)); /* limit: a message has at most INT_MAX bytes */
}

/* An island that is saved and loaded by another continues unchanged. A state with a wrong byte is refused or
 * continues. */
static void states_go_on(void **state)
{
    const struct fixture *f = *state;
    for (int breeding = 0; breeding < 2; breeding++) {
        struct plan plan = plan_of((enum breeding)breeding, 7, 40);
        const struct goal goal = goal_of(f, (enum breeding)breeding, 3);
        struct island *is = island_new(&plan, &goal, f->objective), *other = island_new(&plan, &goal, f->objective);
        const size_t size = island_state_size(is);
        unsigned char *bytes = new_array(size, 1), *later = new_array(size, 1);
        island_start(is, NULL, 0);
        for (int k = 0; k < 20; k++) {
            island_save(is, bytes);
            assert_true(island_load(other, bytes));
            island_save(other, later);
            assert_memory_equal(bytes, later, size);
            island_step(is);
            island_step(other);
            island_save(is, bytes);
            island_save(other, later);
            assert_memory_equal(bytes, later, size);
        }
        const size_t step = getenv("FOOTPOINT_LONG") ? 97 : 197;
        size_t refused = 0;
        for (size_t at = 0; at < 20000; at += step) {
            memcpy(later, bytes, size);
            later[at] ^= 0x81;
            refused += !island_load(other, later);
            island_step(other);
        }
        assert_true(refused > 10);
        free(bytes);
        free(later);
        island_free(is);
        island_free(other);
    }
}

/* Evolves an island for some generations, or until its lowest error is below `enough`. Returns that error and a report
 * in *report, which the caller must free. */
static double evolved(const struct fixture *f, const struct plan *plan, uint64_t place, int generations, double enough,
                      int **report, size_t *size)
{
    const struct goal goal = goal_of(f, plan->breeding, place);
    struct island *is = island_new(plan, &goal, f->objective);
    double last = INFINITY;
    island_start(is, NULL, 0);
    for (int k = 0; k < generations && front_error(is->front, INFINITY) >= enough; k++) {
        island_step(is);
        assert_true(island_best(is)->fitness <= last);
        last = island_best(is)->fitness;
    }
    *size = island_report_size(is);
    *report = new_array(*size, sizeof **report);
    island_report(is, *report);
    check_front(f, plan->breeding, is, *report);
    last = front_error(is->front, INFINITY);
    island_free(is);
    return last;
}

static void same_seed_same_result(void **state)
{
    const struct fixture *f = *state;
    for (int breeding = 0; breeding < 2; breeding++) {
        int *first, *second, *other;
        size_t size;
        struct plan plan = plan_of((enum breeding)breeding, 4, 60);
        const double error = evolved(f, &plan, 0, 15, 0, &first, &size);
        evolved(f, &plan, 1, 15, 0, &other, &size);
        assert_true(evolved(f, &plan, 0, 15, 0, &second, &size) == error);
        assert_memory_equal(first, second, size * sizeof *first);
        assert_memory_not_equal(first, other, size * sizeof *first);
        free(first);
        free(second);
        free(other);
    }
}

/* One of three seeds finds the target for each breeding with one selection; with FOOTPOINT_LONG three of five, with
 * both selections. */
static void finds_a_known_target(void **state)
{
    const struct fixture *f = *state;
    const int seeds = getenv("FOOTPOINT_LONG") ? 5 : 3, enough = seeds - 2;
    for (int k = 0; k < 4; k += seeds == 5 ? 1 : 3) {
        int found = 0;
        for (int seed = 1; seed <= seeds && found < enough; seed++) {
            int *report;
            size_t size;
            struct plan plan = plan_of((enum breeding)(k / 2), (uint64_t)seed, 200);
            plan.selection = (enum selection)(k % 2);
            found += evolved(f, &plan, 0, 60, 1e-15, &report, &size) < 1e-15;
            free(report);
        }
        if (found < enough)
            fail_msg("breeding %d, selection %d: x y + 0.5 is found with %d seeds of %d", k / 2, k % 2, found, seeds);
    }
}

/* A seed stays until a better individual replaces it; the maximum norm is minimised as well. */
static void seeds_survive(void **state)
{
    const struct fixture *f = *state;
    for (int breeding = 0; breeding < 2; breeding++) {
        struct plan plan = plan_of((enum breeding)breeding, 1, 20);
        const struct goal goal = goal_of(f, plan.breeding, 0);
        const struct genes seed[] = {known(plan.breeding, true), known(plan.breeding, false)};
        struct objective *objective = objective_new(f->program, &f->table, NORM_MAX);
        objective->decimal = true;
        struct island *is = island_new(&plan, &goal, objective);
        island_start(is, seed, 2);
        for (int k = 0; k < 12; k++)
            island_step(is);
        assert_true(island_best(is)->error < 1e-15);
        assert_true(structure(f, plan.breeding, &island_best(is)->genes) == structure(f, plan.breeding, &seed[1]));
        island_free(is);
        objective_free(objective);
    }
}

static void guests_compete(void **state)
{
    const struct fixture *f = *state;
    for (int breeding = 0; breeding < 2; breeding++) {
        struct plan plan = plan_of((enum breeding)breeding, 1, 30);
        plan.parsimony = 0.01;
        const struct goal goal = goal_of(f, plan.breeding, 0), there = goal_of(f, plan.breeding, 1);
        const struct genes seed = known(plan.breeding, true);
        struct island *is = island_new(&plan, &goal, f->objective), *other = island_new(&plan, &there, f->objective);
        island_start(is, &seed, 1);
        island_start(other, NULL, 0);
        const double best = fmin(island_best(is)->fitness, island_best(other)->fitness);
        int *parcel = new_array(island_parcel_size(is, 3), sizeof *parcel);
        island_pack(is, 3, parcel);
        island_receive(other, 3, parcel);
        island_receive(other, 3, parcel); /* individuals that live there already change nothing */
        assert_true(breeding == BREED_FRONT ? island_best(other)->fitness <= best
                                            : island_best(other)->fitness == best);
        free(parcel);
        island_free(is);
        island_free(other);
    }
}

static bool thorough_is_magic;

/* A fit that knows the answer; it succeeds only if it is as thorough as required. */
static bool fit_by_magic(struct fits *fits, const struct genes *in, int last, bool thoroughly, struct genes *out)
{
    const struct genes answer = known(BREED_FRONT, false);
    (void)fits;
    (void)last;
    if (in->length == 2 || thoroughly != thorough_is_magic)
        return false;
    genes_copy(&answer, out);
    return true;
}

static void fits_are_called(void **state)
{
    const struct fixture *f = *state;
    const struct genes seed = known(BREED_FRONT, true);
    for (int k = 0; k < 2; k++) {
        struct fitting fit = f->hooks;
        fit.fit = fit_by_magic;
        thorough_is_magic = k == 1;
        struct plan plan = plan_of(BREED_FRONT, 1, 50);
        plan.tune = 1;
        plan.polish_every = 1;
        struct goal goal = goal_of(f, BREED_FRONT, 0);
        goal.fit = &fit;
        struct island *is = island_new(&plan, &goal, f->objective);
        island_start(is, &seed, 1);
        for (int generation = 0; generation < 3; generation++)
            island_step(is);
        if (!(front_error(is->front, 100) < 1e-15))
            fail_msg("fit %d is not used", k);
        island_free(is);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(same_seed_same_result, setup, teardown),
        cmocka_unit_test_setup_teardown(states_go_on, setup, teardown),
        cmocka_unit_test_setup_teardown(finds_a_known_target, setup, teardown),
        cmocka_unit_test_setup_teardown(seeds_survive, setup, teardown),
        cmocka_unit_test_setup_teardown(guests_compete, setup, teardown),
        cmocka_unit_test_setup_teardown(fits_are_called, setup, teardown),
    };
    return cmocka_run_group_tests_name("island", tests, NULL, NULL);
}
