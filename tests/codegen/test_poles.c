/* Zeros of denominators: cases with a known answer, and random cases whose answer is known by construction. */
#include "../../codegen/program/evaluate.h"
#include "../../codegen/region/region.h"
#include "../../codegen/rounding/evidence.h"
#include "../support/long_cases.h"

#include <float.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { ROOM = 4000, POINTS = 2000, BOXES = 6000, RANDOM_CASES = 6, RANDOM_CASES_LONG = 60 };

/* Code for in_a .. in_h and *out_r; requires and ranges as in a genome file. */
struct trial {
    const char *ranges, *code;
    enum pole_verdict verdict; /* of the last denominator */
    double least;              /* POLE_FREE: the least |D|, if it is known */
};

struct subject {
    struct genome_file *file;
    struct program *program;
    struct evidence *evidence;
};

static struct subject examine(const char *ranges, const char *code)
{
    static const struct evidence_options options = {.boxes = BOXES, .seed = 1, .poles = true};
    char text[ROOM];
    struct diag d = {0};
    struct subject s = {0};
    snprintf(text, sizeof text, "footpoint-genome 1\ninput a b c d e f g h\n%s\ngenome t\nr = 0\nend\n", ranges);
    s.file = genome_parse("trial", text, strlen(text), &d);
    s.program = s.file ? program_read(s.file, &s.file->genome[0], code, &d) : NULL;
    if (!s.program)
        fail_msg("%s", d.text);
    s.evidence = evidence_new(s.file, &s.file->genome[0], s.program, &options);
    return s;
}

static void subject_free(struct subject *s)
{
    evidence_free(s->evidence);
    program_free(s->program);
    genome_file_free(s->file);
}

static const char *verdict_name(enum pole_verdict verdict)
{
    return verdict == POLE_FREE       ? "free"
           : verdict == POLE_EXISTS   ? "zero"
           : verdict == POLE_REQUIRED ? "required"
                                      : "undecided";
}

/* At random points of the region no denominator is nearer to 0 than was proved. */
static void check_points(const struct subject *s)
{
    const struct evidence *e = s->evidence;
    const struct program *p = s->program;
    struct region *r = region_new(s->file, p, true);
    double *input = new_array(p->inputs, sizeof *input), *at = new_array(r->known->variables, sizeof *at),
           *value = new_array(p->ops, sizeof *value);
    uint64_t seed = 7;
    long tries = 20 * POINTS;
    point_constants(p, value);
    for (int i = 0; i < POINTS && region_draw(r, &seed, i % 2 ? 3 : 0, &tries, at); i++) {
        region_inputs(r, at, input);
        point_double(p, input, NULL, value);
        for (size_t k = 0; k < e->denominators; k++) {
            const struct denominator *d = &e->denominator[k];
            if (d->verdict == POLE_FREE)
                assert_true(fabs(value[d->op]) >= d->least * (1 - 1e-12) - (d->error < INFINITY ? d->error : 0));
        }
    }
    free(input);
    free(at);
    free(value);
    region_free(r);
}

/* A witness lies in the ranges, and the denominator nearly vanishes there. */
static void check_witness(const struct subject *s, const struct denominator *d)
{
    const struct program *p = s->program;
    double *value = new_array(p->ops, sizeof *value);
    assert_non_null(d->witness);
    for (size_t i = 0; i < p->inputs; i++)
        if (s->file->range[i].given) {
            assert_true(d->witness[i] >= s->file->constant[s->file->range[i].lo].value);
            assert_true(d->witness[i] <= s->file->constant[s->file->range[i].hi].value);
        }
    point_constants(p, value);
    point_double(p, d->witness, NULL, value);
    assert_true(fabs(value[d->op]) < 1e-9);
    free(value);
}

