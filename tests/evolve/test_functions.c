/* Twin trees and the functions of frames: values against those of the genome text they are written as, derivatives
 * against differences, operations counted by hand, hand-written methods among the seeds, and evolution from them. */
#include "../../evolve/archive/archive.h"
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/eval/frame.h"
#include "../../evolve/eval/tape.h"
#include "../../evolve/fit/compose.h"
#include "../../evolve/fit/fit_twin.h"
#include "../../evolve/fit/fits.h"
#include "../../evolve/genotype/twin_text.h"
#include "../../evolve/island/island.h"
#include "../../evolve/samples/samples.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { LONGEST = 40 };

struct fixture {
    struct scene *scene;
    struct archive *archive;
    struct genome_file *program; /* the archive's */
    struct sample_set set;
    struct columns table;
    struct objective *objective;
    struct gene_set genes;
    struct plan plan;
};

static int setup(void **state)
{
    struct fixture *f = new_array(1, sizeof *f);
    struct diag d;
    f->scene = scene_read(".", "tests/scenes/steps.scene", &d);
    assert_non_null(f->scene);
    f->program = frame_program(".", f->scene, "steps", &d);
    assert_non_null(f->program);
    f->archive = archive_new(f->scene, f->program, NULL, &d);
    assert_true(f->archive && scene_samples(f->scene, PART_TRAINING, &f->set, &d));
    struct kernel *kernel = kernel_new_widest();
    f->table = frame_columns(kernel, f->program, f->set.s, f->set.n);
    kernel_free(kernel);
    f->objective = objective_new(f->program, &f->table, NORM_MEAN);
    f->objective->decimal = true;
    f->genes = archive_genes(f->archive, 0, false);
    f->plan = plan_default();
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    gene_set_free(&f->genes);
    objective_free(f->objective);
    columns_free(&f->table);
    sample_set_free(&f->set);
    archive_free(f->archive);
    scene_free(f->scene);
    free(f);
    return 0;
}

static struct tree tree_of(const struct fixture *f, const char *text)
{
    struct tree t;
    assert_true(twin_parse(f->program, text, &t));
    return t;
}

static double error_of(const struct fixture *f, const struct tree *t)
{
    return objective_error(f->objective, t, frame_target(f->program, TIER_BOTH), INFINITY);
}

static double cost_of(const struct fixture *f, const char *text)
{
    struct tree t = tree_of(f, text);
    struct twin_counter *c = twin_counter_new(f->objective->twins);
    const struct operation_count o = count_twin_operations(c, &t);
    twin_counter_free(c);
    free(t.gene);
    return operations_price(&o, &f->plan.prices);
}

/* Bit by bit, or both infinite: errors of a tree against those of its expressions in a copy of the program. */
static void check_against_text(const struct fixture *f, const struct tree *t)
{
    const size_t n = f->set.n;
    double *error = new_array(2 * n, sizeof *error), *value = new_array(n, sizeof *value);
    char *text = NULL;
    size_t size;
    struct diag d;
    struct tree out[2];
    FILE *stream = open_memstream(&text, &size);
    genome_print(f->program, stream);
    fclose(stream);
    struct genome_file *copy = genome_parse("copy", text, size, &d);
    assert_non_null(copy);
    twin_expand(f->objective->twins, t, copy, "value", out);
    struct kernel *kernel = kernel_new_widest();
    struct columns table = frame_columns(kernel, copy, f->set.s, n);
    twin_errors(f->objective->twin, t, error);
    for (size_t half = 0; half < 2; half++) {
        const struct kernel_task task = {out[half].gene, out[half].length, copy->constant, &table};
        kernel_values(kernel, &task, value);
        for (size_t i = 0; i < n; i++) {
            const double e = fabs(value[i] - columns_at(&table, frame_target(copy, (int)half))[i]);
            assert_true(isnan(e) ? error[half * n + i] == INFINITY : error[half * n + i] == e);
        }
        free(out[half].gene);
    }
    columns_free(&table);
    kernel_free(kernel);
    genome_file_free(copy);
    free(text);
    free(error);
    free(value);
}

static void test_values(void **state)
{
    const struct fixture *f = *state;
    int gene[LONGEST];
    struct tree t = {gene, 0};
    gsl_rng *rng = stream_new();
    for (uint64_t k = 0; k < 150; k++) {
        stream_key(rng, 7, k, 0, 0);
        tree_random(rng, &f->genes, 2 + (int)(k % 6), k % 2 == 0, LONGEST, &t);
        check_against_text(f, &t);
    }
    gsl_rng_free(rng);
}

