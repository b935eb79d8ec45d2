/* Statuses of the library's quick search, batches, Newton's iteration, gap, forces and derivatives, compiled with any
 * flags. Every coordinate and every other number that is NaN or infinite is refused, and outputs stay untouched.
 * Segments without area are refused, ordinary segments are answered, at any size. Exit status 1 and a line for each
 * failure. */
#include "runtime/footpoint_batch.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { PAIRS = 70, OUTPUTS = 60 }; /* blocks of a batch and a rest; most doubles that a function writes */

/* The fifteen coordinates, then loc, m, stiffness and gap. */
enum { LOC = 15, NORMAL = 17, STIFFNESS = 20, GAP = 21, NUMBERS = 22 };

typedef int function(const double *x, double *out);
#ifndef POWER_STEP /* spacing of the tested sizes, as a power of 2 */
#define POWER_STEP 1
#endif
#define NODES(x) (x), (x) + 3, (x) + 6, (x) + 9, (x) + 12

static int locate(const double *x, double *out)
{
    return footpoint_locate(NODES(x), out, out + 2);
}

static int newton(const double *x, double *out)
{
    return footpoint_newton(NODES(x), 20, 1e-12, out, out + 2, NULL);
}

static int differentiate(const double *x, double *out)
{
    return footpoint_differentiate(NODES(x), x + LOC, (struct footpoint_derivatives *)(void *)out);
}

static int force(const double *x, double *out)
{
    return footpoint_force(x[GAP], x[STIFFNESS], x + NORMAL, x + LOC, out, (double(*)[3])(out + 3));
}

static int force_balanced(const double *x, double *out)
{
    return footpoint_force_balanced(NODES(x), x + LOC, x[STIFFNESS], out, (double(*)[3])(out + 3));
}

static int gap(const double *x, double *out)
{
    return footpoint_gap(NODES(x), x + LOC, x + NORMAL, out);
}

static int normal(const double *x, double *out)
{
    return footpoint_normal(x, x + 3, x + 9, out);
}

/* Puts the segment into a batch as number 40 of many ordinary pairs. */
static int batch(const double *x, double *out, enum footpoint_tier tier, int sure, int gaps)
{
    static double xyz[10][3], loc[PAIRS][2], g[PAIRS];
    static int32_t seg[PAIRS][4], slave[PAIRS];
    static const double ordinary[5][3] = {{0, 0, 0}, {1, 0, 0.05}, {1.1, 0.75, 0}, {0, 0.6, 0.05}, {0.35, 0.45, 0.125}};
    int status[PAIRS];
    memcpy(xyz, x, 15 * sizeof *x);
    memcpy(xyz[5], ordinary, sizeof ordinary);
    for (int i = 0; i < PAIRS; i++) {
        for (int k = 0; k < 4; k++)
            seg[i][k] = (i == 40 ? 0 : 5) + k;
        slave[i] = i == 40 ? 4 : 9;
    }
    memcpy(loc[40], out, sizeof loc[40]);
    g[40] = out[2];
    const struct footpoint_pairs p = {.n = PAIRS,
                                      .nodes = 10,
                                      .x = xyz[0],
                                      .y = xyz[0] + 1,
                                      .z = xyz[0] + 2,
                                      .stride = 3,
                                      .seg = seg[0],
                                      .slave = slave,
                                      .sure = sure};
    const size_t failed = footpoint_locate_batch(&p, tier, loc[0], gaps ? g : NULL, status);
    memcpy(out, loc[40], sizeof loc[40]);
    out[2] = g[40];
    size_t others = 0;
    for (int i = 0; i < PAIRS; i++)
        others += status[i] != FOOTPOINT_OK;
    return failed == others ? status[40] : -1;
}

#define BATCH(tier, name)                                                                                              \
    static int name(const double *x, double *out)                                                                      \
    {                                                                                                                  \
        return batch(x, out, tier, 0, 1);                                                                              \
    }
BATCH(FOOTPOINT_FAST, batch_fast)
BATCH(FOOTPOINT_COARSE, batch_coarse)
BATCH(FOOTPOINT_MEDIUM, batch_medium)
BATCH(FOOTPOINT_FULL, batch_full)

static int batch_sure(const double *x, double *out)
{
    return batch(x, out, FOOTPOINT_ACCURATE, 1, 1);
}

static int batch_without_gaps(const double *x, double *out)
{
    return batch(x, out, FOOTPOINT_FULL, 0, 0);
}

static int pairs(const double *x, double *out)
{
    static const int seg[4] = {0, 1, 2, 3}, slave = 4;
    int status;
    footpoint_locate_pairs(1, x, 5, seg, &slave, out, out + 2, &status);
    return status;
}

static int prepared(const double *x, double *out)
{
    struct footpoint_segment s;
    int status = footpoint_prepare(x, x + 3, x + 6, x + 9, &s);
    if (status == FOOTPOINT_OK)
        footpoint_locate_prepared(&s, FOOTPOINT_FULL, 1, x + 12, out, out + 2, &status);
    return status;
}

