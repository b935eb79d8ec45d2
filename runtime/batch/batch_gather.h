/* Gathers the mesh's arrays into the columns of a block. For batch_lanes.c only, which compiles it for each instruction
 * set. */
#ifndef FOOTPOINT_BATCH_GATHER_H
#define FOOTPOINT_BATCH_GATHER_H

#include "batch_block.h"

#if defined(__GNUC__) && defined(__x86_64__) && defined(__has_builtin)
#if __has_builtin(__builtin_shufflevector) && __has_builtin(__builtin_convertvector)
#define HAVE_VECTORS 1
#endif
#endif

/* For indices from 0 to `last`, the highest bit is clear. */
#define OUTSIDE(index, last) ((index) | ((last) - (index)))

FOOTPOINT_FN int any_outside(const struct footpoint_pairs *p, size_t first, int kind)
{
    const size_t beyond = kind & KIND_TRIPLES ? 2 : 1;
    if (kind & KIND_WIDE) {
        const int64_t *const seg = p->seg64 + 4 * first, *const slave = p->slave64 + first;
        const uint64_t last = (uint64_t)p->nodes - beyond;
        uint64_t out = 0;
        for (size_t i = 0; i < 4 * BLOCK; i++)
            out |= OUTSIDE((uint64_t)seg[i], last);
        for (size_t i = 0; i < BLOCK; i++)
            out |= OUTSIDE((uint64_t)slave[i], last);
        return out >> 63 != 0;
    }
    const int32_t *const seg = p->seg + 4 * first, *const slave = p->slave + first;
    const uint32_t last =
        p->nodes - beyond > INT32_MAX && p->nodes >= beyond ? INT32_MAX : (uint32_t)(p->nodes - beyond);
    uint32_t out = 0;
    for (size_t i = 0; i < 4 * BLOCK; i++)
        out |= OUTSIDE((uint32_t)seg[i], last);
    for (size_t i = 0; i < BLOCK; i++)
        out |= OUTSIDE((uint32_t)slave[i], last);
    return out >> 31 != 0;
}

/* Returns the index of node k of pair i. */
FOOTPOINT_FN size_t index_of(const struct footpoint_pairs *p, size_t i, size_t k, int kind)
{
    if (kind & KIND_WIDE)
        return (size_t)(k < 4 ? p->seg64[4 * i + k] : p->slave64[i]);
    return (size_t)(k < 4 ? p->seg[4 * i + k] : p->slave[i]);
}

/* Prefetches nodes of later pairs: corners A and C and the slave node of every second pair, because neighbours share
 * the rest. Addresses are plain numbers, because these indices are not checked yet. */
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

/* Gathers two pairs at a time, because processors write two neighbours at once. */
FOOTPOINT_FN void gather_pairs(struct block *b, const struct footpoint_pairs *p, size_t first, int kind)
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
}

#ifdef HAVE_VECTORS
typedef double quad __attribute__((vector_size(32)));
typedef double octet __attribute__((vector_size(64)));
typedef double quad_there __attribute__((vector_size(32), aligned(8), may_alias));
typedef float quad_there_float __attribute__((vector_size(16), aligned(4), may_alias));

/* Writes columns of eight pairs, in stores as wide as the loads that follow; others cannot be forwarded. */
FOOTPOINT_FN void put(double *column, const quad *low, const quad *high, int vectors)
{
    if (vectors == 8) {
        *(octet *)column = __builtin_shufflevector(*low, *high, 0, 1, 2, 3, 4, 5, 6, 7);
    } else {
        *(quad *)column = *low;
        *(quad *)(column + 4) = *high;
    }
}

/* Reads node k of four pairs from columns of x, y and z, without the processors' gather instructions, which may be
 * slow. */
FOOTPOINT_FN void read_columns(const struct footpoint_pairs *p, size_t first, size_t k, int kind, size_t stride,
                               quad *x, quad *y, quad *z)
{
    const size_t a = stride * index_of(p, first, k, kind), b = stride * index_of(p, first + 1, k, kind);
    const size_t c = stride * index_of(p, first + 2, k, kind), d = stride * index_of(p, first + 3, k, kind);
    if (kind & KIND_FLOAT) {
        *x = (quad){(double)p->xf[a], (double)p->xf[b], (double)p->xf[c], (double)p->xf[d]};
        *y = (quad){(double)p->yf[a], (double)p->yf[b], (double)p->yf[c], (double)p->yf[d]};
        *z = (quad){(double)p->zf[a], (double)p->zf[b], (double)p->zf[c], (double)p->zf[d]};
    } else {
        *x = (quad){p->x[a], p->x[b], p->x[c], p->x[d]};
        *y = (quad){p->y[a], p->y[b], p->y[c], p->y[d]};
        *z = (quad){p->z[a], p->z[b], p->z[c], p->z[d]};
    }
}

