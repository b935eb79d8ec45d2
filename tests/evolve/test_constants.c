/* Fits of constants and of root terms: derivatives against differences, known answers, promises kept for random trees.
 */
#include "../../evolve/fit/fit_linear.h"
#include "../support/search_fixture.h"

enum { SYMBOLS = 3, GOAL = SYMBOLS, LONGEST = 60, SAMPLES = 1000 };

static int setup(void **state)
{
    *state = fixture_new(11, SAMPLES, SYMBOLS, 2);
    return 0;
}

static size_t random_genome(gsl_rng *rng, size_t room, int *gene)
{
    if (room < 3 || gsl_rng_uniform_int(rng, 4) == 0) {
        gene[0] = gsl_rng_uniform_int(rng, 2) == 0 ? decimal_gene(6 * gsl_rng_uniform(rng) - 3)
                                                   : X + (int)gsl_rng_uniform_int(rng, SYMBOLS);
        return 1;
    }
    gene[0] = (int)gsl_rng_uniform_int(rng, GENE_OPERATORS);
    size_t n = 1;
    for (int left = gene_arity(gene[0]); left-- > 0;)
        n += random_genome(rng, room - n - (size_t)left, gene + n);
    return n;
}

/* Slopes by all constants against central differences; samples next to a kink or a pole differ, and are few. */
static void slopes_match_differences(void **state)
{
    const struct fixture *f = *state;
    int gene[LONGEST];
    size_t checked = 0, off = 0;
    struct tape *t = tape_new(&f->table);
    for (int round = 0; round < 300; round++) {
        const struct tree tree = {gene, random_genome(f->rng, LONGEST, gene)};
        tape_load(t, &tree);
        for (size_t c = 0; c < t->constants; c++) {
            const size_t at = t->constant[c];
            const double kept = t->number[at], step = 1e-6;
            double slope[TAPE_BLOCK], side[2][TAPE_BLOCK];
            tape_values(t, 0);
            tape_slopes(t, round % 2 == 0);
            memcpy(slope, t->slope[at], sizeof slope);
            for (int k = 0; k < 2; k++) {
                t->number[at] = kept + (k == 0 ? -step : step);
                tape_values(t, 0);
                memcpy(side[k], t->value[0], sizeof side[k]);
            }
            t->number[at] = kept;
            for (size_t i = 0; i < TAPE_BLOCK; i++) {
                const double difference = (side[1][i] - side[0][i]) / (2 * step);
                if (!(fabs(side[0][i]) < 1e3 && fabs(side[1][i]) < 1e3 && fabs(slope[i]) < 1e3))
                    continue;
                checked++;
                off += !(fabs(difference - slope[i]) <= 1e-4 * (1 + fabs(slope[i])));
            }
        }
    }
    tape_free(t);
    assert_true(checked > 50000);
    if (off * 1000 > checked)
        fail_msg("%zu of %zu slopes differ", off, checked);
}

/* 1.5 + y / (3 + 0.25 x) + sqrt(y + 2.5) z is found from constants that are far off. */
static void constants_are_found(void **state)
{
    static const double truth[] = {1.5, 3, 0.25, 2.5}, start[] = {0, 2.6, 1, 3.5};
    struct fixture *f = *state;
    int gene[] = {GENE_ADD, GENE_ADD, 0,        GENE_DIV, Y,         GENE_ADD, 0, GENE_MUL,
                  0,        X,        GENE_MUL, Z,        GENE_SQRT, GENE_ADD, Y, 0};
    static const size_t at[] = {2, 6, 8, 15};
    int found_gene[16];
    struct tree tree = {gene, 16}, found = {found_gene, 0};
    for (size_t i = 0; i < SAMPLES; i++) {
        const double x = columns_at(&f->table, 0)[i], y = columns_at(&f->table, 1)[i], z = columns_at(&f->table, 2)[i];
        columns_at(&f->table, GOAL)[i] = 1.5 + y / (3 + 0.25 * x) + sqrt(y + 2.5) * z;
    }
    for (size_t i = 0; i < 4; i++)
        gene[at[i]] = decimal_gene(start[i]);
    for (int norm = NORM_MEAN; norm <= NORM_P99; norm++) {
        double error;
        assert_true(fit_constants(f->fitter, f->objective[norm], &tree, GOAL, 60, &found, &error));
        for (size_t i = 0; i < 4; i++)
            if (!(fabs(decimal_value(found_gene[at[i]]) - truth[i]) < 2e-3))
                fail_msg("norm %d, constant %zu: %.7g, expected %g", norm, i, decimal_value(found_gene[at[i]]),
                         truth[i]);
        assert_true(error < 1e-4);
    }
}

