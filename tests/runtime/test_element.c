/* The contact element for all kinds of faces: its tangents are derivatives of its forces, by differences; forces
 * balance; Newton's iteration with the tangent converges quadratically. */
#include "../../runtime/footpoint_face.h"
#include "../support/quad_precision.h"

#include <limits.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

enum { SAMPLES = 20, C = MOST_COORDINATES };
#define STEP 1e-5
#define STIFFNESS 70.0
#define TANGENTIAL 30.0

/* A contact and its element. */
struct contact {
    double x[C], xi0, eta0, multiplier, friction; /* the node sticks at (xi0, eta0) */
    double pressure, normal[C], packed[C * (C + 1) / 2], slip[2], tangential[C], full[C * C];
};

struct point {
    double phi[MOST_NODES], r_xi[3], r_eta[3], normal[3], gap, d_gap[C], d_normal[3 * C], hessian[C * (C + 1) / 2];
};

static int point_of(int kind, const double *x, const double loc[2], struct point *p)
{
    const enum footpoint_face face = (enum footpoint_face)kind;
    (void)footpoint_face_place(face, x, loc, p->phi, p->r_xi, p->r_eta, p->normal, &p->gap);
    return footpoint_face_hessian(face, x, loc, NULL, NULL, NULL, p->d_gap, p->d_normal, p->hessian);
}

/* Computes the element at the foot point, found in quadruple precision. */
static void assemble(int kind, const struct exact_face *f, struct contact *e)
{
    const int nodes = f->nodes, n = 3 * (nodes + 1);
    quadruple y[C];
    struct exact_foot foot;
    static struct point at, stick;
    for (int i = 0; i < n; i++)
        y[i] = e->x[i];
    assert_true(exact_foot_near(f, y, 0.2, 0.1, &foot));
    const double loc[2] = {(double)foot.xi, (double)foot.eta}, loc0[2] = {e->xi0, e->eta0};
    assert_int_equal(point_of(kind, e->x, loc, &at), FOOTPOINT_OK);
    assert_int_equal(point_of(kind, e->x, loc0, &stick), FOOTPOINT_OK);
    assert_int_equal(footpoint_element_normal(nodes, at.gap, at.d_gap, at.hessian, STIFFNESS, e->multiplier,
                                              &e->pressure, e->normal, e->packed),
                     FOOTPOINT_OK);
    assert_int_equal(footpoint_element_friction(nodes, e->x, stick.phi, at.r_xi, at.r_eta, at.normal, at.d_gap,
                                                at.d_normal, e->pressure, STIFFNESS, e->friction, TANGENTIAL, e->slip,
                                                e->tangential, e->full),
                     FOOTPOINT_OK);
}

/* Draws moved nodes, and the slave node above or below a place near (0.2, 0.1). */
static void draw(uint64_t *stream, const struct exact_face *f, double gap, struct contact *e)
{
    for (int i = 0; i < 3 * f->nodes + 3; i++) {
        *stream = *stream * 6364136223846793005u + 1442695040888963407u;
        e->x[i] = 0.1 * ((double)(*stream >> 11) * 0x1p-53 - 0.5);
        if (i < 3 * f->nodes && i % 3 < 2)
            e->x[i] += f->place[i / 3][i % 3];
        if (i >= 3 * f->nodes)
            e->x[i] += i % 3 == 0 ? 0.2 : i % 3 == 1 ? 0.1 : gap;
    }
}

static double packed_at(const struct contact *e, int r, int c)
{
    return r < c ? packed_at(e, c, r) : e->packed[r * (r + 1) / 2 + c];
}

static void expect_tangents(int kind, const struct exact_face *f, const struct contact *e)
{
    const int n = 3 * (f->nodes + 1);
    static struct contact away[2];
    for (int c = 0; c < n; c++) {
        for (int side = 0; side < 2; side++) {
            away[side] = *e;
            away[side].x[c] += side ? -STEP : STEP;
            assemble(kind, f, &away[side]);
        }
        for (int r = 0; r < n; r++) {
            const double normal = (away[1].normal[r] - away[0].normal[r]) / (2 * STEP);
            const double tangential = (away[1].tangential[r] - away[0].tangential[r]) / (2 * STEP);
            if (!(fabs(packed_at(e, r, c) - normal) <= 1e-5 * STIFFNESS))
                fail_msg("kind %d, normal %d %d: %g, not %g", kind, r, c, packed_at(e, r, c), normal);
            if (!(fabs(e->full[n * r + c] - tangential) <= 1e-5 * STIFFNESS))
                fail_msg("kind %d, friction %d %d: %g, not %g", kind, r, c, e->full[n * r + c], tangential);
        }
    }
}

