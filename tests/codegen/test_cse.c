/* Common subexpressions: pairs of factors and of terms, and multiples. */
#include "../../codegen/graph/rewrite.h"
#include "../../codegen/passes/cse.h"
#include "../support/graph_text.h"

static struct dag *share(const struct dag *g)
{
    struct dag *made = dag_copy(g);
    share_pairs(made);
    return made;
}

static struct dag *share_factors_multiples(const struct dag *g)
{
    struct dag *made = dag_copy(g);
    share_multiples(made);
    return made;
}

static void common_products_are_shared(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"genome g\nr = * * a b c\nq = * * a b d", "t1 = a*b; r = t1*c; q = t1*d", 3, 0, 0},
        {"genome g\nr = * * a b c\nq = * a b", "t1 = a*b; r = t1*c; q = t1", 2, 0, 0},
        /* of three that contain a b, all but the first cost one multiplication */
        {"genome g\nr = + * * a b c * * a b d\nq = * * a b x", "t1 = a*b; r = t1*c + t1*d; q = t1*x", 4, 1, 0},
        /* a power is a pair of equal factors */
        {"genome g\nr = * x x\nq = * * x x y", "t1 = x^2; r = t1; q = t1*y", 2, 0, 0},
        {"* * x x * x x", "(x^2)^2", 2, 0, 0},
        {"* * * x x * x x * * x x * x x", "((x^2)^2)^2", 3, 0, 0},
        {"* * x y * x y", "(x*y)^2", 2, 0, 0},
        {"genome g\nr = * a b\nq = * a c", NULL, 0, 0, 0},
        {"* a * b c", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(share, row);
}

static void common_sums_are_shared(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"genome g\nr = + + a b c\nq = + + a b d", "t1 = a + b; r = t1 + c; q = t1 + d", 0, 3, 0},
        {"genome g\nr = sqrt + + a b c\nq = sqrt + - c a d", NULL, 0, 0, 0},
        /* up to a common ratio: a + 2 b and 3 a + 6 b */
        {"genome g\nr = + + a * 2 b c\nq = + + * 3 a * 6 b d", "t1 = a + 2*b; r = t1 + c; q = 3*(t1 + (1.0 / 3.0)*d)",
         3, 3, 0},
        /* up to the sign */
        {"genome g\nr = + - a b c\nq = + - b a d", "t1 = a - b; r = t1 + c; q = -(t1 - d)", 0, 3, 0},
        {"genome g\nr = + a b\nq = + + a b c", "t1 = a + b; r = t1; q = t1 + c", 0, 2, 0},
        /* two pairs: the four points of a mixed derivative and a mean */
        {"genome g\nr = + + a b + c d\nq = - + a b + c d", "t1 = a + b; t2 = c + d; r = t1 + t2; q = t1 - t2", 0, 4, 0},
        {"genome g\nr = + a b\nq = - a b", NULL, 0, 0, 0},
        {"genome g\nr = + a b\nq = + a c", NULL, 0, 0, 0},
        {"+ + a b c", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(share, row);
}

/* 2 x y and 2 x z: x becomes a sum of one term, with its own scale, because it is a factor twice. */
static void common_multiples_are_shared(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        {"+ * * 2 x y * * 2 x z", "t1 = x; r = 2*(t1*y + t1*z)", 3, 1, 0},
        {"genome g\nr = * x y\nq = * x z", "t1 = x; r = t1*y; q = t1*z", 2, 0, 0},
        {"genome g\nr = * x + y 1\nq = * a + y 1", NULL, 0, 0, 0},
        {"* x y", NULL, 0, 0, 0},
        {"+ * x y * a b", NULL, 0, 0, 0},
    };
    CHECK_GRAPHS(share_factors_multiples, row);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(common_products_are_shared),
        cmocka_unit_test(common_sums_are_shared),
        cmocka_unit_test(common_multiples_are_shared),
    };
    return cmocka_run_group_tests_name("cse", tests, NULL, NULL);
}
