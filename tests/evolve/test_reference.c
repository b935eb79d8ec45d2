/* The certain closest point against a solver that shares no code with it: Newton's iteration in vector form from many
 * starts, polished with 192 bits (MPFR). Then answers known by hand. */
#include "../../evolve/common/stream.h"
#include "../../evolve/surface/foot_bilinear.h"

#include <gsl/gsl_randist.h>
#include <math.h>
#include <mpfr.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#define BITS 192
#define STARTS 25 /* in each direction */

typedef long double real;

/* Stationary points found from the starts, right to 192 bits before they are rounded. */
struct found {
    double xi, eta, distance;
    double flatness; /* determinant over the product of the Hessian's diagonal: near 0 on the focal surface */
};

static const double (*as_const(double x[4][3]))[3]
{
    return (const double(*)[3])x;
}

/* MPFR registers. */
struct bank {
    mpfr_t c0[3], c1[3], c2[3], c3[3], xi, eta, t1, t2, v, w, f1, f2, e11, e22, mixed, det, distance;
};

static void bank_each(struct bank *b, void (*apply)(mpfr_ptr))
{
    mpfr_t *vector[] = {b->c0, b->c1, b->c2, b->c3};
    mpfr_ptr scalar[] = {b->xi, b->eta, b->t1,  b->t2,    b->v,   b->w,       b->f1,
                         b->f2, b->e11, b->e22, b->mixed, b->det, b->distance};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            apply(vector[i][k]);
    for (size_t i = 0; i < sizeof scalar / sizeof *scalar; i++)
        apply(scalar[i]);
}

static void start_register(mpfr_ptr x)
{
    mpfr_init2(x, BITS);
}

/* Computes c_k = (A sA + B sB + C sC + D sD)/4 exactly. */
static void load_bank(struct bank *b, const double x[4][3], const double xs[3])
{
    static const int sign[4][4] = {{1, 1, 1, 1}, {-1, 1, 1, -1}, {-1, -1, 1, 1}, {1, -1, 1, -1}};
    mpfr_t *vector[] = {b->c0, b->c1, b->c2, b->c3};
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++) {
            mpfr_set_zero(vector[i][k], 1);
            for (int node = 0; node < 4; node++)
                mpfr_add_d(vector[i][k], vector[i][k], sign[i][node] * x[node][k], MPFR_RNDN);
            mpfr_div_ui(vector[i][k], vector[i][k], 4, MPFR_RNDN);
            if (i == 0)
                mpfr_d_sub(vector[0][k], xs[k], vector[0][k], MPFR_RNDN); /* c0 becomes xs - c0 */
        }
}

/* Computes residuals, Hessian and distance at (xi, eta). */
static void evaluate_bank(struct bank *b)
{
    mpfr_ptr zeroed[] = {b->f1, b->f2, b->e11, b->e22, b->mixed, b->distance};
    for (int i = 0; i < 6; i++)
        mpfr_set_zero(zeroed[i], 1);
    for (int k = 0; k < 3; k++) {
        mpfr_fma(b->t1, b->c3[k], b->eta, b->c1[k], MPFR_RNDN);
        mpfr_fma(b->t2, b->c3[k], b->xi, b->c2[k], MPFR_RNDN);
        mpfr_mul(b->v, b->t2, b->eta, MPFR_RNDN);
        mpfr_fma(b->v, b->c1[k], b->xi, b->v, MPFR_RNDN);
        mpfr_sub(b->v, b->c0[k], b->v, MPFR_RNDN);
        mpfr_fma(b->f1, b->t1, b->v, b->f1, MPFR_RNDN);
        mpfr_fma(b->f2, b->t2, b->v, b->f2, MPFR_RNDN);
        mpfr_fma(b->e11, b->t1, b->t1, b->e11, MPFR_RNDN);
        mpfr_fma(b->e22, b->t2, b->t2, b->e22, MPFR_RNDN);
        mpfr_fmms(b->w, b->t1, b->t2, b->v, b->c3[k], MPFR_RNDN);
        mpfr_add(b->mixed, b->mixed, b->w, MPFR_RNDN);
        mpfr_fma(b->distance, b->v, b->v, b->distance, MPFR_RNDN);
    }
    mpfr_sqrt(b->distance, b->distance, MPFR_RNDN);
    mpfr_fmms(b->det, b->e11, b->e22, b->mixed, b->mixed, MPFR_RNDN);
}

