/* Enclosures and error bounds against exact values: intervals, random programs, known programs. With FOOTPOINT_LONG
 * set, at a million points each. */
#include "../../codegen/compile/compile.h"
#include "../../codegen/program/evaluate.h"
#include "../../codegen/region/enclosure.h"
#include "../../codegen/rounding/evidence.h"
#include "../../codegen/rounding/rounding.h"
#include "../../codegen/rounding/rounding_bound.h"
#include "../../codegen/rounding/sampled_errors.h"
#include "../support/genome_text.h"
#include "../support/rounding_subject.h"

#include <float.h>
#include <math.h>

enum { INPUTS = 3, OPS = 24, PROGRAMS = 400, BOXES = 6, POINTS = 8, INTERVALS = 100000 };

/* Searches continue while bounds improve. */
static const struct bound_goal closest = {INFINITY, INFINITY, 0};

/* ---- intervals ---- */

/* Draws zeros, small whole numbers, any exponent, the smallest and the largest number. */
static double odd_number(uint64_t *seed)
{
    static const double special[] = {0, 1, -1, 2, 0x1p-1074, -0x1p-1074, DBL_MIN, DBL_MAX, -DBL_MAX, 0.5};
    const uint64_t kind = random_next(seed) % 4;
    if (kind == 0)
        return special[random_next(seed) % 10];
    if (kind == 1)
        return (double)(random_next(seed) % 9) - 4;
    return (2 * fraction(seed) - 1) * ldexp(1, kind == 2 ? 4 : (int)(random_next(seed) % 2000) - 1020);
}

static struct interval odd_interval(uint64_t *seed)
{
    const double a = odd_number(seed), b = random_next(seed) % 4 ? odd_number(seed) : a;
    return (struct interval){fmin(a, b), fmax(a, b)};
}

static double inside(struct interval x, uint64_t *seed)
{
    const double t = fraction(seed), y = x.lo * (1 - t) + x.hi * t;
    const uint64_t kind = random_next(seed) % 3;
    return kind == 0 ? x.lo : kind == 1 ? x.hi : fmin(fmax(y, x.lo), x.hi);
}

static bool encloses(struct interval x, const arb_t exact)
{
    arf_t end;
    bool good;
    arf_init(end);
    arb_get_ubound_arf(end, exact, 128);
    good = arf_cmp_d(end, x.lo) >= 0;
    arb_get_lbound_arf(end, exact, 128);
    good = good && arf_cmp_d(end, x.hi) <= 0;
    arf_clear(end);
    return good;
}

static void intervals_enclose_values(void **state)
{
    (void)state;
    uint64_t seed = 1;
    arb_t a, b, c;
    arb_init(a);
    arb_init(b);
    arb_init(c);
    for (int i = 0; i < INTERVALS; i++) {
        const struct interval x = odd_interval(&seed), y = odd_interval(&seed);
        arb_set_d(a, inside(x, &seed));
        arb_set_d(b, inside(y, &seed));
        arb_add(c, a, b, 2200);
        assert_true(encloses(interval_add(x, y), c));
        arb_sub(c, a, b, 2200);
        assert_true(encloses(interval_subtract(x, y), c));
        arb_mul(c, a, b, 2200);
        assert_true(encloses(interval_multiply(x, y), c));
        arb_mul(c, a, a, 2200);
        assert_true(encloses(interval_square(x), c));
        arb_div(c, a, b, 2200);
        assert_true(arb_is_zero(b) || encloses(interval_divide(x, y), c));
        arb_sqrt(c, a, 2200);
        assert_true(!arb_is_nonnegative(a) || encloses(function_range(OP_SQRT, x), c));
        arb_abs(c, a);
        assert_true(encloses(interval_absolute(x), c));
        assert_true(interval_has(x, interval_middle(x)));
        assert_true(!signbit(interval_least(x)) && !signbit(interval_least(interval_negative(x))));
    }
    arb_clear(a);
    arb_clear(b);
    arb_clear(c);
}