static void tangents_are_derivatives(void **state)
{
    uint64_t stream = 1;
    int slid = 0, stuck = 0, open = 0;
    (void)state;
    for (int kind = 0; kind < FOOTPOINT_FACES; kind++) {
        const struct exact_face f = exact_face_of(footpoint_face_nodes((enum footpoint_face)kind));
        for (int sample = 0; sample < SAMPLES; sample++) {
            static struct contact e;
            memset(&e, 0, sizeof e);
            draw(&stream, &f, sample % 4 == 3 ? 0.3 : -0.15, &e);
            e.xi0 = 0.2 + 0.05 * (sample % 3);
            e.eta0 = 0.15;
            e.multiplier = sample % 2 ? 2.5 : 0;
            e.friction = sample % 4 < 2 ? 0.05 : 5;
            assemble(kind, &f, &e);
            for (int i = 0; i < 3; i++) {
                double sum = 0, drag = 0;
                for (int k = 0; k <= f.nodes; k++) {
                    sum += e.normal[3 * k + i];
                    drag += e.tangential[3 * k + i];
                }
                assert_true(fabs(sum) + fabs(drag) <= 1e-12 * STIFFNESS);
            }
            double pull = 0;
            for (int i = 0; i < 3; i++)
                pull += e.tangential[3 * f.nodes + i] * e.tangential[3 * f.nodes + i];
            assert_true(sqrt(pull) <= (1 + 1e-12) * e.friction * e.pressure);
            open += e.pressure == 0;
            slid += e.pressure > 0 && e.slip[0] != 0;
            stuck += e.pressure > 0 && e.slip[0] == 0;
            expect_tangents(kind, &f, &e);
        }
    }
    assert_true(open > 5 && slid > 5 && stuck > 5);
}

/* Computes balanced forces at the foot point, in the order of coordinates. */
static void balanced_forces(const struct exact_face *f, const double *x, double *force)
{
    quadruple y[C];
    struct exact_foot foot;
    for (int i = 0; i < 15; i++)
        y[i] = x[i];
    assert_true(exact_foot_near(f, y, 0.2, 0.1, &foot));
    const double loc[2] = {(double)foot.xi, (double)foot.eta};
    assert_int_equal(
        footpoint_force_balanced(x, x + 3, x + 6, x + 9, x + 12, loc, STIFFNESS, force + 12, (double(*)[3])force),
        FOOTPOINT_OK);
}

/* At foot points, forces along xS - r equal those along the normal, and so do their derivatives. */
static void balanced_forces_have_the_same_tangent(void **state)
{
    const struct exact_face f = exact_face_of(4);
    uint64_t stream = 11;
    (void)state;
    for (int sample = 0; sample < SAMPLES; sample++) {
        static struct contact e;
        double force[15], away[2][15];
        memset(&e, 0, sizeof e);
        draw(&stream, &f, -0.15, &e);
        assemble(FOOTPOINT_QUAD4, &f, &e);
        balanced_forces(&f, e.x, force);
        for (int c = 0; c < 15; c++) {
            assert_true(fabs(force[c] - e.normal[c]) <= 1e-12 * STIFFNESS);
            for (int side = 0; side < 2; side++) {
                double x[15];
                memcpy(x, e.x, sizeof x);
                x[c] += side ? -STEP : STEP;
                balanced_forces(&f, x, away[side]);
            }
            for (int r = 0; r < 15; r++)
                assert_true(fabs(packed_at(&e, r, c) - (away[1][r] - away[0][r]) / (2 * STEP)) <= 1e-5 * STIFFNESS);
        }
    }
}

static double length(const double f[3])
{
    return sqrt(f[0] * f[0] + f[1] * f[1] + f[2] * f[2]);
}

/* Newton's residuals fall quadratically for a slave node on springs that is pressed into a face and drawn along it. */
static void newton_is_quadratic(void **state)
{
    static const double anchor[3] = {0.3, 0.2, -0.5}, springs = 10;
    (void)state;
    for (int kind = 0; kind < FOOTPOINT_FACES; kind++)
        for (int slides = 0; slides < 2; slides++) {
            const struct exact_face f = exact_face_of(footpoint_face_nodes((enum footpoint_face)kind));
            const int n = 3 * (f.nodes + 1), s = 3 * f.nodes;
            static struct contact e;
            uint64_t stream = 7;
            double residual[12], last = 1;
            int step = 0;
            memset(&e, 0, sizeof e);
            draw(&stream, &f, -0.05, &e);
            e.xi0 = 0.2;
            e.eta0 = 0.1;
            e.friction = slides ? 0.02 : 5;
            for (; step < 12 && last > 1e-12; step++) {
                double a[3][4];
                assemble(kind, &f, &e);
                for (int i = 0; i < 3; i++) {
                    a[i][3] = e.normal[s + i] + e.tangential[s + i] + springs * (anchor[i] - e.x[s + i]);
                    for (int j = 0; j < 3; j++)
                        a[i][j] = packed_at(&e, s + i, s + j) + e.full[n * (s + i) + s + j] + (i == j ? springs : 0);
                }
                const double f3[3] = {a[0][3], a[1][3], a[2][3]};
                residual[step] = last = length(f3);
                for (int k = 0; k < 3; k++)
                    for (int i = 0; i < 3; i++)
                        for (int j = 3; i != k && j >= k; j--)
                            a[i][j] -= a[i][k] / a[k][k] * a[k][j];
                for (int i = 0; i < 3; i++)
                    e.x[s + i] += a[i][3] / a[i][i];
            }
            if (!(last <= 1e-12))
                fail_msg("kind %d, slides %d: residual %g", kind, slides, last);
            assert_true((e.slip[0] != 0) == slides);
            /* each of the last residuals is below a constant times the square of its predecessor */
            for (int k = step - 2; k < step; k++)
                assert_true(k < 1 || residual[k] <= 1e-12 || residual[k] <= 2 * residual[k - 1] * residual[k - 1]);
        }
}

