/* An implicit code without contact: a mesh, forces of the elements and their tangent, a linear solver.
 *
 * Two blocks of elements, one on the other, whose faces are of one of seven kinds: tetrahedra of 4 and 10 nodes have
 * tri3 and tri6, hexahedra of 8, 20 and 27 nodes quad4, quad8 and quad9; plane strain elements of 4 and 8 nodes have
 * edge2 and edge3, in the x-y plane with y upwards; z is a third unknown that stays 0. Total Lagrangian, St.
 * Venant-Kirchhoff: strain is E = (F'F - 1)/2, energy lambda (tr E)^2/2 + mu E:E. Nodes lie on a lattice with two steps
 * per cell. Units: mm, N, MPa. */
#ifndef BLOCKS_H
#define BLOCKS_H

#include "../../runtime/footpoint_face.h"
#include "space.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double YOUNG = 1000.0, POISSON = 0.3; /* MPa */

static const char *const kind_name[] = {"tri3", "tri6", "quad4", "quad8", "quad9", "", "edge2", "edge3"};
enum { MOST_FACE = 9, MOST_SOLID = 27, MOST_POINTS = 27 };

/* An element, in coordinates from 0 to 1: its nodes, and gradients of the shape functions at quadrature points. */
struct solid {
    int nodes, points;
    vec place[MOST_SOLID], gradient[MOST_POINTS][MOST_SOLID];
    double weight[MOST_POINTS];
};

struct model {
    enum footpoint_face kind;
    struct solid solid;
    int nodes, elements, faces, slaves, unknowns, first_upper; /* nodes from first_upper on belong to the upper block */
    vec *X;                                                    /* indexed by node; undeformed */
    int *unknown; /* first unknown of each node's coordinates, -1: prescribed */
    int (*element)[MOST_SOLID];
    int *face;  /* nodes of the lower block's faces, face by face, counter-clockwise from above */
    int *slave; /* nodes on the underside of the upper block */
    double lambda, mu;
};

/* ---- linear equations ---- */

static double *row_of(double *A, int columns, int row)
{
    return A + (size_t)row * (size_t)columns;
}

static void exchange(int n, double *a, double *b)
{
    for (int i = 0; i < n; i++) {
        const double t = a[i];
        a[i] = b[i];
        b[i] = t;
    }
}

/* Solves A (n x n) Z = B (n x columns), rows first: Z replaces B, A is overwritten; pivots by columns. Returns 0 if A
 * is singular. */
static int solve(int n, double *A, int columns, double *B)
{
    for (int k = 0; k < n; k++) {
        double *const a = row_of(A, n, k), *const b = row_of(B, columns, k);
        int pivot = k;
        for (int r = k + 1; r < n; r++)
            pivot = fabs(row_of(A, n, r)[k]) > fabs(row_of(A, n, pivot)[k]) ? r : pivot;
        exchange(n, a, row_of(A, n, pivot));
        exchange(columns, b, row_of(B, columns, pivot));
        if (!(fabs(a[k]) > 0.0))
            return 0;
        for (int r = k + 1; r < n; r++) {
            double *const below = row_of(A, n, r), *const right = row_of(B, columns, r), factor = below[k] / a[k];
            for (int c = k; c < n && factor != 0.0; c++)
                below[c] -= factor * a[c];
            for (int c = 0; c < columns && factor != 0.0; c++)
                right[c] -= factor * b[c];
        }
    }
    for (int k = n - 1; k >= 0; k--)
        for (int c = 0; c < columns; c++) {
            const double *const a = row_of(A, n, k);
            double sum = row_of(B, columns, k)[c];
            for (int j = k + 1; j < n; j++)
                sum -= a[j] * row_of(B, columns, j)[c];
            row_of(B, columns, k)[c] = sum / a[k];
        }
    return 1;
}

/* ---- shape functions ---- */