static void check(const struct trial *t)
{
    struct subject s = examine(t->ranges, t->code);
    assert_true(s.evidence->denominators > 0);
    const struct denominator *d = &s.evidence->denominator[s.evidence->denominators - 1];
    if (d->verdict != t->verdict)
        fail_msg("%s | %s: %s, not %s", t->ranges, t->code, verdict_name(d->verdict), verdict_name(t->verdict));
    if (d->verdict == POLE_FREE) {
        assert_true(d->least > 0);
        if (t->least > 0 && !(d->least <= t->least && d->least >= 0.9 * t->least))
            fail_msg("%s | %s: least %.17g, not %g", t->ranges, t->code, d->least, t->least);
        assert_null(d->witness);
    }
    if (d->verdict == POLE_EXISTS)
        check_witness(&s, d);
    check_points(&s);
    subject_free(&s);
}

#define UNIT_2 "range a -1 1\nrange b -1 1"
#define UNIT_8 UNIT_2 "\nrange c -1 1\nrange d -1 1\nrange e -1 1\nrange f -1 1\nrange g -1 1\nrange h -1 1"
#define SHIFTED_8                                                                                                      \
    "range a 1 2\nrange b 1 2\nrange c 1 2\nrange d 1 2\nrange e 1 2\nrange f 1 2\nrange g 1 2\nrange h 1 2"

static void zeros_of_polynomials_are_decided(void **state)
{
    (void)state;
    static const struct trial trials[] = {
        {UNIT_2, "*out_r = 1.0 / (1.0 + in_a * in_a);", POLE_FREE, 1},
        {"range a 1 2", "*out_r = 1.0 / in_a;", POLE_FREE, 1},
        {"range a -1 1", "*out_r = 1.0 / in_a;", POLE_EXISTS, 0},
        {"range a 0 1", "*out_r = 1.0 / in_a;", POLE_EXISTS, 0},
        {"range a 0.1 1", "*out_r = 1.0 / (in_a - 0.1);", POLE_EXISTS, 0}, /* an end that is not a double */
        {"range a 0.3 1", "*out_r = 1.0 / (in_a - (1.0 / 3.0));", POLE_EXISTS, 0},
        {"range a 0.34 1", "*out_r = 1.0 / (in_a - (1.0 / 3.0));", POLE_FREE, 0.34 - 1.0 / 3},
        {"range a 1 2", "*out_r = 1.0 / (in_a * in_a - 2.0);", POLE_EXISTS, 0}, /* an irrational zero */
        {"range a 1.5 2", "*out_r = 1.0 / (in_a * in_a - 2.0);", POLE_FREE, 0.25},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a + in_b * in_b - 1.0);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a + in_b * in_b - 3.0);", POLE_FREE, 1},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a + in_b * in_b);", POLE_EXISTS, 0}, /* a single point, even order */
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a - 2.0 * in_a * in_b + in_b * in_b + 0.000001);", POLE_FREE, 1e-6},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a - 2.0 * in_a * in_b + in_b * in_b);", POLE_EXISTS, 0},
        {"range a 0 1\nrange b 0.5 2", "*out_r = 1.0 / ((in_a - in_b) * (in_a - in_b));", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_b + 1.0);", POLE_EXISTS, 0}, /* at two corners */
        {UNIT_2, "*out_r = 1.0 / (in_a * in_b + 1.001);", POLE_FREE, 0.001},
        {UNIT_2, "*out_r = 1.0 / (100.0 * (in_b - in_a * in_a) * (in_b - in_a * in_a) + (1.0 - in_a) * (1.0 - in_a));",
         POLE_EXISTS, 0},
        {UNIT_2,
         "const double t1 = in_b - in_a * in_a;\n*out_r = 1.0 / (100.0 * t1 * t1 + (1.0 - in_a) * (1.0 - in_a) + "
         "0.01);",
         POLE_FREE, 0.01},
        {"range a 0 1", "*out_r = 1.0 / (in_a - in_a * in_a + 0.01);", POLE_FREE, 0.01}, /* dependency */
        {"range a 0 1", "*out_r = 1.0 / (in_a - in_a * in_a - 0.26);", POLE_FREE, 0.01},
        {"range a 0 1", "*out_r = 1.0 / (in_a - in_a * in_a - 0.25);", POLE_EXISTS, 0}, /* touched at 1/2 */
        {"range a -10 10", "*out_r = 1.0 / (((in_a - 6.0) * in_a + 13.0) * in_a * in_a + 1.0);", POLE_FREE, 0},
        {"range a -3 3", "*out_r = 1.0 / (((in_a * in_a - 6.0) * in_a * in_a + 9.0) * in_a * in_a - 4.0);", POLE_EXISTS,
         0},
        {UNIT_8, "*out_r = 1.0 / (in_a * in_b + in_c * in_d + in_e * in_f + in_g * in_h + 4.1);", POLE_FREE, 0.1},
        {UNIT_8, "*out_r = 1.0 / (in_a * in_b + in_c * in_d + in_e * in_f + in_g * in_h + 4.0);", POLE_EXISTS, 0},
        {UNIT_8, "*out_r = 1.0 / (in_a * in_b + in_c * in_d + in_e * in_f + in_g * in_h + 3.9);", POLE_EXISTS, 0},
        {UNIT_8,
         "*out_r = 1.0 / (in_a * in_a + in_b * in_b + in_c * in_c + in_d * in_d + in_e * in_e + in_f * in_f + "
         "in_g * in_g + in_h * in_h + 0.1);",
         POLE_FREE, 0.1},
        {SHIFTED_8, "*out_r = 1.0 / (in_a * in_b * in_c * in_d * in_e * in_f * in_g * in_h - 0.5);", POLE_FREE, 0.5},
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++)
        check(&trials[i]);
}

