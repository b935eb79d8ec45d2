/* Contact, the part to copy: pairs by a global search in buckets; xi and eta of each pair by Newton's iteration or by
 * footpoint, from scratch or from the last step's answers; penalty forces if the gap is negative. Units: plates.h. */
#ifndef PENALTY_H
#define PENALTY_H

#include "plates.h"

#ifndef HEADER /* a generated header and one of its functions */
#define HEADER "../../generated/footpoint_quad4.h"
#define LOCATE footpoint_quad4_fine
#endif
#include HEADER

/* The function over arrays, and from last answers. */
#define OF_LOCATE(name, ending) name##ending
#define LOCATE_AS(name, ending) OF_LOCATE(name, ending)

static const double REACH = 0.3, DEPTH = 0.5; /* range of the global search, and largest penetration; mm */
enum { BLOCK = 128 };

/* A moving state, with its contact pairs and the times of its searches. */
struct world {
    vec *x, *v, *f;
    int pairs, room, *pair_seg, *pair_slave;
    double *xi, *eta;                       /* indexed by pair; choose_segments() moves them onto the segment */
    double *last_xi, *last_eta;             /* indexed by pair: the search's result, NaN before the first search */
    int *nearest;                           /* indexed by slave node: its pair, -1: no pair */
    double *distance;                       /* of each slave node from its nearest segment */
    double kinetic, strain, contact, force; /* energies; force: on the upper plate along z */
    double seconds[3], searched;            /* global search, local search, total; number of searched pairs */
    double *local;                          /* indexed by step: seconds of local search per pair */
};
enum { GLOBAL, LOCAL, ALL };

/* ---- global search ---- */

static void add_pair(struct world *w, int seg, int slave)
{
    if (w->pairs == w->room) {
        w->room = 2 * w->room + 1024;
        w->pair_seg = room_for(w->pair_seg, (size_t)w->room, sizeof *w->pair_seg);
        w->pair_slave = room_for(w->pair_slave, (size_t)w->room, sizeof *w->pair_slave);
        w->xi = room_for(w->xi, (size_t)w->room, sizeof *w->xi);
        w->eta = room_for(w->eta, (size_t)w->room, sizeof *w->eta);
        w->last_xi = room_for(w->last_xi, (size_t)w->room, sizeof *w->last_xi);
        w->last_eta = room_for(w->last_eta, (size_t)w->room, sizeof *w->last_eta);
    }
    w->last_xi[w->pairs] = w->last_eta[w->pairs] = (double)NAN;
    w->pair_seg[w->pairs] = seg;
    w->pair_slave[w->pairs++] = slave;
}

static int cell(double x, double low, double size, int n)
{
    const double c = (x - low) / size;
    return c < 0.0 ? 0 : c >= n ? n - 1 : (int)c;
}

/* Finds pairs of a segment and the slave nodes within REACH of its box. Slave nodes lie in buckets of 1 mm. */
static void find_pairs(const struct model *m, struct world *w)
{
    vec low = {1e30, 1e30, 1e30}, high = {-1e30, -1e30, -1e30};
    int n[3];
    for (int s = 0; s < m->slaves; s++)
        for (int i = 0; i < 3; i++) {
            low[i] = fmin(low[i], w->x[m->slave[s]][i]);
            high[i] = fmax(high[i], w->x[m->slave[s]][i]);
        }
    for (int i = 0; i < 3; i++)
        n[i] = 1 + (int)(high[i] - low[i]);
    const int cells = n[0] * n[1] * n[2];
    int *const head = room_for(NULL, (size_t)(cells + m->slaves), sizeof *head), *const next = head + cells;
    for (int c = 0; c < cells; c++)
        head[c] = -1;
    for (int s = m->slaves - 1; s >= 0; s--) {
        const double *const x = w->x[m->slave[s]];
        const int c = cell(x[0], low[0], 1.0, n[0]) +
                      n[0] * (cell(x[1], low[1], 1.0, n[1]) + n[1] * cell(x[2], low[2], 1.0, n[2]));
        next[s] = head[c];
        head[c] = s;
    }
    w->pairs = 0;
    for (int seg = 0; seg < m->segs; seg++) {
        vec from, to;
        int a[3], b[3];
        for (int i = 0; i < 3; i++) {
            const double p = w->x[m->seg[seg][0]][i], q = w->x[m->seg[seg][1]][i];
            const double r = w->x[m->seg[seg][2]][i], t = w->x[m->seg[seg][3]][i];
            from[i] = fmin(fmin(p, q), fmin(r, t)) - REACH;
            to[i] = fmax(fmax(p, q), fmax(r, t)) + REACH;
            a[i] = cell(from[i], low[i], 1.0, n[i]);
            b[i] = cell(to[i], low[i], 1.0, n[i]);
        }
        for (int k = a[2]; k <= b[2]; k++)
            for (int j = a[1]; j <= b[1]; j++)
                for (int i = a[0]; i <= b[0]; i++)
                    for (int s = head[i + n[0] * (j + n[1] * k)]; s >= 0; s = next[s]) {
                        const double *const x = w->x[m->slave[s]];
                        if (x[0] >= from[0] && x[0] <= to[0] && x[1] >= from[1] && x[1] <= to[1] && x[2] >= from[2] &&
                            x[2] <= to[2])
                            add_pair(w, seg, s);
                    }
    }
    free(head);
}

