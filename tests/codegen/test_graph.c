/* Genome to graph: every value once in any form; exact rationals, and their text. */
#include "../../codegen/graph/constant_text.h"
#include "../../codegen/graph/from_genome.h"
#include "../../codegen/graph/rewrite.h"
#include "../support/graph_text.h"

static void equal_values_are_one_node(void **state)
{
    (void)state;
    static const struct graph_row row[] = {
        /* sums and products are flat, terms and factors collected */
        {"+ + x y + * 2 z x", "2*(x + 0.5*y + z)", 2, 2, 0},
        {"* * x y * x x", "x^3*y", 3, 0, 0},
        {"- + x y y", "x", 0, 0, 0},
        {"- x x", "0", 0, 0, 0},
        {"* 0 / x y", "0", 0, 0, 0},
        {"- - - x y z a", "-(a - x + y + z)", 0, 3, 0},
        /* constants fold exactly, wherever they are */
        {"* 0.5 * x 4", "2*x", 1, 0, 0},
        {"+ 1 + x 2.5", "3.5 + x", 0, 1, 0},
        {"/ x 3", "(1.0 / 3.0)*x", 1, 0, 0},
        {"+ / 1 3 / 1 6", "0.5", 0, 0, 0},
        {"sqrt 2.25", "1.5", 0, 0, 0},
        {"let v = + 2 x\ngenome g\nr = abs - x v", "2", 0, 0, 0},
        {"let v = + 2 x\ngenome g\nr = % 2 - x v", "-1", 0, 0, 0},
        {"let v = + 2 x\ngenome g\nr = min y max - v x 3", "min(y,3)", 0, 0, 0},
        {"abs neg * 2 x", "2*abs(x)", 1, 0, 0},
        {"min 3 neg 4", "-4", 0, 0, 0},
        /* the leading coefficient of a sum is 1, so that multiples meet */
        {"* + x 2 + * 2 x 4", "2*(2 + x)^2", 2, 1, 0},
        /* values are equal by value, not by form: (x - y)(x + y) and x^2 - y^2 */
        {"- * - x y + x y - * x x * y y", "0", 0, 0, 0},
        {"/ - * x x * y y * - x y + x y", "1", 0, 0, 0},
        {"genome g\nr = + x y\nq = + y x", "t1 = x + y; r = t1; q = t1", 0, 1, 0},
        {"* + x y + y x", "(x + y)^2", 1, 1, 0},
        /* quotients: one inverse of all divisors, common factors cancel */
        {"/ / x y z", "x/(y*z)", 1, 0, 1},
        {"* x / y x", "y", 0, 0, 0},
        {"/ 1 / 1 x", "x", 0, 0, 0},
        {"/ x * 2 x", "0.5", 0, 0, 0},
        /* a protected quotient is 1 only by definition; it is not cancelled */
        {"% x x", "1", 0, 0, 0},
        {"% x 0", "1", 0, 0, 0},
        {"% x 4", "0.25*x", 1, 0, 0},
        {"% * x y x", "pdiv(x*y,x)", 1, 0, 0},
        /* other functions of equal values are equal */
        {"- max + x y z max z + y x", "0", 0, 0, 0},
        {"+ sqrt x sqrt x", "2*sqrt(x)", 1, 0, 0},
    };
    CHECK_GRAPHS(NULL, row);
}

static void removed_divisions_are_counted(void **state)
{
    (void)state;
    static const struct {
        const char *genome;
        size_t divisions, roots;
    } row[] = {
        {"/ x y", 0, 0},
        {"/ x x", 1, 0},
        {"* y / x y", 1, 0},
        {"+ / x x / y y", 2, 0},
        {"% x x", 0, 0},
        /* divisors of divisors */
        {"/ 1 / 1 x", 1, 0},
        {"/ x / 1 y", 1, 0},
        {"/ x / y z", 1, 0},
        {"/ x / / y z x", 2, 0},
        {"/ / x y / z y", 1, 0},
        {"/ / 1 y / x / 1 y", 0, 0},
        {"let v = / 1 y\ngenome g\nr = / x v", 1, 0},
        {"let v = / x y\ngenome g\nr = / z v\nq = v", 0, 0},
        {"let v = + 1 / 1 y\ngenome g\nr = / v v", 2, 0},
        /* poles inside of other functions */
        {"- min y / y x min y / y x", 1, 0},
        {"* - y y min y / y x", 1, 0},
        {"* 0 max y / y * x z", 2, 0},
        {"- abs / y x abs / y x", 1, 0},
        {"let m = / y x\ngenome g\nr = % m m", 1, 0},
        {"% / y x 0", 1, 0},
        {"let m = / y x\ngenome g\nr = % m m\nq = m", 0, 0},
        {"% / y x / y x", 1, 0},
        {"min / y x / y x", 0, 0},
        {"/ x min y / y x", 0, 0},
        {"* 0 / y x", 1, 0},
        {"- + / 1 x / 1 y / 1 x", 1, 0},
        /* roots */
        {"- sqrt x sqrt x", 0, 1},
        {"* 0 sqrt - x 5", 0, 1},
        {"- sqrt x sqrt y", 0, 0},
        {"- * 2 sqrt x sqrt x", 0, 0},
        {"+ - sqrt x sqrt x sqrt x", 0, 0},
        {"/ sqrt x sqrt x", 1, 1},
        /* the divisor is another multiple of the same sum, if z is made before y */
        {"genome g\nr = z\nq = + * 0 / x + * 2 y z / a + * 2 y z", 0, 0},
        {"genome g\nr = z\nq = + * 0 sqrt + * 2 y z sqrt + * 2 y z", 0, 0},
        {"genome g\nr = z\nq = + * 0 sqrt + * 2 y z sqrt - * -2 y z", 0, 1},
        {"- sqrt / y x sqrt / y x", 1, 1},
        {"- max x sqrt y max x sqrt y", 0, 1},
        {"+ - abs x abs x min x x", 0, 0},
    };
    size_t wrong = 0;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f);
        struct dag *again = walk_again(g);
        for (int k = 0; k < 2; k++) {
            const struct removed removed = dag_removed(k ? again : g);
            if (removed.divisions == row[i].divisions && removed.roots == row[i].roots)
                continue;
            print_message("%s: %zu divisions and %zu roots cancelled, not %zu and %zu\n", row[i].genome,
                          removed.divisions, removed.roots, row[i].divisions, row[i].roots);
            wrong++;
        }
        dag_free(again);
        dag_free(g);
        genome_file_free(f);
    }
    assert_int_equal(wrong, 0);
}

