/* Compares the speed of the emitted functions with the same formulas written by hand (handwritten.h), and with the
 * genomes' values computed one by one as written (as_written.h, which as_written_main.c makes). Prints CSV, a line for
 * each method and mode, for tests/timed/handwritten.sh.
 *
 * All three are compiled alike, and inlined alike into a function of one search, "scalar", and into a loop over columns
 * of coordinates, "batch"; ours is NAME_n. They take turns, ROUNDS times. A ratio is the median over the rounds of the
 * other's time over ours in the same round, so that other load affects both. */

/* Otherwise clang neither inlines the larger functions nor vectorises the loops. */
#define FOOTPOINT_FN static inline __attribute__((always_inline))
#include "../../generated/footpoint_blocks_quad4.h"
#include "../../generated/footpoint_paper_quad4.h"
#include "../../generated/footpoint_punch_quad4.h"
#include "../../generated/footpoint_quad4.h"
#include "../../generated/footpoint_whole_quad4.h"
#include "../support/ordinary_quad.h"
#include "as_written.h"
#include "handwritten.h"

#include <math.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A block and its results fit into the first cache; its columns are not a power of two apart. */
enum { SAMPLES = 120, BLOCKS = 24, REPEATS = 2, ROUNDS = 101 };
#define TOLERANCE 1e-12 /* largest difference between the answers of the three, in xi and eta */

static struct block {
    struct quad quad[SAMPLES];
    double x[15][SAMPLES]; /* the same by columns: coordinates of A, B, C, D, S */
    double found[2][SAMPLES];
} blocks[BLOCKS];

struct rival_search {
    void (*one)(const struct quad *q, double found[2]);
    void (*batch)(struct block *b);
};

#define DEFINE_ONE(function)                                                                                           \
    __attribute__((noinline)) static void one_##function(const struct quad *q, double found[2])                        \
    {                                                                                                                  \
        function(q->x[0], q->x[1], q->x[2], q->x[3], q->xs, &found[0], &found[1]);                                     \
    }