static void step_bank(struct bank *b)
{
    mpfr_fmms(b->v, b->f1, b->e22, b->f2, b->mixed, MPFR_RNDN);
    mpfr_fmms(b->w, b->f2, b->e11, b->f1, b->mixed, MPFR_RNDN);
    mpfr_div(b->v, b->v, b->det, MPFR_RNDN);
    mpfr_div(b->w, b->w, b->det, MPFR_RNDN);
    mpfr_add(b->xi, b->xi, b->v, MPFR_RNDN);
    mpfr_add(b->eta, b->eta, b->w, MPFR_RNDN);
}

/* Polishes (xi, eta) with 192 bits; returns false if it does not converge. */
static bool polish_mpfr(struct bank *b, real xi, real eta, struct found *f)
{
    mpfr_set_ld(b->xi, xi, MPFR_RNDN);
    mpfr_set_ld(b->eta, eta, MPFR_RNDN);
    for (int i = 0; i < 200; i++) {
        evaluate_bank(b);
        if (mpfr_zero_p(b->det) || !mpfr_number_p(b->det))
            return false;
        step_bank(b);
        const double step = fabs(mpfr_get_d(b->v, MPFR_RNDN)) + fabs(mpfr_get_d(b->w, MPFR_RNDN));
        if (step < 1e-25) {
            evaluate_bank(b);
            *f = (struct found){mpfr_get_d(b->xi, MPFR_RNDN), mpfr_get_d(b->eta, MPFR_RNDN),
                                mpfr_get_d(b->distance, MPFR_RNDN), 0};
            f->flatness = mpfr_get_d(b->det, MPFR_RNDN) / mpfr_get_d(b->e11, MPFR_RNDN) / mpfr_get_d(b->e22, MPFR_RNDN);
            return true;
        }
    }
    return false;
}

/* Runs Newton's iteration from one start, in vectors. */
static bool newton(const double x[4][3], const double xs[3], real *xi, real *eta)
{
    for (int i = 0; i < 60; i++) {
        real f1 = 0, f2 = 0, e11 = 0, e22 = 0, mixed = 0;
        for (int k = 0; k < 3; k++) {
            const real ab = (real)x[1][k] - x[0][k], dc = (real)x[2][k] - x[3][k], ad = (real)x[3][k] - x[0][k];
            const real t1 = (ab * (1 - *eta) + dc * (1 + *eta)) / 4;
            const real t2 = (ad * 2 + (dc - ab) * (1 + *xi)) / 4;
            const real v = (real)xs[k] - x[0][k] - ab * (1 + *xi) / 2 - t2 * (1 + *eta);
            f1 += t1 * v;
            f2 += t2 * v;
            e11 += t1 * t1;
            e22 += t2 * t2;
            mixed += t1 * t2 - v * (dc - ab) / 4;
        }
        const real det = e11 * e22 - mixed * mixed;
        if (det == 0)
            return false;
        const real sx = (f1 * e22 - f2 * mixed) / det, sy = (f2 * e11 - f1 * mixed) / det;
        *xi += sx;
        *eta += sy;
        if (!isfinite(*xi + *eta) || fabsl(*xi) + fabsl(*eta) > 1e8L)
            return false;
        if (fabsl(sx) + fabsl(sy) < 1e-9L * (1 + fabsl(*xi) + fabsl(*eta)))
            return true;
    }
    return false;
}

/* Finds all stationary points to which the starts lead, each once. */
static size_t search(struct bank *b, const double x[4][3], const double xs[3], struct found *found, size_t room)
{
    size_t n = 0;
    load_bank(b, x, xs);
    for (int i = 0; i < STARTS * STARTS; i++) {
        real xi = -3 + 6 * (real)(i % STARTS) / (STARTS - 1), eta = -3 + 6 * (real)(i / STARTS) / (STARTS - 1);
        bool known = false;
        if (!newton(x, xs, &xi, &eta))
            continue;
        for (size_t k = 0; k < n; k++)
            known = known || fabsl(xi - found[k].xi) + fabsl(eta - found[k].eta) < 1e-7L * (1 + fabsl(xi) + fabsl(eta));
        if (!known && n < room && polish_mpfr(b, xi, eta, &found[n]))
            n++;
    }
    return n;
}

/* Makes a segment with random mid-lines and c3 about the origin, turned by a random choice of axes. */
static void make(double x[4][3], const double c1[3], const double c2[3], const double c3[3])
{
    for (int k = 0; k < 3; k++) {
        x[0][k] = -c1[k] - c2[k] + c3[k];
        x[1][k] = c1[k] - c2[k] - c3[k];
        x[2][k] = c1[k] + c2[k] + c3[k];
        x[3][k] = -c1[k] + c2[k] - c3[k];
    }
}

