/* Batches of pairs, and several slave nodes over one segment; see footpoint_batch.h. Full blocks of pairs with valid
 * indices and good answers take the short path. All others are gathered and checked pair by pair, and pairs that still
 * have no good answer are searched separately. */
#include "batch_block.h"

#include "../geometry/vector.h"
#include "../search/locate.h"

/* Destination of answers: one of loc, locf. */
struct answers {
    double *loc, *gap;
    float *locf, *gapf;
    int *status;
};

struct batch {
    const struct footpoint_pairs *p;
    const struct lanes *lanes;
    struct answers to;
    enum footpoint_tier tier;
    int kind; /* of the arrays */
};

static void store_pair(const struct answers *to, const struct block *b, size_t first, size_t i)
{
    if (to->loc) {
        to->loc[2 * (first + i)] = b->xi[i];
        to->loc[2 * (first + i) + 1] = b->eta[i];
    } else {
        to->locf[2 * (first + i)] = (float)b->xi[i];
        to->locf[2 * (first + i) + 1] = (float)b->eta[i];
    }
    if (to->gap)
        to->gap[first + i] = b->gap[i];
    if (to->gapf)
        to->gapf[first + i] = (float)b->gap[i];
}

/* Stores the answers of pairs first..first+BLOCK-1, all good: a loop for each array. */
static void store_block(const struct answers *to, const struct block *b, size_t first)
{
    for (size_t i = 0; to->loc && i < BLOCK; i++) {
        to->loc[2 * (first + i)] = b->xi[i];
        to->loc[2 * (first + i) + 1] = b->eta[i];
    }
    for (size_t i = 0; to->locf && i < BLOCK; i++) {
        to->locf[2 * (first + i)] = (float)b->xi[i];
        to->locf[2 * (first + i) + 1] = (float)b->eta[i];
    }
    for (size_t i = 0; to->gap && i < BLOCK; i++)
        to->gap[first + i] = b->gap[i];
    for (size_t i = 0; to->gapf && i < BLOCK; i++)
        to->gapf[first + i] = (float)b->gap[i];
    for (size_t i = 0; to->status && i < BLOCK; i++)
        to->status[first + i] = FOOTPOINT_OK;
}

/* Prefetches the places of later answers. */
static void fetch_places(const struct answers *to, size_t first)
{
#ifdef __GNUC__
    const uintptr_t loc = to->loc ? (uintptr_t)(to->loc + 2 * first) : (uintptr_t)(to->locf + 2 * first);
    const uintptr_t end = loc + 2 * BLOCK * (to->loc ? sizeof *to->loc : sizeof *to->locf);
    for (uintptr_t at = loc; at < end; at += CACHE_LINE)
        __builtin_prefetch((const void *)at, 1);
#else
    (void)to, (void)first;
#endif
}

/* Searches again, one at a time, for pairs without a good answer. prepared: with the corners of the first pair. */
static void search_again(struct block *b, size_t count, enum footpoint_tier tier, int sure, int prepared)
{
    for (size_t i = 0; i < count; i++) {
        double x[5][3], loc[2] = {0.0, 0.0};
        if (b->status[i] != FOOTPOINT_ERR_DEGENERATE)
            continue;
        for (size_t k = 0; k < 15; k++)
            x[k / 3][k % 3] = b->x[k][prepared && k < 12 ? 0 : i];
        const double *const nodes[5] = {x[0], x[1], x[2], x[3], x[4]};
        b->status[i] = footpoint_locate_one(tier, sure, nodes, loc, &b->gap[i]);
        b->xi[i] = loc[0];
        b->eta[i] = loc[1];
    }
}

/* Stores the answers of `count` pairs with their statuses; returns how many are not good. */
static size_t store_judged(const struct answers *to, const struct block *b, size_t first, size_t count)
{
    size_t failed = 0;
    for (size_t i = 0; i < count; i++) {
        if (to->status)
            to->status[first + i] = (int)b->status[i];
        if (b->status[i] >= FOOTPOINT_OK)
            store_pair(to, b, first, i);
        failed += b->status[i] != FOOTPOINT_OK;
    }
    return failed;
}