/* Finds the pairs, ordered by segment. Earlier pairs keep their last answers. */
static void global_search(const struct model *m, struct world *w)
{
    const int pairs = w->pairs;
    int *const seg = room_for(NULL, 2 * (size_t)pairs, sizeof *seg), *const slave = seg + pairs, first = 0;
    double *const xi = room_for(NULL, 2 * (size_t)pairs, sizeof *xi), *const eta = xi + pairs;
    for (int p = 0; p < pairs; p++) {
        seg[p] = w->pair_seg[p];
        slave[p] = w->pair_slave[p];
        xi[p] = w->last_xi[p];
        eta[p] = w->last_eta[p];
    }
    find_pairs(m, w);
    for (int p = 0; p < w->pairs; p++) {
        while (first < pairs && seg[first] < w->pair_seg[p])
            first++;
        for (int k = first; k < pairs && seg[k] == w->pair_seg[p]; k++)
            if (slave[k] == w->pair_slave[p]) {
                w->last_xi[p] = xi[k];
                w->last_eta[p] = eta[k];
            }
    }
    free(seg);
    free(xi);
}

/* ---- local search: xi and eta of all pairs ---- */

static double dot(const vec a, const vec b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Runs Newton's iteration from loc on r_xi . (S - r) = r_eta . (S - r) = 0 with r = c0 + c1 xi + c2 eta + c3 xi eta. */
static void newton(const double *A, const double *B, const double *C, const double *D, const double *S, double loc[2])
{
    vec c0, c1, c2, c3;
    double xi = loc[0], eta = loc[1], u = 1.0, v = 1.0;
    for (int i = 0; i < 3; i++) {
        c0[i] = S[i] - 0.25 * (A[i] + B[i] + C[i] + D[i]);
        c1[i] = 0.25 * (B[i] - A[i] + C[i] - D[i]);
        c2[i] = 0.25 * (D[i] - A[i] + C[i] - B[i]);
        c3[i] = 0.25 * (A[i] - B[i] + C[i] - D[i]);
    }
    for (int n = 0; n < 20 && (fabs(u) > 1e-8 || fabs(v) > 1e-8); n++) {
        vec a, b, d;
        for (int i = 0; i < 3; i++) {
            a[i] = c1[i] + c3[i] * eta;
            b[i] = c2[i] + c3[i] * xi;
            d[i] = c0[i] - c1[i] * xi - b[i] * eta;
        }
        const double aa = dot(a, a), bb = dot(b, b), ab = dot(a, b) - dot(c3, d), ad = dot(a, d), bd = dot(b, d);
        const double inverse = 1.0 / (aa * bb - ab * ab);
        u = (bb * ad - ab * bd) * inverse;
        v = (aa * bd - ab * ad) * inverse;
        xi += u;
        eta += v;
    }
    loc[0] = xi;
    loc[1] = eta;
}

/* Searches from the centre of the segment, or from the last answer if it exists. */
static void search_newton_from(const struct model *m, struct world *w, int last)
{
    for (int p = 0; p < w->pairs; p++) {
        const int *const node = m->seg[w->pair_seg[p]], from = last && w->last_xi[p] == w->last_xi[p];
        double loc[2] = {from ? w->last_xi[p] : 0.0, from ? w->last_eta[p] : 0.0};
        newton(w->x[node[0]], w->x[node[1]], w->x[node[2]], w->x[node[3]], w->x[m->slave[w->pair_slave[p]]], loc);
        w->xi[p] = loc[0];
        w->eta[p] = loc[1];
    }
}

static void search_newton(const struct model *m, struct world *w)
{
    search_newton_from(m, w, 0);
}

/* Searches a block of n pairs, whose nodes A, B, C, D, S are 15 columns of coordinates. */
typedef void search_block(size_t n, const double *const x[15], double *xi, double *eta);

static void search_columns(const struct model *m, struct world *w, search_block search)
{
    double column[15][BLOCK];
    const double *x[15];
    for (int k = 0; k < 15; k++)
        x[k] = column[k];
    for (int first = 0; first < w->pairs; first += BLOCK) {
        const int n = w->pairs - first < BLOCK ? w->pairs - first : BLOCK;
        for (int p = 0; p < n; p++) {
            const int *const node = m->seg[w->pair_seg[first + p]];
            const double *const S = w->x[m->slave[w->pair_slave[first + p]]];
            for (int i = 0; i < 3; i++) {
                for (int k = 0; k < 4; k++)
                    column[3 * k + i][p] = w->x[node[k]][i];
                column[12 + i][p] = S[i];
            }
        }
        search((size_t)n, x, w->xi + first, w->eta + first);
    }
}

/* Searches by footpoint: coordinates are copied into columns, over which the header's loop vectorises. */
static void search_footpoint(const struct model *m, struct world *w)
{
    search_columns(m, w, LOCATE_AS(LOCATE, _n));
}

static void copy_answers(const struct world *w, const double *const from[2], double *const to[2])
{
    for (int i = 0; i < 2; i++)
        memcpy(to[i], from[i], (size_t)w->pairs * sizeof *to[i]);
}

static void footpoint_from(size_t n, const double *const x[15], double *xi, double *eta)
{
    double gap[BLOCK];
    int status[BLOCK];
    LOCATE_AS(LOCATE, _from_n)(n, x, xi, eta, gap, status);
}

/* Searches by footpoint from the last answers and replaces them. */
static void search_footpoint_last(const struct model *m, struct world *w)
{
    copy_answers(w, (const double *const[]){w->last_xi, w->last_eta}, (double *const[]){w->xi, w->eta});
    search_columns(m, w, footpoint_from);
    copy_answers(w, (const double *const[]){w->xi, w->eta}, (double *const[]){w->last_xi, w->last_eta});
}

static void search_newton_last(const struct model *m, struct world *w)
{
    search_newton_from(m, w, 1);
    copy_answers(w, (const double *const[]){w->xi, w->eta}, (double *const[]){w->last_xi, w->last_eta});
}

/* ---- contact forces ---- */

/* Computes shape functions, gap vector S - r and unit normal at (xi,eta). */
static void foot(const struct model *m, const struct world *w, int pair, double xi, double eta, double phi[4], vec d,
                 vec n)
{
    const int *const node = m->seg[w->pair_seg[pair]];
    vec u = {0}, v = {0};
    memcpy(d, w->x[m->slave[w->pair_slave[pair]]], sizeof(vec));
    for (int k = 0; k < 4; k++) {
        const double s = CORNER[k][0], t = CORNER[k][1];
        phi[k] = 0.25 * (1.0 + s * xi) * (1.0 + t * eta);
        for (int i = 0; i < 3; i++) {
            const double x = w->x[node[k]][i];
            d[i] -= phi[k] * x;
            u[i] += 0.25 * s * (1.0 + t * eta) * x;
            v[i] += 0.25 * t * (1.0 + s * xi) * x;
        }
    }
    for (int i = 0; i < 3; i++)
        n[i] = u[(i + 1) % 3] * v[(i + 2) % 3] - u[(i + 2) % 3] * v[(i + 1) % 3];
    const double length = sqrt(dot(n, n));
    for (int i = 0; i < 3; i++)
        n[i] /= length;
}

/* Assigns each slave node to the segment with the nearest point. */
static void choose_segments(const struct model *m, struct world *w)
{
    double phi[4];
    vec d, n;
    for (int s = 0; s < m->slaves; s++) {
        w->nearest[s] = -1;
        w->distance[s] = DEPTH;
    }
    for (int p = 0; p < w->pairs; p++) {
        const int s = w->pair_slave[p];
        w->xi[p] = fmax(-1.0, fmin(1.0, w->xi[p]));
        w->eta[p] = fmax(-1.0, fmin(1.0, w->eta[p]));
        foot(m, w, p, w->xi[p], w->eta[p], phi, d, n);
        const double distance = sqrt(dot(d, d));
        if (distance < w->distance[s]) {
            w->distance[s] = distance;
            w->nearest[s] = p;
        }
    }
}

/* Adds penalty forces (10), (11) for negative gaps and returns their energy. */
static double contact_forces(const struct model *m, struct world *w)
{
    double energy = 0.0, phi[4];
    vec d, n;
    w->force = 0.0;
    for (int s = 0; s < m->slaves; s++) {
        const int p = w->nearest[s];
        if (p < 0)
            continue;
        foot(m, w, p, w->xi[p], w->eta[p], phi, d, n);
        const double gap = dot(d, n);
        if (gap >= 0.0)
            continue;
        const double push = -m->penalty * gap;
        for (int i = 0; i < 3; i++) {
            w->f[m->slave[s]][i] += push * n[i];
            for (int k = 0; k < 4; k++)
                w->f[m->seg[w->pair_seg[p]][k]][i] -= phi[k] * push * n[i];
        }
        energy += 0.5 * m->penalty * gap * gap;
        w->force += push * n[2];
    }
    return energy;
}

#endif
