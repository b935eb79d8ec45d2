/* Genetic operators keep genomes complete, within their length, and within their set of genes. */
#include "../../evolve/common/decimal.h"
#include "../../evolve/common/stream.h"
#include "../../evolve/genotype/tree.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>

#include <cmocka.h>

enum { POPULATION = 50, MAX_LENGTH = 41, OPERATIONS = 100000 };

static int symbol[] = {GENE_SYMBOL, GENE_SYMBOL + 1, GENE_SYMBOL + 2};
static int constant[] = {-1, -2, -3, -4, -5, -6, -7, -8, -9, -10, -11, -12};
static int operation[] = {GENE_ADD, GENE_SUB, GENE_MUL, GENE_PDIV};
static const struct gene_set set = {symbol, 3, constant, 12, operation, 4, 0};

static bool contains(const int *gene, size_t n, int wanted)
{
    for (size_t i = 0; i < n; i++)
        if (gene[i] == wanted)
            return true;
    return false;
}

static void check_tree(const struct genes *t, size_t max, const char *what, int step)
{
    if (t->length < 1 || t->length > max || gene_span(t->gene, t->length) != t->length)
        fail_msg("%s, operation %d: %zu genes, the first tree has %zu", what, step, t->length,
                 gene_span(t->gene, t->length));
    for (size_t i = 0; i < t->length; i++)
        if (!contains(symbol, 3, t->gene[i]) && !contains(constant, 12, t->gene[i]) &&
            !contains(operation, 4, t->gene[i]) && t->gene[i] != GENE_NEG)
            fail_msg("%s, operation %d: gene %d is not in the set", what, step, t->gene[i]);
}

static void operators_keep_genomes_valid(void **state)
{
    (void)state;
    static int gene[POPULATION + 2][MAX_LENGTH];
    struct genes tree[POPULATION + 2];
    gsl_rng *rng = stream_new();
    stream_key(rng, 3, 0, 0, 0);
    for (int i = 0; i < POPULATION + 2; i++)
        tree[i].gene = gene[i];
    for (int i = 0; i < POPULATION; i++) {
        tree_random(rng, &set, i % 9, i % 2 == 0, MAX_LENGTH, &tree[i]);
        check_tree(&tree[i], MAX_LENGTH, "random", i);
    }
    memcpy(gene[0], (int[]){GENE_NEG, GENE_MUL, GENE_SYMBOL, -1}, 4 * sizeof(int)); /* a seed may bring this operator */
    tree[0].length = 4;
    struct genes *child_a = &tree[POPULATION], *child_b = &tree[POPULATION + 1];
    for (int step = 0; step < OPERATIONS; step++) {
        struct genes *a = &tree[gsl_rng_uniform_int(rng, POPULATION)], *b = &tree[gsl_rng_uniform_int(rng, POPULATION)];
        switch (gsl_rng_uniform_int(rng, 3)) {
        case 0:
            tree_cross(rng, a, b, MAX_LENGTH, child_a, child_b);
            check_tree(child_a, MAX_LENGTH, "cross", step);
            check_tree(child_b, MAX_LENGTH, "cross", step);
            genes_copy(child_a, a);
            genes_copy(child_b, b);
            break;
        case 1:
            tree_mutate_branch(rng, &set, a, MAX_LENGTH, child_a);
            check_tree(child_a, MAX_LENGTH, "branch", step);
            genes_copy(child_a, a);
            break;
        default:
            tree_mutate_gene(rng, &set, a);
            check_tree(a, MAX_LENGTH, "gene", step);
        }
    }
    gsl_rng_free(rng);
}

/* The genes of two children together are their parents' genes, if both fit. */
static void crossover_exchanges(void **state)
{
    (void)state;
    int a_gene[7] = {GENE_MUL, GENE_SYMBOL, GENE_ADD, -1, GENE_SYMBOL + 1}, b_gene[3] = {GENE_SUB, -2, GENE_SYMBOL + 2};
    int c_gene[8], d_gene[8];
    const struct genes a = {a_gene, 5}, b = {b_gene, 3};
    struct genes c = {c_gene, 0}, d = {d_gene, 0};
    gsl_rng *rng = stream_new();
    for (uint64_t k = 0; k < 1000; k++) {
        int sum = 0;
        stream_key(rng, 5, k, 0, 0);
        tree_cross(rng, &a, &b, 8, &c, &d);
        assert_int_equal(c.length + d.length, 8);
        for (size_t i = 0; i < 8; i++)
            sum += i < c.length ? c.gene[i] : d.gene[i - c.length];
        assert_int_equal(sum, GENE_MUL + GENE_ADD + GENE_SUB + 3 * GENE_SYMBOL + 1 + 2 - 1 - 2);
    }
    gsl_rng_free(rng);
}

static void smallest_limits(void **state)
{
    (void)state;
    int gene[3], other[3];
    struct genes t = {gene, 0}, child = {other, 0}, twin = {(int[3]){0}, 0};
    gsl_rng *rng = stream_new();
    stream_key(rng, 9, 0, 0, 0);
    for (size_t max = 1; max <= 3; max++)
        for (int k = 0; k < 200; k++) {
            tree_random(rng, &set, 5, true, max, &t);
            check_tree(&t, max, "random", k);
            tree_mutate_branch(rng, &set, &t, max, &child);
            check_tree(&child, max, "branch", k);
            tree_cross(rng, &t, &t, max, &child, &twin);
            check_tree(&child, max, "cross", k);
            check_tree(&twin, max, "cross", k);
        }
    gsl_rng_free(rng);
}

/* Full trees have all leaves at their depth; hashes distinguish trees. */
static void shapes_and_hashes(void **state)
{
    (void)state;
    int gene[63], same_gene[63];
    struct genes t = {gene, 0}, same = {same_gene, 0};
    gsl_rng *rng = stream_new();
    stream_key(rng, 1, 0, 0, 0);
    tree_random(rng, &set, 5, true, 63, &t);
    assert_int_equal(t.length, 63);
    genes_copy(&t, &same);
    assert_true(genes_equal(&t, &same) && genes_hash(&t) == genes_hash(&same));
    same.gene[62] = same.gene[62] == -1 ? -2 : -1;
    assert_false(genes_equal(&t, &same));
    assert_true(genes_hash(&t) != genes_hash(&same));
    gsl_rng_free(rng);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operators_keep_genomes_valid),
        cmocka_unit_test(crossover_exchanges),
        cmocka_unit_test(smallest_limits),
        cmocka_unit_test(shapes_and_hashes),
    };
    return cmocka_run_group_tests_name("tree", tests, NULL, NULL);
}