/* |u|^2 |v|^2 - (u.v)^2 of u = (a,b,c), v = (d,e,f). */
#define GRAM                                                                                                           \
    "const double t1 = in_a * in_a + in_b * in_b + in_c * in_c;\n"                                                     \
    "const double t2 = in_d * in_d + in_e * in_e + in_f * in_f;\n"                                                     \
    "const double t3 = in_a * in_d + in_b * in_e + in_c * in_f;\n"

static void poles_of_functions_are_decided(void **state)
{
    (void)state;
    static const struct trial trials[] = {
        {"range a 0.9 1.1\nrange b -0.2 0.2\nrange c -0.1 0.1\nrange d -0.2 0.2\nrange e 0.9 1.1\nrange f -0.1 0.1",
         GRAM "*out_r = 1.0 / (t1 * t2 - t3 * t3);", POLE_FREE, 0},
        {"range a 0.5 1\nrange b -0.5 1\nrange c -0.1 0.1\nrange d 0.5 1\nrange e 0.5 1\nrange f -0.1 0.1",
         GRAM "*out_r = 1.0 / (t1 * t2 - t3 * t3);", POLE_EXISTS, 0},
        /* denominators in denominators */
        {"range a 1 2\nrange b 1 2", "*out_r = 1.0 / (in_a + 1.0 / in_b);", POLE_FREE, 1.5},
        {"range a 1 2\nrange b 1 2", "*out_r = 1.0 / (in_a - 1.0 / in_b);", POLE_EXISTS, 0},
        {"range a 1 2\nrange b 1 2", "*out_r = 1.0 / (in_a - 0.9 / in_b);", POLE_FREE, 0.1},
        {"range a 1 2\nrange b -1 1", "*out_r = 1.0 / (in_a / in_b);", POLE_UNDECIDED,
         0}, /* 1/b has no zero, but a pole */
        {"range a 1 2\nrange b 1 3", "const double t1 = in_a / (in_a + in_b);\n*out_r = 1.0 / (t1 - 0.7);", POLE_FREE,
         0},
        {"range a 1 2\nrange b 1 3", "const double t1 = in_a / (in_a + in_b);\n*out_r = 1.0 / (t1 - 0.6);", POLE_EXISTS,
         0},
        /* a change of sign through a pole is not a zero */
        {"range a -1 1", "const double t1 = 1.0 / (in_a * 3.0 - 0.5);\n*out_r = 1.0 / t1;", POLE_UNDECIDED, 0},
        /* protected quotients are not continuous at their protected points */
        {"range a -1 1", "*out_r = 1.0 / (in_a == 0.0 ? 1.0 : 2.0 / in_a);", POLE_UNDECIDED, 0},
        {"range a 1 2", "*out_r = 1.0 / (in_a == 0.0 ? 1.0 : 2.0 / in_a);", POLE_FREE, 1},
        {UNIT_2, "*out_r = 1.0 / ((in_a < in_b ? in_a : in_b) + 1.5);", POLE_FREE, 0.5},
        {UNIT_2, "*out_r = 1.0 / ((in_a < in_b ? in_a : in_b) + 0.5);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / ((in_a > in_b ? in_a : in_b) + 1.0);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / ((in_a > in_b ? in_a : in_b) + 1.1);", POLE_FREE, 0.1},
        {UNIT_2, "*out_r = 1.0 / (fabs(in_a - in_b) + 0.1);", POLE_FREE, 0.1},
        {UNIT_2, "*out_r = 1.0 / (fabs(in_a - in_b) - 0.1);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / sqrt(in_a * in_a + in_b * in_b + 0.25);", POLE_FREE, 0.5},
        {UNIT_2, "*out_r = 1.0 / sqrt(in_a * in_a + in_b * in_b);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / (sqrt(in_a * in_a + 1.0) - 1.2);", POLE_EXISTS, 0},
        {UNIT_2, "*out_r = 1.0 / (sqrt(in_a * in_a + 1.0) - 0.9);", POLE_FREE, 0.1},
        {"range a -1 1", "*out_r = 1.0 / (sqrt(in_a) + 1.0);", POLE_UNDECIDED, 0}, /* not a number for a < 0 */
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++)
        check(&trials[i]);
}

