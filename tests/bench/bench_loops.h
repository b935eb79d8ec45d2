/* What the methods of bench_methods.h are written with: their loops over samples, one at a time and by columns. */
#ifndef FOOTPOINT_BENCH_LOOPS_H
#define FOOTPOINT_BENCH_LOOPS_H

/* Memory changes between samples, as far as the compiler knows: each search stands for itself. */
#define NEXT_SAMPLE __asm__ volatile("" ::: "memory")
#define METHOD_FN __attribute__((noinline, flatten)) static

#define SCALAR_FN(name)                                                                                                \
    METHOD_FN void scalar_##name(const struct bench_input *restrict in, size_t n,                                      \
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

/* Names of this compilation's instruction set. */
#define JOIN(a, b) a##b
#define JOINED(a, b) JOIN(a, b)
#define OF_ISA(name) JOINED(name, BENCH_ISA)

#endif
