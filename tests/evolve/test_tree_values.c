/* The evaluator of trees against a recursive evaluation of one sample at a time: equal bits. */
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/eval/lines_run.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SYMBOLS = 4, LONGEST = 120 };

static const char *const constant_text[] = {"0", "0.5", "-1.25", "3"};

struct fixture {
    gsl_rng *rng;
    struct genome_file *program;
};

static int setup(void **state)
{
    struct fixture *f = new_array(1, sizeof *f);
    f->rng = stream_new();
    stream_key(f->rng, 7, 0, 0, 0);
    f->program = genome_file_new("test");
    for (size_t i = 0; i < sizeof constant_text / sizeof *constant_text; i++)
        genome_add_constant(f->program, constant_text[i]);
    *state = f;
    return 0;
}

static int teardown(void **state)
{
    struct fixture *f = *state;
    genome_file_free(f->program);
    gsl_rng_free(f->rng);
    free(f);
    return 0;
}

/* Makes symbols and a target, with exact zeros among the values. */
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

/* A tree over a table. */
struct task {
    const int *gene;
    size_t length;
    const struct genome_constant *constant; /* NULL: decimal constants */
    const struct columns *table;
};

static double error_sum(const struct task *t, double bound, double *work)
{
    struct lines_run *r = lines_run_new(NULL, t->table);
    const double sum = lines_tree_error(r, t->gene, t->length, t->constant, SYMBOLS, bound);
    *work = r->work;
    lines_run_free(r);
    return sum;
}

static double all_errors(const struct task *t)
{
    double work;
    return error_sum(t, INFINITY, &work);
}

/* A sample of the table. */
struct point {
    const struct genome_constant *constant; /* NULL: decimal constants */
    const struct columns *c;
    size_t i;
};

static double leaf_value(const struct point *p, int gene)
{
    if (gene >= GENE_SYMBOL)
        return columns_at(p->c, (size_t)(gene - GENE_SYMBOL))[p->i];
    return p->constant ? p->constant[-1 - gene].value : decimal_value(gene);
}

