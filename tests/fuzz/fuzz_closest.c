/* Fuzzes the search functions: 120 bytes are fifteen numbers of any kind, fewer are coordinates on a coarse grid.
 * Statuses must be known, written outputs finite and others unchanged, and no point of a grid over the segment may be
 * nearer than the closest point.  Built with clang -fsanitize=fuzzer by tests/long/fuzz_closest.sh; with -DREPLAY a
 * program that reads the given files. */
#include "../../runtime/footpoint.h"
#include "../../runtime/geometry/footpoint-quad4-geometry.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { GRID = 4 };

#define UNTOUCHED 77.25
#define NODES x[0], x[1], x[2], x[3], x[4]

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(int good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "%s\n", what);
    abort();
}

static void check_status(int status)
{
    require(status >= FOOTPOINT_STATUS_LEAST && status <= FOOTPOINT_STATUS_MOST, "a status that is none");
}

static double distance_at(double x[5][3], double xi, double eta)
{
    double d[3];
    footpoint_quad4_offset(NODES, xi, eta, d);
    return hypot(hypot(d[0], d[1]), d[2]);
}

static void check_robust(double x[5][3])
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, dist = UNTOUCHED, size = 0;
    const int status = footpoint_robust(NODES, loc, &dist);
    check_status(status);
    if (status < FOOTPOINT_OK) {
        require(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && dist == UNTOUCHED, "robust wrote something");
        return;
    }
    require(fabs(loc[0]) <= 1 && fabs(loc[1]) <= 1 && isfinite(dist), "robust left the segment");
    for (int i = 0; i < 4; i++)
        for (int k = 0; k < 3; k++)
            size = fmax(size, fabs(x[i][k] - x[0][k]));
    for (int i = 0; i <= GRID; i++)
        for (int j = 0; j <= GRID; j++) {
            const double d = distance_at(x, 2.0 * i / GRID - 1, 2.0 * j / GRID - 1);
            require(!(d < fabs(dist) * (1 - 1e-10) - 1e-10 * size - 1e-320), "a nearer point");
        }
}

static void check_locate(double x[5][3])
{
    double loc[2] = {UNTOUCHED, UNTOUCHED}, gap = UNTOUCHED, rho[2];
    struct footpoint_derivatives derivatives;
    int status = footpoint_locate(NODES, loc, &gap);
    check_status(status);
    if (status != FOOTPOINT_OK) {
        require(loc[0] == UNTOUCHED && loc[1] == UNTOUCHED && gap == UNTOUCHED, "locate wrote something");
        return;
    }
    require(isfinite(loc[0]) && isfinite(loc[1]) && isfinite(gap), "locate is not finite");
    status = footpoint_certify(NODES, loc, rho);
    check_status(status);
    require(status != FOOTPOINT_OK || (isfinite(rho[0]) && isfinite(rho[1])), "rho is not finite");
    check_status(footpoint_differentiate(NODES, loc, &derivatives));
}

static void check_others(double x[5][3])
{
    double points[FOOTPOINT_STATIONARY_MOST][2], loc[2], gap;
    int count = -1;
    const int status = footpoint_stationary(NODES, points, &count);
    check_status(status);
    if (status == FOOTPOINT_OK || status == FOOTPOINT_NOT_UNIQUE)
        for (int k = 0; k < count; k++)
            require(fabs(points[k][0]) <= 1 && fabs(points[k][1]) <= 1, "a stationary point outside");
    check_status(footpoint_newton(NODES, 20, 1e-12, loc, &gap, NULL));
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    double x[5][3];
    if (size == 0)
        return 0;
    if (size >= sizeof x)
        memcpy(x, data, sizeof x);
    else
        for (size_t k = 0; k < 15; k++)
            x[k / 3][k % 3] = (data[k % size] % 16 - 8) / 4.0;
    check_locate(x);
    check_robust(x);
    check_others(x);
    return 0;
}

#ifdef REPLAY
int main(int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        uint8_t data[256];
        FILE *in = fopen(argv[i], "rb");
        require(in != NULL, argv[i]);
        LLVMFuzzerTestOneInput(data, fread(data, 1, sizeof data, in));
        fclose(in);
    }
    return 0;
}
#endif