#define DEFINE_OURS(name)                                                                                              \
    DEFINE_ONE(footpoint_##name##_at)                                                                                  \
    __attribute__((noinline)) static void batch_footpoint_##name##_at(struct block *s)                                 \
    {                                                                                                                  \
        const double *x[15];                                                                                           \
        for (int k = 0; k < 15; k++)                                                                                   \
            x[k] = s->x[k];                                                                                            \
        footpoint_##name##_n(SAMPLES, x, s->found[0], s->found[1]);                                                    \
    }
#define DEFINE(function)                                                                                               \
    DEFINE_ONE(function)                                                                                               \
    __attribute__((noinline)) static void batch_##function(struct block *s)                                            \
    {                                                                                                                  \
        for (int i = 0; i < SAMPLES; i++) {                                                                            \
            const double xA[3] = {s->x[0][i], s->x[1][i], s->x[2][i]}, xB[3] = {s->x[3][i], s->x[4][i], s->x[5][i]};   \
            const double xC[3] = {s->x[6][i], s->x[7][i], s->x[8][i]}, xD[3] = {s->x[9][i], s->x[10][i], s->x[11][i]}; \
            const double xS[3] = {s->x[12][i], s->x[13][i], s->x[14][i]};                                              \
            function(xA, xB, xC, xD, xS, &s->found[0][i], &s->found[1][i]);                                            \
        }                                                                                                              \
    }
/* Bred functions, and those that nobody would write by hand, are compared only with their genome as written. */
#define METHODS(M)                                                                                                     \
    M(blocks_quad4_fast, hand_fast)                                                                                    \
    M(blocks_quad4_coarse, written_blocks_quad4_coarse)                                                                \
    M(blocks_quad4_gauss2, hand_gauss2)                                                                                \
    M(blocks_quad4_medium, written_blocks_quad4_medium)                                                                \
    M(blocks_quad4_balanced, written_blocks_quad4_balanced)                                                            \
    M(blocks_quad4_fine, written_blocks_quad4_fine)                                                                    \
    M(blocks_quad4_accurate, written_blocks_quad4_accurate)                                                            \
    M(paper_quad4_gauss, hand_paper_gauss)                                                                             \
    M(paper_quad4_fast, written_paper_quad4_fast)                                                                      \
    M(paper_quad4_taper, hand_paper_taper)                                                                             \
    M(paper_quad4_gauss2, hand_paper_gauss2)                                                                           \
    M(paper_quad4_coarse, written_paper_quad4_coarse)                                                                  \
    M(paper_quad4_newton, written_paper_quad4_newton)                                                                  \
    M(paper_quad4_medium, written_paper_quad4_medium)                                                                  \
    M(paper_quad4_balanced, written_paper_quad4_balanced)                                                              \
    M(paper_quad4_fine, written_paper_quad4_fine)                                                                      \
    M(paper_quad4_precise, written_paper_quad4_precise)                                                                \
    M(paper_quad4_accurate, written_paper_quad4_accurate)                                                              \
    M(paper_quad4_full, written_paper_quad4_full)                                                                      \
    M(punch_quad4_fast, hand_fast)                                                                                     \
    M(punch_quad4_coarse, hand_coarse)                                                                                 \
    M(punch_quad4_gauss2, hand_gauss2)                                                                                 \
    M(punch_quad4_medium, hand_medium)                                                                                 \
    M(punch_quad4_balanced, written_punch_quad4_balanced)                                                              \
    M(punch_quad4_fine, written_punch_quad4_fine)                                                                      \
    M(punch_quad4_accurate, written_punch_quad4_accurate)                                                              \
    M(quad4_fast, hand_fast)                                                                                           \
    M(quad4_coarse, hand_coarse)                                                                                       \
    M(quad4_gauss2, hand_gauss2)                                                                                       \
    M(quad4_medium, hand_medium)                                                                                       \
    M(quad4_balanced, written_quad4_balanced)                                                                          \
    M(quad4_fine, written_quad4_fine)                                                                                  \
    M(quad4_precise, written_quad4_precise)                                                                            \
    M(quad4_accurate, written_quad4_accurate)                                                                          \
    M(quad4_full, written_quad4_full)                                                                                  \
    M(whole_quad4_gauss, hand_whole_gauss)                                                                             \
    M(whole_quad4_fast, written_whole_quad4_fast)                                                                      \
    M(whole_quad4_taper, hand_whole_taper)                                                                             \
    M(whole_quad4_gauss2, hand_whole_gauss2)                                                                           \
    M(whole_quad4_coarse, written_whole_quad4_coarse)                                                                  \
    M(whole_quad4_newton, written_whole_quad4_newton)                                                                  \
    M(whole_quad4_medium, written_whole_quad4_medium)                                                                  \
    M(whole_quad4_balanced, written_whole_quad4_balanced)                                                              \
    M(whole_quad4_fine, written_whole_quad4_fine)                                                                      \
    M(whole_quad4_precise, written_whole_quad4_precise)                                                                \
    M(whole_quad4_accurate, written_whole_quad4_accurate)                                                              \
    M(whole_quad4_full, written_whole_quad4_full)

/* Names the hand-written function of each method, which several methods may share. */
#define DEFINE_HAND(name, hand)                                                                                        \
    FOOTPOINT_FN void by_hand_##name(HAND_NODES, double *xi, double *eta)                                              \
    {                                                                                                                  \
        hand(xA, xB, xC, xD, xS, xi, eta);                                                                             \
    }
METHODS(DEFINE_HAND)

#define DEFINE_METHOD(name, hand) DEFINE_OURS(name) DEFINE(by_hand_##name) DEFINE(written_##name)
METHODS(DEFINE_METHOD)

enum { OURS, HAND, WRITTEN, RIVALS };
enum mode { SCALAR, BATCH, MODES };
static const char *const mode_name[MODES] = {"scalar", "batch"};

static const struct method {
    const char *name;
    struct rival_search search[RIVALS];
} methods[] = {
#define SEARCH(function)                                                                                               \
    {                                                                                                                  \
        one_##function, batch_##function                                                                               \
    }
#define METHOD(name, hand) {#name, {SEARCH(footpoint_##name##_at), SEARCH(by_hand_##name), SEARCH(written_##name)}},
    METHODS(METHOD)};

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static void run(const struct rival_search *search, enum mode mode, struct block *b)
{
    if (mode == BATCH) {
        search->batch(b);
        return;
    }
    for (int i = 0; i < SAMPLES; i++) {
        double found[2];
        search->one(&b->quad[i], found);
        b->found[0][i] = found[0];
        b->found[1][i] = found[1];
    }
}

/* Returns nanoseconds per search. */
static double time_turn(const struct rival_search *search, enum mode mode)
{
    const double start = now();
    for (int k = 0; k < BLOCKS; k++)
        for (int repeat = 0; repeat < REPEATS; repeat++)
            run(search, mode, &blocks[k]);
    return 1e9 * (now() - start) / (BLOCKS * REPEATS * SAMPLES);
}

static int compare_doubles(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *x)
{
    qsort(x, ROUNDS, sizeof *x, compare_doubles);
    return x[ROUNDS / 2];
}

/* Measures medians (ns) and the ratios of the others' times to ours. */
static void measure(const struct method *m, enum mode mode, double ns[RIVALS], double ratio[RIVALS])
{
    static double time[RIVALS][ROUNDS], quotient[RIVALS][ROUNDS];
    for (int round = 0; round < ROUNDS; round++) {
        for (int turn = 0; turn < RIVALS; turn++) {
            const int r = (turn + round) % RIVALS;
            time[r][round] = time_turn(&m->search[r], mode);
        }
        for (int r = 0; r < RIVALS; r++)
            quotient[r][round] = time[r][round] / time[OURS][round];
    }
    for (int r = 0; r < RIVALS; r++) {
        ns[r] = median(time[r]);
        ratio[r] = median(quotient[r]);
    }
}

/* Returns the largest difference between the answers of a method's searches. */
static double disagreement(const struct method *m)
{
    double most = 0, ours[2][SAMPLES];
    for (int k = 0; k < BLOCKS; k++)
        for (int r = 0; r < RIVALS * MODES; r++) {
            run(&m->search[r / MODES], (enum mode)(r % MODES), &blocks[k]);
            if (r == 0)
                memcpy(ours, blocks[k].found, sizeof ours);
            for (int i = 0; i < 2 * SAMPLES; i++) {
                const double difference =
                    fabs(blocks[k].found[i / SAMPLES][i % SAMPLES] - ours[i / SAMPLES][i % SAMPLES]);
                most = difference <= most ? most : difference; /* NaN counts as larger */
            }
        }
    return most;
}

/* Draws ordinary segments with A the corner of the foot point's quarter, as the genomes of the paper's scene assume. */
static void draw_samples(void)
{
    for (int i = 0; i < BLOCKS * SAMPLES; i++) {
        struct block *b = &blocks[i / SAMPLES];
        struct quad q = quad_draw(&quad_ordinary, (uint64_t)i);
        while (q.xi > 0 || q.eta > 0)
            q = quad_turn_corners(&q);
        b->quad[i % SAMPLES] = q;
        for (int k = 0; k < 15; k++)
            b->x[k][i % SAMPLES] = k < 12 ? q.x[k / 3][k % 3] : q.xs[k - 12];
    }
}

int main(void)
{
    bool agree = true;
    draw_samples();
    puts("method,mode,ns,ns_hand,ns_written,ratio_hand,ratio_written");
    for (size_t i = 0; i < sizeof methods / sizeof *methods; i++) {
        const double difference = disagreement(&methods[i]);
        if (!(difference <= TOLERANCE))
            fprintf(stderr, "%s: the formulas differ by %.1e\n", methods[i].name, difference);
        agree &= difference <= TOLERANCE;
        for (int mode = 0; mode < MODES; mode++) {
            double ns[RIVALS], ratio[RIVALS];
            measure(&methods[i], (enum mode)mode, ns, ratio);
            printf("%s,%s,%.2f,%.2f,%.2f,%.3f,%.3f\n", methods[i].name, mode_name[mode], ns[OURS], ns[HAND],
                   ns[WRITTEN], ratio[HAND], ratio[WRITTEN]);
        }
    }
    return !agree;
}