/* Reads x, y and z of node k of a pair, and the number that follows them. */
FOOTPOINT_FN void read_triple(const struct footpoint_pairs *p, size_t pair, size_t k, int kind, size_t stride,
                              quad *node)
{
    const size_t at = stride * index_of(p, pair, k, kind);
    if (kind & KIND_FLOAT)
        *node = __builtin_convertvector(*(const quad_there_float *)(p->xf + at), quad);
    else
        *node = *(const quad_there *)(p->x + at);
}

/* Reads node k of four pairs from triples, and transposes. */
FOOTPOINT_FN void read_triples(const struct footpoint_pairs *p, size_t first, size_t k, int kind, size_t stride,
                               quad *x, quad *y, quad *z)
{
    quad a, b, c, d;
    read_triple(p, first, k, kind, stride, &a);
    read_triple(p, first + 1, k, kind, stride, &b);
    read_triple(p, first + 2, k, kind, stride, &c);
    read_triple(p, first + 3, k, kind, stride, &d);
    const quad xz = __builtin_shufflevector(a, b, 0, 4, 2, 6), xz2 = __builtin_shufflevector(c, d, 0, 4, 2, 6);
    const quad yy = __builtin_shufflevector(a, b, 1, 5, 1, 5), yy2 = __builtin_shufflevector(c, d, 1, 5, 1, 5);
    *x = __builtin_shufflevector(xz, xz2, 0, 1, 4, 5);
    *y = __builtin_shufflevector(yy, yy2, 0, 1, 4, 5);
    *z = __builtin_shufflevector(xz, xz2, 2, 3, 6, 7);
}

FOOTPOINT_FN void gather_octets(struct block *b, const struct footpoint_pairs *p, size_t first, int kind, int vectors,
                                size_t stride)
{
    for (size_t i = 0; i < BLOCK; i += 8)
        for (size_t k = 0; k < 5; k++) {
            quad x, y, z, x2, y2, z2;
            if (kind & KIND_TRIPLES) {
                read_triples(p, first + i, k, kind, stride, &x, &y, &z);
                read_triples(p, first + i + 4, k, kind, stride, &x2, &y2, &z2);
            } else {
                read_columns(p, first + i, k, kind, stride, &x, &y, &z);
                read_columns(p, first + i + 4, k, kind, stride, &x2, &y2, &z2);
            }
            put(b->x[3 * k] + i, &x, &x2, vectors);
            put(b->x[3 * k + 1] + i, &y, &y2, vectors);
            put(b->x[3 * k + 2] + i, &z, &z2, vectors);
        }
}
#else
#define gather_octets(b, p, first, kind, vectors, stride) gather_pairs(b, p, first, kind)
#endif

/* Returns true if pairs are also adjacent in the mesh, so that processors prefetch by themselves. */
FOOTPOINT_FN int is_near(const struct footpoint_pairs *p, size_t first, size_t k, int kind)
{
    return index_of(p, first + BLOCK - 1, k, kind) - index_of(p, first, k, kind) + 8 * BLOCK < 16 * BLOCK;
}

/* Gathers the columns of the pairs from `first`; nodes in triples far from each other are prefetched. */
FOOTPOINT_FN int gather(struct block *b, const struct footpoint_pairs *p, size_t first, int kind, int vectors)
{
    if (any_outside(p, first, kind))
        return 0;
    const size_t usual = kind & KIND_TRIPLES ? 3 : 1;
    if (vectors && p->stride == usual)
        gather_octets(b, p, first, kind, vectors, usual);
    else if (vectors)
        gather_octets(b, p, first, kind, vectors, p->stride);
    else
        gather_pairs(b, p, first, kind);
    if (p->n - first >= AHEAD + BLOCK && kind & KIND_TRIPLES &&
        !(is_near(p, first, 0, kind) && is_near(p, first, 4, kind)))
        fetch_nodes(p, first + AHEAD, kind);
    return 1;
}

#endif
