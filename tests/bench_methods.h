/* Every search that footpoint-bench compares, in one table: converged Newton, the rivals, and the generated functions.
 * Each is compiled twice, with the search inlined: as a function of one sample, and as a loop over columns of samples.
 * For bench_main.c alone, which finds methods.h, methods.inc, the perceptrons' footpoint_perceptron.h and .inc, and
 * rival_counts.inc in the build folder. */
#ifndef FOOTPOINT_BENCH_METHODS_H
#define FOOTPOINT_BENCH_METHODS_H

#include "../evolve/sample.h"
#include "footpoint_perceptron.h"
#include "methods.h"
#include "pinball.h"
#include "rivals.h"

#include <stddef.h>
#include <string.h>

enum { BENCH_BLOCK = 256 };

/** Samples by columns: coordinates of A, B, C, D, S. */
struct bench_block {
    double x[15][BENCH_BLOCK];
    double xi[BENCH_BLOCK], eta[BENCH_BLOCK]; /* what a search found */
};

struct bench_counts {
    const char *name;
    long mul, div, add, sqrt;
};

struct bench_method {
    const char *scene; /* the one it was made for, or NULL: any */
    enum rival_start start;
    struct bench_counts ops;
    void (*one)(const struct sample *s, double found[2]);
    void (*batch)(struct bench_block *b);
    bool rival;      /* made for a scene, but none of ours */
    bool depth_only; /* finds no xi, eta */
};

#define BENCH_ONE(function, search)                                                                                    \
    __attribute__((noinline)) static void one_##function(const struct sample *s, double found[2])                      \
    {                                                                                                                  \
        search(s->x[0], s->x[1], s->x[2], s->x[3], s->xs, &found[0], &found[1]);                                       \
    }
#define BENCH_BATCH(function, search)                                                                                  \
    __attribute__((noinline)) static void batch_##function(struct bench_block *b)                                      \
    {                                                                                                                  \
        for (int i = 0; i < BENCH_BLOCK; i++) {                                                                        \
            const double xA[3] = {b->x[0][i], b->x[1][i], b->x[2][i]}, xB[3] = {b->x[3][i], b->x[4][i], b->x[5][i]};   \
            const double xC[3] = {b->x[6][i], b->x[7][i], b->x[8][i]}, xD[3] = {b->x[9][i], b->x[10][i], b->x[11][i]}; \
            const double xS[3] = {b->x[12][i], b->x[13][i], b->x[14][i]};                                              \
            search(xA, xB, xC, xD, xS, &b->xi[i], &b->eta[i]);                                                         \
        }                                                                                                              \
    }
#define BENCH_FUNCTIONS(function, search) BENCH_ONE(function, search) BENCH_BATCH(function, search)

/* Without convergence there is no answer. */
static inline int bench_newton_iterations(const double xA[3], const double xB[3], const double xC[3],
                                          const double xD[3], const double xS[3], double *xi, double *eta)
{
    const int n = rival_newton(xA, xB, xC, xD, xS, RIVAL_NEWTON_MAX, RIVAL_NEWTON_TOLERANCE, xi, eta);
    if (n == 0)
        *xi = *eta = (double)NAN;
    return n;
}

#define BENCH_ITERATION(name, start, gauss_newton, newton, clamped) BENCH_FUNCTIONS(name, rival_##name)
#define BENCH_CLOSED_FORM(name) BENCH_FUNCTIONS(name, rival_##name)
#define METHOD(scene, function, mul, div, add, sqrt) BENCH_FUNCTIONS(function, function##_at)
BENCH_FUNCTIONS(newton, bench_newton_iterations)
RIVAL_ITERATIONS(BENCH_ITERATION)
RIVAL_CLOSED_FORMS(BENCH_CLOSED_FORM)
BENCH_CLOSED_FORM(pinball)
#include "footpoint_perceptron.inc"
#include "methods.inc"
#undef METHOD
#undef BENCH_ITERATION
#undef BENCH_CLOSED_FORM

static const struct bench_counts bench_counts[] = {
#include "rival_counts.inc"
};

static inline struct bench_counts bench_counts_of(const char *name)
{
    struct bench_counts none = {name, 0, 0, 0, 0};
    for (size_t i = 0; i < sizeof bench_counts / sizeof *bench_counts; i++)
        if (strcmp(bench_counts[i].name, name) == 0)
            return bench_counts[i];
    return none;
}

/* Newton stands first.  Its operations and those of the rivals are looked up by name. */
#define BENCH_RIVAL(name, start) {NULL, start, {#name, 0, 0, 0, 0}, one_##name, batch_##name, true, false},
#define BENCH_ITERATION(name, start, gauss_newton, newton, clamped) BENCH_RIVAL(name, start)
#define BENCH_CLOSED_FORM(name) BENCH_RIVAL(name, RIVAL_CENTRE)
#define METHOD(scene, function, mul, div, add, sqrt)                                                                   \
    {scene, RIVAL_CENTRE, {#function, mul, div, add, sqrt}, one_##function, batch_##function, false, false},
static const struct bench_method bench_methods[] = {
    BENCH_CLOSED_FORM(newton) RIVAL_ITERATIONS(BENCH_ITERATION) RIVAL_CLOSED_FORMS(BENCH_CLOSED_FORM){
        NULL, RIVAL_CENTRE, {"pinball", 0, 0, 0, 0}, one_pinball, batch_pinball, true, true},
#include "methods.inc"
#undef METHOD
/* They go by perceptron_hidden_8 and so on. */
#define METHOD(scene, function, mul, div, add, sqrt)                                                                   \
    {scene, RIVAL_CENTRE, {&#function[sizeof "footpoint"], mul, div, add, sqrt}, one_##function, batch_##function,     \
     true,  false},
#include "footpoint_perceptron.inc"
};
#undef METHOD

enum { BENCH_METHODS = sizeof bench_methods / sizeof *bench_methods };

#endif