static void requires_exclude_zeros(void **state)
{
    (void)state;
    static const struct trial trials[] = {
        {UNIT_2 "\nrequire - a 0.5", "*out_r = 1.0 / in_a;", POLE_FREE, 0.5},
        {UNIT_2 "\nrequire - a b", "*out_r = 1.0 / (in_a - in_b);", POLE_REQUIRED, 0}, /* > 0, but not by any margin */
        /* if a and b are nearly equal, the quotient is too large; if they are equal, it does not exist */
        {UNIT_2 "\nrequire - 10 abs / 1 - a b", "*out_r = 1.0 / (in_a - in_b);", POLE_REQUIRED, 0},
        {UNIT_2 "\nrequire - 10 abs % 1 - a b", "*out_r = 1.0 / (in_a - in_b);", POLE_UNDECIDED, 0}, /* protected */
        {UNIT_2 "\nrequire - 10 abs / 1 - a b", "*out_r = 1.0 / (in_a + in_b);", POLE_EXISTS, 0},
        {UNIT_2 "\nrequire - - a b 0.1", "*out_r = 1.0 / (in_a - in_b);", POLE_FREE, 0.1},
        {UNIT_2 "\nrequire - - a b 0.1", "*out_r = 1.0 / (in_a + in_b);", POLE_EXISTS, 0},
        {UNIT_2 "\nrequire - + * a a * b b 0.25", "*out_r = 1.0 / (in_a * in_a + in_b * in_b - 0.2);", POLE_FREE, 0.05},
        {UNIT_2 "\nrequire - + * a a * b b 0.25", "*out_r = 1.0 / (in_a * in_a + in_b * in_b - 0.3);", POLE_EXISTS, 0},
        {UNIT_2 "\nrequire - + * a a * b b 0.25", "*out_r = 1.0 / (in_a * in_a * in_a + 1.001 + 0.0 * in_b);",
         POLE_FREE, 0.001},
        {UNIT_2 "\nrequire - 0.5 abs a\nrequire - 0.5 abs b", "*out_r = 1.0 / (in_a * in_b + 0.26);", POLE_FREE, 0.01},
        /* a require bounds a value of the program, in another form and scale */
        {UNIT_8 "\nlet s = + + + * a b * c d * e f * g h\nrequire - s 0.2",
         "const double t1 = -0.5 * (in_h * in_g + in_f * in_e + in_d * in_c + in_b * in_a);\n*out_r = 1.0 / t1;",
         POLE_FREE, 0.1},
        {UNIT_8 "\nlet s = + + + * a b * c d * e f * g h\nlet t = + 1 * s s\nrequire - s * 0.2 t",
         "const double t1 = in_h * in_g + in_f * in_e + in_d * in_c + in_b * in_a;\n*out_r = 1.0 / t1;", POLE_FREE, 0},
        {UNIT_2 "\nrequire - a 2", "*out_r = 1.0 / in_a;", POLE_FREE, 0}, /* the region is empty */
        /* several requires cut off parts of one side */
        {"range a -2 1\nrequire neg a\nrequire - -0.5 a", "*out_r = 1.0 / (in_a + 0.7601);", POLE_EXISTS, 0},
        {"range a -2 1\nrequire neg a\nrequire - -0.5 a", "*out_r = 1.0 / (in_a + 0.25);", POLE_FREE, 0.25},
        {"range a -1 2\nrequire a\nrequire - a 0.5\nrequire - a 0.6", "*out_r = 1.0 / (in_a - 0.9301);", POLE_EXISTS,
         0},
        /* an earlier require already implies a < -0.47 */
        {"range a -2 1\nrequire - -0.5 a\nrequire + a 1",
         "const double t1 = 1.0 / in_a;\n*out_r = 1.0 / (in_a + 0.9801 + 0.0 * t1);", POLE_EXISTS, 0},
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++)
        check(&trials[i]);
}