/* ---- random programs ---- */

static const char ranges[] = "footpoint-genome 1\ninput x y z\nrange x -1 2\nrange y 0.5 1\nrange z -3 -0.1\n%s"
                             "genome g\nr = 0\nend\n";

static int add(struct program *p, struct op op)
{
    grow_array(&p->op, p->ops, &p->op_room, sizeof *p->op);
    p->op[p->ops] = op;
    return (int)p->ops++;
}

static void add_constant(struct program *p, uint64_t *seed)
{
    const bool quotient = random_next(seed) % 3 == 0;
    grow_array(&p->constant, p->constants, &p->constant_room, sizeof *p->constant);
    fmpq_init(&p->constant[p->constants]);
    fmpq_set_si(&p->constant[p->constants], (slong)(random_next(seed) % 41) - 20, quotient ? 7 : 10);
    add(p, (struct op){.kind = OP_CONSTANT, .a = -1, .b = -1, .input = (int)p->constants++, .quotient = quotient});
}

/* Draws a program whose operations are all outputs. */
static struct program *random_program(uint64_t *seed)
{
    static const enum op_kind kind[] = {OP_ADD, OP_ADD, OP_SUB, OP_SUB, OP_MUL, OP_MUL,  OP_MUL,
                                        OP_DIV, OP_NEG, OP_ABS, OP_MIN, OP_MAX, OP_SQRT, OP_PDIV};
    struct program *p = new_array(1, sizeof *p);
    p->inputs = INPUTS;
    for (int i = 0; i < INPUTS; i++)
        add(p, (struct op){.kind = OP_INPUT, .a = -1, .b = -1, .input = i});
    while (p->ops < OPS) {
        if (random_next(seed) % 6 == 0) {
            add_constant(p, seed);
            continue;
        }
        struct op op = {.kind = kind[random_next(seed) % 14], .b = -1, .input = -1};
        op.a = (int)(random_next(seed) % p->ops);
        if (op.kind != OP_NEG && op.kind != OP_ABS && op.kind != OP_SQRT)
            op.b = (int)(random_next(seed) % p->ops);
        op.squared = op.kind == OP_MUL && op.a == op.b;
        add(p, op);
    }
    p->output = new_array(p->ops, sizeof *p->output);
    for (; p->outputs < p->ops; p->outputs++)
        p->output[p->outputs] = (int)p->outputs;
    return p;
}

/* Computes exact values of operations 0..op if they exist; returns false if `op` has no value. */
static bool exact_values(struct program *p, int op, const double *input, arb_ptr exact)
{
    const size_t ops = p->ops, outputs = p->outputs;
    p->ops = p->outputs = (size_t)op + 1;
    const bool good = point_exact(p, input, exact);
    p->ops = ops;
    p->outputs = outputs;
    return good;
}

/* Draws a box inside the ranges; many end at 0, which may have a sign. */
static void random_box(const struct known *x, uint64_t *seed, struct interval *box)
{
    for (size_t k = 0; k < x->variables; k++) {
        const struct interval range = x->range[x->input[k]];
        const double a = inside(range, seed), b = inside(range, seed), shrink = random_next(seed) % 2 ? 1 : 1e-3;
        box[k] = (struct interval){fmin(a, a + shrink * (b - a)), fmax(a, a + shrink * (b - a))};
        if (range.lo <= 0 && range.hi >= 0 && random_next(seed) % 3 == 0) {
            const double zero = random_next(seed) % 2 ? 0.0 : -0.0;
            box[k] = box[k].hi > 0 ? (struct interval){zero, box[k].hi} : (struct interval){box[k].lo, zero};
        }
    }
}

static void point_in(struct subject *s, uint64_t *seed)
{
    for (size_t k = 0; k < s->region->known->variables; k++)
        s->at[k] = inside(s->box[k], seed);
    region_inputs(s->region, s->at, s->input);
}