/* Reads the coordinates of node k of pair i; returns 0 if there is no such node. */
static int node_of(const struct footpoint_pairs *p, size_t i, size_t k, double x[3])
{
    const int64_t index =
        p->seg64 ? (k < 4 ? p->seg64[4 * i + k] : p->slave64[i]) : (k < 4 ? p->seg[4 * i + k] : p->slave[i]);
    if (index < 0 || (uint64_t)index >= p->nodes)
        return 0;
    const size_t at = p->stride * (size_t)index;
    x[0] = p->x ? p->x[at] : (double)p->xf[at];
    x[1] = p->x ? p->y[at] : (double)p->yf[at];
    x[2] = p->x ? p->z[at] : (double)p->zf[at];
    return 1;
}

/* Gathers columns of `count` pairs, then copies of the last pair up to a multiple of LANES. invalid: pairs without all
 * their nodes, a bit each. */
static size_t gather_checked(const struct footpoint_pairs *p, size_t first, size_t count, struct block *b,
                             uint64_t *invalid)
{
    size_t i = 0;
    *invalid = 0;
    for (; i < count || i % LANES != 0; i++)
        for (size_t k = 0; k < 5; k++) {
            double x[3] = {0.0, 0.0, 0.0};
            if (!node_of(p, first + (i < count ? i : count - 1), k, x))
                *invalid |= (uint64_t)1 << i;
            for (size_t c = 0; c < 3; c++)
                b->x[3 * k + c][i] = x[c];
        }
    return i;
}

static size_t locate_checked(const struct batch *batch, size_t first, size_t count)
{
    struct block b;
    uint64_t invalid;
    const size_t padded = gather_checked(batch->p, first, count, &b, &invalid);
    (void)batch->lanes->search[batch->tier](&b, padded);
    if (batch->p->sure)
        batch->lanes->verify(&b, padded);
    search_again(&b, count, batch->tier, batch->p->sure, 0);
    for (size_t i = 0; i < count; i++)
        if (invalid >> i & 1)
            b.status[i] = FOOTPOINT_ERR_ARGUMENT;
    return store_judged(&batch->to, &b, first, count);
}

static size_t locate_block(const struct batch *batch, size_t first)
{
    struct block b;
    const struct lanes *const lanes = batch->lanes;
    const struct footpoint_pairs *const p = batch->p;
    if (!lanes->gather[batch->kind](&b, p, first))
        return locate_checked(batch, first, BLOCK);
    if (p->n - first >= AHEAD + BLOCK)
        fetch_places(&batch->to, first + AHEAD);
    if (!lanes->search[batch->tier](&b, BLOCK) || p->sure) {
        if (p->sure)
            lanes->verify(&b, BLOCK);
        search_again(&b, BLOCK, batch->tier, p->sure, 0);
        return store_judged(&batch->to, &b, first, BLOCK);
    }
    store_block(&batch->to, &b, first);
    return 0;
}

static int kind_of(const struct footpoint_pairs *p)
{
    const int triples = p->nodes > 0 && p->stride > 2 &&
                        (p->x ? p->y == p->x + 1 && p->z == p->x + 2 : p->yf == p->xf + 1 && p->zf == p->xf + 2);
    return (p->seg64 ? KIND_WIDE : 0) | (p->x ? 0 : KIND_FLOAT) | (triples ? KIND_TRIPLES : 0);
}

static int is_tier(enum footpoint_tier tier)
{
    return (int)tier >= 0 && tier < FOOTPOINT_TIERS;
}

static void refuse(int *status, size_t n)
{
    for (size_t i = 0; status && i < n; i++)
        status[i] = FOOTPOINT_ERR_ARGUMENT;
}

static int is_sound(const struct footpoint_pairs *p, enum footpoint_tier tier)
{
    const int coordinates = (p->x ? p->y && p->z : p->xf && p->yf && p->zf) || p->nodes == 0;
    const int indices = p->seg64 ? p->slave64 != NULL : p->seg && p->slave;
    return coordinates && indices && p->stride > 0 && is_tier(tier);
}