static void random_vector(gsl_rng *r, double length, double v[3])
{
    for (int k = 0; k < 3; k++)
        v[k] = gsl_ran_flat(r, -length, length);
}

enum kind {
    ORDINARY,
    LATTICE_LIKE,
    WARPED,
    THIN,
    NEARLY_TRIANGULAR,
    PARALLELOGRAM,
    NEARLY_PARALLELOGRAM,
    TRAPEZIUM,
    PLANE,
    NEAR_FOCAL,
    FAR,
    OFFSET,
    TINY,
    KINDS
};

static const char *const kind_name[KINDS] = {"ordinary",
                                             "lattice-like",
                                             "warped",
                                             "thin",
                                             "nearly triangular",
                                             "parallelogram",
                                             "nearly parallelogram",
                                             "trapezium",
                                             "plane",
                                             "near focal",
                                             "far",
                                             "offset",
                                             "tiny"};

static void draw(gsl_rng *r, enum kind kind, double x[4][3], double xs[3])
{
    double c1[3] = {1, 0, 0}, c2[3] = {0, 1, 0}, c3[3];
    c1[1] = gsl_ran_flat(r, -0.3, 0.3);
    c2[0] = gsl_ran_flat(r, -0.3, 0.3);
    c1[0] *= gsl_ran_flat(r, 0.5, 3);
    random_vector(r, 0.2, c3);
    random_vector(r, 1.5, xs);
    xs[2] *= 0.2;
    switch (kind) {
    case LATTICE_LIKE:
        for (int i = 0; i < 4; i++)
            for (int k = 0; k < 3; k++)
                x[i][k] = k < 2 ? 0.2 * (double)gsl_rng_uniform_int(r, 21) - 2
                                : 0.1 * (double)gsl_rng_uniform_int(r, 7) - 0.3;
        return;
    case WARPED:
        random_vector(r, 1, c3);
        random_vector(r, 2, xs);
        break;
    case THIN:
        for (int k = 0; k < 3; k++)
            c2[k] *= 1e-4, c3[k] *= gsl_rng_uniform(r) < 0.5 ? 1e-4 : 1e-2;
        break;
    case NEARLY_TRIANGULAR: /* C = D to 1e-8 */
        for (int k = 0; k < 3; k++)
            c3[k] = -c1[k] + gsl_ran_flat(r, -1e-8, 1e-8);
        break;
    case PARALLELOGRAM:
        memset(c3, 0, sizeof c3);
        break;
    case NEARLY_PARALLELOGRAM:
        random_vector(r, pow(10, gsl_ran_flat(r, -16, -2)), c3);
        break;
    case TRAPEZIUM:
        for (int k = 0; k < 3; k++)
            c3[k] = c1[k] * 0.3;
        break;
    case PLANE:
        c3[2] = 0;
        if (gsl_rng_uniform(r) < 0.5)
            xs[2] = 0;
        break;
    case NEAR_FOCAL: /* a right saddle, with xs near its axis at the height where the minimum splits */
        c1[1] = c2[0] = 0;
        c1[0] = 1;
        c3[0] = c3[1] = 0;
        c3[2] = 0.5;
        xs[0] = gsl_ran_flat(r, -1, 1) * pow(10, gsl_ran_flat(r, -12, -2));
        xs[1] = gsl_ran_flat(r, -1, 1) * pow(10, gsl_ran_flat(r, -12, -2));
        xs[2] = 2 + gsl_ran_flat(r, -1, 1) * pow(10, gsl_ran_flat(r, -12, -2));
        break;
    case FAR:
        random_vector(r, pow(10, gsl_ran_flat(r, 1, 6)), xs);
        break;
    case ORDINARY:
    case OFFSET:
    case TINY:
    case KINDS:
        break;
    }
    make(x, c1, c2, c3);
    if (kind == OFFSET || kind == TINY) {
        const double shift = kind == OFFSET ? 1e6 : 0, scale = kind == TINY ? 1e-150 : 1;
        for (int i = 0; i < 5; i++)
            for (int k = 0; k < 3; k++) {
                double *v = i < 4 ? &x[i][k] : &xs[k];
                *v = scale * (*v + shift);
            }
    }
}

static void complain(enum kind kind, int i, const char *what, const double x[4][3], const double xs[3])
{
    print_error("%s, case %d: %s\n", kind_name[kind], i, what);
    for (int k = 0; k < 5; k++) {
        const double *v = k < 4 ? x[k] : xs;
        print_error("  {%a, %a, %a}\n", v[0], v[1], v[2]);
    }
    fail();
}