/* At points of the box that belong to the region, the last value's errors stay below the bound, and all values stay in
 * their enclosures: by the forms, or by the region if the forms are NULL. */
static bool check_points(struct subject *s, const struct forms *w, double bound, uint64_t *seed)
{
    const int last = (int)s->program->ops - 1;
    bool any = false;
    for (int i = 0; i < POINTS; i++) {
        struct interval point[INPUTS];
        bool member = true;
        point_in(s, seed);
        for (size_t k = 0; k < s->region->known->variables; k++) {
            point[k] = interval_point(s->at[k]);
            member = member && interval_has(s->box[k], s->input[s->region->known->input[k]]);
        }
        if (!member || !region_holds(s->region, point) || !exact_values(s->program, last, s->input, s->exact))
            continue;
        any = true;
        for (int op = 0; op <= last; op++) {
            assert_true(encloses(s->region->known->value[region_op(s->region, op)], s->exact + op));
            for (size_t n = 0; w && n < w->needs; n++)
                if (w->needed[n] == region_op(s->region, op))
                    assert_true(encloses(w->range[w->needed[n]], s->exact + op));
        }
        for (int k = 0; k < 4; k++) {
            point_double(s->program, s->input, k ? seed : NULL, s->value);
            const double error = error_of(s->value[last], s->exact + last);
            if (!(error <= bound))
                fail_msg("error %a, bound %a", error, bound);
        }
    }
    return any && bound < INFINITY;
}

/* Computes the bound over the whole region, linked through the bounds of half the earlier values in each box. */
static bool check_links(struct subject *s, uint64_t *seed)
{
    const int last = (int)s->program->ops - 1;
    double work = INFINITY;
    for (int op = 0; op < last; op++)
        s->region->known->joint[region_op(s->region, op)] = random_next(seed) % 2;
    const double bound = bound_error(s->region, region_op(s->region, last), closest, 8, &work);
    region_box(s->region, s->box);
    return check_points(s, NULL, bound, seed);
}

static void check_random_programs(const char *requires)
{
    uint64_t seed = 5;
    long bounded = 0, linked = 0;
    char text[1000];
    snprintf(text, sizeof text, ranges, requires);
    for (int i = 0; i < PROGRAMS; i++) {
        struct subject s = subject_new(text, random_program(&seed));
        const int last = region_op(s.region, (int)s.program->ops - 1);
        struct forms *w = forms_new(s.region->known, &last, 1);
        struct rounding *e = rounding_new(w, &last, 1);
        for (int k = 0; k < BOXES; k++) {
            random_box(s.region->known, &seed, s.box);
            if (!forms_evaluate(w, s.box))
                continue;
            double error;
            rounding_errors(e, &error);
            bounded += check_points(&s, w, error, &seed);
        }
        linked += check_links(&s, &seed);
        rounding_free(e);
        forms_free(w);
        subject_free(&s);
    }
    print_message("of %d programs, %ld have a bound\n", PROGRAMS, linked);
    assert_true(bounded > PROGRAMS && linked > PROGRAMS / 5); /* enough programs have a bound */
}

static void random_programs_stay_within_bounds(void **state)
{
    (void)state;
    check_random_programs("");
}

static void requires_keep_bounds_valid(void **state)
{
    (void)state;
    check_random_programs("require - x * 0.5 y\nrequire - + 1 x abs - y 0.7\nrequire + * x y * 2 y\n");
}

/* ---- known programs ---- */

struct bounded {
    const char *ranges, *code;
    double tight; /* the bound is at most this multiple of the worst error found */
};

#define BOX_2 "range a -1 1\nrange b -1 1"
#define BOX_6 "range a 1 2\nrange b 1 2\nrange c 1 2\nrange d -1 1\nrange e -1 1\nrange f -1 1"

