/* What derivatives of a foot point cost, search and all: the headers' beside the implicit function theorem by hand, forward
 * differentiation through Newton's iteration and central differences.  Interleaved in one run on ordinary four-node segments;
 * prints lines
 *     call,ns,ratio,off   ns: least a pair; ratio: forward differentiation's ns / this one's; off: worst difference of
 *                         the derivatives from the header's behind Newton's accuracy, over the greatest of the pair
 * tests/timed/derivatives.sh runs it. */
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_quad4_derivatives.h"
#include "../../runtime/footpoint.h"
#include "../hard/draw.h"
#include "../hard/hard.h"
#include "../rivals/rivals_derivatives.h"

#include <math.h>
#include <stdio.h>
#include <time.h>

/* No power of 2: columns that begin at the same places of the cache would drive each other out. */
enum { CASES = 500, ROUNDS = 400 };
#define STEP 1e-6 /* of differences */

static struct hard_case cases[CASES];
static double column[15][CASES], xi[CASES], eta[CASES], loc[CASES][2], gap[CASES], hessian[CASES][120];
static double rows[4][4 * CASES], by_xi[15 * CASES], by_eta[15 * CASES], by_gap[15 * CASES];
static const double *columns[15];
static int status[CASES];
static struct rival_derivatives got[CASES];
static struct footpoint_derivatives library[CASES];

#define NODES(i) cases[i].x[0], cases[i].x[1], cases[i].x[2], cases[i].x[3], cases[i].x[4]
#define POINTERS(i)                                                                                                    \
    {                                                                                                                  \
        NODES(i)                                                                                                       \
    }

static void search_at(void)
{
    for (int i = 0; i < CASES; i++)
        footpoint_quad4_accurate_at(NODES(i), &loc[i][0], &loc[i][1]);
}

static void search_checked(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_quad4_accurate(NODES(i), loc[i], &gap[i]);
}

static void gradients(void)
{
    for (int i = 0; i < CASES; i++) {
        footpoint_quad4_accurate_at(NODES(i), &loc[i][0], &loc[i][1]);
        status[i] = footpoint_quad4_gradients(NODES(i), loc[i], NULL, NULL, NULL, NULL, &got[i].gap, got[i].xi,
                                              got[i].eta, got[i].by_gap);
    }
}

static void gradients_exact(void)
{
    for (int i = 0; i < CASES; i++) {
        footpoint_quad4_full_at(NODES(i), &loc[i][0], &loc[i][1]);
        status[i] = footpoint_quad4_gradients(NODES(i), loc[i], NULL, NULL, NULL, NULL, &got[i].gap, got[i].xi,
                                              got[i].eta, got[i].by_gap);
    }
}

static void second(void)
{
    for (int i = 0; i < CASES; i++) {
        footpoint_quad4_accurate_at(NODES(i), &loc[i][0], &loc[i][1]);
        status[i] = footpoint_quad4_hessian(NODES(i), loc[i], &got[i].gap, got[i].xi, got[i].eta, got[i].by_gap, NULL,
                                            hessian[i]);
    }
}

FOOTPOINT_QUAD4_GRADIENTS_OF(footpoint_quad4_accurate)
FOOTPOINT_QUAD4_HESSIAN_OF(footpoint_quad4_accurate)

static void gradients_joined(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_quad4_accurate_gradients(NODES(i), loc[i], NULL, NULL, NULL, NULL, &got[i].gap, got[i].xi,
                                                       got[i].eta, got[i].by_gap);
}

static void second_joined(void)
{
    for (int i = 0; i < CASES; i++)
        status[i] = footpoint_quad4_accurate_hessian(NODES(i), loc[i], &got[i].gap, got[i].xi, got[i].eta,
                                                     got[i].by_gap, NULL, hessian[i]);
}

static void differentiate(void)
{
    for (int i = 0; i < CASES; i++) {
        status[i] = footpoint_quad4_accurate(NODES(i), loc[i], &gap[i]);
        status[i] = footpoint_differentiate(NODES(i), loc[i], &library[i]);
    }
}

