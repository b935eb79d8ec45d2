/* Bounds of rounding errors on the hull of a program's values: none is below an error, and they are near the worst ones. */
#include "../../codegen/bound/rounding_bound.h"
#include "../support/genome_text.h"
#include "../support/rounding_subject.h"

#include <math.h>

/* A program of one output. */
struct tested {
    struct genome_file *file;
    struct subject subject;
    struct hull *hull;
    double bound; /* on the hull */
};

static struct tested tested_new(const char *ranges, const char *code, const struct arithmetic *a, long points)
{
    char text[500];
    snprintf(text, sizeof text, "footpoint-genome 1\n%sgenome g\nr = 0\nend\n", ranges);
    struct tested t = {.file = parse(text)};
    t.subject = subject_new(text, read_program(t.file, 0, code));
    t.subject.region->known->arithmetic = *a;
    t.hull = hull_new(t.subject.region, t.subject.program, points, 1);
    double *error = new_array(t.subject.program->ops, sizeof *error);
    bound_errors_on_hull(t.hull, error);
    t.bound = error[t.subject.program->output[0]];
    free(error);
    return t;
}

static void tested_free(struct tested *t)
{
    hull_free(t->hull);
    subject_free(&t->subject);
    genome_file_free(t->file);
}

/* At points of the hull, with products contracted or not. */
static double worst_on_hull(struct tested *t)
{
    double worst;
    t->subject.hull = t->hull;
    worst_errors(&t->subject, &worst);
    print_message("%zu parts: %g, worst error %g\n", t->hull->parts, t->bound, worst);
    assert_true(t->bound >= worst);
    return worst;
}

/* Divisors have a bound on the hull, too, and none is off by more at its points. */
static void check_divisors(struct tested *t)
{
    struct program *p = t->subject.program;
    const int output = p->output[0];
    double *error = new_array(p->ops, sizeof *error), worst;
    bound_errors_on_hull(t->hull, error);
    t->subject.hull = t->hull;
    for (size_t i = 0; i < p->ops; i++) {
        if (p->op[i].kind != OP_DIV)
            continue;
        p->output[0] = p->op[i].b;
        worst_errors(&t->subject, &worst);
        assert_true(error[p->op[i].b] >= worst && error[p->op[i].b] < INFINITY);
    }
    p->output[0] = output;
    free(error);
}

/* The root x of x x + p x = q by Newton's steps from q / (p + 1): on the hull of the values at points neither many steps nor
 * a divisor that is kept from 0 by a maximum make bounds large. */
static void test_steps(void **state)
{
    (void)state;
    enum { STEPS = 6 };
    char code[2000] = "const double t1 = in_q / (in_p + 1.0);\n";
    for (int i = 1; i <= STEPS; i++) {
        const size_t n = strlen(code);
        snprintf(code + n, sizeof code - n,
                 "const double u%d = in_p + 2.0 * t%d;\nconst double v%d = (u%d > 0.1 ? u%d : 0.1);\n"
                 "const double %s%d = (in_q + t%d * t%d) / v%d;\n",
                 i, i, i, i, i, i < STEPS ? "t" : "w", i + 1, i, i, i);
    }
    snprintf(code + strlen(code), sizeof code - strlen(code), "*out_r = w%d;\n", STEPS + 1);
    struct tested t = tested_new("input p q\nrange p 0 3\nrange q 0.1 5\n", code, &arithmetic_double, 2000);
    assert_true(t.bound < 30 * worst_on_hull(&t));
    check_divisors(&t);
    tested_free(&t);
}

/* The same steps, each kept within [-10, 10], where there may be no root: no one set of limits holds for points where they end
 * and where they are thrown about.  Most points drawn anew belong to one of the parts. */
static void test_parts(void **state)
{
    (void)state;
    enum { STEPS = 5, DRAWN = 2000 };
    char code[2000] = "const double t1 = in_q / (in_p + 1.0);\n";
    for (int i = 1; i <= STEPS; i++) {
        const size_t n = strlen(code);
        snprintf(code + n, sizeof code - n,
                 "const double u%d = in_p + 2.0 * t%d;\nconst double v%d = (u%d > 0.001 ? u%d : 0.001);\n"
                 "const double w%d = (in_q + t%d * t%d) / v%d;\nconst double x%d = (w%d > -10.0 ? w%d : -10.0);\n"
                 "const double t%d = (x%d < 10.0 ? x%d : 10.0);\n",
                 i, i, i, i, i, i, i, i, i, i, i, i, i + 1, i, i);
    }
    snprintf(code + strlen(code), sizeof code - strlen(code), "*out_r = t%d * in_q;\n", STEPS + 1);
    struct tested t = tested_new("input p q\nrange p 0 3\nrange q -1 5\n", code, &arithmetic_double, 4000);
    uint64_t seed = 7;
    long held = 0, tries = DRAWN;
    for (int i = 0; i < DRAWN && region_draw(t.subject.region, &seed, 0, true, &tries, t.subject.at); i++)
        held += hull_holds(t.hull, t.subject.at);
    print_message("%ld of %d points\n", held, DRAWN);
    assert_true(t.hull->parts > 1 && held > 0.95 * DRAWN);
    assert_true(t.bound < 100 * worst_on_hull(&t));
    tested_free(&t);
}