static const struct bounded known[] = {
    {BOX_2, "*out_r = in_a + in_b;", 2.5},
    {BOX_2, "*out_r = in_a * in_b;", 2.5},
    {BOX_2, "*out_r = 1.5 + in_a * (-0.3 + in_a * (0.7 + in_a * 1.1));", 3.5},
    {BOX_2, "*out_r = in_a * in_a * in_a - 3.0 * in_a * in_b * in_b + 0.1 * in_b;", 4},
    {BOX_2, "const double t1 = in_a + in_b;\n*out_r = t1 + t1 - in_a * in_b;", 2.5},
    {BOX_2, "const double t1 = in_a * in_b;\n*out_r = t1 + t1;", 5}, /* fma(a, b, t1) is not exact */
    {BOX_2, "const double t1 = in_a * in_b;\n*out_r = (t1 - t1) * 1000000.0 + t1;", 5},
    {BOX_2, "*out_r = in_a / (2.5 + in_b);", 2.5},
    {BOX_2, "*out_r = (in_a + in_b) / (in_a * in_a + in_b * in_b + 0.1);", 3},
    {BOX_2, "*out_r = sqrt(in_a * in_a + in_b * in_b);", 2.5}, /* its derivative has no bound at 0 */
    {BOX_2, "*out_r = sqrt(in_a * in_a + 1.0);", 2.5},
    {BOX_2, "*out_r = (in_a < 0.3 ? in_a : 0.3) * (in_b > in_a ? in_b : in_a) + fabs(in_a - in_b);", 2.5},
    {BOX_2, "*out_r = (7.0 / 3.0) * in_a + 0.1 * in_b;", 2.5},
    {BOX_2, "*out_r = -(in_a * in_a);", 2.5}, /* 0 is at the ends of boxes and may have a sign */
    {BOX_2, "const double u1 = 3.0 * in_b;\n*out_r = fabs(in_b) * (u1 < in_a ? u1 : in_a);", 2.5},
    {BOX_6,
     "const double t1 = in_a * in_b - in_d * in_e;\nconst double t2 = 1.0 / t1;\n"
     "*out_r = t2 * (in_f * in_b - in_d * in_c);\n",
     INFINITY}, /* t1 vanishes at a corner */
    {BOX_6,
     "const double t1 = in_a * in_b + in_d * in_e + 1.0;\nconst double t2 = 1.0 / t1;\n"
     "*out_r = t2 * (in_f * in_b - in_d * in_c);\n",
     8},
    {BOX_6 "\nrequire - - * a b * d e 0.5",
     "const double t1 = in_a * in_b - in_d * in_e;\nconst double t2 = 1.0 / t1;\n"
     "*out_r = t2 * (in_f * in_b - in_d * in_c);\n",
     8},
};

static void known_programs_have_tight_bounds(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        char text[1000];
        snprintf(text, sizeof text, "footpoint-genome 1\ninput a b c d e f\n%s\ngenome g\nr = 0\nend\n",
                 known[i].ranges);
        struct genome_file *f = parse(text);
        struct program *p = read_program(f, 0, known[i].code);
        struct subject s = subject_new(text, p);
        double worst, work = INFINITY;
        const double bound = bound_error(s.region, region_op(s.region, p->output[0]), closest, 20000, &work);
        worst_errors(&s, &worst);
        if (!(bound >= worst && (bound <= known[i].tight * worst)))
            fail_msg("%s: bound %g, worst error %g", known[i].code, bound, worst);
        subject_free(&s);
        genome_file_free(f);
    }
}

/* ---- test points ---- */

/* A region block: x and y lie on curved lines, z is a multiple of a value that the block bounds better, w is near its
 * t. */