/* The best constant by the mean error is the median, by the largest error the middle of the range. */
static void norms_have_their_own_optimum(void **state)
{
    struct fixture *f = *state;
    int gene[] = {decimal_gene(0.2)}, found_gene[1];
    struct tree tree = {gene, 1}, found = {found_gene, 1};
    double error;
    for (size_t i = 0; i < SAMPLES; i++) {
        const double at = (double)i / (SAMPLES - 1);
        columns_at(&f->table, GOAL)[i] = at * at * at;
    }
    fit_constants(f->fitter, f->objective[NORM_MEAN], &tree, GOAL, 40, &found, &error);
    assert_true(fabs(decimal_value(found_gene[0]) - 0.125) < 5e-3);
    fit_constants(f->fitter, f->objective[NORM_MAX], &tree, GOAL, 40, &found, &error);
    assert_true(fabs(decimal_value(found_gene[0]) - 0.5) < 2e-2);
}

/* Whatever the tree and the norm: same genes but for constants, never worse, and the error is the objective's. */
static void never_worse(void **state)
{
    struct fixture *f = *state;
    int gene[LONGEST], found_gene[LONGEST];
    size_t better = 0, finite = 0;
    for (int round = 0; round < 300; round++) {
        const enum scene_norm norm = (enum scene_norm)(round % 3);
        const struct tree tree = {gene, random_genome(f->rng, LONGEST, gene)};
        struct tree found = {found_gene, 0};
        double error;
        const double before = objective_error(f->objective[norm], &tree, GOAL, INFINITY);
        better += fit_constants(f->fitter, f->objective[norm], &tree, GOAL, 4, &found, &error);
        finite += isfinite(before) ? 1 : 0;
        assert_true(error <= before);
        assert_true(objective_error(f->objective[norm], &found, GOAL, INFINITY) == error);
        assert_int_equal(found.length, tree.length);
        for (size_t i = 0; i < tree.length; i++)
            assert_true(gene[i] < 0 ? decimal_valid(found_gene[i]) : found_gene[i] == gene[i]);
    }
    assert_true(finite > 100 && better > finite / 4);
}

static void samples_that_are_not_finite(void **state)
{
    struct fixture *f = *state;
    int gene[] = {GENE_ADD, decimal_gene(0.5), GENE_MUL, decimal_gene(2), X}, found_gene[10];
    const struct tree tree = {gene, 5};
    struct tree found = {found_gene, 0};
    double error;
    columns_at(&f->table, 0)[SAMPLES / 2] = NAN;
    assert_false(fit_constants(f->fitter, f->objective[NORM_MEAN], &tree, GOAL, 5, &found, &error));
    assert_true(tree_equal(&tree, &found) && error == INFINITY);
    assert_false(fit_root_terms(f->fitter, &tree, GOAL, 10, &found));
}

/* A guarded fit ends with a divisor of one sign, where one through zero would fit. */
static void divisors_stay_guarded(void **state)
{
    struct fixture *f = *state;
    int gene[] = {GENE_DIV, decimal_gene(1), GENE_ADD, decimal_gene(3), X};
    const struct tree tree = {gene, 5};
    const struct loss loss = {LOSS_SQUARES, 1, 0};
    for (size_t i = 0; i < SAMPLES; i++)
        columns_at(&f->table, GOAL)[i] = 1 / (columns_at(&f->table, 0)[i] + 1.9);
    f->fitter->guard = 0.1;
    tape_load(f->fitter->tape, &tree);
    assert_true(isfinite(fitter_descend(f->fitter, GOAL, &loss, 50)));
    assert_true(f->fitter->tape->number[3] > 2.1);
    f->fitter->guard = 0;
}

/* 2 - 3 x + 0.5 x y - z: constants of the terms are replaced, repeated terms and constants vanish. */
static void root_terms_are_found(void **state)
{
    struct fixture *f = *state;
    const int gene[] = {
        GENE_SUB, GENE_ADD, GENE_MUL,        decimal_gene(7), X, GENE_NEG, GENE_MUL, X, Y, GENE_ADD, GENE_SUB, X,
        Z,        GENE_ADD, decimal_gene(4), decimal_gene(1)};
    const int expected[] = {GENE_SUB, GENE_ADD, GENE_ADD,          decimal_gene(2), GENE_MUL, decimal_gene(-3),
                            X,        GENE_MUL, decimal_gene(0.5), GENE_MUL,        X,        Y,
                            Z};
    int kept[16], found_gene[40];
    memcpy(kept, gene, sizeof kept);
    const struct tree tree = {kept, 16};
    struct tree found = {found_gene, 0};
    for (size_t i = 0; i < SAMPLES; i++) {
        const double x = columns_at(&f->table, 0)[i], y = columns_at(&f->table, 1)[i], z = columns_at(&f->table, 2)[i];
        columns_at(&f->table, GOAL)[i] = 2 - 3 * x + 0.5 * x * y - z;
    }
    assert_true(fit_root_terms(f->fitter, &tree, GOAL, 13, &found));
    assert_int_equal(found.length, sizeof expected / sizeof *expected);
    assert_memory_equal(found_gene, expected, sizeof expected);
    assert_false(fit_root_terms(f->fitter, &tree, GOAL, 12, &found));
}

