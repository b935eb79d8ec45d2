/* Tests error statistics on short lists. */
#include "error_stats.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

static void test_known(void **state)
{
    double error[200];
    (void)state;
    for (int i = 0; i < 200; i++)
        error[i] = (i * 37) % 200 + 1;
    const struct error_stats s = error_stats_of(error, 200);
    assert_true(fabs(s.mean - 100.5) < 1e-12);
    assert_true(s.p99 == 198);
    assert_true(s.max == 200);
    assert_int_equal(s.failures, 0);
}

static void test_one(void **state)
{
    double error[1] = {0.25};
    (void)state;
    const struct error_stats s = error_stats_of(error, 1);
    assert_true(s.mean == 0.25 && s.p99 == 0.25 && s.max == 0.25);
}

static void test_failures(void **state)
{
    double error[5] = {(double)NAN, 3, (double)INFINITY, 1, -(double)INFINITY};
    (void)state;
    const struct error_stats s = error_stats_of(error, 5);
    assert_int_equal(s.failures, 3);
    assert_true(s.mean == 2 && s.p99 == 3 && s.max == 3);
}

static void test_nothing_left(void **state)
{
    double error[2] = {(double)NAN, (double)NAN};
    (void)state;
    const struct error_stats s = error_stats_of(error, 2), none = error_stats_of(error, 0);
    assert_int_equal(s.failures, 2);
    assert_true(isinf(s.mean) && isinf(s.p99) && isinf(s.max));
    assert_int_equal(none.failures, 0);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_known), cmocka_unit_test(test_one),
                                       cmocka_unit_test(test_failures), cmocka_unit_test(test_nothing_left)};
    return cmocka_run_group_tests_name("error_stats", tests, NULL, NULL);
}
