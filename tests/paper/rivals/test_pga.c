/* Tests the genetic algorithm on polynomials: it recovers a known polynomial and obeys sizes; fits and errors match the
 * samples; dependent terms do no harm; and results do not depend on how the evaluation is shared. */
#include "../../../evolve/common/decimal.h"
#include "../../../evolve/common/stream.h"
#include "../../../evolve/eval/lines_run.h"
#include "normal_equations.h"
#include "pga.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SYMBOLS = 4, GOAL = SYMBOLS, TWIN = SYMBOLS + 1, SAMPLES = 1003, DEGREE = 3, COUNT = 35, GOAL_TERMS = 5 };
static const int symbol[] = {GENE_SYMBOL, GENE_SYMBOL + 1, GENE_SYMBOL + 2, GENE_SYMBOL + 3};
static const int twins[] = {GENE_SYMBOL, GENE_SYMBOL + 1, GENE_SYMBOL + TWIN};
static const size_t goal_term[GOAL_TERMS] = {0, 3, 11, 20, 34};

struct fixture {
    gsl_rng *rng;
    struct columns table; /* SYMBOLS, the goal, and a copy of the first symbol */
    struct polynomials *p;
};

static double term_value(const struct monomial *m, const struct columns *c, size_t row)
{
    double v = 1;
    for (size_t i = 0; i < m->degree; i++)
        v *= columns_at(c, (size_t)(m->symbol[i] - GENE_SYMBOL))[row];
    return v;
}

static int setup(void **state)
{
    struct fixture *f = new_array(1, sizeof *f);
    size_t count;
    struct monomial *m = monomials_new(symbol, SYMBOLS, DEGREE, &count);
    assert_int_equal(count, COUNT);
    f->rng = stream_new();
    stream_key(f->rng, 5, 0, 0, 0);
    f->table = columns_new(SAMPLES, TWIN + 1);
    for (size_t i = 0; i < SAMPLES; i++) {
        for (size_t j = 0; j < SYMBOLS; j++)
            columns_at(&f->table, j)[i] = 2 * gsl_rng_uniform(f->rng) - 1;
        columns_at(&f->table, TWIN)[i] = columns_at(&f->table, 0)[i];
        for (size_t k = 0; k < GOAL_TERMS; k++)
            columns_at(&f->table, GOAL)[i] += ((double)k - 1.5) * term_value(&m[goal_term[k]], &f->table, i);
    }
    free(m);
    f->p = polynomials_new(symbol, SYMBOLS, DEGREE, &f->table, GOAL);
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    polynomials_free(f->p);
    columns_free(&f->table);
    gsl_rng_free(f->rng);
    free(f);
    return 0;
}

static void errors_at_once(void *context, const gene_bit *chosen, size_t n, double *error)
{
    polynomials_errors(context, chosen, n, error);
}

/* Computes errors from the last choice to the first, one by one. */
static void errors_apart(void *context, const gene_bit *chosen, size_t n, double *error)
{
    const struct polynomials *p = context;
    while (n-- > 0)
        polynomials_errors(p, chosen + n * p->count, 1, error + n);
}

static void draw(gsl_rng *rng, gene_bit *chosen, size_t n)
{
    for (size_t i = 0; i < n; i++)
        chosen[i] = gsl_rng_uniform_int(rng, 4) == 0 ? 1 : 0;
}

/* Compares errors with the samples; the residual must be orthogonal to every term and have the fit's sum of squares. */
static void fits_are_least_squares(void **state)
{
    struct fixture *f = *state;
    const double *goal = columns_at(&f->table, GOAL);
    for (int round = 0; round < 50; round++) {
        gene_bit chosen[COUNT];
        size_t at[COUNT];
        double coefficient[COUNT], product[COUNT] = {0}, error, sum = 0, square = 0;
        draw(f->rng, chosen, COUNT);
        chosen[round % COUNT] = 1;
        const size_t n = polynomials_terms(f->p, chosen, at);
        const double left = polynomials_fit(f->p, chosen, coefficient);
        polynomials_errors(f->p, chosen, 1, &error);
        for (size_t i = 0; i < SAMPLES; i++) {
            double r = -goal[i];
            for (size_t k = 0; k < n; k++)
                r += coefficient[k] * term_value(&f->p->term[at[k]], &f->table, i);
            for (size_t k = 0; k < n; k++)
                product[k] += r * term_value(&f->p->term[at[k]], &f->table, i);
            sum += fabs(r);
            square += r * r;
        }
        assert_true(fabs(error - sum / SAMPLES) < 1e-12);
        assert_true(fabs(left - square) < 1e-9);
        for (size_t k = 0; k < n; k++)
            assert_true(fabs(product[k]) < 1e-9);
        assert_in_range(polynomials_condition(f->p, chosen), 1, 10000);
    }
}

/* There must be binomial(n + degree, degree) monomials, all different. */
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

