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
#if defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector)
#define HAVE_SHUFFLE 1
#endif
#endif

/* ---- from the mesh into columns ---- */

FOOTPOINT_FN uint64_t greatest(const struct footpoint_pairs *p, size_t first, int kind)
{
    if (kind & KIND_WIDE) {
        const int64_t *const seg = p->seg64 + 4 * first, *const slave = p->slave64 + first;
        uint64_t most = 0;
        for (size_t i = 0; i < 4 * BLOCK; i++)
            most = (uint64_t)seg[i] > most ? (uint64_t)seg[i] : most;
        for (size_t i = 0; i < BLOCK; i++)
            most = (uint64_t)slave[i] > most ? (uint64_t)slave[i] : most;
        return most;
    }
    const int32_t *const seg = p->seg + 4 * first, *const slave = p->slave + first;
    uint32_t most = 0;
    for (size_t i = 0; i < 4 * BLOCK; i++)
        most = (uint32_t)seg[i] > most ? (uint32_t)seg[i] : most;
    for (size_t i = 0; i < BLOCK; i++)
        most = (uint32_t)slave[i] > most ? (uint32_t)slave[i] : most;
    return most;
}

/* Index of node k of pair i. */
FOOTPOINT_FN size_t index_of(const struct footpoint_pairs *p, size_t i, size_t k, int kind)
{
    if (kind & KIND_WIDE)
        return (size_t)(k < 4 ? p->seg64[4 * i + k] : p->slave64[i]);
    return (size_t)(k < 4 ? p->seg[4 * i + k] : p->slave[i]);
}

FOOTPOINT_FN void gather_strided(struct block *b, const struct footpoint_pairs *p, size_t first, int kind)
{
    for (size_t i = 0; i < BLOCK; i++)
        for (size_t k = 0; k < 5; k++) {
            const size_t at = p->stride * index_of(p, first + i, k, kind);
            b->x[3 * k][i] = kind & KIND_FLOAT ? (double)p->xf[at] : p->x[at];
            b->x[3 * k + 1][i] = kind & KIND_FLOAT ? (double)p->yf[at] : p->y[at];
            b->x[3 * k + 2][i] = kind & KIND_FLOAT ? (double)p->zf[at] : p->z[at];
        }
}

#ifdef HAVE_SHUFFLE
typedef double quadruple __attribute__((vector_size(32), aligned(8), may_alias));

/* Four nodes at a time, transposed in registers; what follows the third coordinate is dropped. */
FOOTPOINT_FN void gather_triples(struct block *b, const struct footpoint_pairs *p, size_t first, int kind)
{
    const double *const xyz = p->x;
    for (size_t i = 0; i < BLOCK; i += 4)
        for (size_t k = 0; k < 5; k++) {
            const quadruple s = *(const quadruple *)(xyz + 3 * index_of(p, first + i, k, kind));
            const quadruple t = *(const quadruple *)(xyz + 3 * index_of(p, first + i + 1, k, kind));
            const quadruple u = *(const quadruple *)(xyz + 3 * index_of(p, first + i + 2, k, kind));
            const quadruple v = *(const quadruple *)(xyz + 3 * index_of(p, first + i + 3, k, kind));
            const quadruple st_xz = __builtin_shufflevector(s, t, 0, 4, 2, 6);
            const quadruple uv_xz = __builtin_shufflevector(u, v, 0, 4, 2, 6);
            const quadruple st_y = __builtin_shufflevector(s, t, 1, 5, 3, 7);
            const quadruple uv_y = __builtin_shufflevector(u, v, 1, 5, 3, 7);
            *(quadruple *)&b->x[3 * k][i] = __builtin_shufflevector(st_xz, uv_xz, 0, 1, 4, 5);
            *(quadruple *)&b->x[3 * k + 1][i] = __builtin_shufflevector(st_y, uv_y, 0, 1, 4, 5);
            *(quadruple *)&b->x[3 * k + 2][i] = __builtin_shufflevector(st_xz, uv_xz, 2, 3, 6, 7);
        }
}
#endif

/* Has the nodes of later pairs brought into the cache: of every second pair the corners A and C and the slave node, as
 * neighbours share what is left.  Addresses are plain numbers: these indices have not been checked. */
FOOTPOINT_FN void fetch_nodes(const struct footpoint_pairs *p, size_t first, int kind)
{
#ifdef __GNUC__
    const uintptr_t x = (uintptr_t)(kind & KIND_FLOAT ? (const void *)p->xf : (const void *)p->x);
    const uintptr_t y = (uintptr_t)(kind & KIND_FLOAT ? (const void *)p->yf : (const void *)p->y);
    const uintptr_t z = (uintptr_t)(kind & KIND_FLOAT ? (const void *)p->zf : (const void *)p->z);
    for (size_t i = first; i < first + BLOCK; i += 2)
        for (size_t k = 0; k < 5; k += 2) {
            const size_t at =
                p->stride * index_of(p, i, k, kind) * (kind & KIND_FLOAT ? sizeof(float) : sizeof(double));
            __builtin_prefetch((const void *)(x + at));
            if (kind & KIND_TRIPLES)
                continue;
            __builtin_prefetch((const void *)(y + at));
            __builtin_prefetch((const void *)(z + at));
        }
#else
    (void)p, (void)first, (void)kind;
#endif
}