static void region_blocks_yield_bounds(void **state)
{
    (void)state;
    static const char text[] = "footpoint-genome 2\ninput x y\nregion\ninput s t one\nrange s 0.5 2\nrange t -1 1\n"
                               "range one 1 1\nlet x = * s + 3 t\nlet y = / - 3 t s\n"
                               "let product = * + 3 t - 3 t\nlet same = * one product\nrequire - 1.8 s\nend\n"
                               "let w = / - * x y 8.5 2\nrequire - 1.4 abs - w t\ngenome g\nr = 0\nend\n";
    static const char *const code[] = {
        "const double t1 = in_x * in_y;\n*out_r = 1.0 / (t1 - 7.5);\n",
        "const double t1 = (in_x * in_y - 8.5) / 2.0;\n*out_r = sqrt(2.5 + t1) * in_x;\n"};
    for (int i = 0; i < 2; i++) {
        struct genome_file *f = parse(text);
        struct program *p = read_program(f, 0, code[i]);
        struct subject s = subject_new(text, p);
        double worst, work = INFINITY;
        assert_int_equal(s.region->known->variables, 2);
        const double bound = bound_error(s.region, region_op(s.region, p->output[0]), closest, 20000, &work);
        worst_errors(&s, &worst);
        if (!(bound >= worst && bound <= 8 * worst))
            fail_msg("%s: bound %g, worst error %g", code[i], bound, worst);
        subject_free(&s);
        genome_file_free(f);
    }
}

/* Membership in the region does not depend on the box that was tested last. */
static void membership_does_not_depend_on_the_last_box(void **state)
{
    (void)state;
    static const char text[] = "footpoint-genome 2\ninput x y\nrange x 0 1, y 0 1\nlet v = * x x\n"
                               "require - 0.1 abs - v y\nrequire + v 1\ngenome g\nr = 0\nend\n";
    struct genome_file *f = parse(text);
    struct program *p = read_program(f, 0, "*out_r = in_x + in_y;\n");
    struct region *r = region_new(f, p, true);
    assert_false(region_holds(r, (const struct interval[]){{0, 1}, {0, 0.5}}));
    assert_true(forms_hold_at(r->required, (const struct interval[]){{1, 1}, {0.97, 0.97}}));
    region_free(r);
    program_free(p);
    genome_file_free(f);
}

/* ---- single programs ---- */

/* A program with one output. */
struct tested {
    struct genome_file *file;
    struct subject subject;
    double bound;
};

static struct tested tested_new(const char *inputs, const char *code, const struct arithmetic *a)
{
    char text[500];
    double work = 1e8;
    snprintf(text, sizeof text, "footpoint-genome 1\n%sgenome g\nr = 0\nend\n", inputs);
    struct tested t = {.file = parse(text)};
    t.subject = subject_new(text, read_program(t.file, 0, code));
    t.subject.region->known->arithmetic = *a;
    t.bound =
        bound_error(t.subject.region, region_op(t.subject.region, t.subject.program->output[0]), closest, 2000, &work);
    return t;
}

static void tested_free(struct tested *t)
{
    subject_free(&t->subject);
    genome_file_free(t->file);
}

static double worst_of(struct tested *t)
{
    double worst;
    worst_errors(&t->subject, &worst);
    print_message("bound %g, worst error %g\n", t->bound, worst);
    assert_true(t->bound >= worst);
    return worst;
}

/* In float, 1e-42 is off by more than a unit of rounding. */
static void small_constants_are_bounded_in_float(void **state)
{
    (void)state;
    static const char code[] = "const double t1 = 0.000000000000000000000000000000000000000001 * in_x * "
                               "1000000000000.0;\n*out_r = in_y / t1;\n";
    struct tested t = tested_new("input x y\nrange x 1e30 2e30\nrange y 1 2\n", code, &arithmetic_single);
    const float x = 1e30F, computed = 2 / (1e-42F * x * 1e12F);
    const double error = fabs(computed - 2 / (1e-42 * (double)x * 1e12));
    print_message("small constant: %g, error %g\n", t.bound, error);
    assert_true(t.bound >= error && t.bound < 100 * error);
    tested_free(&t);
}

/* The same product occurs in two sums, whose small difference is a divisor. If only one is contracted, its rounding
 * does not cancel. As a factor it is never contracted, so it does. */
