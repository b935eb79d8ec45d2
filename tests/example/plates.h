/* An explicit code without contact: a mesh, lumped masses, and forces of the elements.
 *
 * Two plates of eight-node hexahedra with one quadrature point and stiffness hourglass control (Flanagan and
 * Belytschko), total Lagrangian, St. Venant-Kirchhoff: strain is E = (F'F - 1)/2, energy lambda (tr E)^2/2 + mu E:E.
 * Forces are the exact gradient of that energy, so that only the time step changes the total energy. Units: mm, ms, g,
 * N, MPa. */
#ifndef PLATES_H
#define PLATES_H

#include "space.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

static const double YOUNG = 1000.0, POISSON = 0.4, DENSITY = 0.95e-3; /* MPa, g/mm^3: polyethylene */
static const double COURANT = 0.5; /* time step / longest stable time step of a single element */

struct element {
    double b[8][3], g[4][8];  /* dN/dX at the centre; hourglass shapes, orthogonal to linear motion */
    double volume, stiffness; /* stiffness: against hourglasses */
};

struct model {
    int nodes, elements, segs, slaves, first_upper; /* nodes from first_upper on belong to the upper plate */
    vec *X;                                         /* indexed by node; undeformed */
    int (*hex)[8], (*seg)[4], *slave;
    struct element *element;
    double *mass;          /* indexed by node */
    double lambda, mu, dt; /* Lame's constants, stable time step */
    double penalty;        /* N/mm */
};

/* ---- mesh ---- */

struct plate {
    int n[3];
    vec low, size;
    double turn;                      /* about z, radians */
    double (*height)(double, double); /* height of its contact side above z = low or low + size */
    int side;                         /* contact side: 0 below, 1 above */
};

static double waves(double x, double y)
{
    return 0.06 * sin(0.4 * x) * cos(0.3 * y);
}

static double bowl(double x, double y)
{
    return (x * x + y * y) / 600.0;
}

/* Places node (i,j,k) of a brick: inner nodes are moved in the plane, one side is curved, and the brick is turned about
 * z. */
static void place_node(const struct plate *p, const int ijk[3], vec X)
{
    double u[3], r[3];
    for (int c = 0; c < 3; c++) {
        u[c] = (double)ijk[c] / p->n[c];
        r[c] = p->low[c] + p->size[c] * u[c];
    }
    const double inner = 16.0 * u[0] * (1.0 - u[0]) * u[1] * (1.0 - u[1]);
    const double x = r[0] + 0.25 * inner * sin(1.3 * r[0]) * cos(0.9 * r[1]);
    const double y = r[1] + 0.25 * inner * cos(1.1 * r[0]) * sin(1.2 * r[1]);
    X[0] = x * cos(p->turn) - y * sin(p->turn);
    X[1] = x * sin(p->turn) + y * cos(p->turn);
    X[2] = r[2] + p->height(X[0], X[1]) * (p->side ? u[2] : 1.0 - u[2]);
}

static void add_plate(struct model *m, const struct plate *p)
{
    const int nx = p->n[0], ny = p->n[1], nz = p->n[2], row = nx + 1, layer = row * (ny + 1), first = m->nodes;
    m->X = room_for(m->X, (size_t)(first + layer * (nz + 1)), sizeof *m->X);
    m->hex = room_for(m->hex, (size_t)(m->elements + nx * ny * nz), sizeof *m->hex);
    for (int k = 0; k <= nz; k++)
        for (int j = 0; j <= ny; j++)
            for (int i = 0; i <= nx; i++)
                place_node(p, (int[3]){i, j, k}, m->X[m->nodes++]);
    for (int k = 0; k < nz; k++)
        for (int j = 0; j < ny; j++)
            for (int i = 0; i < nx; i++) {
                const int a = first + i + row * j + layer * k, c = a + layer;
                const int node[8] = {a, a + 1, a + row + 1, a + row, c, c + 1, c + row + 1, c + row};
                memcpy(m->hex[m->elements++], node, sizeof node);
            }
}

