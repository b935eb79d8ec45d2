/* The work on one block of pairs, written once as plain loops and compiled for each instruction set; see batch_block.h.
 * Attributes stand for separate files with separate flags: whoever copies this folder needs neither.  Loops with square
 * roots and comparisons vectorise under -fno-math-errno -fno-trapping-math, which change no result. */
#if defined(__GNUC__)
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

/* ---- gaps and statuses ---- */

/* Corners of the first pair: values of their own, which no store through b can change. */
FOOTPOINT_FN void first_corners(const struct block *b, double c[12])
{
    for (size_t k = 0; k < 12; k++)
        c[k] = b->x[k][0];
}

/* Nodes of pair i, with the corners c if `prepared`. */
#define CORNER(b, c, prepared, i, k) ((prepared) ? (c)[k] : (b)->x[k][i])
#define NODE(b, c, prepared, i, k)                                                                                     \
    {                                                                                                                  \
        CORNER(b, c, prepared, i, k), CORNER(b, c, prepared, i, k + 1), CORNER(b, c, prepared, i, k + 2)               \
    }
#define NODES_OF(b, c, prepared, i)                                                                                    \
    const double xA[3] = NODE(b, c, prepared, i, 0), xB[3] = NODE(b, c, prepared, i, 3);                               \
    const double xC[3] = NODE(b, c, prepared, i, 6), xD[3] = NODE(b, c, prepared, i, 9);                               \
    const double xS[3] = {(b)->x[12][i], (b)->x[13][i], (b)->x[14][i]}

/* The gap and, after a search, the status: FOOTPOINT_ERR_DEGENERATE also where the function for one pair has to be asked. */
FOOTPOINT_FN void judge(struct block *b, size_t count, int prepared)
{
    double c[12];
    first_corners(b, c);
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, c, prepared, i);
        double gap;
        const uint64_t flaw =
            footpoint_detail_gap(xA, xB, xC, xD, xS, b->xi[i], b->eta[i], FOOTPOINT_QUAD4_LEAST, &gap);
        b->gap[i] = gap;
        b->status[i] = (int64_t)(((uint64_t)b->status[i] | flaw) >> 63) * FOOTPOINT_ERR_DEGENERATE;
    }
}

/* After judge: FOOTPOINT_ERR_DOMAIN where an answer is not sure. */
FOOTPOINT_FN void verify(struct block *b, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, b->xi, 0, i);
        const int64_t sure = footpoint_check(xA, xB, xC, xD, xS, b->xi[i], b->eta[i]);
        const int doubtful = (b->status[i] == FOOTPOINT_OK) & !sure;
        b->status[i] = doubtful ? FOOTPOINT_ERR_DOMAIN : b->status[i];
    }
}

/* a b + c, in one rounding if `fused`. */
FOOTPOINT_FN double multiply_add(double a, double b, double c, int fused)
{
#ifdef __GNUC__
    if (fused)
        return __builtin_fma(a, b, c);
#endif
    return a * b + c;
}

FOOTPOINT_FN double square(const double a[3], int fused)
{
    return multiply_add(a[0], a[0], multiply_add(a[1], a[1], a[2] * a[2], fused), fused);
}

/* |a|^2 + b */
FOOTPOINT_FN double add_square(const double a[3], double b, int fused)
{
    return multiply_add(a[0], a[0], multiply_add(a[1], a[1], multiply_add(a[2], a[2], b, fused), fused), fused);
}

/* Sufficient for FOOTPOINT_OK, at half the price and whatever the rounding; with `gap` that of footpoint_detail_gap as
 * well, out of what the two have in common, in its order of operations.  For |xi| + |eta| <= 9, |r_xi|^2 is at most 81
 * times the greater of |AB|^2, |DC|^2, so that the product of its test is less than 82^2 times the one below; the other
 * limits are well within those of the function for one pair. */