static void test_halves(void **state)
{
    const struct fixture *f = *state;
    static const char *const equal[][2] = {{"exchange exchange p", "p"},
                                           {"exchange p", "halves q exchange p"},
                                           {"halves p exchange q", "halves p p"},
                                           {"halves 1 exchange halves 2 3", "halves 1 2"},
                                           {"solve_v solve_u p", "halves solve_u p solve_v solve_u p"},
                                           {"max halves u_lo v_lo min halves u_hi v_hi ut", "inside ut"}};
    for (size_t i = 0; i < sizeof equal / sizeof *equal; i++) {
        struct tree a = tree_of(f, equal[i][0]), b = tree_of(f, equal[i][1]);
        assert_true(error_of(f, &a) == error_of(f, &b));
        assert_true(cost_of(f, equal[i][0]) == cost_of(f, equal[i][1]));
        free(a.gene);
        free(b.gene);
    }
}

/* d root / d number by central differences, sample by sample. */
static void test_derivatives(void **state)
{
    const struct fixture *f = *state;
    static const char *const text[] = {"place * 0.9 p", "inside + halves 0.02 -0.03 newton_kept * 0.8 ut",
                                       "max -0.2 solve_u + 0.1 solve_v - p 0.05", "newton * 0.7 newton * 0.7 p"};
    const double step = 1e-6;
    struct twin_run *r = twin_run_new(f->objective->twins, &f->table);
    for (size_t i = 0; i < sizeof text / sizeof *text; i++) {
        struct tree t = tree_of(f, text[i]);
        twin_load(r, &t);
        assert_true(r->code->numbers > 0);
        for (size_t k = 0; k < r->code->numbers; k++)
            for (int half = 0; half < 2; half++) {
                double *number = &r->code->line[r->code->number[k]].number, slope[TAPE_BLOCK] = {0},
                       value[2][TAPE_BLOCK];
                const double kept = *number;
                size_t far = 0;
                twin_values(r, 0);
                twin_slopes(r, half);
                if (r->slope[r->code->number[k]])
                    memcpy(slope, r->slope[r->code->number[k]], sizeof slope);
                for (int side = 0; side < 2; side++) {
                    *number = kept + (side ? step : -step);
                    twin_values(r, 0);
                    memcpy(value[side], r->value[r->code->root[half]], sizeof *value);
                }
                *number = kept;
                for (size_t j = 0; j < TAPE_BLOCK; j++)
                    far += !(fabs((value[1][j] - value[0][j]) / (2 * step) - slope[j]) < 1e-3 * (1 + fabs(slope[j])));
                assert_true(far <= TAPE_BLOCK / 20); /* kinks and poles */
            }
        free(t.gene);
    }
    twin_run_free(r);
}

/* Prices: a product and a sum 1, a quotient 8. */
static void test_costs(void **state)
{
    const struct fixture *f = *state;
    /* (d1 + v (cd - (e12 + v c2))) / (e11 + v (c1 + (c1 + v cc))): 4 products, 6 sums and a quotient; c1, c2, cc and
     * cd, which p does not need, are 12 products and 8 sums; 3 products and a sum made p, which is not needed. */
    assert_true(cost_of(f, "solve_u p") - cost_of(f, "p") == 4 + 6 + 8 + 12 + 8 - 3 - 1);
    /* A step of a step costs a step: nothing grows with nesting, and halves share what they have in common. */
    const double one = cost_of(f, "newton p"), two = cost_of(f, "newton newton p"),
                 four = cost_of(f, "newton newton newton newton p");
    assert_true(four - two == 2 * (two - one) && two - one < 80);
    /* What a seed has in common with the frame's own value is counted once. */
    assert_true(cost_of(f, "halves u2 inside ut") == cost_of(f, "inside ut"));
}

static void test_text(void **state)
{
    const struct fixture *f = *state;
    static const char *const bad[] = {"", "newton", "newton p q", "halves p", "sqr p", "1.5e", "+ p 1x"};
    static const char good[] = "place + newton_kept halves p 0.25 * -1.5 exchange min ut solve_u uw";
    struct tree t = tree_of(f, good);
    char *text = twin_print(f->program, &t);
    assert_string_equal(text, good);
    free(text);
    free(t.gene);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(twin_parse(f->program, bad[i], &t));
}

/* Truncated iterations that a programmer would write: for the cost of each there is a seed that is as good. */
static void test_seeds(void **state)
{
    const struct fixture *f = *state;
    static const char *const method[] = {"place p",
                                         "place inside p",
                                         "place inside ut",
                                         "place newton_kept p",
                                         "place newton_kept inside p",
                                         "place inside newton_kept inside ut",
                                         "place newton_kept newton_kept p",
                                         "place inside newton_kept inside newton_kept inside ut",
                                         "place solve_v inside solve_u inside ut",
                                         "place newton_kept newton_kept newton_kept ut"};
    struct front *found = front_new(f->plan.front_limit, 12);
    compose_twins(&f->genes, f->objective, &f->plan.prices, found);
    for (size_t i = 0; i < sizeof method / sizeof *method; i++) {
        struct tree t = tree_of(f, method[i]);
        assert_true(front_error(found, cost_of(f, method[i])) <= error_of(f, &t));
        free(t.gene);
    }
    front_free(found);
}