/* Drags the slave node of a square with sides 2 * 2^power from the middle to 0.1 below (0.3, 0.1); forces do not change
 * with the power. */
static int drag(int power, double eta, double slip[2], double force[15], double tangent[225])
{
    const double phi[4] = {0.25, 0.25, 0.25, 0.25}, normal[3] = {0, 0, 1}, square = 0.1;
    double x[15] = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0, 0.3, 0.1, -0.1}, r_xi[3] = {1, 0, 0},
           r_eta[3] = {1, eta, 0};
    double d_gap[15] = {0}, d_normal[45] = {0};
    for (int i = 0; i < 15; i++)
        x[i] = ldexp(x[i], power);
    for (int i = 0; i < 3; i++) {
        r_xi[i] = ldexp(r_xi[i], power);
        r_eta[i] = ldexp(r_eta[i], power);
    }
    for (int k = 0; k < 5; k++)
        d_gap[3 * k + 2] = k < 4 ? -0.25 : 1;
    const int status = footpoint_element_friction(4, x, phi, r_xi, r_eta, normal, d_gap, d_normal, 1, ldexp(5, -power),
                                                  0.5, ldexp(10, -power), slip, force, tangent);
    if (status == FOOTPOINT_OK) {
        const double rest = 1 - 0.5 / (10 * sqrt(square));
        assert_true(fabs(slip[0] - rest * (0.3 - 0.1 / eta)) <= 1e-13 / eta);
        assert_true(fabs(slip[1] - rest * 0.1 / eta) <= 1e-13 / eta);
        assert_true(fabs(force[12] + 0.5 * 0.3 / sqrt(square)) + fabs(force[13] + 0.5 * 0.1 / sqrt(square)) <= 1e-14);
    }
    return status;
}

/* Friction works in any unit of length from 1e-300 to 1e300, and for nearly parallel tangents. */
static void friction_takes_any_unit(void **state)
{
    static double force[15], tangent[225], at_one[225];
    double slip[2];
    (void)state;
    assert_int_equal(drag(0, 1, slip, force, at_one), FOOTPOINT_OK);
    for (int power = -990; power <= 990; power += 30) {
        assert_int_equal(drag(power, 1, slip, force, tangent), FOOTPOINT_OK);
        for (int i = 0; i < 225; i++)
            assert_true(fabs(ldexp(tangent[i], power) - at_one[i]) <= 1e-13);
    }
    for (double eta = 1; eta > 2e-10; eta *= 0.1)
        assert_int_equal(drag(0, eta, slip, force, tangent), FOOTPOINT_OK);
    assert_int_equal(drag(0, 1e-11, slip, force, tangent), FOOTPOINT_ERR_DEGENERATE);
}

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

