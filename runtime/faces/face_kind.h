/* The functions of one kind of face, out of its generated headers: a table that faces.c chooses from.  A file of each kind
 * includes its headers and this one, and says KIND(quad8, full, 8): the kind, its most accurate search, how many nodes. */
#ifndef FOOTPOINT_FACE_KIND_H
#define FOOTPOINT_FACE_KIND_H

#include "face_table.h"

#define X3 x[0], x[1], x[2]
#define X4 X3, x[3]
#define X6 X4, x[4], x[5]
#define X8 X6, x[6], x[7]
#define X9 X8, x[8]

#if defined(__GNUC__) && defined(__x86_64__)
#define HAVE_X86 1
#ifdef __clang__
#define AVX512 __attribute__((flatten, target("avx512f,avx512dq,avx512vl,fma")))
#else
#define AVX512 __attribute__((flatten, target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")))
#endif
#define AVX2 __attribute__((flatten, target("avx2,fma")))
#endif

/* A block of pairs by the machine's own instructions, as batch/batch_lanes.c has them. */
#define BLOCK_OF(kind, tier, set, attributes)                                                                          \
    attributes static void block_##set(const double *const *columns, double *xi, double *eta, double *gap,             \
                                       int *status)                                                                    \
    {                                                                                                                  \
        footpoint_##kind##_##tier##_checked_n(FACE_BLOCK, columns, xi, eta, gap, status);                              \
    }
#ifdef HAVE_X86
#define BLOCKS_OF(kind, tier)                                                                                          \
    BLOCK_OF(kind, tier, plain, )                                                                                      \
    BLOCK_OF(kind, tier, avx2, AVX2)                                                                                   \
    BLOCK_OF(kind, tier, avx512, AVX512)                                                                               \
    static void block(const double *const *columns, double *xi, double *eta, double *gap, int *status)                 \
    {                                                                                                                  \
        if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))                                  \
            block_avx512(columns, xi, eta, gap, status);                                                               \
        else if (__builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))                                      \
            block_avx2(columns, xi, eta, gap, status);                                                                 \
        else                                                                                                           \
            block_plain(columns, xi, eta, gap, status);                                                                \
    }
#else
#define BLOCKS_OF(kind, tier) BLOCK_OF(kind, tier, plain, )
#define block block_plain
#endif

#define KIND(kind, tier, count)                                                                                        \
    static int locate(const double *const *x, const double *s, double *loc, double *gap)                               \
    {                                                                                                                  \
        return footpoint_##kind##_##tier(X##count, s, loc, gap);                                                       \
    }                                                                                                                  \
    static int closest(const double *const *x, const double *s, double *loc, double *distance, int *region)            \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest(X##count, s, loc, distance, region);                                \
    }                                                                                                                  \
    static int nearest(size_t n, const double *const *x, const double *s, double *loc, double *distance, int *region,  \
                       size_t *which)                                                                                  \
    {                                                                                                                  \
        return footpoint_##kind##_##tier##_closest_of(n, x, s, loc, distance, region, which);                          \
    }                                                                                                                  \
    static int place(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,            \
                     double *r_eta, double *normal, double *gap)                                                       \
    {                                                                                                                  \
        return footpoint_##kind##_place(X##count, s, loc, phi, r_xi, r_eta, normal, gap);                              \
    }                                                                                                                  \
    static int differentiate(const double *const *x, const double *s, const double *loc, double *phi, double *r_xi,    \
                             double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta, double *d_gap)   \
    {                                                                                                                  \
        return footpoint_##kind##_gradients(X##count, s, loc, phi, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap);      \
    }                                                                                                                  \
    static int hessian(const double *const *x, const double *s, const double *loc, double *gap, double *d_xi,          \
                       double *d_eta, double *d_gap, double *d_normal, double *second)                                 \
    {                                                                                                                  \
        return footpoint_##kind##_hessian(X##count, s, loc, gap, d_xi, d_eta, d_gap, d_normal, second);                \
    }                                                                                                                  \
    BLOCKS_OF(kind, tier)                                                                                              \
    const struct face footpoint_face_##kind = {count, locate, closest, nearest, place, differentiate, hessian, block};

#endif