/* In float, 1e-42 is off by more than a unit of rounding. */
static void test_small_constant(void **state)
{
    (void)state;
    static const char code[] = "const double t1 = 0.000000000000000000000000000000000000000001 * in_x * "
                               "1000000000000.0;\n*out_r = in_y / t1;\n";
    struct tested t = tested_new("input x y\nrange x 1e30 2e30\nrange y 1 2\n", code, &arithmetic_single, 100);
    const float x = 1e30F, computed = 2 / (1e-42F * x * 1e12F);
    const double error = fabs(computed - 2 / (1e-42 * (double)x * 1e12));
    print_message("small constant: %g, error %g\n", t.bound, error);
    assert_true(t.bound >= error && t.bound < 100 * error);
    tested_free(&t);
}

/* The same product in two sums, the small difference of which is divided by: contracted in one of them alone, its rounding does
 * not cancel; as a factor it is never contracted, and does. */
static void test_contracted_in_one(void **state)
{
    (void)state;
    static const char ranges[] = "input x y c\nrange x 1 2\nrange y 1 2\nrange c 0.00001 0.00002\n";
    struct tested sums = tested_new(ranges,
                                    "const double t1 = in_x * in_y;\nconst double t2 = t1 + in_c;\n"
                                    "const double t3 = t1 - in_c;\n*out_r = in_c / (t2 - t3);\n",
                                    &arithmetic_double, 1000);
    struct tested factors =
        tested_new(ranges, "const double t1 = in_x * in_y;\n*out_r = (t1 * in_c) / (t1 * (in_c + 1.0));\n",
                   &arithmetic_double, 1000);
    assert_true(sums.bound < 30 * worst_on_hull(&sums) && sums.bound > 1e-12);
    assert_true(factors.bound < 30 * worst_on_hull(&factors));
    tested_free(&sums);
    tested_free(&factors);
}

/* Where a clamp chooses 0.5, t is 1 without an error, however large the result's derivative by it; and what is off by the same,
 * as 0.3 chosen twice, cancels. */
static void test_chosen_numbers(void **state)
{
    (void)state;
    static const char ranges[] = "input x y\nrange x 0.6 2\nrange y 0.6 2\n";
    struct tested exact =
        tested_new(ranges,
                   "const double t1 = (in_x < 0.5 ? in_x : 0.5) + 0.5;\n*out_r = 1000000.0 * (t1 * in_y - "
                   "in_y) + in_x;\n",
                   &arithmetic_double, 1000);
    struct tested same =
        tested_new(ranges,
                   "const double t1 = (in_x < 0.3 ? in_x : 0.3);\nconst double t2 = (in_y < 0.3 ? in_y : "
                   "0.3);\n*out_r = 1000000.0 * (t1 - t2) + in_x;\n",
                   &arithmetic_double, 1000);
    assert_true(worst_on_hull(&exact) < 1e-9 && worst_on_hull(&same) < 1e-15 && same.bound < 1e-15);
    tested_free(&exact);
    tested_free(&same);
}

/* Products that underflow at all points, or may overflow: bounds are of what is exact. */
static void test_ends_of_range(void **state)
{
    (void)state;
    struct tested under = tested_new("input x y c\nrange x 1e-200 2e-200\nrange y 1e-200 2e-200\nrange c 1e300 2e300\n",
                                     "const double t1 = in_x * in_y;\n*out_r = t1 * in_c;\n", &arithmetic_double, 200);
    struct tested subnormal =
        tested_new("input x y c\nrange x 1e-162 1.1e-162\nrange y 3e-161 3.1e-161\nrange c 1e300 2e300\n",
                   "const double t1 = in_x * in_y;\n*out_r = t1 * in_c;\n", &arithmetic_double, 200);
    struct tested over =
        tested_new("input x y\nrange x 1.3e21 3e21\nrange y 1e21 4e21\n",
                   "const double t1 = in_x * 288230376151711744.0;\n*out_r = in_y / t1;\n", &arithmetic_single, 200);
    assert_true(under.bound < 1e-20 && subnormal.bound < 1e-20 && over.bound > 7e-18);
    assert_true(worst_on_hull(&under) > 0 && worst_on_hull(&subnormal) > 0);
    tested_free(&under);
    tested_free(&subnormal);
    tested_free(&over);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_steps),          cmocka_unit_test(test_parts),
        cmocka_unit_test(test_small_constant), cmocka_unit_test(test_contracted_in_one),
        cmocka_unit_test(test_chosen_numbers), cmocka_unit_test(test_ends_of_range),
    };
    return cmocka_run_group_tests_name("hulls", tests, NULL, NULL);
}
