/* The iteration-free search, for one pair and for many; see footpoint.h.  Pairs go in blocks: the gather from the mesh,
 * which jumps about in memory, stands apart from the arithmetic on contiguous columns, which compilers vectorise. */
#include "footpoint.h"

#include "check.h"

#include "../generated/footpoint_quad4.h"

enum { BLOCK = 64 };

int footpoint_locate(const double xA[3], const double xB[3], const double xC[3], const double xD[3], const double xS[3],
                     double loc[2], double *gap)
{
    double found[2], g;
    const int status = footpoint_quad4_accurate(xA, xB, xC, xD, xS, found, &g);
    if (status != FOOTPOINT_OK)
        return status;
    if (!footpoint_check(xA, xB, xC, xD, xS, found[0], found[1]))
        return FOOTPOINT_ERR_DOMAIN;
    loc[0] = found[0];
    loc[1] = found[1];
    *gap = g;
    return FOOTPOINT_OK;
}

/* Columns of a block: 15 coordinates in, xi, eta, gap and status out; area: whether the segment has a normal there. */
struct block {
    double x[15][BLOCK], xi[BLOCK], eta[BLOCK], gap[BLOCK];
    int status[BLOCK], area[BLOCK];
};

/* Coordinates of node `index`; zeros, and *valid cleared, if there is no such node. */
static const double *node_at(const double *xyz, size_t nodes, int index, int *valid)
{
    static const double none[3] = {0.0, 0.0, 0.0};
    if (index >= 0 && (size_t)index < nodes)
        return xyz + 3 * (size_t)index;
    *valid = 0;
    return none;
}

/* Columns of pairs first..first+count-1. */
static void gather(struct block *b, size_t first, size_t count, const double *xyz, size_t nodes, const int *seg,
                   const int *slave)
{
    for (size_t i = 0; i < count; i++) {
        int valid = 1;
        for (size_t k = 0; k < 5; k++) {
            const int index = k < 4 ? seg[4 * (first + i) + k] : slave[first + i];
            const double *const x = node_at(xyz, nodes, index, &valid);
            b->x[3 * k][i] = x[0];
            b->x[3 * k + 1][i] = x[1];
            b->x[3 * k + 2][i] = x[2];
        }
        b->status[i] = valid ? FOOTPOINT_OK : FOOTPOINT_ERR_ARGUMENT;
    }
}

/* Nodes of pair i. */
#define NODES_OF(b, i)                                                                                                 \
    const double xA[3] = {(b)->x[0][i], (b)->x[1][i], (b)->x[2][i]};                                                   \
    const double xB[3] = {(b)->x[3][i], (b)->x[4][i], (b)->x[5][i]};                                                   \
    const double xC[3] = {(b)->x[6][i], (b)->x[7][i], (b)->x[8][i]};                                                   \
    const double xD[3] = {(b)->x[9][i], (b)->x[10][i], (b)->x[11][i]};                                                 \
    const double xS[3] = {(b)->x[12][i], (b)->x[13][i], (b)->x[14][i]}

/* As footpoint_quad4_accurate does it for one pair, a loop for each of its parts: so each of them is vectorised. */
static void compute(struct block *b, size_t count)
{
    const double *x[15];
    for (size_t k = 0; k < 15; k++)
        x[k] = b->x[k];
    footpoint_quad4_accurate_n(count, x, b->xi, b->eta);
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, i);
        double gap = 0.0;
        b->area[i] = footpoint_detail_gap(xA, xB, xC, xD, xS, b->xi[i], b->eta[i], &gap);
        b->gap[i] = gap;
    }
    for (size_t i = 0; i < count; i++) {
        NODES_OF(b, i);
        const double sum = (b->xi[i] - b->xi[i]) + (b->eta[i] - b->eta[i]) + (b->gap[i] - b->gap[i]);
        const int nodes = footpoint_detail_inspect(xA, xB, xC, xD, xS);
        const int sure = footpoint_check(xA, xB, xC, xD, xS, b->xi[i], b->eta[i]);
        const int found = !(b->area[i] && sum == 0.0) ? FOOTPOINT_ERR_DEGENERATE
                          : sure                      ? FOOTPOINT_OK
                                                      : FOOTPOINT_ERR_DOMAIN;
        const int status = nodes != FOOTPOINT_OK ? nodes : found;
        b->status[i] = b->status[i] != FOOTPOINT_OK ? b->status[i] : status;
    }
}

size_t footpoint_locate_pairs(size_t n, const double *xyz, size_t nodes, const int *seg, const int *slave, double *loc,
                              double *gap, int *status)
{
    struct block b;
    size_t failed = 0;
    for (size_t first = 0; first < n; first += BLOCK) {
        const size_t count = n - first < BLOCK ? n - first : BLOCK;
        gather(&b, first, count, xyz, nodes, seg, slave);
        compute(&b, count);
        for (size_t i = 0; i < count; i++) {
            if (status)
                status[first + i] = b.status[i];
            if (b.status[i] != FOOTPOINT_OK) {
                failed++;
                continue;
            }
            loc[2 * (first + i)] = b.xi[i];
            loc[2 * (first + i) + 1] = b.eta[i];
            gap[first + i] = b.gap[i];
        }
    }
    return failed;
}