static void products_contracted_in_one_use_are_bounded(void **state)
{
    (void)state;
    static const char inputs[] = "input x y c\nrange x 1.5 1.500001\nrange y 1.7 1.700001\nrange c 0.00001 0.00002\n";
    struct tested sums = tested_new(inputs,
                                    "const double t1 = in_x * in_y;\nconst double t2 = t1 + in_c;\n"
                                    "const double t3 = t1 - in_c;\n*out_r = in_c / (t2 - t3);\n",
                                    &arithmetic_double);
    struct tested factors = tested_new(
        inputs, "const double t1 = in_x * in_y;\n*out_r = (t1 * in_c) / (t1 * (in_c + 1.0));\n", &arithmetic_double);
    assert_true(sums.bound < 30 * worst_of(&sums) && sums.bound > 1e-12);
    assert_true(factors.bound < 30 * worst_of(&factors));
    tested_free(&sums);
    tested_free(&factors);
}

/* If a clamp chooses 0.5, t is 1 without an error, however large the result's derivative by it. */
static void chosen_numbers_have_no_error(void **state)
{
    (void)state;
    struct tested exact = tested_new("input x y\nrange x 0.6 2\nrange y 0.6 2\n",
                                     "const double t1 = (in_x < 0.5 ? in_x : 0.5) + 0.5;\n"
                                     "*out_r = 1000000.0 * (t1 * in_y - in_y) + in_x;\n",
                                     &arithmetic_double);
    assert_true(worst_of(&exact) < 1e-9 && exact.bound < 1e-9);
    tested_free(&exact);
}

/* Products that underflow at all points, or may overflow: the bounds hold for the exact values. */
static void bounds_hold_at_the_ends_of_the_range(void **state)
{
    (void)state;
    struct tested under = tested_new("input x y c\nrange x 1e-200 2e-200\nrange y 1e-200 2e-200\nrange c 1e300 2e300\n",
                                     "const double t1 = in_x * in_y;\n*out_r = t1 * in_c;\n", &arithmetic_double);
    struct tested subnormal =
        tested_new("input x y c\nrange x 1e-162 1.1e-162\nrange y 3e-161 3.1e-161\nrange c 1e300 2e300\n",
                   "const double t1 = in_x * in_y;\n*out_r = t1 * in_c;\n", &arithmetic_double);
    struct tested over =
        tested_new("input x y\nrange x 1.3e21 3e21\nrange y 1e21 4e21\n",
                   "const double t1 = in_x * 288230376151711744.0;\n*out_r = in_y / t1;\n", &arithmetic_single);
    assert_true(under.bound < 1e-20 && subnormal.bound < 1e-20 && over.bound > 7e-18);
    assert_true(worst_of(&under) > 0 && worst_of(&subnormal) > 0);
    tested_free(&under);
    tested_free(&subnormal);
    tested_free(&over);
}

/* Newton's steps for x x + p x = q, from far away: enclosures grow with each step. A search with an unreachable goal
 * takes a small part of its work and still returns a bound. */
static void hopeless_searches_end_early(void **state)
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
    struct tested t = tested_new("input p q\nrange p 0 3\nrange q 0.1 5\n", code, &arithmetic_double);
    const double most = 1e9, worst = worst_of(&t);
    double work = most;
    const double bound = bound_error(t.subject.region, region_op(t.subject.region, t.subject.program->output[0]),
                                     (struct bound_goal){1.01 * worst, 1.01 * worst, 0}, 100000, &work);
    print_message("hopeless: %g, by %g of the work\n", bound, (most - work) / most);
    assert_true(bound >= worst && most - work < 0.1 * most);
    tested_free(&t);
}