/* For sizes and stiffnesses up to 1e305, all outputs are finite or untouched. */
static void friction_is_finite_or_refused(void **state)
{
    static double force[15], tangent[225];
    uint64_t stream = 20247;
    int answers = 0;
    (void)state;
    for (int sample = 0; sample < 20000; sample++) {
        const double size = pow(10, 610 * uniform(&stream) - 305), phi[4] = {0.1, 0.2, 0.3, 0.4}, normal[3] = {0, 0, 1},
                     r_xi[3] = {size, 0, 0}, r_eta[3] = {0, size, 0};
        double x[15], d_gap[15], d_normal[45], slip[2] = {77.25, 77.25};
        for (int i = 0; i < 45; i++) {
            x[i % 15] = size * (2 * uniform(&stream) - 1);
            d_gap[i % 15] = 2 * uniform(&stream) - 1;
            d_normal[i] = (2 * uniform(&stream) - 1) / size;
            tangent[i] = force[i % 15] = 77.25;
        }
        const double pressure = pow(10, 610 * uniform(&stream) - 305),
                     tangential = pow(10, 610 * uniform(&stream) - 305);
        const int status =
            footpoint_element_friction(4, x, phi, r_xi, r_eta, normal, d_gap, d_normal, pressure, pressure / size,
                                       sample % 7 ? 0.3 : 1e250, tangential, slip, force, tangent);
        if (status == FOOTPOINT_OK) {
            int finite = isfinite(slip[0]) && isfinite(slip[1]);
            for (int i = 0; i < 225; i++)
                finite = finite && isfinite(force[i % 15]) && isfinite(tangent[i]);
            assert_true(finite);
            answers++;
        } else {
            assert_int_equal(status, FOOTPOINT_ERR_NOT_FINITE);
            for (int i = 0; i < 45; i++)
                assert_true(tangent[i] == 77.25 && force[i % 15] == 77.25 && slip[i % 2] == 77.25);
        }
    }
    assert_in_range(answers, 5000, 19000);
}

/* The number of nodes must not overflow unnoticed: 3 (1431655765 + 1) is 2 modulo 2^32. */
static void nodes_are_counted(void **state)
{
    static double zero[C * C], out[C * C], pressure, slip[2];
    static const int wrong[] = {INT_MIN, -1431655766, -1, 0, 10, 715827882, 1431655765, INT_MAX};
    const double a[3] = {1, 0, 0}, b[3] = {0, 1, 0}, c[3] = {0, 0, 1};
    (void)state;
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        assert_int_equal(footpoint_element_normal(wrong[i], 0, zero, zero, 1, 0, &pressure, out, out),
                         FOOTPOINT_ERR_ARGUMENT);
        assert_int_equal(
            footpoint_element_friction(wrong[i], zero, zero, a, b, c, zero, zero, 1, 1, 1, 1, slip, out, out),
            FOOTPOINT_ERR_ARGUMENT);
    }
}

static void arguments_are_checked(void **state)
{
    static double many[C * C], out[C * C], pressure, slip[2];
    const double a[3] = {1, 0, 0}, b[3] = {0, 1, 0}, c[3] = {0, 0, 1};
    (void)state;
    assert_int_equal(footpoint_element_normal(1, 0, many, many, 1, 0, &pressure, out, out), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_element_normal(10, 0, many, many, 1, 0, &pressure, out, out), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_element_normal(4, 0, many, many, -1, 0, &pressure, out, out), FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_element_normal(4, (double)NAN, many, many, 1, 0, &pressure, out, out),
                     FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_element_friction(4, many, many, a, a, c, many, many, 1, 1, 1, 1, slip, out, out),
                     FOOTPOINT_ERR_DEGENERATE);
    assert_int_equal(footpoint_element_friction(4, many, many, a, b, c, many, many, 1, 1, 1, 0, slip, out, out),
                     FOOTPOINT_ERR_ARGUMENT);
    assert_int_equal(footpoint_element_normal(4, -1e200, many, many, 1e200, 0, &pressure, out, out),
                     FOOTPOINT_ERR_NOT_FINITE);
    double steep[15] = {0};
    steep[14] = 1e200;
    assert_int_equal(footpoint_element_normal(4, -1e150, steep, many, 1, 0, &pressure, out, out),
                     FOOTPOINT_ERR_NOT_FINITE);
    assert_int_equal(footpoint_element_normal(4, 1e200, many, many, 1e200, 0, &pressure, out, out), FOOTPOINT_OK);
    out[0] = slip[0] = 77.25;
    for (int bad = 0; bad < 3; bad++) { /* each bad number once reached an answer */
        double phi[4] = {bad == 0 ? INFINITY : 0.25, 0.25, 0.25, 0.25};
        assert_int_equal(footpoint_element_friction(4, many, phi, a, b, c, many, many, 1, bad == 1 ? INFINITY : 1, 1,
                                                    bad == 2 ? INFINITY : 1, slip, out, out),
                         FOOTPOINT_ERR_NOT_FINITE);
    }
    assert_true(out[0] == 77.25 && slip[0] == 77.25);
    many[4] = INFINITY;
    assert_int_equal(footpoint_element_friction(4, many, many, a, b, c, many, many, 1, 1, 1, 1, slip, out, out),
                     FOOTPOINT_ERR_NOT_FINITE);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(tangents_are_derivatives), cmocka_unit_test(balanced_forces_have_the_same_tangent),
        cmocka_unit_test(newton_is_quadratic),      cmocka_unit_test(friction_takes_any_unit),
        cmocka_unit_test(arguments_are_checked),    cmocka_unit_test(friction_is_finite_or_refused),
        cmocka_unit_test(nodes_are_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
