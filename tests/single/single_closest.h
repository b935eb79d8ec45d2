/* Closest points of curved faces in float, called with doubles that are floats; for test_closest_curved.c. */
#ifndef FOOTPOINT_TESTS_SINGLE_CLOSEST_H
#define FOOTPOINT_TESTS_SINGLE_CLOSEST_H

enum { CASES_LONG = 100000, FUNCTIONS = 9, COLUMNS = 3 * CURVED_NODES + 3 };
#define BORDER 3e-4    /* of xi and eta: nearer than this to the border of a region, either is right */
#define TIE 3.01e-5    /* distances this much apart, over the longest edge, are equal */
#define ROUNDING 2e-5  /* of distances */
#define ON_EDGE 1.3e-7 /* of xi and eta */
#define OVER 3.1e-8    /* the sum of xi and eta may exceed 1 by this */

static void round_case(struct curved_case *f)
{
    for (int k = 0; k <= f->kind->nodes; k++)
        for (int i = 0; i < 3; i++)
            f->x[k][i] = (double)single_round(f->x[k][i]);
}
#define ROUND(f) round_case(f)
/* % that must be proved, by group, of promises above COARSE */
#define COARSE 1e-4
#define PROVED_LEAST                                                                                                   \
    {                                                                                                                  \
        98, 60, 50, 0, 0, 85, 0, 0                                                                                     \
    }

typedef int one_single(const float *const *x, float loc[2], float *dist, int *region);
typedef void many_single(size_t n, const float *const *x, float *xi, float *eta, float *dist, int *region, int *status);
typedef int of_many_single(size_t n, const float *const *x, const float *xs, float loc[2], float *dist, int *region,
                           size_t *which);

static void widen(int status, const float from[2], float dist, double loc[2], double *to)
{
    if (status < 0)
        return;
    loc[0] = (double)from[0];
    loc[1] = (double)from[1];
    *to = (double)dist;
}

static int call_one(one_single *call, int nodes, const double *const *x, const double *s, double loc[2], double *dist,
                    int *region)
{
    float y[CURVED_NODES + 1][3], at[2] = {0, 0}, d = 0;
    const float *row[CURVED_NODES + 1];
    for (int k = 0; k <= nodes; k++) {
        row[k] = y[k];
        for (int i = 0; i < 3; i++)
            y[k][i] = (float)(k < nodes ? x[k] : s)[i];
    }
    const int status = call(row, at, &d, region);
    widen(status, at, d, loc, dist);
    return status;
}

static void call_many(many_single *call, int nodes, size_t n, const double *const *x, double *xi, double *eta,
                      double *dist, int *region, int *status)
{
    static float column[COLUMNS][PAIRS], found[3][PAIRS];
    const float *c[COLUMNS];
    for (int k = 0; k < 3 * nodes + 3; k++) {
        c[k] = column[k];
        for (size_t i = 0; i < n; i++)
            column[k][i] = (float)x[k][i];
    }
    call(n, c, found[0], found[1], found[2], region, status);
    for (size_t i = 0; i < n; i++) {
        xi[i] = (double)found[0][i];
        eta[i] = (double)found[1][i];
        dist[i] = (double)found[2][i];
    }
}

static int call_of_many(of_many_single *call, int nodes, size_t n, const double *const *x, const double *xs,
                        double loc[2], double *dist, int *region, size_t *which)
{
    float y[CURVED_NODES * SEVERAL][3], at[2] = {0, 0}, d = 0;
    const float *row[CURVED_NODES * SEVERAL], s[3] = {(float)xs[0], (float)xs[1], (float)xs[2]};
    for (int k = 0; k < nodes * (int)n; k++) {
        row[k] = y[k];
        for (int i = 0; i < 3; i++)
            y[k][i] = (float)x[k][i];
    }
    const int status = call(n, row, s, at, &d, region, which);
    widen(status, at, d, loc, dist);
    return status;
}

#define ALL(F)                                                                                                         \
    F(6, tri6, fast, TRI6_FLOAT_FAST)                                                                                  \
    F(6, tri6, balanced, TRI6_FLOAT_BALANCED)                                                                          \
    F(6, tri6, fine, TRI6_FLOAT_FINE)                                                                                  \
    F(8, quad8, fast, QUAD8_FLOAT_FAST)                                                                                \
    F(8, quad8, balanced, QUAD8_FLOAT_BALANCED)                                                                        \
    F(8, quad8, fine, QUAD8_FLOAT_FINE)                                                                                \
    F(9, quad9, fast, QUAD9_FLOAT_FAST)                                                                                \
    F(9, quad9, balanced, QUAD9_FLOAT_BALANCED)                                                                        \
    F(9, quad9, fine, QUAD9_FLOAT_FINE)
#define WRAP(nodes, kind, tier, capitals)                                                                              \
    static int single_##kind##_##tier(const float *const *x, float loc[2], float *dist, int *region)                   \
    {                                                                                                                  \
        return footpoint_##kind##_float_##tier##_closest(X##nodes, x[nodes], loc, dist, region);                       \
    }                                                                                                                  \
    static int one_##kind##_##tier(const double *const *x, const double *s, double loc[2], double *dist, int *region)  \
    {                                                                                                                  \
        return call_one(single_##kind##_##tier, nodes, x, s, loc, dist, region);                                       \
    }                                                                                                                  \
    static void many_##kind##_##tier(size_t n, const double *const *x, double *xi, double *eta, double *dist,          \
                                     int *region, int *status)                                                         \
    {                                                                                                                  \
        call_many(footpoint_##kind##_float_##tier##_closest_n, nodes, n, x, xi, eta, dist, region, status);            \
    }                                                                                                                  \
    static int of_##kind##_##tier(size_t n, const double *const *x, const double *xs, double loc[2], double *dist,     \
                                  int *region, size_t *which)                                                          \
    {                                                                                                                  \
        return call_of_many(footpoint_##kind##_float_##tier##_closest_of, nodes, n, x, xs, loc, dist, region, which);  \
    }
ALL(WRAP)
#define ROW(nodes, kind, tier, capitals)                                                                               \
    {#kind "_" #tier,   nodes, (double)FOOTPOINT_##capitals##_PROMISE, one_##kind##_##tier, many_##kind##_##tier,      \
     of_##kind##_##tier},

#endif
