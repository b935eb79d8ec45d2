/* Region blocks: the numbers measured of a segment reproduce it, in each kind, and scalar products equal those of the
 * block. */
#include "../../evolve/common/vec3.h"
#include "../../evolve/region/shape_region.h"
#include "../../evolve/surface/surface.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SEGMENTS = 50, MOST_SYMBOLS = 1000, MOST_STACK = 100 };

static double fraction(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-53;
}

/* Evaluates an expression from its end, as a stack machine. */
static double value_of(const struct genome_file *f, const struct genome_expr *e, const double *symbol)
{
    double stack[MOST_STACK];
    size_t depth = 0;
    for (size_t i = e->length; i-- > 0;) {
        const int gene = e->gene[i];
        if (gene < 0)
            stack[depth++] = f->constant[-1 - gene].value;
        else if (gene >= GENE_SYMBOL)
            stack[depth++] = symbol[gene - GENE_SYMBOL];
        else if (gene == GENE_NEG)
            stack[depth - 1] = -stack[depth - 1];
        else {
            const double x = stack[--depth], y = stack[--depth];
            stack[depth++] = gene == GENE_ADD ? x + y : gene == GENE_SUB ? x - y : gene == GENE_MUL ? x * y : x / y;
        }
    }
    return stack[0];
}

static void evaluate(const struct genome_file *f, const double *number, size_t numbers, double *symbol)
{
    for (size_t i = 0; i < f->inputs; i++)
        symbol[i] = i + numbers < f->inputs ? f->constant[f->range[i].lo].value : number[i + numbers - f->inputs];
    for (size_t i = 0; i < f->lets; i++)
        symbol[f->inputs + i] = value_of(f, &f->let[i], symbol);
}

/* Draws a face near the unit face, anywhere, and a slave node over one of its points. */
static struct sample random_sample(const struct segment_kind *kind, uint64_t *seed)
{
    static const double square[9][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, 0}};
    static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    const struct surface *f = surface_find(kind);
    struct sample s = {.xi = 0.6 * fraction(seed), .eta = 0.4 * fraction(seed)};
    double r[3], n[3];
    for (size_t i = 0; i < strlen(kind->nodes); i++) {
        const double *at = kind->triangle ? triangle[i] : square[i];
        for (int k = 0; k < 3; k++)
            s.x[i][k] = 3 + (k < 2 ? at[k] : at[0]) + 0.1 * fraction(seed);
    }
    assert_true(surface_normal(f, s.x, s.xi, s.eta, r, n));
    for (int k = 0; k < 3; k++)
        s.xs[k] = r[k] + 0.3 * n[k];
    return s;
}

static double symbol_named(const struct genome_file *f, const double *symbol, const char *name)
{
    const long k = genome_find_symbol(f, name);
    assert_true(k >= 0);
    return symbol[k];
}

/* Copies the coordinates of a vector, or the vector that begins with a let. */
static void vector_named(const struct genome_file *f, const double *symbol, const char *name, double v[3])
{
    for (int k = 0; k < 3; k++) {
        char component[20];
        snprintf(component, sizeof component, "%s%c", name, "xyz"[k]);
        v[k] = symbol_named(f, symbol, component);
    }
}

static void check_product(const struct genome_file *f, const double *symbol, const char *a, const char *b,
                          const char *product)
{
    double x[3], y[3];
    vector_named(f, symbol, a, x);
    vector_named(f, symbol, b, y);
    assert_true(fabs(vector_dot(x, y) - symbol_named(f, symbol, product)) < 1e-10);
}

/* Checks d = S - r0, where A = 0 lies at rA from r0, and its parts. */
static void check_distance(const struct genome_file *f, const double *symbol)
{
    static const char *const name[] = {"c10", "c01", "c11"}, *const product[] = {"d1", "d2", "d11"};
    double d[3], to[3], own[3];
    vector_named(f, symbol, "S", d);
    vector_named(f, symbol, "rA", to);
    for (int k = 0; k < 3; k++)
        d[k] += to[k];
    for (int i = 0; i < 3 && genome_find_symbol(f, product[i]) >= 0; i++) {
        vector_named(f, symbol, name[i], own);
        assert_true(fabs(vector_dot(d, own) - symbol_named(f, symbol, product[i])) < 1e-10);
    }
    const double p = symbol_named(f, symbol, "p"), q = symbol_named(f, symbol, "q");
    assert_true(fabs(p * symbol_named(f, symbol, "e11") + q * symbol_named(f, symbol, "skew") -
                     symbol_named(f, symbol, "d1")) < 1e-10);
}

static void check_kind(const char *name)
{
    const struct segment_kind *kind = segment_find(name);
    struct shape *shape = shape_new(kind);
    struct genome_file *region = shape_region(shape);
    double symbol[MOST_SYMBOLS], number[SHAPE_NUMBERS];
    uint64_t seed = 1;
    assert_non_null(region);
    assert_true(region->inputs + region->lets <= MOST_SYMBOLS);
    for (int i = 0; i < SEGMENTS; i++) {
        const struct sample s = random_sample(kind, &seed);
        struct sample placed;
        shape_measure(shape, &s, number, &placed);
        evaluate(region, number, shape_numbers(shape), symbol);
        for (size_t n = 0; n <= strlen(kind->nodes); n++) {
            const bool node = n < strlen(kind->nodes);
            const char vector[] = {node ? kind->nodes[n] : 'S', '\0'};
            double v[3];
            vector_named(region, symbol, vector, v);
            for (int k = 0; k < 3; k++)
                assert_true(fabs(v[k] - (node ? placed.x[n][k] : placed.xs[k])) < 1e-10);
        }
        check_product(region, symbol, "c10", "c10", "e11");
        check_product(region, symbol, "c10", "c01", "skew");
        check_product(region, symbol, "c01", "c01", "e22");
        check_distance(region, symbol);
        if (strlen(kind->nodes) > 3) {
            check_product(region, symbol, "c11", "c11", "s1111");
            check_product(region, symbol, "ru", "ru", "foot_11");
            check_product(region, symbol, "ru", "rv", "foot_12");
            check_product(region, symbol, "rv", "rv", "foot_22");
            const double g11 = symbol_named(region, symbol, "foot_11"), g12 = symbol_named(region, symbol, "foot_12");
            const double g22 = symbol_named(region, symbol, "foot_22"), j = symbol_named(region, symbol, "foot_j");
            assert_true(fabs(j - (g11 * g22 - g12 * g12)) < 1e-10);
        }
    }
    genome_file_free(region);
    free(shape);
}

static void shape_numbers_reproduce_segments(void **state)
{
    (void)state;
    static const char *const name[] = {"tri3", "quad4", "tri6", "quad8", "quad9"};
    for (size_t i = 0; i < sizeof name / sizeof *name; i++)
        check_kind(name[i]);
    assert_null(shape_new(segment_find("gregory")));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(shape_numbers_reproduce_segments)};
    return cmocka_run_group_tests_name("shapes", tests, NULL, NULL);
}
