/* The evaluator against a recursive evaluation of one sample at a time: equal bits, for every vector width. */
#include "../evolve/kernel.h"
#include "../evolve/stream.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SYMBOLS = 4, LONGEST = 120 };

static const char *const constant_text[] = {"0", "0.5", "-1.25", "3"};

struct fixture {
    gsl_rng *rng;
    struct genome_file *program;
    struct kernel *kernel[KERNEL_WIDTHS]; /* NULL: not supported here */
};

static int setup(void **state)
{
    struct fixture *f = new_array(1, sizeof *f);
    f->rng = stream_new();
    stream_key(f->rng, 7, 0, 0, 0);
    f->program = genome_file_new("test");
    for (size_t i = 0; i < sizeof constant_text / sizeof *constant_text; i++)
        genome_add_constant(f->program, constant_text[i]);
    for (int w = 0; w < KERNEL_WIDTHS; w++)
        f->kernel[w] = kernel_supports((enum kernel_width)w) ? kernel_new((enum kernel_width)w) : NULL;
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    for (int w = 0; w < KERNEL_WIDTHS; w++)
        kernel_free(f->kernel[w]);
    genome_file_free(f->program);
    gsl_rng_free(f->rng);
    free(f);
    return 0;
}

/* Symbols and a target, with exact zeros among the values. */
static struct columns random_table(gsl_rng *rng, size_t n)
{
    struct columns c = columns_new(n, SYMBOLS + 1);
    for (size_t j = 0; j < c.count; j++)
        for (size_t i = 0; i < n; i++)
            columns_at(&c, j)[i] = gsl_rng_uniform_int(rng, 20) == 0 ? 0 : 4 * gsl_rng_uniform(rng) - 2;
    return c;
}

static size_t random_genome(gsl_rng *rng, const int *operators, size_t count, size_t room, int *gene)
{
    if (room < 3 || gsl_rng_uniform_int(rng, 4) == 0) {
        gene[0] = gsl_rng_uniform_int(rng, 4) == 0 ? -1 - (int)gsl_rng_uniform_int(rng, 4)
                                                   : GENE_SYMBOL + (int)gsl_rng_uniform_int(rng, SYMBOLS);
        return 1;
    }
    gene[0] = operators[gsl_rng_uniform_int(rng, count)];
    size_t n = 1;
    for (int left = gene_arity(gene[0]); left-- > 0;)
        n += random_genome(rng, operators, count, room - n - (size_t)left, gene + n);
    return n;
}