FOOTPOINT_FN int all_good(struct block *b, size_t count, int gap, int fused)
{
    uint64_t bad = 0;
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, b->xi, 0, i);
        const double s = gap ? 0.5 * (1.0 + b->xi[i]) : multiply_add(0.5, b->xi[i], 0.5, fused);
        const double t = gap ? 0.5 * (1.0 + b->eta[i]) : multiply_add(0.5, b->eta[i], 0.5, fused);
        double ab[3], dc[3], ad[3], bc[3], as[3], u[3], v[3], n[3];
        for (int k = 0; k < 3; k++) {
            ab[k] = xB[k] - xA[k], dc[k] = xC[k] - xD[k], ad[k] = xD[k] - xA[k], bc[k] = xC[k] - xB[k];
            as[k] = xS[k] - xA[k];
            u[k] = multiply_add(t, dc[k] - ab[k], ab[k], fused && !gap);
            v[k] = multiply_add(s, gap ? bc[k] - ad[k] : dc[k] - ab[k], ad[k], fused && !gap);
        }
        for (int k = 0; k < 3; k++) {
            const int k1 = (k + 1) % 3, k2 = (k + 2) % 3;
            n[k] = multiply_add(u[k1], v[k2], -(u[k2] * v[k1]), fused && !gap);
        }
        const double nn = gap ? vector_dot(n, n) : square(n, fused);
        const double xi2 = add_square(ab, square(dc, fused), fused), eta2 = add_square(ad, square(bc, fused), fused);
        const double size = xi2 + eta2, far = add_square(as, size, fused);
        bad |= (uint64_t)b->status[i] | footpoint_detail_below(size, 2.0 * FOOTPOINT_QUAD4_LEAST) |
               footpoint_detail_below(0.5 / FOOTPOINT_QUAD4_LEAST, size) |
               footpoint_detail_bits(nn - 1e-15 * xi2 * eta2) | footpoint_detail_below(nn, 1e-150) |
               footpoint_detail_below(1e150, far) | footpoint_detail_below(9.0, fabs(b->xi[i]) + fabs(b->eta[i]));
        if (gap) {
            double d[3];
            for (int k = 0; k < 3; k++)
                d[k] = as[k] - s * ab[k] - t * v[k];
            b->gap[i] = vector_dot(d, n) / sqrt(nn);
        }
    }
    return bad >> 63 == 0;
}

/* ---- xi and eta ---- */

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

/* Into the status what the search says of its denominators.  What depends on a prepared segment alone is computed once by
 * the compiler's own doing. */
#define SEARCH_EITHER(tier, name, attributes, prepared)                                                                \
    attributes static void name(struct block *b, size_t count)                                                         \
    {                                                                                                                  \
        double c[12];                                                                                                  \
        first_corners(b, c);                                                                                           \
        double *const xi = b->xi, *const eta = b->eta;                                                                 \
        for (size_t i = 0; i < count; i++) {                                                                           \
            NODES_OF(b, c, prepared, i);                                                                               \
            double at[2];                                                                                              \
            b->status[i] = (int64_t)footpoint_detail_footpoint_quad4_##tier(xA, xB, xC, xD, xS, &at[0], &at[1]);       \
            xi[i] = at[0];                                                                                             \
            eta[i] = at[1];                                                                                            \
        }                                                                                                              \
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
    attributes static int all_good_##suffix(struct block *b, size_t count)                                             \
    {                                                                                                                  \
        return all_good(b, count, 0, vectors > 0);                                                                     \
    }                                                                                                                  \
    attributes static int all_good_gaps_##suffix(struct block *b, size_t count)                                        \
    {                                                                                                                  \
        return all_good(b, count, 1, vectors > 0);                                                                     \
    }                                                                                                                  \
    attributes static void judge_##suffix(struct block *b, size_t count)                                               \
    {                                                                                                                  \
        judge(b, count, 0);                                                                                            \
    }                                                                                                                  \
    attributes static void judge_prepared_##suffix(struct block *b, size_t count)                                      \
    {                                                                                                                  \
        judge(b, count, 1);                                                                                            \
    }                                                                                                                  \
    attributes static void verify_##suffix(struct block *b, size_t count)                                              \
    {                                                                                                                  \
        verify(b, count);                                                                                              \
    }                                                                                                                  \
    static const struct lanes lanes_##suffix = {{gather0_##suffix, gather1_##suffix, gather2_##suffix,                 \
                                                 gather3_##suffix, gather4_##suffix, gather5_##suffix,                 \
                                                 gather6_##suffix, gather7_##suffix},                                  \
                                                {TIERS(NAME_SEARCH, suffix, attributes)},                              \
                                                {TIERS(NAME_PREPARED, suffix, attributes)},                            \
                                                {all_good_##suffix, all_good_gaps_##suffix},                           \
                                                judge_##suffix,                                                        \
                                                judge_prepared_##suffix,                                               \
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
