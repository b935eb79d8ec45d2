/* The work on one block of pairs, written once as plain loops and compiled for each instruction set; see batch_block.h.
 * Attributes stand for separate files with separate flags: whoever copies this folder needs neither.  Loops with square
 * roots and comparisons vectorise under -fno-math-errno -fno-trapping-math, which change no result. */
#if defined(__GNUC__)
#define FOOTPOINT_FN static inline __attribute__((always_inline))
#else
#define FOOTPOINT_FN static inline
#endif

#include "batch_block.h"
#include "check.h"

#include "../generated/footpoint_quad4.h"

#if defined(__GNUC__) && defined(__x86_64__)
#define HAVE_X86 1
#endif

/* ---- from the mesh into columns ---- */

/* Among indices from 0 to `last`, all of these have their highest bits clear. */
#define OUTSIDE(index, last) ((index) | ((last) - (index)))

FOOTPOINT_FN int any_outside(const struct footpoint_pairs *p, size_t first, int kind)
{
    if (kind & KIND_WIDE) {
        const int64_t *const seg = p->seg64 + 4 * first, *const slave = p->slave64 + first;
        const uint64_t last = (uint64_t)p->nodes - 1;
        uint64_t out = 0;
        for (size_t i = 0; i < 4 * BLOCK; i++)
            out |= OUTSIDE((uint64_t)seg[i], last);
        for (size_t i = 0; i < BLOCK; i++)
            out |= OUTSIDE((uint64_t)slave[i], last);
        return out >> 63 != 0;
    }
    const int32_t *const seg = p->seg + 4 * first, *const slave = p->slave + first;
    const uint32_t last = p->nodes > INT32_MAX ? INT32_MAX : (uint32_t)p->nodes - 1;
    uint32_t out = 0;
    for (size_t i = 0; i < 4 * BLOCK; i++)
        out |= OUTSIDE((uint32_t)seg[i], last);
    for (size_t i = 0; i < BLOCK; i++)
        out |= OUTSIDE((uint32_t)slave[i], last);
    return out >> 31 != 0;
}

/* Index of node k of pair i. */
FOOTPOINT_FN size_t index_of(const struct footpoint_pairs *p, size_t i, size_t k, int kind)
{
    if (kind & KIND_WIDE)
        return (size_t)(k < 4 ? p->seg64[4 * i + k] : p->slave64[i]);
    return (size_t)(k < 4 ? p->seg[4 * i + k] : p->slave[i]);
}

/* Has the nodes of later pairs brought into the cache: of every second pair the corners A and C and the slave node, as
 * neighbours share what is left.  Addresses are plain numbers: these indices have not been checked. */
FOOTPOINT_FN void fetch_nodes(const struct footpoint_pairs *p, size_t first, int kind)
{
#ifdef __GNUC__
    const uintptr_t x = kind & KIND_FLOAT ? (uintptr_t)p->xf : (uintptr_t)p->x;
    const size_t size = p->stride * (kind & KIND_FLOAT ? sizeof *p->xf : sizeof *p->x);
    for (size_t i = first; i < first + BLOCK; i += 2)
        for (size_t k = 0; k < 5; k += 2)
            __builtin_prefetch((const void *)(x + size * index_of(p, i, k, kind)));
#else
    (void)p, (void)first, (void)kind;
#endif
}

/* Two pairs at a time: processors write two neighbours at once, and their own gather instructions may be slow.  Of
 * columns, which share lines among more nodes, they look ahead by themselves. */
