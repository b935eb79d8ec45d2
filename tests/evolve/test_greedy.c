/* Greedy polynomials: sparse ones are found term by term, Horner's form computes the same, hostile columns do no harm.
 */
#include "../../evolve/fit/grow_greedy.h"
#include "../../evolve/fit/monomials.h"
#include "../support/search_fixture.h"

enum { SYMBOLS = 4, GOAL = SYMBOLS, SAMPLES = 1000 };
static const int symbol[SYMBOLS] = {X, Y, Z, W};

static int setup(void **state)
{
    struct fixture *f = fixture_new(3, SAMPLES, SYMBOLS, 1);
    f->front.prices = (struct prices){0.1, 1, 0};
    *state = f;
    return 0;
}

static double monomial_value(const struct monomial *m, const struct columns *c, size_t row)
{
    double v = 1;
    for (size_t i = 0; i < m->degree; i++)
        v *= columns_at(c, (size_t)(m->symbol[i] - GENE_SYMBOL))[row];
    return v;
}

/* binomial(n + degree, degree) monomials, all different. */
static void monomials_are_complete(void **state)
{
    static const size_t expected[MONOMIAL_DEGREE + 1] = {1, 5, 15, 35, 70};
    (void)state;
    for (size_t degree = 0; degree <= MONOMIAL_DEGREE; degree++) {
        size_t count;
        struct monomial *m = monomials_new(symbol, SYMBOLS, degree, &count);
        assert_int_equal(count, expected[degree]);
        assert_int_equal(m[0].degree, 0);
        for (size_t i = 0; i < count; i++)
            for (size_t j = 0; j < i; j++)
                assert_memory_not_equal(&m[i], &m[j], sizeof *m);
        free(m);
    }
}

/* Random sums of monomials against their trees. */
static void horner_form_is_the_sum(void **state)
{
    const struct fixture *f = *state;
    size_t count;
    struct monomial *all = monomials_new(symbol, SYMBOLS, MONOMIAL_DEGREE, &count);
    struct kernel *kernel = kernel_new(KERNEL_PLAIN);
    double *value = new_array(SAMPLES, sizeof *value);
    for (size_t round = 0; round < 200; round++) {
        struct monomial term[70];
        double coefficient[70];
        size_t n = 0;
        for (size_t i = 0; i < count; i++)
            if (gsl_rng_uniform_int(f->rng, 1 + round % 20) == 0) {
                term[n] = all[i];
                coefficient[n++] = decimal_value(decimal_gene(4 * gsl_rng_uniform(f->rng) - 2));
            }
        if (n == 0)
            continue;
        struct tree t = {new_array(monomials_room(n), sizeof *t.gene), 0};
        monomials_tree(term, coefficient, n, &t);
        assert_true(t.length <= monomials_room(n));
        assert_int_equal(gene_span(t.gene, t.length), t.length);
        kernel_values(kernel, &(struct kernel_task){t.gene, t.length, NULL, &f->table}, value);
        for (size_t row = 0; row < SAMPLES; row++) {
            double sum = 0;
            for (size_t i = 0; i < n; i++)
                sum += coefficient[i] * monomial_value(&term[i], &f->table, row);
            assert_true(fabs(sum - value[row]) < 1e-12);
        }
        free(t.gene);
    }
    free(value);
    kernel_free(kernel);
    free(all);
}

/* Five terms of a goal are found in five steps, and no sixth is of use. */
static void sparse_polynomial_is_found(void **state)
{
    struct fixture *f = *state;
    const struct greedy_plan plan = {symbol, SYMBOLS, 3, 12, 200};
    for (size_t i = 0; i < SAMPLES; i++) {
        double x[SYMBOLS];
        for (size_t j = 0; j < SYMBOLS; j++)
            x[j] = columns_at(&f->table, j)[i];
        columns_at(&f->table, GOAL)[i] =
            0.25 - x[0] + 2 * x[1] * x[2] - 1.5 * x[0] * x[3] * x[3] + 3 * x[2] * x[2] * x[2];
    }
    greedy_polynomials(&plan, f->objective[NORM_MEAN], GOAL, &f->front);
    assert_true(f->front.n >= 4);
    const struct pareto_member *last = &f->front.member[f->front.n - 1];
    assert_true(last->error < 1e-6 && last->operations.add == 4 && last->operations.div == 0);
    for (size_t i = 0; i < f->front.n; i++)
        assert_true(objective_error(f->objective[NORM_MEAN], &f->front.member[i].tree, GOAL, INFINITY) ==
                    f->front.member[i].error);
}

/* Too many monomials: a lower degree; short trees alone where only these fit. */
static void limits_hold(void **state)
{
    enum { MANY = 40 };
    struct fixture *f = *state;
    int many[MANY];
    struct columns wide = columns_new(200, MANY + 1);
    struct objective *objective = objective_new(f->program, &wide, NORM_MEAN);
    for (size_t j = 0; j < wide.count; j++)
        for (size_t i = 0; i < wide.n; i++)
            columns_at(&wide, j)[i] = gsl_rng_uniform(f->rng);
    for (int j = 0; j < MANY; j++)
        many[j] = GENE_SYMBOL + j;
    greedy_polynomials(&(struct greedy_plan){many, MANY, 4, 1000, 33}, objective, MANY, &f->front);
    assert_true(f->front.n > 1);
    for (size_t i = 0; i < f->front.n; i++)
        assert_true(f->front.member[i].tree.length <= 33);
    objective_free(objective);
    columns_free(&wide);
}

/* Columns that are equal, constant or not finite: chosen at most once, or never. */
static void useless_columns(void **state)
{
    struct fixture *f = *state;
    memcpy(columns_at(&f->table, 1), columns_at(&f->table, 0), SAMPLES * sizeof(double));
    for (size_t i = 0; i < SAMPLES; i++) {
        columns_at(&f->table, 2)[i] = 2;
        columns_at(&f->table, 3)[i] = i == 5 ? INFINITY : 1;
        columns_at(&f->table, GOAL)[i] = exp(columns_at(&f->table, 0)[i]);
    }
    greedy_polynomials(&(struct greedy_plan){symbol, SYMBOLS, 3, 20, 200}, f->objective[NORM_MEAN], GOAL, &f->front);
    assert_true(f->front.n == 4);
    assert_true(f->front.member[3].error < 0.02 && f->front.member[3].operations.add == 3);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(monomials_are_complete),
        cmocka_unit_test_setup_teardown(horner_form_is_the_sum, setup, teardown),
        cmocka_unit_test_setup_teardown(sparse_polynomial_is_found, setup, teardown),
        cmocka_unit_test_setup_teardown(limits_hold, setup, teardown),
        cmocka_unit_test_setup_teardown(useless_columns, setup, teardown),
    };
    return cmocka_run_group_tests_name("greedy", tests, NULL, NULL);
}
