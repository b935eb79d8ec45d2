/* The work on one block of pairs, written once as plain loops and compiled for each instruction set; see batch_block.h.
 * Attributes replace separate files with separate flags, so that this folder can be copied into any build. Loops with
 * square roots and comparisons vectorise under -fno-math-errno -fno-trapping-math, which change no result. */
#if defined(__GNUC__) && defined(__OPTIMIZE__)
#define FOOTPOINT_FN static inline __attribute__((always_inline))
#else
#define FOOTPOINT_FN static inline
#endif

#include "../certain/check.h"
#include "batch_gather.h"

#include "../../generated/footpoint_quad4.h"

#if defined(__GNUC__) && defined(__x86_64__)
#define HAVE_X86 1
#endif

/* ---- nodes ---- */

/* Copies the corners of the first pair, so that no store through b can change them. */
FOOTPOINT_FN void first_corners(const struct block *b, double c[12])
{
    for (size_t k = 0; k < 12; k++)
        c[k] = b->x[k][0];
}

/* Node k of pair i, or of the corners c if `prepared`. */
#define CORNER(b, c, prepared, i, k) ((prepared) ? (c)[k] : (b)->x[k][i])
#define NODE(b, c, prepared, i, k)                                                                                     \
    {                                                                                                                  \
        CORNER(b, c, prepared, i, k), CORNER(b, c, prepared, i, k + 1), CORNER(b, c, prepared, i, k + 2)               \
    }
#define NODES_OF(b, c, prepared, i)                                                                                    \
    const double xA[3] = NODE(b, c, prepared, i, 0), xB[3] = NODE(b, c, prepared, i, 3);                               \
    const double xC[3] = NODE(b, c, prepared, i, 6), xD[3] = NODE(b, c, prepared, i, 9);                               \
    const double xS[3] = {(b)->x[12][i], (b)->x[13][i], (b)->x[14][i]}

/* ---- sure answers ---- */

/* Sets FOOTPOINT_ERR_DOMAIN for answers that are not sure. */
FOOTPOINT_FN void verify(struct block *b, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, b->xi, 0, i);
        const int64_t sure = footpoint_check(xA, xB, xC, xD, xS, b->xi[i], b->eta[i]);
        const int doubtful = (b->status[i] == FOOTPOINT_OK) & !sure;
        b->status[i] = doubtful ? FOOTPOINT_ERR_DOMAIN : b->status[i];
    }
}

/* ---- xi, eta and gap ---- */

#define TIERS(X, suffix, attributes)                                                                                   \
    X(fast, suffix, attributes)                                                                                        \
    X(coarse, suffix, attributes)                                                                                      \
    X(gauss2, suffix, attributes)                                                                                      \
    X(medium, suffix, attributes)                                                                                      \
    X(balanced, suffix, attributes)                                                                                    \
    X(fine, suffix, attributes)                                                                                        \
    X(precise, suffix, attributes)                                                                                     \
    X(accurate, suffix, attributes)                                                                                    \
    X(full, suffix, attributes)

/* The compiler moves computations that depend only on a prepared segment out of the loop. */
#define SEARCH_EITHER(tier, name, attributes, prepared)                                                                \
    attributes static int name(struct block *b, size_t count)                                                          \
    {                                                                                                                  \
        double c[12];                                                                                                  \
        uint64_t bad = 0;                                                                                              \
        first_corners(b, c);                                                                                           \
        double *const xi = b->xi, *const eta = b->eta, *const gap = b->gap;                                            \
        for (size_t i = 0; i < count; i++) {                                                                           \
            NODES_OF(b, c, prepared, i);                                                                               \
            const double *const x[5] = {xA, xB, xC, xD, xS};                                                           \
            double at[3];                                                                                              \
            const uint64_t flaw = footpoint_quad4_##tier##_detail_checked(x, 0, 0.0, &at[0], &at[1], &at[2]);          \
            b->status[i] = (int64_t)(flaw >> 63) * FOOTPOINT_ERR_DEGENERATE;                                           \
            xi[i] = at[0];                                                                                             \
            eta[i] = at[1];                                                                                            \
            gap[i] = at[2];                                                                                            \
            bad |= flaw;                                                                                               \
        }                                                                                                              \
        return bad >> 63 == 0;                                                                                         \
    }
#define SEARCH(tier, suffix, attributes)                                                                               \
    SEARCH_EITHER(tier, tier##_##suffix, attributes, 0)                                                                \
    SEARCH_EITHER(tier, tier##_prepared_##suffix, attributes, 1)

/* ---- instruction sets ---- */

#define NAME_SEARCH(tier, suffix, attributes) tier##_##suffix,
#define NAME_PREPARED(tier, suffix, attributes) tier##_prepared_##suffix,
#define GATHER(kind, suffix, attributes, vectors)                                                                      \
    attributes static int gather##kind##_##suffix(struct block *b, const struct footpoint_pairs *p, size_t first)      \
    {                                                                                                                  \
        return gather(b, p, first, kind, vectors);                                                                     \
    }

#define INSTRUCTIONS(suffix, attributes, vectors)                                                                      \
    TIERS(SEARCH, suffix, attributes)                                                                                  \
    GATHER(0, suffix, attributes, vectors)                                                                             \
    GATHER(1, suffix, attributes, vectors)                                                                             \
    GATHER(2, suffix, attributes, vectors)                                                                             \
    GATHER(3, suffix, attributes, vectors)                                                                             \
    GATHER(4, suffix, attributes, vectors)                                                                             \
    GATHER(5, suffix, attributes, vectors)                                                                             \
    GATHER(6, suffix, attributes, vectors)                                                                             \
    GATHER(7, suffix, attributes, vectors)                                                                             \
    attributes static void verify_##suffix(struct block *b, size_t count)                                              \
    {                                                                                                                  \
        verify(b, count);                                                                                              \
    }                                                                                                                  \
    static const struct lanes lanes_##suffix = {{gather0_##suffix, gather1_##suffix, gather2_##suffix,                 \
                                                 gather3_##suffix, gather4_##suffix, gather5_##suffix,                 \
                                                 gather6_##suffix, gather7_##suffix},                                  \
                                                {TIERS(NAME_SEARCH, suffix, attributes)},                              \
                                                {TIERS(NAME_PREPARED, suffix, attributes)},                            \
                                                verify_##suffix};

INSTRUCTIONS(plain, , 0)

#ifdef HAVE_X86
#ifdef __clang__
#define AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,fma")))
#else
#define AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,fma,prefer-vector-width=512")))
#endif
INSTRUCTIONS(avx2, __attribute__((target("avx2,fma"))), 4)
INSTRUCTIONS(avx512, AVX512, 8)
#endif

const struct lanes *footpoint_batch_lanes_of(int set)
{
#ifdef HAVE_X86
    if (set == 2 && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
        return &lanes_avx512;
    if (set == 1 && __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"))
        return &lanes_avx2;
#endif
    return set == 0 ? &lanes_plain : NULL;
}

const struct lanes *footpoint_batch_lanes(void)
{
    int set = LANE_SETS - 1;
    while (!footpoint_batch_lanes_of(set))
        set--;
    return footpoint_batch_lanes_of(set);
}