/* Value for one sample, by recursion; advances *gene past the branch. */
__attribute__((no_sanitize("float-divide-by-zero"))) static double
recursive_value(const int **gene, const struct genome_file *program, const struct columns *c, size_t i)
{
    const int g = *(*gene)++;
    if (g < 0)
        return program->constant[-1 - g].value;
    if (g >= GENE_SYMBOL)
        return columns_at(c, (size_t)(g - GENE_SYMBOL))[i];
    const double x = recursive_value(gene, program, c, i);
    const double y = gene_arity(g) == 2 ? recursive_value(gene, program, c, i) : 0;
    switch (g) {
    case GENE_ADD:
        return x + y;
    case GENE_SUB:
        return x - y;
    case GENE_MUL:
        return x * y;
    case GENE_DIV:
        return x / y;
    case GENE_PDIV:
        return y == 0 ? 1 : x / y;
    case GENE_MIN:
        return x < y ? x : y;
    case GENE_MAX:
        return x > y ? x : y;
    case GENE_NEG:
        return -x;
    case GENE_SQRT:
        return sqrt(x);
    default:
        return fabs(x);
    }
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* The documented order of summation: lane i mod 16, then the lanes in turn. */
static double lane_sum(const double *value, const double *target, size_t n)
{
    double lane[KERNEL_LANES] = {0}, sum = 0;
    for (size_t i = 0; i < n; i++)
        lane[i % KERNEL_LANES] += fabs(value[i] - target[i]);
    for (int j = 0; j < KERNEL_LANES; j++)
        sum += lane[j];
    return isfinite(sum) ? sum : INFINITY;
}

static void check_genome(const struct fixture *f, const struct columns *c, const int *gene, size_t length)
{
    const struct kernel_task task = {gene, length, f->program->constant, c};
    double *expected = new_array(c->n, sizeof *expected), *found = new_array(c->n + 1, sizeof *found);
    for (size_t i = 0; i < c->n; i++) {
        const int *at = gene;
        expected[i] = recursive_value(&at, f->program, c, i);
    }
    const double sum = lane_sum(expected, columns_at(c, SYMBOLS), c->n);
    for (int w = 0; w < KERNEL_WIDTHS; w++) {
        if (!f->kernel[w])
            continue;
        found[c->n] = 12345;
        kernel_values(f->kernel[w], &task, found);
        for (size_t i = 0; i < c->n; i++)
            if (!same_bits(expected[i], found[i]))
                fail_msg("%d bits, sample %zu of %zu: %a, expected %a", kernel_bits((enum kernel_width)w), i, c->n,
                         found[i], expected[i]);
        assert_true(found[c->n] == 12345);
        const double fused = kernel_error_sum(f->kernel[w], &task, SYMBOLS, INFINITY);
        if (!same_bits(sum, fused))
            fail_msg("%d bits: sum %a, expected %a", kernel_bits((enum kernel_width)w), fused, sum);
    }
    free(expected);
    free(found);
}

/* All operators, numbers of samples around multiples of blocks and lanes. */
static void values_match_recursion(void **state)
{
    static const size_t sizes[] = {
        1, 15, 16, 17, KERNEL_BLOCK - 1, KERNEL_BLOCK, KERNEL_BLOCK + 1, 3 * KERNEL_BLOCK + 37};
    const struct fixture *f = *state;
    int all[GENE_OPERATORS], gene[LONGEST];
    for (int i = 0; i < GENE_OPERATORS; i++)
        all[i] = i;
    for (size_t s = 0; s < sizeof sizes / sizeof *sizes; s++) {
        struct columns c = random_table(f->rng, sizes[s]);
        for (int k = 0; k < 150; k++) {
            const size_t length = random_genome(f->rng, all, GENE_OPERATORS, LONGEST, gene);
            check_genome(f, &c, gene, length);
        }
        columns_free(&c);
    }
}

static void leaves_and_constants(void **state)
{
    const struct fixture *f = *state;
    const int symbol[] = {GENE_SYMBOL + 2}, constant[] = {-3}, folded[] = {GENE_PDIV, -2, -1},
              mixed[] = {GENE_SUB, GENE_MUL, -2, -4, GENE_SYMBOL};
    struct columns c = random_table(f->rng, 700);
    check_genome(f, &c, symbol, 1);
    check_genome(f, &c, constant, 1);
    check_genome(f, &c, folded, 3);
    check_genome(f, &c, mixed, 5);
    columns_free(&c);
}

/* A value that is not finite makes the sum infinite, wherever it stands. */
static void not_finite(void **state)
{
    const struct fixture *f = *state;
    const int leaf[] = {GENE_SYMBOL};
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    struct columns c = random_table(f->rng, 1000);
    const struct kernel_task task = {leaf, 1, f->program->constant, &c};
    for (size_t i = 0; i < c.n; i += 111)
        for (size_t k = 0; k < 3; k++) {
            const double kept = columns_at(&c, 0)[i];
            columns_at(&c, 0)[i] = bad[k];
            for (int w = 0; w < KERNEL_WIDTHS; w++)
                if (f->kernel[w])
                    assert_true(kernel_error_sum(f->kernel[w], &task, SYMBOLS, INFINITY) == INFINITY);
            columns_at(&c, 0)[i] = kept;
        }
    assert_true(isfinite(kernel_error_sum(f->kernel[KERNEL_PLAIN], &task, SYMBOLS, INFINITY)));
    columns_free(&c);
}

/* Evaluation stops at the first block whose partial sum exceeds the bound, and never below the bound. */
static void early_end(void **state)
{
    const struct fixture *f = *state;
    const int leaf[] = {GENE_SYMBOL};
    struct columns c = random_table(f->rng, 10 * KERNEL_BLOCK);
    const struct kernel_task task = {leaf, 1, f->program->constant, &c};
    const double sum = kernel_error_sum(f->kernel[KERNEL_PLAIN], &task, SYMBOLS, INFINITY);
    for (int w = 0; w < KERNEL_WIDTHS; w++) {
        struct kernel *k = f->kernel[w];
        if (!k)
            continue;
        assert_true(same_bits(kernel_error_sum(k, &task, SYMBOLS, sum), sum));
        assert_true(kernel_error_sum(k, &task, SYMBOLS, nextafter(sum, 0)) == INFINITY);
        const double before = kernel_work(k);
        assert_true(kernel_error_sum(k, &task, SYMBOLS, 0.25 * sum) == INFINITY);
        const double blocks = (kernel_work(k) - before) / KERNEL_BLOCK;
        if (!(blocks >= 2 && blocks <= 4))
            fail_msg("%d bits: %g of 10 blocks for a quarter of the sum", kernel_bits((enum kernel_width)w), blocks);
    }
    columns_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(values_match_recursion, setup, teardown),
        cmocka_unit_test_setup_teardown(leaves_and_constants, setup, teardown),
        cmocka_unit_test_setup_teardown(not_finite, setup, teardown),
        cmocka_unit_test_setup_teardown(early_end, setup, teardown),
    };
    return cmocka_run_group_tests_name("kernel", tests, NULL, NULL);
}