/* Returns the tolerance, relative: digits are lost if the Hessian is nearly singular, and far from the segment. */
static double tolerance_of(const struct found *f)
{
    return fabs(f->xi) + fabs(f->eta) > 10 ? 1e-9 : 1e-13 / fmin(1, fabs(f->flatness) * 100);
}

static bool contains(const struct stationary *s, int n, const struct found *f, double tolerance)
{
    for (int k = 0; k < n; k++)
        if (fabs(s[k].xi - f->xi) + fabs(s[k].eta - f->eta) <= tolerance * (1 + fabs(f->xi) + fabs(f->eta)))
            return true;
    return false;
}

static void finds_all_that_many_starts_find(void **state)
{
    gsl_rng *r = stream_new();
    struct bank b;
    (void)state;
    bank_each(&b, start_register);
    for (int kind = 0; kind < KINDS; kind++)
        for (int i = 0; i < 200; i++) {
            double raw[4][3], xs[3];
            struct stationary s[5];
            struct found f[16];
            stream_key(r, 1, (uint64_t)kind, (uint64_t)i, 0);
            draw(r, (enum kind)kind, raw, xs);
            const double(*x)[3] = as_const(raw);
            const int n = foot_bilinear_stationary(x, xs, s);
            const size_t m = search(&b, x, xs, f, 16);
            for (int k = 0; k + 1 < n; k++)
                if (s[k].distance > s[k + 1].distance)
                    complain((enum kind)kind, i, "not in ascending distance", x, xs);
            const double length = hypot(hypot(x[2][0] - x[0][0], x[2][1] - x[0][1]), x[2][2] - x[0][2]);
            for (size_t k = 0; k < m; k++) {
                if (n < 1 || s[0].distance > f[k].distance * (1 + 1e-13) + 1e-15 * length)
                    complain((enum kind)kind, i, "a nearer point was missed", x, xs);
                if (fabs(f[k].flatness) > 1e-6 && !contains(s, n, &f[k], tolerance_of(&f[k])))
                    complain((enum kind)kind, i, "a stationary point was missed, or is inaccurate", x, xs);
            }
        }
    bank_each(&b, mpfr_clear);
    gsl_rng_free(r);
}

static void set(double x[4][3], const double a[3], const double b[3], const double c[3], const double d[3])
{
    memcpy(x[0], a, sizeof x[0]);
    memcpy(x[1], b, sizeof x[1]);
    memcpy(x[2], c, sizeof x[2]);
    memcpy(x[3], d, sizeof x[3]);
}

static void unit_square(double x[4][3])
{
    set(x, (double[]){-1, -1, 0}, (double[]){1, -1, 0}, (double[]){1, 1, 0}, (double[]){-1, 1, 0});
}

/* z = xi eta: at height h above the centre there is one minimum for h <= 1, otherwise a saddle between two minima at xi
 * = eta = +-sqrt(h - 1). */
static void saddle_splits_above_its_focus(void **state)
{
    struct stationary s[5];
    double x[4][3];
    (void)state;
    set(x, (double[]){-1, -1, 1}, (double[]){1, -1, -1}, (double[]){1, 1, 1}, (double[]){-1, 1, -1});
    assert_int_equal(foot_bilinear_stationary(as_const(x), (const double[]){0, 0, 0.5}, s), 1);
    assert_true(s[0].minimum && fabs(s[0].xi) + fabs(s[0].eta) < 1e-15 && fabs(s[0].distance - 0.5) < 1e-15);
    assert_int_equal(foot_bilinear_stationary(as_const(x), (const double[]){0, 0, 1.25}, s), 3);
    for (int k = 0; k < 2; k++) {
        assert_true(s[k].minimum && fabs(fabs(s[k].xi) - 0.5) < 1e-15 && fabs(s[k].xi - s[k].eta) < 1e-15);
        assert_true(fabs(s[k].distance - sqrt(1.5)) < 1e-15);
    }
    assert_true(!s[2].minimum && fabs(s[2].xi) + fabs(s[2].eta) < 1e-15 && fabs(s[2].distance - 1.25) < 1e-15);
}

/* A plane trapezium with its apex at (0,3,0) has the foot point of a node above the plane, and a saddle at the apex. */
static void trapezium_has_one_minimum(void **state)
{
    struct stationary s[5];
    double x[4][3];
    (void)state;
    set(x, (double[]){-2, -1, 0}, (double[]){2, -1, 0}, (double[]){1, 1, 0}, (double[]){-1, 1, 0});
    const int n = foot_bilinear_stationary(as_const(x), (const double[]){0.75, 0, 2}, s);
    assert_in_range(n, 1, 2);
    assert_true(s[0].minimum && fabs(s[0].xi - 0.5) < 1e-15 && fabs(s[0].eta) < 1e-15 &&
                fabs(s[0].distance - 2) < 1e-15);
    assert_true(n == 1 || !s[1].minimum);
}

