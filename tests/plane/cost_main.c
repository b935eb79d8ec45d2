/* Calls footpoint_edge3_accurate, or two Newton steps as FE codes write them, on the same ordinary edges, to count
 * instructions: cost_main accurate|closest|newton. */
#include "../../generated/footpoint_edge3.h"
#include "edge_judge.h"

#include <stdio.h>
#include <string.h>

enum { CALLS = 10000 };

typedef int search(double x[4][2], double *xi, double *gap);

__attribute__((noinline)) int counted_accurate(double x[4][2], double *xi, double *gap);
__attribute__((noinline)) int counted_closest(double x[4][2], double *xi, double *gap);
__attribute__((noinline)) int counted_newton(double x[4][2], double *xi, double *gap);

int counted_accurate(double x[4][2], double *xi, double *gap)
{
    return footpoint_edge3_accurate(x[0], x[1], x[2], x[3], xi, gap);
}

int counted_closest(double x[4][2], double *xi, double *gap)
{
    int region;
    return footpoint_edge3_accurate_closest(x[0], x[1], x[2], x[3], xi, gap, &region);
}

/* Computes r - S, tangent and second derivative at t. */
static inline void evaluate(double x[4][2], double t, double d[2], double u[2], double v[2])
{
    for (int i = 0; i < 2; i++) {
        d[i] = 0.5 * t * (t - 1) * x[0][i] + 0.5 * t * (t + 1) * x[1][i] + (1 - t * t) * x[2][i] - x[3][i];
        u[i] = (t - 0.5) * x[0][i] + (t + 0.5) * x[1][i] - 2 * t * x[2][i];
        v[i] = x[0][i] + x[1][i] - 2 * x[2][i];
    }
}

/* Starts from the slave node's projection on AB. */
int counted_newton(double x[4][2], double *xi, double *gap)
{
    const double h[2] = {x[1][0] - x[0][0], x[1][1] - x[0][1]};
    double d[2], u[2], v[2];
    double t = (h[0] * (2 * x[3][0] - x[0][0] - x[1][0]) + h[1] * (2 * x[3][1] - x[0][1] - x[1][1])) /
               (h[0] * h[0] + h[1] * h[1]);
    for (int k = 0; k < 2; k++) {
        evaluate(x, t, d, u, v);
        t -= (d[0] * u[0] + d[1] * u[1]) / (u[0] * u[0] + u[1] * u[1] + d[0] * v[0] + d[1] * v[1]);
    }
    evaluate(x, t, d, u, v);
    *xi = t;
    *gap = (d[1] * u[0] - d[0] * u[1]) / sqrt(u[0] * u[0] + u[1] * u[1]);
    return 0;
}

int main(int argc, char **argv)
{
    search *const call = argc < 2                           ? NULL
                         : strcmp(argv[1], "accurate") == 0 ? counted_accurate
                         : strcmp(argv[1], "closest") == 0  ? counted_closest
                         : strcmp(argv[1], "newton") == 0   ? counted_newton
                                                            : NULL;
    uint64_t stream = 1;
    int failed = 0;
    for (int i = 0; call && i < CALLS; i++) {
        double x[4][2], xi, gap;
        draw_edge(ORDINARY, &stream, 3, x);
        failed += call(x, &xi, &gap) != 0;
    }
    printf("%d of %d failed\n", failed, (int)CALLS);
    return !call || failed;
}