FOOTPOINT_FN void gather(struct block *b, const struct footpoint_pairs *p, size_t first, int kind)
{
    for (size_t i = 0; i < BLOCK; i += 2)
        for (size_t k = 0; k < 5; k++) {
            const size_t at = p->stride * index_of(p, first + i, k, kind);
            const size_t next = p->stride * index_of(p, first + i + 1, k, kind);
            double *const x = b->x[3 * k] + i, *const y = b->x[3 * k + 1] + i, *const z = b->x[3 * k + 2] + i;
            x[0] = kind & KIND_FLOAT ? (double)p->xf[at] : p->x[at];
            x[1] = kind & KIND_FLOAT ? (double)p->xf[next] : p->x[next];
            y[0] = kind & KIND_FLOAT ? (double)p->yf[at] : p->y[at];
            y[1] = kind & KIND_FLOAT ? (double)p->yf[next] : p->y[next];
            z[0] = kind & KIND_FLOAT ? (double)p->zf[at] : p->z[at];
            z[1] = kind & KIND_FLOAT ? (double)p->zf[next] : p->z[next];
        }
    if (p->n - first >= AHEAD + BLOCK && p->stride > 1)
        fetch_nodes(p, first + AHEAD, kind);
}

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

/* The gap and the status, as the function for one pair has them. */
FOOTPOINT_FN void judge(struct block *b, size_t count, int prepared)
{
    double c[12];
    first_corners(b, c);
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, c, prepared, i);
        double gap = 0.0;
        const int area = footpoint_detail_gap(xA, xB, xC, xD, xS, b->xi[i], b->eta[i], &gap);
        const double sum = (b->xi[i] - b->xi[i]) + (b->eta[i] - b->eta[i]) + (gap - gap);
        const int nodes = footpoint_detail_inspect(xA, xB, xC, xD, xS);
        const int found = (area & (sum == 0.0)) ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE;
        b->gap[i] = gap;
        b->status[i] = nodes != FOOTPOINT_OK ? nodes : found;
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

/* The lesser of two numbers; one of a and b if either is not a number. */
FOOTPOINT_FN double lesser(double a, double b)
{
    return a < b ? a : b;
}

/* Sufficient for FOOTPOINT_OK, at half the price; with `gap` that of footpoint_detail_gap as well, out of what the two
 * have in common, in its order of operations.  For |xi| + |eta| <= 9, |r_xi|^2 is at most 81 times the greater of
 * |AB|^2, |DC|^2, so that the product of its test is less than 82^2 times the one below; the other limits keep
 * everything it forms within the range of double.  Comparisons are few, as each waits for the one before. */
FOOTPOINT_FN int all_good(struct block *b, size_t count, int gap)
{
    int64_t bad = 0;
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, b->xi, 0, i);
        const double s = 0.5 * (1.0 + b->xi[i]), t = 0.5 * (1.0 + b->eta[i]);
        double ab[3], dc[3], ad[3], bc[3], ac[3], bd[3], u[3], v[3], d[3], n[3];
        for (int k = 0; k < 3; k++) {
            ab[k] = xB[k] - xA[k], dc[k] = xC[k] - xD[k], ad[k] = xD[k] - xA[k], bc[k] = xC[k] - xB[k];
            ac[k] = xC[k] - xA[k], bd[k] = xD[k] - xB[k];
            u[k] = ab[k] + t * (dc[k] - ab[k]);
            v[k] = ad[k] + s * (bc[k] - ad[k]);
            d[k] = (xS[k] - xA[k]) - s * ab[k] - t * v[k];
        }
        vector_cross(u, v, n);
        const double nn = vector_dot(n, n), far = vector_dot(xA, xA) + vector_dot(xS, xS);
        const double ab2 = vector_dot(ab, ab), dc2 = vector_dot(dc, dc), xi2 = ab2 + dc2;
        const double ad2 = vector_dot(ad, ad), bc2 = vector_dot(bc, bc), eta2 = ad2 + bc2;
        const double diagonals = lesser(vector_dot(ac, ac), vector_dot(bd, bd));
        const double least = lesser(lesser(lesser(ab2, dc2), lesser(ad2, bc2)), diagonals);
        const int good = (nn > 1e-15 * (xi2 * eta2 + 1e-180)) & (xi2 + eta2 + far < 1e70) & (least > 0.0) &
                         (fabs(b->xi[i]) + fabs(b->eta[i]) <= 9.0);
        bad |= good ? 0 : 1;
        if (gap)
            b->gap[i] = vector_dot(d, n) / sqrt(nn);
    }
    return !bad;
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