static int is_tetrahedron(enum footpoint_face kind)
{
    return kind == FOOTPOINT_TRI3 || kind == FOOTPOINT_TRI6;
}

static int is_plane(enum footpoint_face kind)
{
    return kind == FOOTPOINT_EDGE2 || kind == FOOTPOINT_EDGE3;
}

/* Returns the axis that points from the lower block to the upper one. */
static int upwards(enum footpoint_face kind)
{
    return is_plane(kind) ? 1 : 2;
}

/* Returns true if a kind's element has a node this many half steps along each axis from its first node. Then x^p y^q
 * z^r is among its shape functions' monomials. */
static int has_node(enum footpoint_face kind, const int half[3])
{
    const int sum = half[0] + half[1] + half[2], middles = (half[0] == 1) + (half[1] == 1) + (half[2] == 1);
    switch (kind) {
    case FOOTPOINT_TRI3:
        return sum <= 2 && middles == 0;
    case FOOTPOINT_TRI6:
        return sum <= 2;
    case FOOTPOINT_QUAD4:
        return middles == 0;
    case FOOTPOINT_QUAD8:
        return middles <= 1;
    case FOOTPOINT_EDGE2:
        return half[1] == 0 && middles == 0;
    case FOOTPOINT_EDGE3:
        return half[1] == 0 && middles <= 1;
    default:
        return 1;
    }
}

/* Computes the powers of the monomial for that node: half steps 0, 1, 2 become 1, x^2 and x in tetrahedra of degree
 * 2. */
static void powers_of(enum footpoint_face kind, const int half[3], int power[3])
{
    for (int i = 0; i < 3; i++)
        power[i] = kind == FOOTPOINT_TRI6 ? half[i] : half[i] == 1 ? 2 : half[i] / 2;
}

static double power_of(double x, int p)
{
    return p == 0 ? 1.0 : p == 1 ? x : x * x;
}