static const struct {
    const char *name;
    function *call;
    const char *reads; /* a letter for each of NUMBERS: x if the function reads it */
    int searches;      /* finds xi, eta and gap */
} functions[] = {{"footpoint_locate", locate, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_newton", newton, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_pairs", pairs, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_prepared", prepared, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, fast", batch_fast, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, coarse", batch_coarse, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, medium", batch_medium, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, full", batch_full, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, sure", batch_sure, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_locate_batch, no gaps", batch_without_gaps, "xxxxxxxxxxxxxxx.......", 1},
                 {"footpoint_differentiate", differentiate, "xxxxxxxxxxxxxxxxx.....", 0},
                 {"footpoint_force", force, "...............xxxxxxx", 0},
                 {"footpoint_force_balanced", force_balanced, "xxxxxxxxxxxxxxxxx...x.", 0},
                 {"footpoint_gap", gap, "xxxxxxxxxxxxxxxxxxxx..", 0},
                 {"footpoint_normal", normal, "xxxxxx...xxx..........", 0}};
enum { FUNCTIONS = sizeof functions / sizeof *functions };

static const double usual[NUMBERS] = {0,      0,     0,      1,     0,     0.0625, 1.125, 0.75, 0,   0, 0.625,
                                      0.0625, 0.375, 0.4375, 0.125, -0.25, 0.25,   0,     0.6,  0.8, 1, -0.5};
static int failures;

static void expect(int f, const double *x, int expected, const char *what, int number)
{
    double out[OUTPUTS], before[OUTPUTS];
    for (int i = 0; i < OUTPUTS; i++)
        out[i] = before[i] = 77.25;
    int status = functions[f].call(x, out);
#ifdef __FAST_MATH__ /* compiled without proofs */
    status = status == FOOTPOINT_UNPROVED ? FOOTPOINT_OK : status;
#endif
    const int same = memcmp(out, before, sizeof out) == 0;
    if ((status != expected || same == (expected == FOOTPOINT_OK)) && failures++ < 20)
        printf("%s, %s %d: status %d, outputs %s\n", functions[f].name, what, number, status,
               same ? "kept" : "written");
}

/* Tests NaN of either sign and both infinities, made of their bits. */
static void test_not_finite(int f)
{
    static const uint64_t bad[4] = {0x7ff8000000000000, 0xfff8000000000000, 0x7ff0000000000000, 0xfff0000000000000};
    for (int i = 0; i < NUMBERS; i++)
        for (int b = 0; b < 4; b++) {
            double x[NUMBERS];
            memcpy(x, usual, sizeof x);
            memcpy(&x[i], &bad[b], sizeof x[i]);
            expect(f, x, functions[f].reads[i] == 'x' ? FOOTPOINT_ERR_NOT_FINITE : FOOTPOINT_OK, "not finite", i);
        }
}

static void test_sizes(int f)
{
    double at_one[OUTPUTS];
    functions[f].call(usual, at_one);
    for (int power = -992; power <= 992; power += POWER_STEP) {
        double x[NUMBERS], flat[NUMBERS], out[OUTPUTS];
        memcpy(x, usual, sizeof x);
        memcpy(flat, usual, sizeof flat);
        for (int i = 0; i < 15; i++) {
            x[i] = ldexp(x[i], power);
            flat[i] = ldexp(i < 12 ? (double)((i % 3 + 1) * (i / 3)) : usual[i], power);
        }
        expect(f, flat, FOOTPOINT_ERR_DEGENERATE, "no area", power);
        expect(f, x, FOOTPOINT_OK, "size", power);
        functions[f].call(x, out);
        if (!(fabs(out[0] - at_one[0]) < 1e-9 && fabs(out[1] - at_one[1]) < 1e-9) && failures++ < 20)
            printf("%s, size %d: xi %g eta %g\n", functions[f].name, power, out[0], out[1]);
    }
}

/* Moves a corner onto the next, with the slave node over the middle of the rest. */
static void test_collapsed(int f)
{
    for (int edge = 0; edge < 4; edge++) {
        double x[NUMBERS];
        memcpy(x, usual, sizeof x);
        memcpy(&x[3 * edge], &x[3 * ((edge + 1) % 4)], 3 * sizeof *x);
        for (int k = 0; k < 3; k++)
            x[12 + k] = (x[k] + x[3 + k] + x[6 + k] + x[9 + k]) / 4 + (k == 2 ? 0.0625 : 0);
        expect(f, x, FOOTPOINT_OK, "collapsed edge", edge);
    }
}

int main(void)
{
    for (int f = 0; f < FUNCTIONS; f++) {
        test_not_finite(f);
        if (functions[f].searches) {
            test_sizes(f);
            test_collapsed(f);
        }
    }
    return failures != 0;
}
