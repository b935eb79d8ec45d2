/* Growth of seeds: functions that are there are found, budgets hold, fronts are fronts, the same seeds every time. */
#include "../../evolve/genotype/term.h"
#include "../support/search_fixture.h"

enum { SYMBOLS = 3, GOAL = SYMBOLS, SAMPLES = 1500, LONGEST = 60 };
static const int symbol[] = {X, Y, Z};

static int setup(void **state)
{
    struct fixture *f = fixture_new(5, SAMPLES, SYMBOLS, 1);
    f->plan = grow_plan_new(symbol, SYMBOLS, 6, LONGEST);
    f->plan.rows = 500;
    f->front.prices = f->plan.prices;
    *state = f;
    return 0;
}

static void set_goal(const struct fixture *f, double goal(double, double, double))
{
    for (size_t i = 0; i < SAMPLES; i++)
        columns_at(&f->table, GOAL)[i] =
            goal(columns_at(&f->table, 0)[i], columns_at(&f->table, 1)[i], columns_at(&f->table, 2)[i]);
}

static double product(double x, double y, double z)
{
    return 0.3 + (x + 0.5) * (y - 0.4 * z);
}

static double quotient(double x, double y, double z)
{
    return (1 + 0.5 * x * z) / (2 + y);
}

static double smooth(double x, double y, double z)
{
    return sin(2 * x + y) * cos(z) / (1.2 + x * y);
}

static double zero(double x, double y, double z)
{
    return 0 * (x + y + z);
}

/* Errors as the objective's, costs within the plan, each seed better than all cheaper ones. */
static void check_front(const struct fixture *f)
{
    const struct pareto *s = &f->front;
    assert_true(s->n > 0);
    for (size_t i = 0; i < s->n; i++) {
        const struct pareto_member *x = &s->member[i];
        assert_int_equal(gene_span(x->tree.gene, x->tree.length), x->tree.length);
        assert_true(x->tree.length <= f->plan.max_length);
        assert_true(x->cost <= f->plan.max_cost + 1e-9 && x->cost == tree_price(&f->plan.prices, &x->tree));
        assert_true(objective_error(f->objective[NORM_MEAN], &x->tree, GOAL, INFINITY) == x->error);
        if (i > 0)
            assert_true(x->cost > s->member[i - 1].cost && x->error < s->member[i - 1].error);
    }
}