static struct solid solid_of(enum footpoint_face kind)
{
    static const double gauss[3][3] = {
        {0.5, 0, 0}, {0.2113248654051871, 0.7886751345948129, 0}, {0.1127016653792583, 0.5, 0.8872983346207417}};
    static const double share[3][3] = {{1, 0, 0}, {0.5, 0.5, 0}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
    static const double near = 0.1381966011250105, far = 0.5854101966249685; /* a tetrahedron's quadrature points */
    struct solid s = {0};
    vec point[MOST_POINTS];
    int power[MOST_SOLID][3];
    double value[MOST_SOLID * MOST_SOLID], shape[MOST_SOLID * MOST_SOLID] = {0};
    const int order = kind == FOOTPOINT_QUAD4 || kind == FOOTPOINT_EDGE2 ? 2 : 3, thick = is_plane(kind) ? 1 : order;
    for (int i = 0; i < 27; i++) {
        const int half[3] = {i % 3, i / 3 % 3, i / 9};
        if (!has_node(kind, half))
            continue;
        for (int k = 0; k < 3; k++)
            s.place[s.nodes][k] = 0.5 * half[k];
        powers_of(kind, half, power[s.nodes++]);
    }
    if (is_tetrahedron(kind))
        for (; s.points < 4; s.points++) {
            for (int k = 0; k < 3; k++)
                point[s.points][k] = k == s.points ? far : near;
            s.weight[s.points] = 1.0 / 24;
        }
    else
        for (; s.points < order * thick * order; s.points++) {
            const int at[3] = {s.points % order, s.points / order % thick, s.points / order / thick};
            s.weight[s.points] = 1.0;
            for (int k = 0; k < 3; k++) {
                const int row = (k == 1 ? thick : order) - 1;
                point[s.points][k] = gauss[row][at[k]];
                s.weight[s.points] *= share[row][at[k]];
            }
        }
    /* Shape function a is the sum over m of shape[m][a] times monomial m: 1 at node a, 0 at the other nodes. */
    for (int a = 0; a < s.nodes; a++)
        for (int m = 0; m < s.nodes; m++) {
            value[a * s.nodes + m] = power_of(s.place[a][0], power[m][0]) * power_of(s.place[a][1], power[m][1]) *
                                     power_of(s.place[a][2], power[m][2]);
            shape[a * s.nodes + m] = a == m;
        }
    solve(s.nodes, value, s.nodes, shape);
    for (int q = 0; q < s.points; q++)
        for (int m = 0; m < s.nodes; m++)
            for (int k = 0; k < 3; k++) {
                const int *const p = power[m], i = (k + 1) % 3, j = (k + 2) % 3;
                if (p[k] == 0)
                    continue;
                const double by =
                    p[k] * power_of(point[q][k], p[k] - 1) * power_of(point[q][i], p[i]) * power_of(point[q][j], p[j]);
                for (int a = 0; a < s.nodes; a++)
                    s.gradient[q][a][k] += by * shape[m * s.nodes + a];
            }
    return s;
}

/* ---- mesh ---- */

struct block {
    int cells[3];
    vec low, size;
    double turn, wave; /* about z, radians; of the upper side, mm */
};

static void place_node(const struct block *b, int plane, const int at[3], vec X)
{
    double u[3];
    for (int k = 0; k < 3; k++)
        u[k] = 0.5 * at[k] / b->cells[k];
    if (plane) {
        X[0] = b->low[0] + b->size[0] * u[0];
        X[1] = b->low[2] + b->size[2] * u[2] + b->wave * u[2] * sin(1.1 * X[0] + 0.4);
        X[2] = 0.0;
        return;
    }
    const double x = b->low[0] + b->size[0] * u[0], y = b->low[1] + b->size[1] * u[1];
    X[0] = x * cos(b->turn) - y * sin(b->turn);
    X[1] = x * sin(b->turn) + y * cos(b->turn);
    X[2] = b->low[2] + b->size[2] * u[2] + b->wave * u[2] * sin(1.1 * x + 0.4) * cos(0.9 * y);
}

/* Returns true if an element has a node at that place of the lattice. */
static int is_node(enum footpoint_face kind, const int at[3])
{
    const int middles = at[0] % 2 + at[1] % 2 + at[2] % 2;
    return kind == FOOTPOINT_QUAD8 || kind == FOOTPOINT_EDGE3                             ? middles <= 1
           : kind == FOOTPOINT_TRI3 || kind == FOOTPOINT_QUAD4 || kind == FOOTPOINT_EDGE2 ? middles == 0
                                                                                          : 1;
}

/* Adds the elements of a cell whose lowest corner is `at`: one hexahedron, or the six tetrahedra along the paths from
 * there to the opposite corner. index: of nodes, on a lattice of n. */
static void add_cell(struct model *m, const int at[3], const int n[3], const int *index)
{
    static const int way[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    for (int t = 0; t < (is_tetrahedron(m->kind) ? 6 : 1); t++) {
        for (int a = 0; a < m->solid.nodes; a++) {
            const double *const u = m->solid.place[a];
            int place[3];
            for (int k = 0; k < 3; k++)
                place[k] = at[k] + (int)(2 * u[k]);
            if (is_tetrahedron(m->kind)) { /* its corners are 0 and the ends of one, two and three edges of the path */
                place[way[t][0]] = at[way[t][0]] + (int)(2 * (u[0] + u[1] + u[2]));
                place[way[t][1]] = at[way[t][1]] + (int)(2 * (u[1] + u[2]));
                place[way[t][2]] = at[way[t][2]] + (int)(2 * u[2]);
            }
            m->element[m->elements][a] = index[(place[2] * n[1] + place[1]) * n[0] + place[0]];
        }
        m->elements++;
    }
}

/* Adds the faces on top of such a cell. */
static void add_faces(struct model *m, const int at[3], const int n[3], const int *index)
{
    static const int quad[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    static const int tri[2][6][2] = {{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {2, 1}, {1, 1}},
                                     {{0, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 1}}};
    static const int edge[3][2] = {{2, 0}, {0, 0}, {1, 0}}; /* the block to its left */
    const int nodes = footpoint_face_nodes(m->kind);
    for (int f = 0; f < (is_tetrahedron(m->kind) ? 2 : 1); f++) {
        const int(*const node)[2] = is_tetrahedron(m->kind) ? tri[f] : is_plane(m->kind) ? edge : quad;
        for (int a = 0; a < nodes; a++)
            m->face[m->faces * nodes + a] = index[((n[2] - 1) * n[1] + at[1] + node[a][1]) * n[0] + at[0] + node[a][0]];
        m->faces++;
    }
}

/* Adds a block, with its nodes layer by layer to keep the bandwidth small. Its outer side, `held`, is prescribed. */
static void add_block(struct model *m, const struct block *b, int lower)
{
    const int plane = is_plane(m->kind), across = plane ? 1 : b->cells[1];
    const int n[3] = {2 * b->cells[0] + 1, plane ? 1 : 2 * across + 1, 2 * b->cells[2] + 1}, all = n[0] * n[1] * n[2];
    const int cells = b->cells[0] * across * b->cells[2], held = lower ? 0 : n[2] - 1;
    int *const index = room_for(NULL, (size_t)all, sizeof *index);
    m->X = room_for(m->X, (size_t)(m->nodes + all), sizeof *m->X);
    m->unknown = room_for(m->unknown, (size_t)(m->nodes + all), sizeof *m->unknown);
    m->element = room_for(m->element, (size_t)(m->elements + 6 * cells), sizeof *m->element);
    m->face = room_for(m->face, (size_t)(m->faces + 2 * cells) * MOST_FACE, sizeof *m->face);
    m->slave = room_for(m->slave, (size_t)(m->slaves + n[0] * n[1]), sizeof *m->slave);
    for (int i = 0; i < all; i++) {
        const int at[3] = {i % n[0], i / n[0] % n[1], i / n[0] / n[1]};
        if (!is_node(m->kind, at))
            continue;
        index[i] = m->nodes;
        place_node(b, plane, at, m->X[m->nodes]);
        m->unknown[m->nodes] = at[2] == held ? -1 : m->unknowns;
        m->unknowns += at[2] == held ? 0 : 3;
        if (!lower && at[2] == 0)
            m->slave[m->slaves++] = m->nodes;
        m->nodes++;
    }
    for (int i = 0; i < cells; i++) {
        const int at[3] = {2 * (i % b->cells[0]), 2 * (i / b->cells[0] % across), 2 * (i / b->cells[0] / across)};
        add_cell(m, at, n, index);
        if (lower && at[2] == n[2] - 3)
            add_faces(m, at, n, index);
    }
    free(index);
}

static struct model blocks(enum footpoint_face kind)
{
    static const struct block lower = {{3, 3, 1}, {-1.5, -1.5, -1.0}, {3.0, 3.0, 1.0}, 0.0, 0.05};
    static const struct block upper = {{2, 2, 1}, {-0.8, -0.8, 0.05}, {1.6, 1.6, 0.8}, 0.3, 0.0};
    struct model m = {.kind = kind, .solid = solid_of(kind)};
    m.lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    m.mu = 0.5 * YOUNG / (1.0 + POISSON);
    add_block(&m, &lower, 1);
    m.first_upper = m.nodes;
    add_block(&m, &upper, 0);
    return m;
}

static void free_model(struct model *m)
{
    free(m->X);
    free(m->unknown);
    free(m->element);
    free(m->face);
    free(m->slave);
}

/* ---- elements ---- */

/* Adds the tangent between two nodes: the change of the force on a when b moves. */
static void add_tangent(const struct model *m, double *K, int a, int b, double tangent[3][3])
{
    const int row = m->unknown[a], column = m->unknown[b];
    for (int i = 0; i < 3 && row >= 0 && column >= 0; i++)
        for (int j = 0; j < 3; j++)
            row_of(K, m->unknowns, row + i)[column + j] += tangent[i][j];
}

/* Adds the forces f of a quadrature point on the nodes and, since their derivatives are -K, its part of K. */
static void add_point(const struct model *m, const int *node, int q, const vec *x, vec *f, double *K)
{
    const struct solid *const s = &m->solid;
    double J[3][3] = {{0}}, inverse[3][3], F[3][3] = {{0}}, E[3][3], S[3][3], FF[3][3];
    vec g[MOST_SOLID], Fg[MOST_SOLID]; /* gradients by X, and F times these */
    for (int a = 0; a < s->nodes; a++)
        for (int i = 0; i < 9; i++)
            J[i / 3][i % 3] += s->gradient[q][a][i / 3] * m->X[node[a]][i % 3];
    if (is_plane(m->kind))
        J[1][2] = F[2][2] = 1.0; /* across the plane, along which nothing changes */
    const double volume = fabs(invert(J, inverse)) * s->weight[q];
    for (int a = 0; a < s->nodes; a++)
        for (int i = 0; i < 3; i++) {
            g[a][i] = 0.0;
            for (int j = 0; j < 3; j++)
                g[a][i] += inverse[i][j] * s->gradient[q][a][j];
        }
    for (int a = 0; a < s->nodes; a++)
        for (int i = 0; i < 9; i++)
            F[i / 3][i % 3] += x[node[a]][i / 3] * g[a][i % 3];
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            E[i][j] = 0.5 * (F[0][i] * F[0][j] + F[1][i] * F[1][j] + F[2][i] * F[2][j] - (i == j));
            FF[i][j] = F[i][0] * F[j][0] + F[i][1] * F[j][1] + F[i][2] * F[j][2];
        }
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++)
            S[i][j] = 2.0 * m->mu * E[i][j] + (i == j ? m->lambda * (E[0][0] + E[1][1] + E[2][2]) : 0.0);
    for (int a = 0; a < s->nodes; a++)
        for (int i = 0; i < 3; i++)
            Fg[a][i] = F[i][0] * g[a][0] + F[i][1] * g[a][1] + F[i][2] * g[a][2];
    for (int a = 0; a < s->nodes; a++) {
        vec Sg;
        for (int i = 0; i < 3; i++)
            Sg[i] = S[i][0] * g[a][0] + S[i][1] * g[a][1] + S[i][2] * g[a][2];
        for (int i = 0; i < 3; i++)
            f[node[a]][i] -= volume * (F[i][0] * Sg[0] + F[i][1] * Sg[1] + F[i][2] * Sg[2]);
        for (int b = 0; b < s->nodes; b++) {
            const double gg = g[a][0] * g[b][0] + g[a][1] * g[b][1] + g[a][2] * g[b][2];
            const double gSg = Sg[0] * g[b][0] + Sg[1] * g[b][1] + Sg[2] * g[b][2];
            double tangent[3][3];
            for (int i = 0; i < 3; i++)
                for (int j = 0; j < 3; j++)
                    tangent[i][j] = volume * (m->lambda * Fg[a][i] * Fg[b][j] +
                                              m->mu * (gg * FF[i][j] + Fg[b][i] * Fg[a][j]) + (i == j ? gSg : 0.0));
            add_tangent(m, K, node[a], node[b], tangent);
        }
    }
}

/* Adds the forces of the elements on the nodes, and their tangent -df/dx by the unknowns. */
static void add_elements(const struct model *m, const vec *x, vec *f, double *K)
{
    for (int e = 0; e < m->elements; e++)
        for (int q = 0; q < m->solid.points; q++)
            add_point(m, m->element[e], q, x, f, K);
}

#endif
