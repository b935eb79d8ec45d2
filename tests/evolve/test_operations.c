/* Costs of trees: known counts, invariance under free changes, and agreement with the values. */
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/eval/objective.h"
#include "../../evolve/eval/operation_count.h"
#include "../../evolve/genotype/tree.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { MAX_LENGTH = 63, X = GENE_SYMBOL, Y = GENE_SYMBOL + 1, SAMPLES = 64 };

static const struct {
    const char *text; /* x, y; digits are constants, ~ is -1 */
    unsigned mul, add, div;
} known[] = {
    {"x", 0, 0, 0},         {"3", 0, 0, 0}, {"*xy", 1, 0, 0}, {"+*xy*yx", 1, 1, 0}, /* equal products */
    {"-*xy*yx", 0, 0, 0},                                                           /* 0 */
    {"*-xy-yx", 1, 1, 0},                                                           /* equal except for the sign */
    {"*1+x0", 0, 0, 0},                                                             /* x */
    {"*~x", 0, 0, 0},                                                               /* a change of sign */
    {"+y*0%xy", 0, 0, 0},                                                           /* not computed */
    {"*+23x", 1, 0, 0},                                                             /* folded */
    {"%x2", 1, 0, 0},                                                               /* a product */
    {"%x1", 0, 0, 0},                                                               /* */
    {"%xx", 0, 0, 0},                                                               /* 1 */
    {"%x0", 0, 0, 0},                                                               /* 1 */
    {"%1+1x", 0, 1, 1},                                                             /* */
    {"+%1x%1x", 0, 1, 1},                                                           /* equal quotients */
    {"**xx*xx", 2, 0, 0},                                                           /* fourth power */
    {"+*2x*-23x", 1, 1, 0}, /* 2 x - x: the second factor is -1 */
};

static struct genes parse(const char *text, int gene[MAX_LENGTH])
{
    struct genes t = {gene, strlen(text)};
    for (size_t i = 0; i < t.length; i++)
        switch (text[i]) {
        case '+':
            gene[i] = GENE_ADD;
            break;
        case '-':
            gene[i] = GENE_SUB;
            break;
        case '*':
            gene[i] = GENE_MUL;
            break;
        case '%':
            gene[i] = GENE_PDIV;
            break;
        case '~':
            gene[i] = decimal_gene(-1);
            break;
        case 'x':
        case 'y':
            gene[i] = X + text[i] - 'x';
            break;
        default:
            gene[i] = decimal_gene(text[i] - '0');
        }
    return t;
}

static void known_counts(void **state)
{
    (void)state;
    int gene[MAX_LENGTH];
    struct counter *c = counter_new();
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        const struct genes t = parse(known[i].text, gene);
        const struct operation_count o = count_operations(c, &t, NULL);
        if (o.mul != known[i].mul || o.add != known[i].add || o.div != known[i].div)
            fail_msg("%s: %u mul, %u add, %u div", known[i].text, o.mul, o.add, o.div);
    }
    counter_free(c);
}

/* Exchanges the operands of sums and products at random. */
static size_t shuffle(gsl_rng *rng, const int *gene, int *to)
{
    to[0] = gene[0];
    if (gene_arity(gene[0]) == 0)
        return 1;
    const size_t a = gene_span(gene + 1, MAX_LENGTH), b = gene_span(gene + 1 + a, MAX_LENGTH);
    const bool exchange = (gene[0] == GENE_ADD || gene[0] == GENE_MUL) && gsl_rng_uniform(rng) < 0.5;
    const size_t first = shuffle(rng, exchange ? gene + 1 + a : gene + 1, to + 1);
    shuffle(rng, exchange ? gene + 1 : gene + 1 + a, to + 1 + first);
    return 1 + a + b;
}

static const struct gene_set *test_genes(void)
{
    static int symbol[] = {X, Y}, constant[7], operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_PDIV};
    static const double value[] = {-2, -1, -0.5, 0, 0.5, 1, 3};
    static const struct gene_set set = {symbol, 2, constant, 7, operation, 4, 0};
    for (int i = 0; i < 7; i++)
        constant[i] = decimal_gene(value[i]);
    return &set;
}

/* The order of operands changes neither count nor hash; trees of equal hash have equal values to the bit. */
static void equal_hashes_mean_equal_errors(void **state)
{
    (void)state;
    enum { TREES = 20000 };
    static struct {
        uint64_t hash;
        double error;
    } seen[1 << 16];
    int gene[MAX_LENGTH], other[MAX_LENGTH];
    struct genes t = {gene, 0}, u = {other, 0};
    size_t repeats = 0;
    struct counter *c = counter_new();
    struct columns table = columns_new(SAMPLES, 3);
    gsl_rng *rng = stream_new();
    stream_key(rng, 1, 2, 3, 4);
    for (size_t i = 0; i < SAMPLES; i++) {
        columns_at(&table, 0)[i] = gsl_rng_uniform(rng) - 0.5;
        columns_at(&table, 1)[i] = i % 5 == 0 ? 0 : gsl_rng_uniform(rng);
    }
    struct objective *j = objective_new(NULL, &table, NORM_MEAN);
    j->decimal = true;
    for (int k = 0; k < TREES; k++) {
        tree_random(rng, test_genes(), 1 + k % 4, false, MAX_LENGTH, &t);
        u.length = shuffle(rng, t.gene, u.gene);
        const struct operation_count o = count_operations(c, &t, NULL), p = count_operations(c, &u, NULL);
        if (o.hash != p.hash || o.mul != p.mul || o.add != p.add || o.div != p.div)
            fail_msg("tree %d of %zu genes changes with the order of its operands", k, t.length);
        if (!(o.mul + o.add + o.div <= t.length / 2))
            fail_msg("tree %d of %zu genes: %u operations", k, t.length, o.mul + o.add + o.div);
        const double error = objective_tree_error(j, &t, 2, INFINITY);
        const size_t at = o.hash >> 48;
        if (seen[at].hash == o.hash) {
            repeats++;
            if (seen[at].error != error)
                fail_msg("tree %d: errors %a and %a of equal hashes", k, seen[at].error, error);
        }
        seen[at].hash = o.hash;
        seen[at].error = error;
    }
    assert_true(repeats > TREES / 10);
    objective_free(j);
    columns_free(&table);
    counter_free(c);
    gsl_rng_free(rng);
}

static void prices(void **state)
{
    (void)state;
    int gene[MAX_LENGTH];
    struct counter *c = counter_new();
    const struct genes t = parse("%+x*xy+1y", gene);
    const struct operation_count o = count_operations(c, &t, NULL);
    assert_true(operations_price(&o, &(struct prices){.add = 0, .div = 1}) == 2);
    assert_true(operations_price(&o, &(struct prices){.add = 1, .div = 8, .path = 0}) == 11);
    gene[0] = GENE_MIN;
    const struct operation_count p = count_operations(c, &t, NULL);
    assert_int_equal(p.other, 1);
    const struct genome_constant seven = {NULL, 7};
    const struct genes product = {(int[]){GENE_MUL, -1, X}, 3}; /* -1 is 0 as a decimal number */
    assert_int_equal(count_operations(c, &product, NULL).mul, 0);
    assert_int_equal(count_operations(c, &product, &seven).mul, 1);
    counter_free(c);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(known_counts),
        cmocka_unit_test(equal_hashes_mean_equal_errors),
        cmocka_unit_test(prices),
    };
    return cmocka_run_group_tests_name("operations", tests, NULL, NULL);
}