static void implicit(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = POINTERS(i);
        status[i] = footpoint_quad4_accurate(NODES(i), loc[i], &gap[i]);
        rival_implicit(x, loc[i][0], loc[i][1], &got[i]);
    }
}

static void forward(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = POINTERS(i);
        rival_forward(x, &got[i]);
    }
}

static void search_full(const double *const *x, double *u, double *v, double *distance)
{
    double at[2] = {0, 0};
    (void)footpoint_quad4_full(x[0], x[1], x[2], x[3], x[4], at, distance);
    *u = at[0];
    *v = at[1];
}

static void differences(void)
{
    for (int i = 0; i < CASES; i++) {
        const double *const x[5] = POINTERS(i);
        rival_differences(x, STEP, search_full, &got[i]);
    }
}

static void arrays(void)
{
    footpoint_quad4_accurate_n(CASES, columns, xi, eta);
    footpoint_quad4_gradients_n(CASES, columns, xi, eta, rows[0], rows[1], rows[2], rows[3], gap, by_xi, by_eta, by_gap,
                                status);
}

static void arrays_joined(void)
{
    footpoint_quad4_accurate_gradients_n(CASES, columns, xi, eta, rows[0], rows[1], rows[2], rows[3], gap, by_xi,
                                         by_eta, by_gap, status);
}

static void arrays_alone(void)
{
    footpoint_quad4_gradients_n(CASES, columns, xi, eta, rows[0], rows[1], rows[2], rows[3], gap, by_xi, by_eta, by_gap,
                                status);
}

static const struct call {
    const char *name;
    void (*run)(void);
    int leaves; /* derivatives in `got` */
} calls[] = {{"forward through Newton", forward, 1},
             {"central differences", differences, 1},
             {"accurate, implicit by hand", implicit, 1},
             {"accurate, footpoint_differentiate", differentiate, 0},
             {"accurate_at, gradients", gradients, 1},
             {"accurate_gradients", gradients_joined, 1},
             {"accurate_at, hessian", second, 1},
             {"accurate_hessian", second_joined, 1},
             {"accurate_at", search_at, 0},
             {"accurate", search_checked, 0},
             {"accurate_n, gradients_n", arrays, 0},
             {"accurate_gradients_n", arrays_joined, 0},
             {"gradients_n", arrays_alone, 0}};
enum { CALLS = sizeof calls / sizeof *calls };

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static double worst(const struct call *call)
{
    static struct rival_derivatives exact[CASES];
    double off = 0;
    gradients_exact();
    for (int i = 0; i < CASES; i++)
        exact[i] = got[i];
    call->run();
    for (int i = 0; i < CASES; i++) {
        double most = 0;
        for (int k = 0; k < 15; k++)
            most = fmax(most, fmax(fabs(exact[i].xi[k]), fabs(exact[i].eta[k])));
        for (int k = 0; k < 15; k++)
            off =
                fmax(off, fmax(fmax(fabs(got[i].xi[k] - exact[i].xi[k]), fabs(got[i].eta[k] - exact[i].eta[k])) / most,
                               fabs(got[i].by_gap[k] - exact[i].by_gap[k])));
    }
    return off;
}

int main(void)
{
    double least[CALLS];
    for (int i = 0; i < CASES; i++) {
        hard_draw(0, 1, (uint64_t)i, &cases[i]);
        for (int k = 0; k < 15; k++)
            column[k][i] = cases[i].x[k / 3][k % 3];
    }
    for (int k = 0; k < 15; k++)
        columns[k] = column[k];
    for (int c = 0; c < CALLS; c++)
        least[c] = HUGE_VAL;
    for (int round = 0; round < ROUNDS; round++)
        for (int c = 0; c < CALLS; c++) {
            const double start = seconds();
            calls[c].run();
            least[c] = fmin(least[c], seconds() - start);
        }
    printf("call,ns,ratio,off\n");
    for (int c = 0; c < CALLS; c++) {
        printf("\"%s\",%.1f,%.1f,", calls[c].name, 1e9 * least[c] / CASES, least[0] / least[c]);
        if (calls[c].leaves)
            printf("%.1e", worst(&calls[c]));
        putchar('\n');
    }
    return 0;
}