/* The quintic of this node has a leading coefficient that is only rounding, with a root of 1e19. */
static void far_roots_hide_no_minimum(void **state)
{
    const double lo[2] = {-1, -1}, hi[2] = {0, 0};
    struct sample s = {.xs = {0.2, 0.2, -0.3}};
    (void)state;
    set(s.x, (double[]){0, 0, 0}, (double[]){1, 0, 0}, (double[]){0.6, 0.6, 0}, (double[]){0.4, 0.6, 0});
    assert_true(foot_bilinear(&s, lo, hi));
    assert_true(fabs(s.xi + 9. / 11) < 1e-15 && fabs(s.eta + 1. / 3) < 1e-15 && fabs(s.gap + 0.3) < 1e-15);
}

static void degenerate_segments_are_refused(void **state)
{
    static const double point[3] = {1, 2, 3};
    struct stationary s[5];
    struct sample sample = {.xi = 7};
    double x[4][3];
    (void)state;
    set(x, point, point, point, point);
    assert_int_equal(foot_bilinear_stationary(as_const(x), (const double[]){0, 0, 0}, s), -1);
    set(x, (double[]){0, 0, 0}, (double[]){1, 1, 1}, (double[]){3, 3, 3}, (double[]){-2, -2, -2});
    assert_int_equal(foot_bilinear_stationary(as_const(x), (const double[]){0, 0, 1}, s), -1);
    unit_square(x);
    assert_int_equal(foot_bilinear_stationary(as_const(x), (const double[]){0, NAN, 0}, s), -1);
    x[2][1] = INFINITY;
    assert_int_equal(foot_bilinear_stationary(as_const(x), point, s), -1);
    memcpy(sample.x, x, sizeof x);
    assert_false(foot_bilinear(&sample, (const double[]){-1, -1}, (const double[]){1, 1}));
    assert_true(sample.xi == 7);
}

/* The box excludes its lower bound and includes its upper bound; the gap is positive on the side of the normal. */
static void foot_lies_in_the_box(void **state)
{
    struct sample s = {.xs = {-1, 0.5, -0.25}};
    (void)state;
    unit_square(s.x);
    assert_false(foot_bilinear(&s, (const double[]){-1, -1}, (const double[]){0, 1}));
    assert_true(foot_bilinear(&s, (const double[]){-1.5, -1}, (const double[]){-1, 0.5}));
    assert_true(fabs(s.xi + 1) < 1e-15 && fabs(s.eta - 0.5) < 1e-15 && fabs(s.gap + 0.25) < 1e-15);
    assert_false(foot_bilinear(&s, (const double[]){-1.5, 0.5}, (const double[]){-0.5, 1}));
}

/* Powers of two scale exactly, and whole numbers move small segments exactly, so all bits are kept. */
static void scaling_and_moving_keep_the_bits(void **state)
{
    static const double lo[2] = {-1.5, -1.5}, hi[2] = {1.5, 1.5};
    gsl_rng *r = stream_new();
    (void)state;
    for (uint64_t i = 0; i < 200; i++) {
        struct sample s, t;
        stream_key(r, 2, i, 0, 0);
        draw(r, ORDINARY, s.x, s.xs);
        for (int k = 0; k < 15; k++) {
            double *v = k < 12 ? &s.x[k / 3][k % 3] : &s.xs[k - 12];
            *v = ldexp(rint(ldexp(*v, 30)), -30);
        }
        t = s;
        for (int k = 0; k < 15; k++) {
            double *v = k < 12 ? &t.x[k / 3][k % 3] : &t.xs[k - 12];
            *v = 1024 * (*v + 4096);
        }
        const bool found = foot_bilinear(&s, lo, hi);
        assert_int_equal(found, foot_bilinear(&t, lo, hi));
        if (found) {
            assert_memory_equal(&s.xi, &t.xi, sizeof s.xi);
            assert_memory_equal(&s.eta, &t.eta, sizeof s.eta);
            assert_true(1024 * s.gap == t.gap);
        }
    }
    gsl_rng_free(r);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(finds_all_that_many_starts_find),  cmocka_unit_test(saddle_splits_above_its_focus),
        cmocka_unit_test(trapezium_has_one_minimum),        cmocka_unit_test(far_roots_hide_no_minimum),
        cmocka_unit_test(degenerate_segments_are_refused),  cmocka_unit_test(foot_lies_in_the_box),
        cmocka_unit_test(scaling_and_moving_keep_the_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
