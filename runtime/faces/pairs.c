/* Searches many pairs in blocks; see pairs.h. */
#include "pairs.h"

struct columns {
    double x[3 * PAIRS_MOST_VECTORS][PAIRS_BLOCK], xi[PAIRS_BLOCK], eta[PAIRS_BLOCK], gap[PAIRS_BLOCK];
    int status[PAIRS_BLOCK], valid[PAIRS_BLOCK]; /* valid: all indices are in range */
};

/* Returns the number of a pair's vectors. */
static int vectors_with(const struct pairs_kind *kind)
{
    return kind->nodes + kind->normals + 1 + kind->directions;
}

/* Returns vector k of a pair, or NULL if an index is out of range. */
static const double *vector_of(const struct pairs_kind *kind, const struct pairs *p, size_t pair, int k)
{
    if (k > kind->nodes + kind->normals)
        return p->along + 3 * pair;
    const int is_normal = k >= kind->nodes && k < kind->nodes + kind->normals, corner = is_normal ? k - kind->nodes : k;
    const int index = corner < kind->nodes ? p->seg[pair * (size_t)kind->nodes + (size_t)corner] : p->slave[pair];
    return index < 0 || (size_t)index >= p->nodes ? NULL : (is_normal ? p->normals : p->xyz) + 3 * (size_t)index;
}

/* Searches a block from pair `first` on, filled up with copies of the last of `count` pairs.  last: answers by pair, or NULL. */
static void locate_block(const struct pairs_kind *kind, const struct pairs *p, size_t first, size_t count,
                         const double *last, struct columns *c)
{
    const int vectors = vectors_with(kind);
    const double *column[3 * PAIRS_MOST_VECTORS];
    for (size_t i = 0; i < PAIRS_BLOCK; i++) {
        const size_t pair = first + (i < count ? i : count - 1);
        c->valid[i] = 1;
        c->xi[i] = last ? last[2 * pair] : 0.0;
        c->eta[i] = last ? last[2 * pair + 1] : 0.0;
        for (int k = 0; k < vectors; k++) {
            const double *const x = vector_of(kind, p, pair, k);
            c->valid[i] = c->valid[i] && x;
            for (int j = 0; j < 3; j++)
                c->x[3 * k + j][i] = x ? x[j] : 0.0;
        }
    }
    for (int k = 0; k < 3 * vectors; k++)
        column[k] = c->x[k];
    kind->block(column, c->xi, c->eta, c->gap, c->status);
}

/* Copies the vectors of a pair from its columns. */
static void vectors_of(const struct pairs_kind *kind, const struct columns *c, size_t i, double y[][3])
{
    for (int k = 0; k < vectors_with(kind); k++)
        for (int j = 0; j < 3; j++)
            y[k][j] = c->x[3 * k + j][i];
}

/* Searches a single pair. */
static int locate_one(const struct pairs_kind *kind, const double y[][3], double *loc, double *gap)
{
    const double *x[PAIRS_MOST_VECTORS];
    for (int k = 0; k < vectors_with(kind); k++)
        x[k] = y[k];
    return kind->locate(x, x[kind->nodes + kind->normals], loc, gap);
}

static size_t refuse_all(const struct pairs *p, int *status)
{
    for (size_t i = 0; status && i < p->n; i++)
        status[i] = FOOTPOINT_ERR_ARGUMENT;
    return p->n;
}

size_t footpoint_pairs_locate(const struct pairs_kind *kind, const struct pairs *p, double *loc, double *gap,
                              int *status)
{
    size_t failed = 0;
    if (!kind)
        return refuse_all(p, status);
    for (size_t first = 0; first < p->n; first += PAIRS_BLOCK) {
        const size_t count = p->n - first < PAIRS_BLOCK ? p->n - first : PAIRS_BLOCK;
        struct columns c;
        locate_block(kind, p, first, count, kind->tracks ? loc : NULL, &c);
        for (size_t i = 0; i < count; i++) {
            const size_t at = first + i;
            double y[PAIRS_MOST_VECTORS][3];
            if (!c.valid[i]) {
                c.status[i] = FOOTPOINT_ERR_ARGUMENT;
            } else if (c.status[i] == FOOTPOINT_OK) {
                loc[2 * at] = c.xi[i];
                loc[2 * at + 1] = c.eta[i];
                gap[at] = c.gap[i];
            } else {
                vectors_of(kind, &c, i, y);
                c.status[i] = locate_one(kind, (const double(*)[3])y, loc + 2 * at, gap + at);
            }
            failed += c.status[i] != FOOTPOINT_OK;
            if (status)
                status[at] = c.status[i];
        }
    }
    return failed;
}

size_t footpoint_pairs_finish(const struct pairs_kind *kind, const struct pairs *p, pairs_finish *finish,
                              const void *of, int *status)
{
    size_t failed = 0;
    if (!kind)
        return refuse_all(p, status);
    for (size_t first = 0; first < p->n; first += PAIRS_BLOCK) {
        const size_t count = p->n - first < PAIRS_BLOCK ? p->n - first : PAIRS_BLOCK;
        struct columns c;
        locate_block(kind, p, first, count, NULL, &c);
        for (size_t i = 0; i < count; i++) {
            double y[PAIRS_MOST_VECTORS][3], loc[2] = {c.xi[i], c.eta[i]}, gap = c.gap[i];
            int outcome = FOOTPOINT_ERR_ARGUMENT;
            if (c.valid[i]) {
                vectors_of(kind, &c, i, y);
                if (c.status[i] != FOOTPOINT_OK)
                    c.status[i] = locate_one(kind, (const double(*)[3])y, loc, &gap);
                outcome = finish(of, first + i, y[0], c.status[i], loc, gap);
            }
            failed += outcome != FOOTPOINT_OK && outcome != FOOTPOINT_OUTSIDE;
            if (status)
                status[first + i] = outcome;
        }
    }
    return failed;
}