__attribute__((no_sanitize("float-divide-by-zero"))) static double apply(int gene, double x, double y)
{
    switch (gene) {
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

/* Returns the value for one sample, by recursion; advances *gene past the branch. */
static double recursive_value(const int **gene, const struct point *p)
{
    const int g = *(*gene)++;
    if (gene_arity(g) == 0)
        return leaf_value(p, g);
    const double x = recursive_value(gene, p);
    const double y = gene_arity(g) == 2 ? recursive_value(gene, p) : 0;
    return apply(g, x, y);
}

static bool same_bits(double a, double b)
{
    return memcmp(&a, &b, sizeof a) == 0 || (isnan(a) && isnan(b));
}

/* Returns the sum in the documented order: in a block, lane i mod 64, then halves of the lanes; blocks in turn. */
static double lane_sum(const double *value, const struct point *p)
{
    const size_t n = p->c->n;
    double sum = 0;
    for (size_t first = 0; first < n; first += SUM_BLOCK) {
        double lane[TREE_LANES] = {0};
        for (size_t i = first; i < n && i < first + SUM_BLOCK; i++) {
            const struct point at = {NULL, p->c, i};
            lane[i % TREE_LANES] += fabs(value[i] - leaf_value(&at, GENE_SYMBOL + SYMBOLS));
        }
        for (int half = TREE_LANES / 2; half > 0; half /= 2)
            for (int j = 0; j < half; j++)
                lane[j] += lane[j + half];
        sum += lane[0];
    }
    return isfinite(sum) ? sum : INFINITY;
}

static void check_values(const struct task *task, const double *expected)
{
    const size_t n = task->table->n;
    double *found = new_array(n + 1, sizeof *found);
    found[n] = 12345;
    table_values(task->table, task->constant, task->gene, task->length, found);
    for (size_t i = 0; i < n; i++)
        if (!same_bits(expected[i], found[i]))
            fail_msg("sample %zu of %zu: %a, expected %a", i, n, found[i], expected[i]);
    assert_true(found[n] == 12345);
    free(found);
}

/* Checks values and sums of a genome. */
static void check_task(const struct task *task)
{
    const struct columns *c = task->table;
    double *expected = new_array(c->n, sizeof *expected);
    struct point p = {task->constant, c, 0};
    for (; p.i < c->n; p.i++) {
        const int *at = task->gene;
        expected[p.i] = recursive_value(&at, &p);
        assert_true(at == task->gene + task->length);
    }
    check_values(task, expected);
    const double sum = all_errors(task), expected_sum = lane_sum(expected, &p);
    if (!same_bits(expected_sum, sum))
        fail_msg("sum %a, expected %a", sum, expected_sum);
    free(expected);
}

static void check_genome(const struct fixture *f, const struct columns *c, const int *gene, size_t length)
{
    check_task(&(struct task){gene, length, f->program->constant, c});
}

/* All operators agree; numbers of samples are near multiples of blocks and lanes. */
static void values_match_recursion(void **state)
{
    static const size_t sizes[] = {
        1, 15, 16, 17, 127, 129, SUM_BLOCK - 1, SUM_BLOCK, SUM_BLOCK + 1, 3 * SUM_BLOCK + 37};
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

/* Constants in the genes equal the same constants in a program. */
static void decimal_constants(void **state)
{
    const struct fixture *f = *state;
    const int decimal[] = {GENE_MUL, GENE_ADD, GENE_SYMBOL, decimal_gene(0.1), decimal_gene(-1.25)};
    const int indexed[] = {GENE_MUL, GENE_ADD, GENE_SYMBOL, -1, -2};
    const struct genome_constant constant[] = {{NULL, 0.1}, {NULL, -1.25}};
    struct columns c = random_table(f->rng, 1000);
    const struct task a = {decimal, 5, NULL, &c}, b = {indexed, 5, constant, &c};
    check_task(&a);
    check_task(&b);
    assert_true(same_bits(all_errors(&a), all_errors(&b)));
    columns_free(&c);
}

/* A full tree of given depth, or a comb along the first or the second operands. */
enum shape { FULL, FIRST_COMB, SECOND_COMB };
static size_t shaped_genome(gsl_rng *rng, enum shape shape, int depth, bool slow, int *gene)
{
    static const int operators[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_MIN, GENE_MAX};
    if (depth == 0) {
        gene[0] = GENE_SYMBOL + (int)gsl_rng_uniform_int(rng, SYMBOLS);
        return 1;
    }
    gene[0] = operators[gsl_rng_uniform_int(rng, slow ? 5 : 3)];
    size_t n = 1;
    for (enum shape side = FIRST_COMB; side <= SECOND_COMB; side++)
        n += shaped_genome(rng, shape, shape == FULL || shape == side ? depth - 1 : depth > 1, slow, gene + n);
    return n;
}

/* Genomes have thousands of genes, or need many blocks. */
static void long_genomes(void **state)
{
    enum { ROOM = 1 << 13 };
    const struct fixture *f = *state;
    int *gene = new_array(ROOM, sizeof *gene);
    struct columns c = random_table(f->rng, 200);
    for (int slow = 0; slow < 2; slow++) {
        check_genome(f, &c, gene, shaped_genome(f->rng, FULL, 12, slow, gene));
        check_genome(f, &c, gene, shaped_genome(f->rng, FIRST_COMB, 2000, slow, gene));
        check_genome(f, &c, gene, shaped_genome(f->rng, SECOND_COMB, 2000, slow, gene));
    }
    columns_free(&c);
    free(gene);
}

/* Draws from the whole range of numbers: zeros, subnormal, huge and infinite numbers, NaN, and random numbers
 * between. */
static double wild(gsl_rng *rng)
{
    static const double special[] = {0, -0.0, 0x1p-1074, -0x1p-1050, 0x1p-1022, 0x1p1023, INFINITY, -INFINITY, NAN, 1};
    const size_t k = gsl_rng_uniform_int(rng, 40);
    if (k < sizeof special / sizeof *special)
        return special[k];
    const double x = 1 + gsl_rng_uniform(rng);
    return ldexp(k % 2 == 0 ? x : -x, k < 20 ? (int)gsl_rng_uniform_int(rng, 2100) - 1060 : (int)k - 30);
}

/* Draws integers x and y < 2^p whose quotient is as near as possible to the middle of two neighbouring numbers of p
 * digits. It differs by 1 / (2^(p+1) y) if x < y, where x 2^(p+1) = +-1 modulo y, and by 1 / (2^p y) otherwise, where x
 * 2^p = +-1. */
static void hard_quotient(gsl_rng *rng, int p, double *x, double *y)
{
    const uint64_t limit = UINT64_C(1) << p;
    const bool below_one = gsl_rng_uniform_int(rng, 2) == 0;
    uint64_t d = limit - 1 - 2 * gsl_rng_uniform_int(rng, 3000); /* their reciprocals are the hardest to round */
    if (gsl_rng_uniform_int(rng, 4) > 0)
        d = limit / 2 + (uint64_t)ldexp(gsl_rng_uniform(rng), p - 2) * 2 + 1;
    uint64_t inverse = 1; /* of the power of two, modulo d */
    for (int i = below_one ? p + 1 : p; i > 0; i--)
        inverse = inverse % 2 == 0 ? inverse / 2 : (inverse + d) / 2;
    const uint64_t greater = inverse > d / 2 ? inverse : d - inverse;
    const uint64_t n = below_one ? greater : d + (d - greater);
    *x = (double)(n < limit ? n : greater);
    *y = (double)d;
}

static void quotients(void **state)
{
    enum { N = 20000 };
    const struct fixture *f = *state;
    const int divide[] = {GENE_DIV, GENE_SYMBOL, GENE_SYMBOL + 1};
    const int protected[] = {GENE_PDIV, GENE_SYMBOL, GENE_SYMBOL + 1};
    const int inverse[] = {GENE_DIV, -4, GENE_SYMBOL + 1};
    struct columns c = random_table(f->rng, N);
    for (int round = 0; round < 4; round++) {
        for (size_t i = 0; i < N; i++)
            if (round == 0) {
                columns_at(&c, 0)[i] = wild(f->rng);
                columns_at(&c, 1)[i] = wild(f->rng);
            } else if (round == 1) {
                columns_at(&c, 0)[i] = gsl_rng_uniform(f->rng) - 0.5;
                columns_at(&c, 1)[i] = gsl_rng_uniform(f->rng) - 0.5;
            } else {
                hard_quotient(f->rng, round == 2 ? 24 : 53, columns_at(&c, 0) + i, columns_at(&c, 1) + i);
            }
        check_genome(f, &c, divide, 3);
        check_genome(f, &c, protected, 3);
        check_genome(f, &c, inverse, 3);
    }
    columns_free(&c);
}

/* A value that is not finite makes the sum infinite, wherever it occurs. */
static void nonfinite_values_make_the_sum_infinite(void **state)
{
    const struct fixture *f = *state;
    const int leaf[] = {GENE_SYMBOL};
    static const double bad[] = {NAN, INFINITY, -INFINITY};
    struct columns c = random_table(f->rng, 1000);
    const struct task task = {leaf, 1, f->program->constant, &c};
    for (size_t i = 0; i < c.n; i += 111)
        for (size_t k = 0; k < 3; k++) {
            const double kept = columns_at(&c, 0)[i];
            columns_at(&c, 0)[i] = bad[k];
            assert_true(all_errors(&task) == INFINITY);
            columns_at(&c, 0)[i] = kept;
        }
    assert_true(isfinite(all_errors(&task)));
    columns_free(&c);
}

/* Evaluation stops at the first block whose partial sum exceeds the bound, and never below the bound. */
static void early_end(void **state)
{
    const struct fixture *f = *state;
    const int leaf[] = {GENE_SYMBOL};
    struct columns c = random_table(f->rng, 10 * SUM_BLOCK);
    const struct task task = {leaf, 1, f->program->constant, &c};
    const double sum = all_errors(&task);
    double work;
    assert_true(same_bits(error_sum(&task, sum, &work), sum));
    assert_true(error_sum(&task, nextafter(sum, 0), &work) == INFINITY);
    assert_true(error_sum(&task, 0.25 * sum, &work) == INFINITY);
    if (!(work >= 2 * SUM_BLOCK && work <= 4 * SUM_BLOCK))
        fail_msg("%g of 10 blocks for a quarter of the sum", work / SUM_BLOCK);
    columns_free(&c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(values_match_recursion, setup, teardown),
        cmocka_unit_test_setup_teardown(leaves_and_constants, setup, teardown),
        cmocka_unit_test_setup_teardown(decimal_constants, setup, teardown),
        cmocka_unit_test_setup_teardown(long_genomes, setup, teardown),
        cmocka_unit_test_setup_teardown(quotients, setup, teardown),
        cmocka_unit_test_setup_teardown(nonfinite_values_make_the_sum_infinite, setup, teardown),
        cmocka_unit_test_setup_teardown(early_end, setup, teardown),
    };
    return cmocka_run_group_tests_name("tree_values", tests, NULL, NULL);
}
