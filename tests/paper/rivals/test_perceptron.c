/* Tests perceptrons: derivatives match finite differences, training recovers a function that a network can learn, the genome has the
 * network's values, and training depends only on its seed. */
#include "../../../evolve/common/stream.h"
#include "../../../evolve/eval/lines_run.h"
#include "perceptron_train.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { INPUTS = 3, SAMPLES = 700, OTHER = 700 }; /* OTHER: samples outside of training */
static const struct perceptron networks[] = {
    {3, {INPUTS, 1, 2}}, {3, {INPUTS, 5, 2}}, {4, {INPUTS, 4, 3, 2}}, {2, {INPUTS, 2}}};
enum { NETWORKS = sizeof networks / sizeof *networks };

static double *draw(const struct perceptron *p, uint64_t seed)
{
    double *weight = new_array(perceptron_weights(p), sizeof *weight);
    perceptron_draw(p, seed, weight);
    return weight;
}

static double output_at(const struct perceptron *p, const double *weight, const double *in, size_t k)
{
    struct perceptron_state s;
    perceptron_forward(p, weight, in, &s);
    return s.value[p->layers - 1][k];
}

static void test_derivatives(void **state)
{
    (void)state;
    const double in[INPUTS] = {0.7, -1.3, 0.2}, h = 1e-5;
    for (size_t i = 0; i < NETWORKS; i++) {
        const struct perceptron *p = &networks[i];
        const size_t count = perceptron_weights(p);
        double *weight = draw(p, i), *slope = new_array(3 * count, sizeof *slope);
        struct perceptron_state s;
        perceptron_forward(p, weight, in, &s);
        for (size_t k = 0; k < 2; k++) {
            perceptron_backward(p, weight, &s, k, slope, 3);
            for (size_t j = 0; j < count; j++) {
                const double kept = weight[j];
                weight[j] = kept + h;
                const double above = output_at(p, weight, in, k);
                weight[j] = kept - h;
                const double below = output_at(p, weight, in, k);
                weight[j] = kept;
                assert_true(fabs((above - below) / (2 * h) - slope[3 * j]) < 1e-8);
            }
        }
        free(weight);
        free(slope);
    }
}

/* Returns inputs uniform in -2..2 and the outputs of a network; training sees the first SAMPLES. */
static struct columns lesson_table(const struct perceptron *p, const double *weight)
{
    struct columns c = columns_new(SAMPLES + OTHER, INPUTS + 2);
    gsl_rng *rng = stream_new();
    stream_key(rng, 11, 0, 0, 0);
    for (size_t i = 0; i < c.n; i++) {
        double in[INPUTS];
        for (size_t j = 0; j < INPUTS; j++)
            in[j] = columns_at(&c, j)[i] = 4 * gsl_rng_uniform(rng) - 2;
        for (size_t k = 0; k < 2; k++)
            columns_at(&c, INPUTS + k)[i] = output_at(p, weight, in, k);
    }
    gsl_rng_free(rng);
    return c;
}

static void test_training(void **state)
{
    (void)state;
    static const size_t input[INPUTS] = {0, 1, 2};
    const struct perceptron *p = &networks[1];
    double *teacher = draw(p, 3), *pupil = draw(p, 4), *again = draw(p, 4);
    struct columns table = lesson_table(p, teacher);
    const struct lesson lesson = {&table, input, {INPUTS, INPUTS + 1}, SAMPLES};
    const double before = perceptron_train(p, &lesson, 0, pupil), after = perceptron_train(p, &lesson, 200, pupil);
    assert_true(before > 0.1 && after < 1e-4);
    /* Samples outside of training do not matter, and are learnt as well. */
    for (size_t i = SAMPLES; i < table.n; i++) {
        double in[INPUTS];
        for (size_t j = 0; j < INPUTS; j++)
            in[j] = columns_at(&table, j)[i];
        for (size_t k = 0; k < 2; k++) {
            double *goal = &columns_at(&table, INPUTS + k)[i];
            assert_true(fabs(output_at(p, pupil, in, k) - *goal) < 0.01);
            *goal = (double)NAN;
        }
    }
    assert_true(perceptron_train(p, &lesson, 200, again) == after);
    assert_memory_equal(pupil, again, perceptron_weights(p) * sizeof *pupil);
    columns_free(&table);
    free(teacher);
    free(pupil);
    free(again);
}

/* Tests a program of the network over inputs a, b, c, with lets evaluated in order. */
static void test_genome(void **state)
{
    (void)state;
    enum { N = 100 };
    for (size_t i = 0; i < NETWORKS; i++) {
        const struct perceptron *p = &networks[i];
        struct genome_file *f = genome_file_new("test");
        int gene[INPUTS];
        for (int j = 0; j < INPUTS; j++) {
            genome_add_input(f, (const char[]){(char)('a' + j), '\0'});
            gene[j] = GENE_SYMBOL + j;
        }
        double *weight = draw(p, 20 + i);
        const struct genome *g = perceptron_add(p, weight, gene, "net", f);
        assert_int_equal(g->outs, 2);
        assert_string_equal(g->out[0].name, "xi");
        struct columns table = columns_new(N, INPUTS + f->lets);
        gsl_rng *rng = stream_new();
        stream_key(rng, 1, i, 0, 0);
        for (size_t row = 0; row < N; row++)
            for (size_t j = 0; j < INPUTS; j++)
                columns_at(&table, j)[row] = 6 * gsl_rng_uniform(rng) - 3;
        for (size_t j = 0; j < f->lets; j++)
            table_values(&table, f->constant, f->let[j].gene, f->let[j].length, columns_at(&table, INPUTS + j));
        for (size_t k = 0; k < 2; k++) {
            double value[N], in[INPUTS];
            table_values(&table, f->constant, g->out[k].gene, g->out[k].length, value);
            for (size_t row = 0; row < N; row++) {
                for (size_t j = 0; j < INPUTS; j++)
                    in[j] = columns_at(&table, j)[row];
                assert_true(fabs(output_at(p, weight, in, k) - value[row]) < 1e-13);
            }
        }
        gsl_rng_free(rng);
        columns_free(&table);
        genome_file_free(f);
        free(weight);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_derivatives), cmocka_unit_test(test_training),
                                       cmocka_unit_test(test_genome)};
    return cmocka_run_group_tests_name("perceptron", tests, NULL, NULL);
}
