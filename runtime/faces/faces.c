/* Faces of every kind; see footpoint_face.h. */
#include "../footpoint_face.h"
#include "face_table.h"

/* NULL: there is no such face. */
static const struct face *face_of(enum footpoint_face face)
{
    switch (face) {
    case FOOTPOINT_TRI3:
        return &footpoint_face_tri3;
    case FOOTPOINT_TRI6:
        return &footpoint_face_tri6;
    case FOOTPOINT_QUAD4:
        return &footpoint_face_quad4;
    case FOOTPOINT_QUAD8:
        return &footpoint_face_quad8;
    case FOOTPOINT_QUAD9:
        return &footpoint_face_quad9;
    default:
        return NULL;
    }
}

/* Nodes, and behind them the slave node. */
struct rows {
    const double *x[FACE_MOST_NODES + 1], *s;
};

static struct rows rows_of(const struct face *f, const double *x)
{
    struct rows r;
    for (int k = 0; k < f->nodes; k++)
        r.x[k] = x + 3 * k;
    r.s = x + 3 * f->nodes;
    return r;
}

int footpoint_face_nodes(enum footpoint_face face)
{
    const struct face *const f = face_of(face);
    return f ? f->nodes : 0;
}

int footpoint_face_locate(enum footpoint_face face, const double *x, double loc[2], double *gap)
{
    const struct face *const f = face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->locate(r.x, r.s, loc, gap);
}

int footpoint_face_closest(enum footpoint_face face, const double *x, double loc[2], double *distance, int *region)
{
    const struct face *const f = face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->closest(r.x, r.s, loc, distance, region);
}

int footpoint_face_place(enum footpoint_face face, const double *x, const double loc[2], double *phi, double *r_xi,
                         double *r_eta, double *normal, double *gap)
{
    const struct face *const f = face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->place(r.x, r.s, loc, phi, r_xi, r_eta, normal, gap);
}

int footpoint_face_differentiate(enum footpoint_face face, const double *x, const double loc[2], double *phi,
                                 double *r_xi, double *r_eta, double *normal, double *gap, double *d_xi, double *d_eta,
                                 double *d_gap)
{
    const struct face *const f = face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->differentiate(r.x, r.s, loc, phi, r_xi, r_eta, normal, gap, d_xi, d_eta, d_gap);
}

int footpoint_face_hessian(enum footpoint_face face, const double *x, const double loc[2], double *gap, double *d_xi,
                           double *d_eta, double *d_gap, double *d_normal, double *hessian)
{
    const struct face *const f = face_of(face);
    if (!f)
        return FOOTPOINT_ERR_ARGUMENT;
    const struct rows r = rows_of(f, x);
    return f->hessian(r.x, r.s, loc, gap, d_xi, d_eta, d_gap, d_normal, hessian);
}

/* ---- one slave node, many faces ---- */

/* In groups, in each of which the best one of those before comes first. */
int footpoint_face_select(enum footpoint_face face, const double *xyz, size_t candidates, const int *seg,
                          const double xS[3], size_t *chosen, double loc[2], double *distance, int *region)
{
    enum { GROUP = 16 };
    const struct face *const f = face_of(face);
    const double *x[GROUP * FACE_MOST_NODES];
    size_t best = 0, next = 0;
    int found = 0, status = f ? FOOTPOINT_ERR_DOMAIN : FOOTPOINT_ERR_ARGUMENT;
    const size_t nodes = f ? (size_t)f->nodes : 0;
    for (size_t i = 0; i < candidates * nodes; i++)
        if (seg[i] < 0)
            return FOOTPOINT_ERR_ARGUMENT;
    while (f && next < candidates) {
        size_t member[GROUP], n = 0, which;
        if (found)
            member[n++] = best;
        while (n < GROUP && next < candidates)
            member[n++] = next++;
        for (size_t i = 0; i < n * nodes; i++)
            x[i] = xyz + 3 * (size_t)seg[member[i / nodes] * nodes + i % nodes];
        const int one = f->nearest(n, x, xS, loc, distance, region, &which);
        if (one >= FOOTPOINT_OK) {
            best = member[which];
            found = 1;
        }
        if (one >= FOOTPOINT_OK || !found)
            status = one;
    }
    if (found)
        *chosen = best;
    return status;
}

/* ---- many pairs ---- */

struct columns {
    double x[3 * (FACE_MOST_NODES + 1)][FACE_BLOCK], xi[FACE_BLOCK], eta[FACE_BLOCK], gap[FACE_BLOCK];
    int status[FACE_BLOCK];
};

/* Index of node k of a pair; < 0: it is out of range. */
static long long node_of(const struct face *f, size_t nodes, const int *seg, const int *slave, size_t pair, int k)
{
    const int index = k < f->nodes ? seg[pair * (size_t)f->nodes + (size_t)k] : slave[pair];
    return index < 0 || (size_t)index >= nodes ? -1 : index;
}

/* One pair out of its columns; whether it is good. */
static int locate_one(const struct face *f, const struct columns *c, size_t i, double *loc, double *gap, int *status)
{
    double x[3 * (FACE_MOST_NODES + 1)];
    for (int k = 0; k < 3 * (f->nodes + 1); k++)
        x[k] = c->x[k][i];
    const struct rows r = rows_of(f, x);
    *status = f->locate(r.x, r.s, loc, gap);
    return *status == FOOTPOINT_OK;
}

size_t footpoint_face_locate_pairs(enum footpoint_face face, size_t n, const double *xyz, size_t nodes, const int *seg,
                                   const int *slave, double *loc, double *gap, int *status)
{
    const struct face *const f = face_of(face);
    size_t failed = 0;
    for (size_t i = 0; !f && status && i < n; i++)
        status[i] = FOOTPOINT_ERR_ARGUMENT;
    if (!f)
        return n;
    for (size_t first = 0; first < n; first += FACE_BLOCK) {
        const size_t count = n - first < FACE_BLOCK ? n - first : FACE_BLOCK;
        struct columns c;
        const double *column[3 * (FACE_MOST_NODES + 1)];
        int valid[FACE_BLOCK];
        for (size_t i = 0; i < FACE_BLOCK; i++) { /* copies of the last one fill the block */
            const size_t pair = first + (i < count ? i : count - 1);
            valid[i] = 1;
            for (int k = 0; k <= f->nodes; k++) {
                const long long node = node_of(f, nodes, seg, slave, pair, k);
                valid[i] = valid[i] && node >= 0;
                for (int j = 0; j < 3; j++)
                    c.x[3 * k + j][i] = node < 0 ? 0.0 : xyz[3 * node + j];
            }
        }
        for (int k = 0; k < 3 * (f->nodes + 1); k++)
            column[k] = c.x[k];
        f->block(column, c.xi, c.eta, c.gap, c.status);
        for (size_t i = 0; i < count; i++) {
            const size_t at = first + i;
            if (valid[i] && c.status[i] == FOOTPOINT_OK) {
                loc[2 * at] = c.xi[i];
                loc[2 * at + 1] = c.eta[i];
                gap[at] = c.gap[i];
            } else if (!valid[i] || !locate_one(f, &c, i, loc + 2 * at, gap + at, &c.status[i])) {
                c.status[i] = valid[i] ? c.status[i] : FOOTPOINT_ERR_ARGUMENT;
                failed++;
            }
            if (status)
                status[at] = c.status[i];
        }
    }
    return failed;
}
