/* Searches blocks of pairs by the machine's vector instructions, as batch/batch_lanes.c does.  SEARCH(locate, quad8, full, 8)
 * defines locate(), for a pair, and locate_block(), which calls footpoint_quad8_full_checked_n.  TRACK(quad8, full, 8) defines
 * track() and track_block(), which begin at last answers. */
#ifndef FOOTPOINT_PAIR_BLOCKS_H
#define FOOTPOINT_PAIR_BLOCKS_H

#include "pairs.h"

#define BLOCK_OF(name, loop, set, attributes)                                                                          \
    attributes static void name##_block_##set(const double *const *columns, double *xi, double *eta, double *gap,      \
                                              int *status)                                                             \
    {                                                                                                                  \
        loop(PAIRS_BLOCK, columns, xi, eta, gap, status);                                                              \
    }

#if defined(__GNUC__) && defined(__x86_64__)
#ifdef __clang__
#define AVX512 __attribute__((flatten, target("avx512f,avx512dq,avx512vl,fma")))
#else
#define AVX512 __attribute__((flatten, target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")))
#endif
#define AVX2 __attribute__((flatten, target("avx2,fma")))

/* On machines without either, each pair is searched by itself. */
#define BLOCKS_OF(name, loop)                                                                                          \
    BLOCK_OF(name, loop, avx2, AVX2)                                                                                   \
    BLOCK_OF(name, loop, avx512, AVX512)                                                                               \
    static void name##_block(const double *const *columns, double *xi, double *eta, double *gap, int *status)          \
    {                                                                                                                  \
        if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))                                  \
            name##_block_avx512(columns, xi, eta, gap, status);                                                        \
        else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))                                      \
            name##_block_avx2(columns, xi, eta, gap, status);                                                          \
        else                                                                                                           \
            for (int i = 0; i < PAIRS_BLOCK; i++)                                                                      \
                status[i] = FOOTPOINT_ERR_UNPROVED;                                                                    \
    }
#else
#define BLOCKS_OF(name, loop)                                                                                          \
    BLOCK_OF(name, loop, plain, )                                                                                      \
    static void name##_block(const double *const *columns, double *xi, double *eta, double *gap, int *status)          \
    {                                                                                                                  \
        name##_block_plain(columns, xi, eta, gap, status);                                                             \
    }
/* A block of projections along directions, whose columns come after the nodes' and the slave node's. */
#define ALONG_BLOCKS(loop, nodes)                                                                                      \
    static inline void along_n(size_t n, const double *const *columns, double *xi, double *eta, double *dist,          \
                               int *status)                                                                            \
    {                                                                                                                  \
        loop(n, columns, columns + 3 * (nodes) + 3, xi, eta, dist, status);                                            \
    }                                                                                                                  \
    BLOCKS_OF(along, along_n)

#endif

#define SEARCH(name, kind, tier, vectors)                                                                              \
    static int name(const double *const *x, const double *s, double *loc, double *gap)                                 \
    {                                                                                                                  \
        return footpoint_##kind##_##tier(X##vectors, s, loc, gap);                                                     \
    }                                                                                                                  \
    BLOCKS_OF(name, footpoint_##kind##_##tier##_checked_n)

#define TRACK(kind, tier, vectors)                                                                                     \
    static int track(const double *const *x, const double *s, double *loc, double *gap)                                \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_from(X##vectors, s, loc, gap);                                              \
    }                                                                                                                  \
    BLOCKS_OF(track, footpoint_##kind##_##tier##_from_n)

/* A block of projections along directions, whose columns come after the nodes' and the slave node's. */
#define ALONG_BLOCKS(loop, nodes)                                                                                      \
    static inline void along_n(size_t n, const double *const *columns, double *xi, double *eta, double *dist,          \
                               int *status)                                                                            \
    {                                                                                                                  \
        loop(n, columns, columns + 3 * (nodes) + 3, xi, eta, dist, status);                                            \
    }                                                                                                                  \
    BLOCKS_OF(along, along_n)

#endif