/* Compares random sums of monomials with their trees. */
static void horner_form_is_the_sum(void **state)
{
    struct fixture *f = *state;
    double *value = new_array(SAMPLES, sizeof *value);
    for (size_t round = 0; round < 200; round++) {
        struct monomial term[COUNT];
        double coefficient[COUNT];
        size_t n = 0;
        for (size_t i = 0; i < COUNT; i++)
            if (gsl_rng_uniform_int(f->rng, 1 + round % 20) == 0) {
                term[n] = f->p->term[i];
                coefficient[n++] = decimal_value(decimal_gene(4 * gsl_rng_uniform(f->rng) - 2));
            }
        if (n == 0)
            continue;
        struct genes t = {new_array(monomials_room(n), sizeof *t.gene), 0};
        monomials_tree(term, coefficient, n, &t);
        assert_true(t.length <= monomials_room(n));
        assert_int_equal(gene_span(t.gene, t.length), t.length);
        table_values(&f->table, NULL, t.gene, t.length, value);
        for (size_t row = 0; row < SAMPLES; row++) {
            double sum = 0;
            for (size_t i = 0; i < n; i++)
                sum += coefficient[i] * term_value(&term[i], &f->table, row);
            assert_true(fabs(sum - value[row]) < 1e-12);
        }
        free(t.gene);
    }
    free(value);
}