/* From the seeds evolution goes on: it keeps all of them and betters some, and the whole front is there. */
static void test_evolution(void **state)
{
    const struct fixture *f = *state;
    struct front *found = front_new(f->plan.front_limit, 12);
    struct fits *fits = fits_new(f->objective);
    const struct fitting hooks = fits_hooks(fits);
    struct plan plan = f->plan;
    plan.population = 60;
    plan.migrants = 0;
    const struct goal goal = {
        .target = frame_target(f->program, TIER_BOTH), .max_length = 12, .genes = &f->genes, .fit = &hooks};
    compose_twins(&f->genes, f->objective, &plan.prices, found);
    struct tree *seed = new_array(front_count(found), sizeof *seed);
    for (size_t i = 0; i < front_count(found); i++)
        seed[i] = front_member(found, i)->tree;
    struct island *is = island_new(&plan, &goal, f->objective);
    island_start(is, seed, front_count(found));
    for (int k = 0; k < 15; k++)
        island_step(is);
    const struct front *all = island_front(is);
    size_t better = 0;
    for (size_t i = 0; i < front_count(found); i++) {
        const struct member *m = front_member(found, i);
        assert_true(front_error(all, m->cost) <= m->error);
        better += front_error(all, m->cost) < 0.9 * m->error;
    }
    assert_true(better >= 5);
    for (size_t i = 0; i + 1 < front_count(all); i++) {
        const struct member *m = front_member(all, i), *next = front_member(all, i + 1);
        assert_true(m->cost < next->cost && m->error > next->error && m->error == error_of(f, &m->tree));
    }
    unsigned char *saved = new_array(island_state_size(is), 1);
    island_save(is, saved);
    assert_true(island_load(is, saved)); /* functions are genes of a saved state, too */
    free(saved);
    island_free(is);
    fits_free(fits);
    free(seed);
    front_free(found);
}

/* The best numbers are found again, in each norm. */
static void test_fit(void **state)
{
    const struct fixture *f = *state;
    int gene[LONGEST];
    struct tree fitted = {gene, 0}, t = tree_of(f, "place * 0.5 inside + halves 0.1 -0.1 p");
    struct twin_run *r = twin_run_new(f->objective->twins, &f->table);
    for (enum scene_norm norm = NORM_MEAN; norm <= NORM_MAX; norm++) {
        f->objective->norm = norm;
        assert_true(twin_fit(r, &t, norm, 20, &fitted));
        assert_int_equal(fitted.length, t.length);
        const double error = error_of(f, &fitted);
        assert_true(error < 0.9 * error_of(f, &t));
        for (size_t i = 0; i < fitted.length; i++)
            for (int side = -1; side <= 1; side += 2) {
                const int kept = gene[i];
                if (kept >= 0)
                    continue;
                gene[i] = decimal_gene(decimal_value(kept) + side * 0.02);
                assert_true(error < 1.01 * error_of(f, &fitted));
                gene[i] = kept;
            }
    }
    f->objective->norm = NORM_MEAN;
    struct tree none = tree_of(f, "newton p");
    assert_false(twin_fit(r, &none, NORM_MEAN, 5, &fitted));
    free(none.gene);
    twin_run_free(r);
    free(t.gene);
}

/* Minima and maxima in trees of one output: |x| and a clamp are found. */
static void test_clamps(void **state)
{
    const struct fixture *f = *state;
    const struct gene_set genes = archive_genes(f->archive, 1, false);
    int gene[LONGEST];
    struct tree t = {gene, 0};
    size_t clamps = 0;
    gsl_rng *rng = stream_new();
    assert_true(genes.operations == 5 && genes.functions == 0);
    for (uint64_t k = 0; k < 50; k++) {
        stream_key(rng, 8, k, 0, 0);
        tree_random(rng, &genes, 4, true, LONGEST, &t);
        for (size_t i = 0; i < t.length; i++)
            clamps += t.gene[i] == GENE_MIN || t.gene[i] == GENE_MAX;
    }
    assert_true(clamps > 100);
    gsl_rng_free(rng);
    struct gene_set set = genes;
    gene_set_free(&set);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_values), cmocka_unit_test(test_halves), cmocka_unit_test(test_derivatives),
        cmocka_unit_test(test_costs),  cmocka_unit_test(test_text),   cmocka_unit_test(test_seeds),
        cmocka_unit_test(test_fit),    cmocka_unit_test(test_clamps), cmocka_unit_test(test_evolution)};
    return cmocka_run_group_tests(tests, setup, teardown);
}