/* Least squares of the terms as they were is never better. */
static void root_terms_are_optimal(void **state)
{
    struct fixture *f = *state;
    int gene[LONGEST], found_gene[4 * LONGEST];
    const struct loss squares = {LOSS_SQUARES, 1, 0};
    size_t fitted = 0;
    for (int round = 0; round < 500; round++) {
        const struct tree tree = {gene, random_genome(f->rng, LONGEST, gene)};
        struct tree found = {found_gene, 0};
        tape_load(f->fitter->tape, &tree);
        const double before = fitter_loss(f->fitter, GOAL, &squares);
        if (!isfinite(before) || !fit_root_terms(f->fitter, &tree, GOAL, 4 * LONGEST, &found))
            continue;
        assert_int_equal(gene_span(found_gene, found.length), found.length);
        tape_load(f->fitter->tape, &found);
        const double after = fitter_loss(f->fitter, GOAL, &squares);
        if (!(after <= before * (1 + 1e-6)))
            fail_msg("round %d: %g, before %g", round, after, before);
        fitted++;
    }
    assert_true(fitted > 100);
}

/* Products of columns against sums in long double, and the fit that is made of them. */
static void products_match(void **state)
{
    enum { COLUMNS = 7 };
    const struct fixture *f = *state;
    double gram[COLUMNS * COLUMNS], coefficient[COLUMNS], work[COLUMNS * COLUMNS], *x;
    struct products p = products_new(COLUMNS, COLUMNS);
    x = new_array(COLUMNS * 2 * SAMPLES, sizeof *x);
    for (size_t i = 0; i < COLUMNS * 2 * SAMPLES; i++)
        x[i] = gsl_rng_uniform(f->rng) - 0.3;
    for (size_t i = 0; i < SAMPLES; i++) {
        x[6 * SAMPLES + i] = 3 * x[2 * SAMPLES + i] - 2 * x[4 * SAMPLES + i];
        x[5 * SAMPLES + i] = x[i] + x[SAMPLES + i];
    }
    products_add(&p, (struct panel){x, SAMPLES}, (struct panel){x, SAMPLES}, SAMPLES, true);
    products_sum(&p, true, gram);
    for (size_t i = 0; i < COLUMNS; i++)
        for (size_t j = 0; j < COLUMNS; j++) {
            long double sum = 0;
            for (size_t k = 0; k < SAMPLES; k++)
                sum += (long double)x[i * SAMPLES + k] * x[j * SAMPLES + k];
            assert_true(fabs(gram[i * COLUMNS + j] - (double)sum) < 1e-10);
        }
    const size_t chosen[] = {4, 1, 2}, dependent[] = {0, 1, 5};
    const double left = products_fit(gram, COLUMNS, chosen, 3, 6, coefficient, work);
    assert_true(left >= 0 && left < 1e-9);
    assert_true(fabs(coefficient[0] + 2) < 1e-9 && fabs(coefficient[1]) < 1e-9 && fabs(coefficient[2] - 3) < 1e-9);
    assert_true(products_fit(gram, COLUMNS, dependent, 3, 6, coefficient, work) == -1);
    products_free(&p);
    free(x);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(slopes_match_differences, setup, teardown),
        cmocka_unit_test_setup_teardown(constants_are_found, setup, teardown),
        cmocka_unit_test_setup_teardown(norms_have_their_own_optimum, setup, teardown),
        cmocka_unit_test_setup_teardown(never_worse, setup, teardown),
        cmocka_unit_test_setup_teardown(samples_that_are_not_finite, setup, teardown),
        cmocka_unit_test_setup_teardown(divisors_stay_guarded, setup, teardown),
        cmocka_unit_test_setup_teardown(root_terms_are_found, setup, teardown),
        cmocka_unit_test_setup_teardown(root_terms_are_optimal, setup, teardown),
        cmocka_unit_test_setup_teardown(products_match, setup, teardown),
    };
    return cmocka_run_group_tests_name("constants", tests, NULL, NULL);
}