static void zero_divisors_are_refused(void **state)
{
    (void)state;
    static const char *const genome[] = {"/ x 0", "/ x - y y", "sqrt neg 4", "/ 1 - * - x y + x y - * x x * y y"};
    for (size_t i = 0; i < sizeof genome / sizeof *genome; i++) {
        struct diag d = {0};
        struct genome_file *f = row_file(genome[i]);
        assert_null(simplify_genome(f, &f->genome[0], KEEP_ALL, &d));
        assert_true(strstr(d.text, "always 0") || strstr(d.text, "always negative"));
        genome_file_free(f);
    }
}

static void degrees_are_known(void **state)
{
    (void)state;
    static const struct {
        const char *genome;
        int degree;
    } row[] = {{"+ x 1", 1},         {"* x * y z", 3}, {"/ 1 * x x", 2},
               {"/ * x x + y 1", 2}, {"/ * x x y", 1}, {"* + x * y y + 1 z", 3}};
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct genome_file *f = row_file(row[i].genome);
        struct dag *g = row_graph(f);
        if (dag_degree(g) != row[i].degree)
            fail_msg("%s: degree %d, not %d", row[i].genome, dag_degree(g), row[i].degree);
        dag_free(g);
        genome_file_free(f);
    }
}

static void rationals_are_exact(void **state)
{
    (void)state;
    struct dag *g = dag_new(1); /* makes the table */
    const rational third = rational_inv(rational_from_si(3)), sixth = rational_inv(rational_from_si(-6));
    assert_int_equal(rational_add(third, rational_mul(TWO, sixth)), ZERO);
    assert_int_equal(rational_mul(third, rational_from_si(3)), ONE);
    assert_int_equal(rational_neg(sixth), rational_mul(third, rational_inv(TWO)));
    assert_int_equal(rational_abs(sixth), rational_inv(rational_from_si(6)));
    assert_int_equal(rational_pow(MINUS_TWO, 3), MINUS_EIGHT);
    assert_int_equal(rational_pow(TWO, -2), rational_inv(FOUR));
    assert_int_equal(rational_pow(third, 0), ONE);
    assert_int_equal(rational_sign(sixth), -1);
    assert_int_equal(rational_sign(ZERO), 0);
    /* a residue equals the quotient's: 3 (1/3) = 1 modulo the prime */
    for (int k = 0; k < PRIMES; k++) {
        nmod_t prime;
        nmod_init(&prime, rational_prime[k]);
        assert_int_equal(nmod_mul(3, rational_mod(third, k), prime), 1);
    }
    assert_false(rational_take_overflow());
    rational big = rational_from_si(3);
    for (int i = 0; i < 30; i++)
        big = rational_mul(big, big);
    assert_true(rational_take_overflow());
    assert_false(rational_take_overflow());
    dag_free(g);
}

static void constants_have_exact_text(void **state)
{
    (void)state;
    static const struct {
        long num;
        ulong den;
        const char *text;
    } row[] = {{0, 1, "0.0"},        {7, 1, "7.0"},    {-1, 2, "-0.5"},       {1, 8, "0.125"},
               {-7, 5, "-1.4"},      {1, 100, "0.01"}, {1, 3, "(1.0 / 3.0)"}, {-22, 7, "(-22.0 / 7.0)"},
               {1, 6, "(1.0 / 6.0)"}};
    fmpq_t q;
    fmpq_init(q);
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        fmpq_set_si(q, row[i].num, row[i].den);
        char *text = constant_text(q);
        assert_string_equal(text, row[i].text);
        free(text);
    }
    fmpq_clear(q);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(equal_values_are_one_node), cmocka_unit_test(removed_divisions_are_counted),
        cmocka_unit_test(zero_divisors_are_refused), cmocka_unit_test(degrees_are_known),
        cmocka_unit_test(rationals_are_exact),       cmocka_unit_test(constants_have_exact_text),
    };
    return cmocka_run_group_tests_name("graph", tests, NULL, NULL);
}