/* What depends on the segment alone is computed once by the compiler's own doing. */
#define SEARCH(tier, suffix, attributes)                                                                               \
    attributes static void tier##_##suffix(struct block *b, size_t count)                                              \
    {                                                                                                                  \
        const double *x[15];                                                                                           \
        for (size_t k = 0; k < 15; k++)                                                                                \
            x[k] = b->x[k];                                                                                            \
        footpoint_quad4_##tier##_n(count, x, b->xi, b->eta);                                                           \
    }                                                                                                                  \
    attributes static void tier##_prepared_##suffix(struct block *b, size_t count)                                     \
    {                                                                                                                  \
        double c[12];                                                                                                  \
        first_corners(b, c);                                                                                           \
        double *const xi = b->xi, *const eta = b->eta;                                                                 \
        for (size_t i = 0; i < count; i++) {                                                                           \
            NODES_OF(b, c, 1, i);                                                                                      \
            double at[2];                                                                                              \
            footpoint_quad4_##tier##_at(xA, xB, xC, xD, xS, &at[0], &at[1]);                                           \
            xi[i] = at[0];                                                                                             \
            eta[i] = at[1];                                                                                            \
        }                                                                                                              \
    }

/* ---- instruction sets ---- */

#define NAME_SEARCH(tier, suffix, attributes) tier##_##suffix,
#define NAME_PREPARED(tier, suffix, attributes) tier##_prepared_##suffix,
#define GATHER(kind, suffix, attributes)                                                                               \
    attributes static void gather##kind##_##suffix(struct block *b, const struct footpoint_pairs *p, size_t first)     \
    {                                                                                                                  \
        gather(b, p, first, kind);                                                                                     \
    }

#define INSTRUCTIONS(suffix, attributes)                                                                               \
    TIERS(SEARCH, suffix, attributes)                                                                                  \
    GATHER(0, suffix, attributes)                                                                                      \
    GATHER(1, suffix, attributes)                                                                                      \
    GATHER(2, suffix, attributes)                                                                                      \
    GATHER(3, suffix, attributes)                                                                                      \
    attributes static int any_outside32_##suffix(const struct footpoint_pairs *p, size_t first)                        \
    {                                                                                                                  \
        return any_outside(p, first, 0);                                                                               \
    }                                                                                                                  \
    attributes static int any_outside64_##suffix(const struct footpoint_pairs *p, size_t first)                        \
    {                                                                                                                  \
        return any_outside(p, first, KIND_WIDE);                                                                       \
    }                                                                                                                  \
    attributes static int all_good_##suffix(struct block *b, size_t count)                                             \
    {                                                                                                                  \
        return all_good(b, count, 0);                                                                                  \
    }                                                                                                                  \
    attributes static int all_good_gaps_##suffix(struct block *b, size_t count)                                        \
    {                                                                                                                  \
        return all_good(b, count, 1);                                                                                  \
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
    static const struct lanes lanes_##suffix = {                                                                       \
        {any_outside32_##suffix, any_outside64_##suffix},                                                              \
        {gather0_##suffix, gather1_##suffix, gather2_##suffix, gather3_##suffix},                                      \
        {TIERS(NAME_SEARCH, suffix, attributes)},                                                                      \
        {TIERS(NAME_PREPARED, suffix, attributes)},                                                                    \
        {all_good_##suffix, all_good_gaps_##suffix},                                                                   \
        judge_##suffix,                                                                                                \
        judge_prepared_##suffix,                                                                                       \
        verify_##suffix};

INSTRUCTIONS(plain, )

#ifdef HAVE_X86
#ifdef __clang__
#define AVX512 __attribute__((target("avx512f,avx512dq,avx512vl")))
#else
#define AVX512 __attribute__((target("avx512f,avx512dq,avx512vl,prefer-vector-width=512")))
#endif
INSTRUCTIONS(avx2, __attribute__((target("avx2"))))
INSTRUCTIONS(avx512, AVX512)
#endif

const struct lanes *footpoint_batch_lanes_of(int set)
{
#ifdef HAVE_X86
    if (set == 2 && __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq"))
        return &lanes_avx512;
    if (set == 1 && __builtin_cpu_supports("avx2"))
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