static void add_contact(struct model *m, const struct plate *lower, const struct plate *upper)
{
    const int below = lower->n[0] * lower->n[1] * (lower->n[2] - 1), quads = lower->n[0] * lower->n[1];
    m->segs = quads;
    m->seg = room_for(NULL, (size_t)quads, sizeof *m->seg);
    for (int s = 0; s < quads; s++)
        memcpy(m->seg[s], m->hex[below + s] + 4, sizeof *m->seg); /* S2, counter-clockwise from above */
    m->slaves = (upper->n[0] + 1) * (upper->n[1] + 1);
    m->slave = room_for(NULL, (size_t)m->slaves, sizeof *m->slave);
    for (int s = 0; s < m->slaves; s++)
        m->slave[s] = m->first_upper + s;
}

static void write_inp(const struct model *m)
{
    printf("*HEADING\nTwo plates of hexahedra, mm\n*NODE\n");
    for (int i = 0; i < m->nodes; i++)
        printf("%d, %.9g, %.9g, %.9g\n", i + 1, m->X[i][0], m->X[i][1], m->X[i][2]);
    for (int e = 0; e < m->elements; e++) {
        if (e == 0 || (m->hex[e][0] >= m->first_upper && m->hex[e - 1][0] < m->first_upper))
            printf("*ELEMENT, TYPE=C3D8R, ELSET=%s\n", e ? "UPPER" : "LOWER");
        printf("%d", e + 1);
        for (int a = 0; a < 8; a++)
            printf(", %d", m->hex[e][a] + 1);
        printf("\n");
    }
    printf("*SURFACE, NAME=TOP, TYPE=ELEMENT\n");
    for (int e = m->elements, s = m->segs; s > 0; e--)
        if (memcmp(m->hex[e - 1] + 4, m->seg[s - 1], sizeof *m->seg) == 0) {
            printf("%d, S2\n", e);
            s--;
        }
    printf("*NSET, NSET=BOTTOM\n");
    for (int s = 0; s < m->slaves; s++)
        printf("%d\n", m->slave[s] + 1);
    printf("*SURFACE, NAME=BELOW, TYPE=NODE\nBOTTOM\n"
           "*SURFACE INTERACTION, NAME=SMOOTH\n*CONTACT PAIR, INTERACTION=SMOOTH\nBELOW, TOP\n");
}

/* ---- elements ---- */