FOOTPOINT_FN void gather(struct block *b, const struct footpoint_pairs *p, size_t first, int kind)
{
#ifdef HAVE_SHUFFLE
    if (kind & KIND_TRIPLES)
        gather_triples(b, p, first, kind);
    else
#endif
        gather_strided(b, p, first, kind);
    if (p->n - first >= AHEAD + BLOCK)
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

/* The gap, and status FOOTPOINT_ERR_DEGENERATE where there is no normal. */
FOOTPOINT_FN void gaps(struct block *b, size_t count, int prepared)
{
    double c[12];
    first_corners(b, c);
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, c, prepared, i);
        double gap = 0.0;
        const int area = footpoint_detail_gap(xA, xB, xC, xD, xS, b->xi[i], b->eta[i], &gap);
        b->gap[i] = gap;
        b->status[i] = area ? FOOTPOINT_OK : FOOTPOINT_ERR_DEGENERATE;
    }
}

FOOTPOINT_FN void judge(struct block *b, size_t count, int prepared)
{
    double c[12];
    first_corners(b, c);
    gaps(b, count, prepared);
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, c, prepared, i);
        const double sum = (b->xi[i] - b->xi[i]) + (b->eta[i] - b->eta[i]) + (b->gap[i] - b->gap[i]);
        const int nodes = footpoint_detail_inspect(xA, xB, xC, xD, xS);
        const int64_t found = sum == 0.0 ? b->status[i] : FOOTPOINT_ERR_DEGENERATE;
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

/* Sufficient for FOOTPOINT_OK, at half the price.  For |xi|, |eta| <= 9, |r_xi|^2 is at most 81 times the greater of
 * |AB|^2, |DC|^2, so that the product of footpoint_detail_gap's test is less than 82^2 times the one below; the other
 * limits keep everything it forms within the range of double. */
FOOTPOINT_FN int all_good(const struct block *b, size_t count)
{
    int64_t bad = 0;
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, b->xi, 0, i);
        const double t = 0.5 * (1.0 + b->eta[i]), s = 0.5 * (1.0 + b->xi[i]);
        double ab[3], ad[3], u[3], v[3], ab2 = 0.0, dc2 = 0.0, ad2 = 0.0, bc2 = 0.0, ac = 0.0, bd = 0.0, far = 0.0;
        for (int k = 0; k < 3; k++) {
            const double dc = xC[k] - xD[k], bc = xC[k] - xB[k];
            ab[k] = xB[k] - xA[k];
            ad[k] = xD[k] - xA[k];
            const double twist = dc - ab[k];
            u[k] = ab[k] + t * twist;
            v[k] = ad[k] + s * twist;
            ab2 += ab[k] * ab[k];
            dc2 += dc * dc;
            ad2 += ad[k] * ad[k];
            bc2 += bc * bc;
            ac += fabs(ab[k] + bc);
            bd += fabs(bc - dc);
            far += fabs(xA[k]) + fabs(xS[k]);
        }
        const double nx = u[1] * v[2] - u[2] * v[1], ny = u[2] * v[0] - u[0] * v[2], nz = u[0] * v[1] - u[1] * v[0];
        const double nn = nx * nx + ny * ny + nz * nz, xi2 = ab2 + dc2, eta2 = ad2 + bc2, size = xi2 * eta2;
        const int good = (nn > 1e-15 * size) & (size > 1e-200) & (xi2 + eta2 < 1e150) & (far < 1e100) & (ab2 > 0.0) &
                         (dc2 > 0.0) & (ad2 > 0.0) & (bc2 > 0.0) & (ac > 0.0) & (bd > 0.0) & (fabs(b->xi[i]) <= 9.0) &
                         (fabs(b->eta[i]) <= 9.0);
        bad |= good ? 0 : 1;
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
    GATHER(4, suffix, attributes)                                                                                      \
    GATHER(5, suffix, attributes)                                                                                      \
    attributes static uint64_t greatest32_##suffix(const struct footpoint_pairs *p, size_t first)                      \
    {                                                                                                                  \
        return greatest(p, first, 0);                                                                                  \
    }                                                                                                                  \
    attributes static uint64_t greatest64_##suffix(const struct footpoint_pairs *p, size_t first)                      \
    {                                                                                                                  \
        return greatest(p, first, KIND_WIDE);                                                                          \
    }                                                                                                                  \
    attributes static int all_good_##suffix(const struct block *b, size_t count)                                       \
    {                                                                                                                  \
        return all_good(b, count);                                                                                     \
    }                                                                                                                  \
    attributes static void gaps_##suffix(struct block *b, size_t count)                                                \
    {                                                                                                                  \
        gaps(b, count, 0);                                                                                             \
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
        {greatest32_##suffix, greatest64_##suffix},                                                                    \
        {gather0_##suffix, gather1_##suffix, gather2_##suffix, gather3_##suffix, gather4_##suffix, gather5_##suffix},  \
        {TIERS(NAME_SEARCH, suffix, attributes)},                                                                      \
        {TIERS(NAME_PREPARED, suffix, attributes)},                                                                    \
        all_good_##suffix,                                                                                             \
        gaps_##suffix,                                                                                                 \
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
