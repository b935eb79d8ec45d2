/* Constants of evolution: coding, rounding, text. */
#include "../../evolve/common/decimal.h"

#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

static void values_come_back(void **state)
{
    static const double value[] = {0, 1, -1, 0.05, -4.95, 5, 1234567, -0.001234567, 1e-12, 1e9, 9999999e3, 10, 100000};
    (void)state;
    for (size_t i = 0; i < sizeof value / sizeof *value; i++) {
        const int gene = decimal_gene(value[i]);
        assert_true(gene < 0 && decimal_valid(gene));
        assert_true(decimal_value(gene) == value[i]);
    }
}

static void text_reads_back(void **state)
{
    char text[DECIMAL_TEXT];
    (void)state;
    for (int i = -200000; i <= 200000; i += 7) {
        const int gene = decimal_gene(i * 1.25e-5 * (i % 11) * (i % 13));
        decimal_text(gene, text);
        assert_true(strtod(text, NULL) == decimal_value(gene));
        assert_int_equal(decimal_gene(decimal_value(gene)), gene);
        assert_true(decimal_valid(gene));
    }
    decimal_text(decimal_gene(-0.35), text);
    assert_string_equal(text, "-0.35");
}

static void rounding_is_to_seven_digits(void **state)
{
    (void)state;
    assert_true(decimal_value(decimal_gene(M_PI)) == 3.141593);
    assert_true(decimal_value(decimal_gene(-M_PI * 1e5)) == -314159.3);
    assert_true(decimal_value(decimal_gene(1e-13)) == 0);
    assert_true(decimal_value(decimal_gene(1e30)) == 9999999e3);
    assert_true(decimal_value(decimal_gene(-INFINITY)) == -9999999e3);
    assert_true(decimal_value(decimal_gene(NAN)) == 0);
    assert_true(decimal_value(decimal_gene(0.99999999)) == 1);
}

static void only_canonical_genes_are_valid(void **state)
{
    (void)state;
    assert_false(decimal_valid(0));
    assert_false(decimal_valid(7));
    assert_false(decimal_valid(INT_MIN));
    assert_false(decimal_valid(-2)); /* -0 */
    assert_false(decimal_valid(-1 - (10 * 16 + 3) * 2));
    assert_true(decimal_valid(-1 - (1 * 16 + 4) * 2));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(values_come_back),
        cmocka_unit_test(text_reads_back),
        cmocka_unit_test(rounding_is_to_seven_digits),
        cmocka_unit_test(only_canonical_genes_are_valid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