/* Samples reach the worst error that the tests' own search finds, within a factor of two. */
static void samples_come_near_the_worst_errors(void **state)
{
    (void)state;
    struct tested t = tested_new("input x y\nrange x 0.6 2\nrange y -1 1\n",
                                 "*out_r = in_x / (in_y * in_y + 0.01) - sqrt(in_x) * in_y;\n", &arithmetic_double);
    const struct sampled of = {t.subject.program, arithmetic_double};
    struct sampled_errors *found = sampled_errors_new(t.file, &of, 1, 100000, 1);
    const double worst = worst_of(&t);
    print_message("%ld points: %g\n", found->points, found->worst[0]);
    assert_true(found->points == 100000 && found->worst[0] <= t.bound && found->worst[0] > 0.5 * worst);
    sampled_errors_free(found);
    free(found);
    tested_free(&t);
}

static void check_row(struct subject *s, const char *row, uint64_t *seed)
{
    const struct program *p = s->program;
    double number[64];
    size_t n = 0;
    for (const char *at = strchr(row, '{'); *at != '}' && n < 64; n++) {
        char *end;
        number[n] = strtod(at + 1, &end);
        assert_true(end > at + 1 && (*end == ',' || *end == '}'));
        at = end;
    }
    assert_int_equal(n, p->inputs + 2 * p->outputs);
    for (int k = 0; k < 4; k++) {
        point_double(p, number, k ? seed : NULL, s->value);
        for (size_t i = 0; i < p->outputs; i++)
            assert_true(fabs(s->value[p->output[i]] - number[p->inputs + i]) <= number[p->inputs + p->outputs + i]);
    }
}

static void points_stay_within_bounds(void **state)
{
    (void)state;
    static const char text[] = "footpoint-genome 1\ninput x y z\nrange x 0.1 2\nrange y -3 3\n%s"
                               "require - 2 * x y\ngenome g\nr = / - * x y 0.3 + x * z z\ns = sqrt + 1 * y z\nend\n";
    uint64_t seed = 1;
    for (int with = 0; with < 2; with++) {
        char whole[400], *rows = NULL;
        size_t size = 0;
        struct diag d = {0};
        struct compiled c;
        struct compile_options o = compile_defaults();
        o.effort = 0;
        snprintf(whole, sizeof whole, text, with ? "range z 0 0.25\n" : "");
        struct genome_file *f = parse(whole);
        assert_true(compile_genome(f, &f->genome[0], &o, &c, &d));
        struct program *p = read_program(f, 0, c.text);
        struct subject s = subject_new(whole, p);
        struct evidence *e = evidence_new(s.file, &s.file->genome[0], p, &(struct evidence_options){.boxes = 100});
        FILE *out = open_memstream(&rows, &size);
        const int n = evidence_print_points(s.file, p, out);
        fclose(out);
        assert_int_equal(n, 8);
        char *row = rows;
        for (int i = 0; i < n; i++, row = strchr(row, '\n') + 1)
            check_row(&s, row, &seed);
        assert_string_equal(row, "");
        free(rows);
        compiled_free(&c);
        evidence_free(e);
        subject_free(&s);
        genome_file_free(f);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(intervals_enclose_values),
        cmocka_unit_test(random_programs_stay_within_bounds),
        cmocka_unit_test(requires_keep_bounds_valid),
        cmocka_unit_test(known_programs_have_tight_bounds),
        cmocka_unit_test(region_blocks_yield_bounds),
        cmocka_unit_test(membership_does_not_depend_on_the_last_box),
        cmocka_unit_test(small_constants_are_bounded_in_float),
        cmocka_unit_test(products_contracted_in_one_use_are_bounded),
        cmocka_unit_test(chosen_numbers_have_no_error),
        cmocka_unit_test(bounds_hold_at_the_ends_of_the_range),
        cmocka_unit_test(hopeless_searches_end_early),
        cmocka_unit_test(samples_come_near_the_worst_errors),
        cmocka_unit_test(points_stay_within_bounds),
    };
    return cmocka_run_group_tests_name("bound", tests, NULL, NULL);
}