static void product_is_found(void **state)
{
    struct fixture *f = *state;
    set_goal(f, product);
    grow_polynomials(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    check_front(f);
    assert_true(f->front.member[f->front.n - 1].error < 1e-5);
    for (size_t i = 0; i < f->front.n; i++)
        assert_int_equal(f->front.member[i].operations.div, 0);
}

static void quotient_is_found(void **state)
{
    struct fixture *f = *state;
    set_goal(f, quotient);
    grow_quotients(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    check_front(f);
    assert_true(f->front.member[f->front.n - 1].error < 1e-5);
}

/* Growing from a good value leaves it in the tree and corrects it. */
static void base_is_corrected(void **state)
{
    struct fixture *f = *state;
    const int genes[] = {GENE_MUL, X, Y};
    int gene[3];
    memcpy(gene, genes, sizeof gene);
    set_goal(f, quotient);
    for (size_t i = 0; i < SAMPLES; i++)
        columns_at(&f->table, GOAL)[i] += columns_at(&f->table, 0)[i] * columns_at(&f->table, 1)[i];
    const struct tree base = {gene, 3};
    f->plan.max_cost = 12;
    grow_quotients(&f->plan, f->objective[NORM_MEAN], GOAL, &base, &f->front);
    check_front(f);
    assert_true(f->front.member[f->front.n - 1].error < 1e-5);
}

static double clamped(double x, double y, double z)
{
    return fmax(-0.3, fmin(0.4, 1.5 * x * y - z));
}

/* What is clamped is found from inside the clamp, its bounds too. */
static void clamp_is_found(void **state)
{
    struct fixture *f = *state;
    set_goal(f, clamped);
    f->plan.clamped = true;
    f->plan.low = -0.5;
    f->plan.high = 0.5;
    grow_polynomials(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    check_front(f);
    const struct pareto_member *last = &f->front.member[f->front.n - 1];
    assert_true(last->error < 1e-5 && last->tree.gene[0] == GENE_MAX && last->tree.gene[2] == GENE_MIN);
    assert_true(fabs(decimal_value(last->tree.gene[1]) + 0.3) < 1e-4);
    assert_true(fabs(decimal_value(last->tree.gene[3]) - 0.4) < 1e-4);
}

/* Nothing to be found exactly: every budget holds, and two runs give the same genes. */
static void same_every_time(void **state)
{
    struct fixture *f = *state;
    struct pareto again = {.prices = f->plan.prices};
    set_goal(f, smooth);
    f->plan.max_length = 41;
    grow_quotients(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    grow_quotients(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &again);
    check_front(f);
    assert_int_equal(f->front.n, again.n);
    for (size_t i = 0; i < again.n; i++)
        assert_true(tree_equal(&f->front.member[i].tree, &again.member[i].tree));
    pareto_free(&again);
}

/* No term to fit, or samples that are not numbers: no endless growth, no seed without an error. */
static void hopeless_goals(void **state)
{
    struct fixture *f = *state;
    set_goal(f, zero);
    grow_polynomials(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    assert_true(f->front.n == 1 && f->front.member[0].error == 0 && f->front.member[0].tree.length == 1);
    pareto_free(&f->front);
    columns_at(&f->table, GOAL)[3] = NAN;
    grow_polynomials(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    grow_quotients(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    assert_int_equal(f->front.n, 0);
}

/* A column that never changes and one that is not finite do no harm beside good ones. */
static void useless_columns(void **state)
{
    struct fixture *f = *state;
    set_goal(f, product);
    memcpy(columns_at(&f->table, 1), columns_at(&f->table, 2), SAMPLES * sizeof(double));
    for (size_t i = 0; i < SAMPLES; i++)
        columns_at(&f->table, 2)[i] = i == 7 ? NAN : 1;
    grow_polynomials(&f->plan, f->objective[NORM_MEAN], GOAL, NULL, &f->front);
    check_front(f);
    assert_true(f->front.n > 3);
}

/* Terms are inserted where they should be, and vanish when their constant is 0. */
static void terms_come_and_go(void **state)
{
    static const int with[] = {GENE_MUL, X, GENE_ADD, Y, GENE_MUL, GENE_MUL, -1, Z, X};
    int gene[] = {GENE_MUL, X, Y}, to_gene[20], back_gene[20], with_zero[sizeof with / sizeof *with];
    const struct tree tree = {gene, 3};
    struct tree to = {to_gene, 0}, back = {back_gene, 0};
    const struct term term = {.at = 2, .symbol = {Z, X}, .symbols = 2, .coefficient = 0};
    (void)state;
    memcpy(with_zero, with, sizeof with);
    with_zero[6] = decimal_gene(0);
    term_insert(&tree, &term, &to);
    assert_true(tree_equal(&to, &(struct tree){with_zero, 9}));
    terms_drop_zeros(&to, &back);
    assert_true(tree_equal(&back, &tree));
    int whole[] = {GENE_ADD, Y, GENE_SUB, GENE_MUL, X, Z, X};
    const struct tree sum_tree = {whole, 7};
    assert_true(term_repeats(&sum_tree, &(struct term){.symbol = {X}, .symbols = 1, .unit = true}));
    assert_true(term_repeats(&sum_tree, &(struct term){.symbol = {Z, X}, .symbols = 2, .unit = true}));
    assert_false(term_repeats(&sum_tree, &(struct term){.symbol = {Z}, .symbols = 1, .unit = true}));
    assert_false(term_repeats(&sum_tree, &(struct term){.symbol = {X}, .symbols = 1}));
    assert_false(term_repeats(&sum_tree, &(struct term){.at = 1, .symbol = {X}, .symbols = 1, .unit = true}));
    int sum[] = {GENE_SUB, GENE_ADD, decimal_gene(0), X, GENE_DIV, GENE_MUL, Y, decimal_gene(0), Z}, x[] = {X};
    terms_drop_zeros(&(struct tree){sum, 9}, &back);
    assert_true(tree_equal(&back, &(struct tree){x, 1}));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(product_is_found, setup, teardown),
        cmocka_unit_test_setup_teardown(quotient_is_found, setup, teardown),
        cmocka_unit_test_setup_teardown(base_is_corrected, setup, teardown),
        cmocka_unit_test_setup_teardown(clamp_is_found, setup, teardown),
        cmocka_unit_test_setup_teardown(same_every_time, setup, teardown),
        cmocka_unit_test_setup_teardown(hopeless_goals, setup, teardown),
        cmocka_unit_test_setup_teardown(useless_columns, setup, teardown),
        cmocka_unit_test(terms_come_and_go),
    };
    return cmocka_run_group_tests_name("grow", tests, NULL, NULL);
}