/* Without all ranges, a verdict must hold for all real numbers. */
static void without_ranges_all_numbers_count(void **state)
{
    (void)state;
    static const struct trial trials[] = {
        {"", "*out_r = 1.0 / (1.0 + in_a * in_a);", POLE_FREE, 1},
        {"", "*out_r = 1.0 / (in_a * in_a + in_b * in_b + 0.5);", POLE_FREE, 0.5},
        {"", "*out_r = 1.0 / (fabs(in_a) + sqrt(in_b * in_b + 4.0));", POLE_FREE, 2},
        {"", "*out_r = 1.0 / in_a;", POLE_UNDECIDED, 0},
        {"", "*out_r = 1.0 / (in_a * in_a);", POLE_UNDECIDED, 0},
        {"range b 1 2", "*out_r = 1.0 / (in_a * in_a + in_b);", POLE_FREE, 1},
        {"range b 1 2", "*out_r = 1.0 / (in_a + in_b);", POLE_UNDECIDED, 0},
    };
    for (size_t i = 0; i < sizeof trials / sizeof *trials; i++) {
        struct subject s = examine(trials[i].ranges, trials[i].code);
        assert_false(s.evidence->region);
        assert_true(s.evidence->error[0].bound == INFINITY);
        subject_free(&s);
        check(&trials[i]);
    }
}

/* A constant denominator does not count, a denominator that divides twice counts once, and names are those in the
 * text. */
static void denominators_are_counted_and_named(void **state)
{
    (void)state;
    struct subject s = examine("range a 1 2\nrange b 1 2",
                               "const double t1 = in_a + in_b;\n"
                               "*out_r = in_a / 3.0 + 1.0 / t1 + in_b / t1 + 2.0 / in_b + 1.0 / (in_a * in_b + 1.0);");
    static const char *const name[] = {"t1", "in_b", "in_a * in_b + 1.0"};
    assert_int_equal(s.evidence->denominators, 3);
    for (size_t i = 0; i < 3; i++)
        assert_string_equal(s.evidence->denominator[i].name, name[i]);
    assert_true(evidence_pole_free(s.evidence));
    subject_free(&s);
}

/* (a - p)^2 + (b - q)^2 + (c - s)^2 + m with p, q, s inside: free of zeros for m > 0, but not for m < 0. */
static void random_spheres_are_decided(void **state)
{
    (void)state;
    uint64_t seed = 3;
    const long cases = long_cases(RANDOM_CASES, RANDOM_CASES_LONG);
    for (int i = 0; i < cases; i++) {
        char code[400];
        double centre[3];
        for (int k = 0; k < 3; k++)
            centre[k] = (double)(random_next(&seed) % 1001) / 1000;
        const double margin = pow(10, -1 - (double)(random_next(&seed) % 4)) * (i % 2 ? -1 : 1);
        snprintf(code, sizeof code,
                 "const double t1 = in_a - %.3f;\nconst double t2 = in_b - %.3f;\nconst double t3 = in_c - %.3f;\n"
                 "*out_r = 1.0 / (t1 * t1 + t2 * t2 + t3 * t3 %c %.4f);",
                 centre[0], centre[1], centre[2], i % 2 ? '-' : '+', fabs(margin));
        const struct trial t = {"range a 0 1\nrange b 0 1\nrange c 0 1", code, i % 2 ? POLE_EXISTS : POLE_FREE,
                                i % 2 ? 0 : margin};
        check(&t);
    }
}