static size_t locate(const struct footpoint_pairs *p, enum footpoint_tier tier, const struct answers *to)
{
    size_t failed = 0;
    if (!is_sound(p, tier)) {
        refuse(to->status, p->n);
        return p->n;
    }
    const struct batch batch = {p, footpoint_batch_lanes(), *to, tier, kind_of(p)};
    const ptrdiff_t blocks = (ptrdiff_t)(p->n / BLOCK);
#ifdef _OPENMP
#pragma omp parallel for schedule(static) reduction(+ : failed)
#endif
    for (ptrdiff_t block = 0; block < blocks; block++)
        failed += locate_block(&batch, BLOCK * (size_t)block);
    if (p->n % BLOCK != 0)
        failed += locate_checked(&batch, BLOCK * (size_t)blocks, p->n % BLOCK);
    return failed;
}

size_t footpoint_locate_batch(const struct footpoint_pairs *p, enum footpoint_tier tier, double *loc, double *gap,
                              int *status)
{
    const struct answers to = {loc, gap, NULL, NULL, status};
    return locate(p, tier, &to);
}

size_t footpoint_locate_batch_float(const struct footpoint_pairs *p, enum footpoint_tier tier, float *loc, float *gap,
                                    int *status)
{
    const struct answers to = {NULL, NULL, loc, gap, status};
    return locate(p, tier, &to);
}

/* ---- several slave nodes over one segment ---- */

int footpoint_prepare(const double xA[3], const double xB[3], const double xC[3], const double xD[3],
                      struct footpoint_segment *segment)
{
    const double *const x[4] = {xA, xB, xC, xD};
    if (!vector_finite(xA) || !vector_finite(xB) || !vector_finite(xC) || !vector_finite(xD))
        return FOOTPOINT_ERR_NOT_FINITE;
    for (int k = 0; k < 3; k++) {
        const double ab = xB[k] - xA[k], dc = xC[k] - xD[k];
        for (int i = 0; i < 4; i++)
            segment->x[i][k] = x[i][k];
        segment->c1[k] = 0.25 * (ab + dc);
        segment->c2[k] = 0.25 * ((xD[k] - xA[k]) + (xC[k] - xB[k]));
        segment->c3[k] = 0.25 * (dc - ab);
    }
    return FOOTPOINT_OK;
}

size_t footpoint_locate_prepared(const struct footpoint_segment *segment, enum footpoint_tier tier, size_t n,
                                 const double *xs, double *loc, double *gap, int *status)
{
    const struct lanes *const lanes = footpoint_batch_lanes();
    const struct answers to = {loc, gap, NULL, NULL, status};
    struct block b;
    size_t failed = 0;
    if (!is_tier(tier)) {
        refuse(status, n);
        return n;
    }
    for (size_t k = 0; k < 12; k++)
        b.x[k][0] = segment->x[k / 3][k % 3];
    for (size_t first = 0; first < n; first += BLOCK) {
        const size_t count = n - first < BLOCK ? n - first : BLOCK;
        size_t i = 0;
        for (; i < count || i % LANES != 0; i++)
            for (size_t k = 0; k < 3; k++)
                b.x[12 + k][i] = xs[3 * (first + (i < count ? i : count - 1)) + k];
        if (!lanes->prepared[tier](&b, i))
            search_again(&b, count, tier, 0, 1);
        failed += store_judged(&to, &b, first, count);
    }
    return failed;
}

_Static_assert(sizeof(int) == sizeof(int32_t), "indices of 32 bits");

size_t footpoint_locate_pairs(size_t n, const double *xyz, size_t nodes, const int *seg, const int *slave, double *loc,
                              double *gap, int *status)
{
    const struct footpoint_pairs p = {.n = n,
                                      .nodes = nodes,
                                      .x = xyz,
                                      .y = nodes ? xyz + 1 : NULL,
                                      .z = nodes ? xyz + 2 : NULL,
                                      .stride = 3,
                                      .seg = seg,
                                      .slave = slave,
                                      .sure = 1};
    return footpoint_locate_batch(&p, FOOTPOINT_ACCURATE, loc, gap, status);
}