static const double CORNER[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                    {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};

/* Computes gradients at the centre, hourglass shapes h minus their linear part, and the element's share in masses and
 * dt. */
static void prepare_element(struct model *m, int e)
{
    struct element *const q = &m->element[e];
    const int *const node = m->hex[e];
    double J[3][3] = {{0}}, inverse[3][3], bb = 0.0;
    for (int a = 0; a < 8; a++)
        for (int i = 0; i < 9; i++)
            J[i / 3][i % 3] += 0.125 * CORNER[a][i / 3] * m->X[node[a]][i % 3];
    q->volume = 8.0 * invert(J, inverse);
    for (int a = 0; a < 8; a++)
        for (int i = 0; i < 3; i++) {
            q->b[a][i] = 0.0;
            for (int j = 0; j < 3; j++)
                q->b[a][i] += 0.125 * inverse[i][j] * CORNER[a][j];
            bb += q->b[a][i] * q->b[a][i];
        }
    for (int h = 0; h < 4; h++) {
        double shape[8], moment[3] = {0};
        for (int a = 0; a < 8; a++) {
            const double *const c = CORNER[a];
            shape[a] = h < 3 ? c[h] * c[(h + 1) % 3] : c[0] * c[1] * c[2];
            for (int i = 0; i < 3; i++)
                moment[i] += shape[a] * m->X[node[a]][i];
        }
        for (int a = 0; a < 8; a++)
            q->g[h][a] = shape[a] - moment[0] * q->b[a][0] - moment[1] * q->b[a][1] - moment[2] * q->b[a][2];
    }
    q->stiffness = 0.01 * (m->lambda + 2.0 * m->mu) * q->volume * bb;
    for (int a = 0; a < 8; a++)
        m->mass[node[a]] += 0.125 * DENSITY * q->volume;
    m->dt = fmin(m->dt, COURANT * sqrt(DENSITY / (m->lambda + 2.0 * m->mu) / bb) * 2.0);
}

/* Adds forces of the elements to f; returns the strain energy, including hourglasses. */
static double internal_forces(const struct model *m, const vec *x, vec *f)
{
    double energy = 0.0;
    for (int e = 0; e < m->elements; e++) {
        const struct element *const q = &m->element[e];
        const int *const node = m->hex[e];
        double F[3][3] = {{0}}, E[3][3], P[3][3], glass[4][3] = {{0}};
        for (int a = 0; a < 8; a++)
            for (int i = 0; i < 3; i++) {
                const double xa = x[node[a]][i];
                for (int j = 0; j < 3; j++)
                    F[i][j] += xa * q->b[a][j];
                for (int h = 0; h < 4; h++)
                    glass[h][i] += xa * q->g[h][a];
            }
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++)
                E[i][j] = 0.5 * (F[0][i] * F[0][j] + F[1][i] * F[1][j] + F[2][i] * F[2][j] - (i == j));
        const double pressure = m->lambda * (E[0][0] + E[1][1] + E[2][2]);
        for (int i = 0; i < 3; i++) /* P = F S, S = lambda tr E + 2 mu E */
            for (int j = 0; j < 3; j++) {
                P[i][j] = pressure * F[i][j];
                for (int k = 0; k < 3; k++)
                    P[i][j] += 2.0 * m->mu * F[i][k] * E[k][j];
                energy += 0.5 * q->volume * (2.0 * m->mu * E[i][j] + (i == j ? pressure : 0.0)) * E[i][j];
            }
        for (int h = 0; h < 4; h++)
            for (int i = 0; i < 3; i++)
                energy += 0.5 * q->stiffness * glass[h][i] * glass[h][i];
        for (int a = 0; a < 8; a++)
            for (int i = 0; i < 3; i++) {
                double fa = 0.0;
                for (int j = 0; j < 3; j++)
                    fa += q->volume * P[i][j] * q->b[a][j];
                for (int h = 0; h < 4; h++)
                    fa += q->stiffness * glass[h][i] * q->g[h][a];
                f[node[a]][i] -= fa;
            }
    }
    return energy;
}

/* ---- the model ---- */

static struct model plates(void)
{
    static const struct plate lower = {{32, 32, 3}, {-16.0, -16.0, -3.0}, {32.0, 32.0, 3.0}, 0.0, waves, 1};
    static const struct plate upper = {{32, 32, 4}, {-11.2, -11.2, 0.2}, {22.4, 22.4, 2.8}, 0.35, bowl, 0};
    struct model m = {.dt = 1e30};
    m.lambda = YOUNG * POISSON / ((1.0 + POISSON) * (1.0 - 2.0 * POISSON));
    m.mu = 0.5 * YOUNG / (1.0 + POISSON);
    m.penalty = 0.35 * (m.lambda + 2.0 * m.mu); /* about half the stiffness of an upper element (0.7 mm) */
    add_plate(&m, &lower);
    m.first_upper = m.nodes;
    add_plate(&m, &upper);
    add_contact(&m, &lower, &upper);
    m.mass = room_for(NULL, (size_t)m.nodes, sizeof *m.mass);
    m.element = room_for(NULL, (size_t)m.elements, sizeof *m.element);
    for (int n = 0; n < m.nodes; n++)
        m.mass[n] = 0.0;
    for (int e = 0; e < m.elements; e++)
        prepare_element(&m, e);
    return m;
}

static void free_model(struct model *m)
{
    free(m->X);
    free(m->hex);
    free(m->seg);
    free(m->slave);
    free(m->element);
    free(m->mass);
}

#endif