/* Checks sums of products, and fits of any choice of columns; dependent columns must be refused. */
static void products_match(void **state)
{
    enum { COLUMNS = 7, ROWS = 1000 };
    const struct fixture *f = *state;
    double gram[COLUMNS * COLUMNS], coefficient[COLUMNS], work[COLUMNS * COLUMNS], *x;
    struct products p = products_new(COLUMNS, COLUMNS);
    x = new_array(COLUMNS * 2 * ROWS, sizeof *x);
    for (size_t i = 0; i < COLUMNS * 2 * ROWS; i++)
        x[i] = gsl_rng_uniform(f->rng) - 0.3;
    for (size_t i = 0; i < ROWS; i++) {
        x[6 * ROWS + i] = 3 * x[2 * ROWS + i] - 2 * x[4 * ROWS + i];
        x[5 * ROWS + i] = x[i] + x[ROWS + i];
    }
    products_add(&p, (struct panel){x, ROWS}, (struct panel){x, ROWS}, ROWS, true);
    products_sum(&p, true, gram);
    for (size_t i = 0; i < COLUMNS; i++)
        for (size_t j = 0; j < COLUMNS; j++) {
            long double sum = 0;
            for (size_t k = 0; k < ROWS; k++)
                sum += (long double)x[i * ROWS + k] * x[j * ROWS + k];
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

static double norm_of(const struct fixture *f, const gene_bit *chosen, const double *coefficient, bool largest)
{
    size_t at[COUNT];
    const size_t n = polynomials_terms(f->p, chosen, at);
    double sum = 0, most = 0;
    for (size_t i = 0; i < SAMPLES; i++) {
        double r = -columns_at(&f->table, GOAL)[i];
        for (size_t k = 0; k < n; k++)
            r += coefficient[k] * term_value(&f->p->term[at[k]], &f->table, i);
        sum += fabs(r);
        most = fmax(most, fabs(r));
    }
    return largest ? most : sum / SAMPLES;
}

/* Other norms must have other coefficients, and small changes of these must not improve them, beyond the remaining progress of
 * weighted squares. */
static void norms_have_their_own_optimum(void **state)
{
    const struct fixture *f = *state;
    for (int largest = 0; largest < 2; largest++) {
        gene_bit chosen[COUNT] = {0};
        double squares[COUNT], own[COUNT];
        for (size_t i = 0; i < 12; i++)
            chosen[3 * i] = 1 - (i == goal_term[1] / 3);
        polynomials_fit(f->p, chosen, squares);
        memcpy(own, squares, sizeof own);
        polynomials_fit_norm(f->p, chosen, largest ? NORM_MAX : NORM_MEAN, own);
        const double least = norm_of(f, chosen, own, largest);
        assert_true(least < (largest ? 0.95 : 0.9999) * norm_of(f, chosen, squares, largest));
        for (size_t k = 0; k < polynomials_terms(f->p, chosen, NULL); k++)
            for (int sign = -1; sign <= 1; sign += 2) {
                double other[COUNT];
                memcpy(other, own, sizeof other);
                other[k] += 0.05 * sign;
                assert_true(norm_of(f, chosen, other, largest) > 0.995 * least);
            }
    }
}

static void fitness_is_as_published(void **state)
{
    (void)state;
    assert_true(pga_fitness(0.25, 10, 10) == 4);
    assert_true(pga_fitness(0.25, 13, 10) == 4.0 / 300);
    assert_true(pga_fitness((double)INFINITY, 1, 10) == 0);
}

static void known_polynomial_is_recovered(void **state)
{
    struct fixture *f = *state;
    const struct pga_evaluator e = {f->p, errors_at_once};
    for (int exchange = 0; exchange < 2; exchange++) {
        struct pga_plan plan = pga_plan_default();
        plan.terms = GOAL_TERMS;
        plan.exchange = exchange;
        struct pga *g = pga_new(&plan, f->p, &e);
        for (int i = 0; i < (exchange ? 0 : 400); i++)
            pga_step(g);
        const struct pga_state s = pga_look(g);
        assert_true(s.error < 1e-7);
        for (size_t k = 0; k < GOAL_TERMS; k++)
            assert_int_equal(s.best[goal_term[k]], 1);
        assert_int_equal(s.terms, GOAL_TERMS);
        pga_free(g);
    }
}

/* The best must never have more terms than allowed, and never get worse. */
static void restricted_size_is_obeyed(void **state)
{
    struct fixture *f = *state;
    const struct pga_evaluator e = {f->p, errors_at_once};
    for (size_t limit = 1; limit < COUNT; limit += 4) {
        struct pga_plan plan = pga_plan_default();
        plan.population = 2 + limit;
        plan.terms = limit;
        plan.exchange = limit % 8 == 1;
        double before = INFINITY;
        struct pga *g = pga_new(&plan, f->p, &e);
        for (int i = 0; i < 30; i++, pga_step(g)) {
            const struct pga_state s = pga_look(g);
            assert_in_range(s.terms, 1, limit);
            assert_true(s.error <= before);
            before = s.error;
        }
        pga_free(g);
    }
}

static void exchange_descends(void **state)
{
    struct fixture *f = *state;
    for (size_t round = 0; round < 40; round++) {
        gene_bit chosen[COUNT];
        double coefficient[COUNT];
        draw(f->rng, chosen, COUNT);
        chosen[0] = 1;
        const size_t terms = polynomials_terms(f->p, chosen, NULL), limit = 1 + round % COUNT;
        const double before = polynomials_fit(f->p, chosen, coefficient);
        polynomials_exchange(f->p, chosen, limit);
        assert_true(polynomials_terms(f->p, chosen, NULL) <= limit);
        if (terms <= limit)
            assert_true(polynomials_fit(f->p, chosen, coefficient) <= before);
        if (limit >= GOAL_TERMS)
            assert_true(polynomials_fit(f->p, chosen, coefficient) < 1e-6);
    }
}

/* Two equal variables: choices with both must be refused, and the search must continue among the others. */
static void dependent_terms_do_no_harm(void **state)
{
    struct fixture *f = *state;
    struct polynomials *p = polynomials_new(twins, 3, 2, &f->table, GOAL);
    const struct pga_evaluator e = {p, errors_at_once};
    gene_bit all[10];
    double error;
    for (size_t i = 0; i < p->count; i++)
        all[i] = 1;
    polynomials_errors(p, all, 1, &error);
    assert_true(error == INFINITY);
    assert_true(polynomials_condition(p, all) > 1e12);
    const struct pga_plan plan = {.seed = 2, .population = 40, .terms = 10, .crossover = 0.5, .mutation = 0.5};
    struct pga *g = pga_new(&plan, p, &e);
    for (int i = 0; i < 50; i++)
        pga_step(g);
    const struct pga_state s = pga_look(g);
    assert_true(s.error < INFINITY && s.singular > 0 && s.singular < s.evaluations);
    pga_free(g);
    polynomials_free(p);
}

static void sharing_changes_nothing(void **state)
{
    struct fixture *f = *state;
    const struct pga_evaluator e[2] = {{f->p, errors_at_once}, {f->p, errors_apart}};
    const struct pga_plan plan = {.seed = 7, .population = 31, .terms = 8, .crossover = 0.7, .mutation = 0.3};
    struct pga *g[2] = {pga_new(&plan, f->p, &e[0]), pga_new(&plan, f->p, &e[1])};
    for (int i = 0; i < 30; i++) {
        const struct pga_state s = pga_look(g[0]), t = pga_look(g[1]);
        assert_memory_equal(s.best, t.best, COUNT * sizeof *s.best);
        assert_true(s.error == t.error && s.median == t.median && s.evaluations == t.evaluations);
        pga_step(g[0]);
        pga_step(g[1]);
    }
    pga_free(g[0]);
    pga_free(g[1]);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(monomials_are_complete),
        cmocka_unit_test(horner_form_is_the_sum),
        cmocka_unit_test(products_match),
        cmocka_unit_test(fits_are_least_squares),
        cmocka_unit_test(norms_have_their_own_optimum),
        cmocka_unit_test(fitness_is_as_published),
        cmocka_unit_test(known_polynomial_is_recovered),
        cmocka_unit_test(restricted_size_is_obeyed),
        cmocka_unit_test(exchange_descends),
        cmocka_unit_test(dependent_terms_do_no_harm),
        cmocka_unit_test(sharing_changes_nothing),
    };
    return cmocka_run_group_tests(tests, setup, teardown);
}
