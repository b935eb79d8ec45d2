/* Many pairs, in blocks; see pairs.h. */
#include "pairs.h"

struct columns {
    double x[3 * PAIRS_MOST_VECTORS][PAIRS_BLOCK], xi[PAIRS_BLOCK], eta[PAIRS_BLOCK], gap[PAIRS_BLOCK];
    int status[PAIRS_BLOCK];
};

/* Vector k of a pair, NULL: an index is out of range. */
static const double *vector_of(const struct pairs_kind *kind, const struct pairs *p, size_t pair, int k)
{
    const int is_normal = k >= kind->nodes && k < kind->nodes + kind->normals, corner = is_normal ? k - kind->nodes : k;
    const int index = corner < kind->nodes ? p->seg[pair * (size_t)kind->nodes + (size_t)corner] : p->slave[pair];
    return index < 0 || (size_t)index >= p->nodes ? NULL : (is_normal ? p->normals : p->xyz) + 3 * (size_t)index;
}

/* One pair out of its columns; whether it is good. */
static int locate_one(const struct pairs_kind *kind, const struct columns *c, size_t i, double *loc, double *gap,
                      int *status)
{
    const int vectors = kind->nodes + kind->normals;
    double y[PAIRS_MOST_VECTORS][3];
    const double *x[PAIRS_MOST_VECTORS];
    for (int k = 0; k <= vectors; k++) {
        for (int j = 0; j < 3; j++)
            y[k][j] = c->x[3 * k + j][i];
        x[k] = y[k];
    }
    *status = kind->locate(x, x[vectors], loc, gap);
    return *status == FOOTPOINT_OK;
}

size_t footpoint_pairs_locate(const struct pairs_kind *kind, const struct pairs *p, double *loc, double *gap,
                              int *status)
{
    const int vectors = kind ? kind->nodes + kind->normals : 0;
    size_t failed = 0;
    for (size_t i = 0; !kind && status && i < p->n; i++)
        status[i] = FOOTPOINT_ERR_ARGUMENT;
    if (!kind)
        return p->n;
    for (size_t first = 0; first < p->n; first += PAIRS_BLOCK) {
        const size_t count = p->n - first < PAIRS_BLOCK ? p->n - first : PAIRS_BLOCK;
        struct columns c;
        const double *column[3 * PAIRS_MOST_VECTORS];
        int valid[PAIRS_BLOCK];
        for (size_t i = 0; i < PAIRS_BLOCK; i++) { /* copies of the last one fill the block */
            const size_t pair = first + (i < count ? i : count - 1);
            valid[i] = 1;
            for (int k = 0; k <= vectors; k++) {
                const double *const x = vector_of(kind, p, pair, k);
                valid[i] = valid[i] && x;
                for (int j = 0; j < 3; j++)
                    c.x[3 * k + j][i] = x ? x[j] : 0.0;
            }
        }
        for (int k = 0; k < 3 * (vectors + 1); k++)
            column[k] = c.x[k];
        kind->block(column, c.xi, c.eta, c.gap, c.status);
        for (size_t i = 0; i < count; i++) {
            const size_t at = first + i;
            if (valid[i] && c.status[i] == FOOTPOINT_OK) {
                loc[2 * at] = c.xi[i];
                loc[2 * at + 1] = c.eta[i];
                gap[at] = c.gap[i];
            } else if (!valid[i] || !locate_one(kind, &c, i, loc + 2 * at, gap + at, &c.status[i])) {
                c.status[i] = valid[i] ? c.status[i] : FOOTPOINT_ERR_ARGUMENT;
                failed++;
            }
            if (status)
                status[at] = c.status[i];
        }
    }
    return failed;
}