#define NEAR "range a 1 1.000000000001\nrange b 1 1.000000000002\nrequire - - * a a b "

/* Freedom from zeros concerns exact values. A divisor is safe if its rounding error is below its least value, or if
 * intervals of computed values exclude 0, and not otherwise. */
static void rounding_may_change_signs_of_divisors(void **state)
{
    (void)state;
    static const struct {
        const char *ranges, *code;
        bool safe, apart;
        int sign;
    } row[] = {
        {"range a 1 2", "*out_r = 1.0 / in_a;", true, true, 1},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_b - 1.001);", true, true, -1},
        {"", "*out_r = 1.0 / (1.0 + in_a * in_a);", true, true, 1}, /* no range, no bound */
        {"range b 1 2", "*out_r = in_a / (in_b + 3.0);", true, true, 1},
        {UNIT_2, "*out_r = 1.0 / (in_a * in_a - 2.0 * in_a * in_b + in_b * in_b + 0.000001);", true, false, 1},
        {NEAR "1e-17", "*out_r = 1.0 / (in_a * in_a - in_b);", false, false, 1},
        {NEAR "1e-17", "*out_r = 1.0 / (in_b - in_a * in_a);", false, false, -1},
        {NEAR "1e-14", "*out_r = 1.0 / (in_a * in_a - in_b);", true, false, 1},
        {"range b 1 2\nrange c 1 4\nrequire - - * b b c 0.01", "*out_r = in_a / (in_b * in_b - in_c);", false, false,
         1},
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct subject s = examine(row[i].ranges, row[i].code);
        const struct denominator *d = &s.evidence->denominator[0];
        if (d->verdict != POLE_FREE || denominator_is_safe(d) != row[i].safe || d->apart != row[i].apart ||
            d->sign != row[i].sign)
            fail_msg("%s | %s: %s, least %g, error %g, apart %d, sign %d", row[i].ranges, row[i].code,
                     verdict_name(d->verdict), d->least, d->error, d->apart, d->sign);
        subject_free(&s);
    }
}

/* A value just below 1 is 1 in float, so intervals of doubles do not enclose the result of float. */
static void computed_values_in_float_are_enclosed(void **state)
{
    (void)state;
    struct diag d = {0};
    static const char text[] = "footpoint-genome 1\ninput a\nrange a 0 0.99999999\ngenome g\nr = / 1 - 1 a\nend\n";
    struct genome_file *f = genome_parse("test", text, strlen(text), &d);
    assert_non_null(f);
    struct program *p = program_read(f, &f->genome[0], "*out_r = 1.0 / (1.0 - 1.0 * in_a);\n", &d);
    assert_non_null(p);
    for (int single = 0; single < 2; single++) {
        const struct evidence_options o = {
            .arithmetic = single ? &arithmetic_single : &arithmetic_double, .boxes = 100, .seed = 1};
        struct evidence *e = evidence_new(f, &f->genome[0], p, &o);
        assert_int_equal(e->denominator[0].apart, !single);
        evidence_free(e);
    }
    program_free(p);
    genome_file_free(f);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(zeros_of_polynomials_are_decided),
        cmocka_unit_test(poles_of_functions_are_decided),
        cmocka_unit_test(requires_exclude_zeros),
        cmocka_unit_test(without_ranges_all_numbers_count),
        cmocka_unit_test(denominators_are_counted_and_named),
        cmocka_unit_test(random_spheres_are_decided),
        cmocka_unit_test(rounding_may_change_signs_of_divisors),
        cmocka_unit_test(computed_values_in_float_are_enclosed),
    };
    return cmocka_run_group_tests_name("poles", tests, NULL, NULL);
}
