/* Loops over samples, calls and columns, for the methods of bench_methods.h, which must be included before. */
#ifndef FOOTPOINT_BENCH_LOOPS_H
#define FOOTPOINT_BENCH_LOOPS_H

#include <stdint.h>
#include <string.h>

/* Ends sample i. Compilers must assume that memory changes, so they cannot join searches; the processor still overlaps
 * them. A chain prevents that: a coordinate of the next slave node is made from the answer, without changing its
 * value. */
static inline void next_sample(struct bench_input *in, size_t n, size_t i, const struct bench_chain *chain,
                               const double found[BENCH_FOUND])
{
    if (chain && i + 1 < n) {
        uint64_t coordinate, bits[BENCH_FOUND];
        memcpy(bits, found, sizeof bits);
        memcpy(&coordinate, &in[i + 1].x[chain->slave][0], sizeof coordinate);
        coordinate |= (bits[0] | bits[1] | bits[2]) & chain->none;
        memcpy(&in[i + 1].x[chain->slave][0], &coordinate, sizeof coordinate);
    }
    __asm__ volatile("" ::: "memory");
}
#define NEXT_SAMPLE(xi, eta, gap) next_sample(in, n, i, chain, (const double[BENCH_FOUND]){xi, eta, gap})
#define METHOD_FN __attribute__((noinline, flatten)) static

#define SCALAR_FN(name)                                                                                                \
    METHOD_FN void scalar_##name(struct bench_input *restrict in, size_t n, const struct bench_chain *restrict chain,  \
                                 const struct rival_tuning *restrict t, double(*restrict found)[BENCH_FOUND],          \
                                 bench_slopes *restrict slope)
#define BATCH_FN(name)                                                                                                 \
    METHOD_FN void batch_##name(struct bench_block *restrict b, const struct rival_tuning *restrict t)

/* Vectors of search i of block b. */
#define GATHERED(k)                                                                                                    \
    {                                                                                                                  \
        b->x[3 * (k)][i], b->x[3 * (k) + 1][i], b->x[3 * (k) + 2][i]                                                   \
    }
#define GATHERED_ALL                                                                                                   \
    {                                                                                                                  \
        GATHERED(0), GATHERED(1), GATHERED(2), GATHERED(3), GATHERED(4), GATHERED(5), GATHERED(6), GATHERED(7),        \
            GATHERED(8), GATHERED(9), GATHERED(10)                                                                     \
    }

/* Names that contain this compilation's instruction set. */
#define JOIN(a, b) a##b
#define JOINED(a, b) JOIN(a, b)
#define OF_ISA(name) JOINED(name, BENCH_ISA)

#endif
