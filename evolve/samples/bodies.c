/* Smooth bodies and their meshes; see bodies.h.  The closest point of a graph z = f(x,y) is found by Newton's
 * iteration from the point above or below. */
#include "bodies.h"

#include "../../runtime/geometry/footpoint-node-normals.h"
#include "../common/stream.h"
#include "../common/vec3.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TUBE 0.4
#define SADDLE 0.4
#define SHEET_DEPTH 0.35
#define SHEET_RADIUS 0.5

const char *const smooth_name[SMOOTH_KINDS] = {"sphere", "torus", "saddle", "sheet"};

static double project_sphere(const double x[3], double foot[3], double normal[3])
{
    const double length = vector_length(x);
    for (int k = 0; k < 3; k++)
        foot[k] = normal[k] = x[k] / length;
    return length - 1;
}

static double project_torus(const double x[3], double foot[3], double normal[3])
{
    const double ring = hypot(x[0], x[1]), tube[3] = {x[0] - x[0] / ring, x[1] - x[1] / ring, x[2]};
    const double length = vector_length(tube);
    for (int k = 0; k < 3; k++) {
        normal[k] = tube[k] / length;
        foot[k] = (x[k] - tube[k]) + TUBE * normal[k];
    }
    return length - TUBE;
}

/* Computes f, f_x, f_y, f_xx, f_xy and f_yy. */
static void graph(enum smooth_kind kind, double x, double y, double f[6])
{
    if (kind == SMOOTH_SADDLE) {
        const double value[6] = {SADDLE * (x * x - y * y), 2 * SADDLE * x, -2 * SADDLE * y, 2 * SADDLE, 0, -2 * SADDLE};
        memcpy(f, value, sizeof value);
        return;
    }
    /* f = -d/(1 + q^2) with q = (x^2 + y^2)/a^2 */
    const double aa = SHEET_RADIUS * SHEET_RADIUS, q = (x * x + y * y) / aa, below = 1 + q * q;
    const double g1 = 2 * SHEET_DEPTH * q / (below * below);
    const double g2 = 2 * SHEET_DEPTH * (1 - 3 * q * q) / (below * below * below);
    const double qx = 2 * x / aa, qy = 2 * y / aa;
    const double value[6] = {-SHEET_DEPTH / below,       g1 * qx,      g1 * qy,
                             g2 * qx * qx + 2 * g1 / aa, g2 * qx * qy, g2 * qy * qy + 2 * g1 / aa};
    memcpy(f, value, sizeof value);
}

static double project_graph(enum smooth_kind kind, const double x[3], double foot[3], double normal[3])
{
    double u = x[0], v = x[1], f[6];
    for (int i = 0; i < 50; i++) {
        graph(kind, u, v, f);
        const double h = f[0] - x[2], r1 = u - x[0] + h * f[1], r2 = v - x[1] + h * f[2];
        const double a = 1 + f[1] * f[1] + h * f[3], b = f[1] * f[2] + h * f[4], c = 1 + f[2] * f[2] + h * f[5];
        const double det = a * c - b * b, du = (b * r2 - c * r1) / det, dv = (b * r1 - a * r2) / det;
        u += du;
        v += dv;
        if (fabs(du) + fabs(dv) < 1e-16)
            break;
    }
    graph(kind, u, v, f);
    const double n[3] = {-f[1], -f[2], 1}, length = vector_length(n);
    const double at[3] = {u, v, f[0]};
    double distance = 0;
    for (int k = 0; k < 3; k++) {
        foot[k] = at[k];
        normal[k] = n[k] / length;
        distance += (x[k] - at[k]) * normal[k];
    }
    return distance;
}

double smooth_project(enum smooth_kind kind, const double x[3], double foot[3], double normal[3])
{
    return kind == SMOOTH_SPHERE  ? project_sphere(x, foot, normal)
           : kind == SMOOTH_TORUS ? project_torus(x, foot, normal)
                                  : project_graph(kind, x, foot, normal);
}

/* ---- meshes ---------------------------------------------------------------------------------------------------- */

static struct smooth_mesh *room_for(enum smooth_kind kind, size_t nodes, size_t segments)
{
    struct smooth_mesh *m = new_array(1, sizeof *m);
    m->kind = kind;
    m->xyz = arena_array(&m->memory, nodes, sizeof *m->xyz);
    m->exact = arena_array(&m->memory, nodes, sizeof *m->exact);
    m->mean = arena_array(&m->memory, nodes, sizeof *m->mean);
    m->seg = arena_array(&m->memory, segments, sizeof *m->seg);
    return m;
}

static void add_segment(struct smooth_mesh *m, int a, int b, int c, int d)
{
    const int corner[4] = {a, b, c, d};
    memcpy(m->seg[m->segments++], corner, sizeof corner);
}

/* Returns the node at lattice point p of a cube with n segments a side. A new node gets the next number. */
static int cube_node(struct smooth_mesh *m, int *number, int n, const int p[3])
{
    int *at = &number[(p[0] * (n + 1) + p[1]) * (n + 1) + p[2]];
    if (*at == 0) {
        for (int k = 0; k < 3; k++)
            m->xyz[m->nodes][k] = tan(M_PI_4 * (2.0 * p[k] / n - 1));
        *at = (int)++m->nodes;
    }
    return *at - 1;
}

/* Projects a cube's lattice, with equal angles, onto the sphere. */
static struct smooth_mesh *sphere(int n)
{
    const size_t side = (size_t)n;
    struct smooth_mesh *m = room_for(SMOOTH_SPHERE, 6 * side * side + 2, 6 * side * side);
    int *number = new_array((side + 1) * (side + 1) * (side + 1), sizeof *number);
    for (int face = 0; face < 6; face++) {
        const int a = face % 3, b = (a + 1) % 3, c = (a + 2) % 3; /* a is normal to the face */
        for (int i = 0; i < n; i++)
            for (int j = 0; j < n; j++) {
                int node[4];
                for (int k = 0; k < 4; k++) {
                    int p[3];
                    p[a] = face < 3 ? n : 0;
                    p[b] = i + (k == 1 || k == 2);
                    p[c] = j + (k >= 2);
                    node[k] = cube_node(m, number, n, p);
                }
                if (face < 3)
                    add_segment(m, node[0], node[1], node[2], node[3]);
                else
                    add_segment(m, node[0], node[3], node[2], node[1]);
            }
    }
    free(number);
    return m;
}

static struct smooth_mesh *torus(int n)
{
    const int around = 2 * n;
    const size_t count = (size_t)around * (size_t)n;
    struct smooth_mesh *m = room_for(SMOOTH_TORUS, count, count);
    for (int i = 0; i < around; i++)
        for (int j = 0; j < n; j++) {
            const double phi = 2 * M_PI * i / around, theta = 2 * M_PI * j / n, ring = 1 + TUBE * cos(theta);
            const double x[3] = {ring * cos(phi), ring * sin(phi), TUBE * sin(theta)};
            const int next = (i + 1) % around;
            memcpy(m->xyz[m->nodes++], x, sizeof x);
            add_segment(m, i * n + j, next * n + j, next * n + (j + 1) % n, i * n + (j + 1) % n);
        }
    return m;
}

static struct smooth_mesh *square(enum smooth_kind kind, int n)
{
    const size_t side = (size_t)n;
    struct smooth_mesh *m = room_for(kind, (side + 1) * (side + 1), side * side);
    for (int i = 0; i <= n; i++)
        for (int j = 0; j <= n; j++) {
            const int a = i * (n + 1) + j, b = a + n + 1;
            m->xyz[m->nodes][0] = 2.0 * i / n - 1;
            m->xyz[m->nodes++][1] = 2.0 * j / n - 1;
            if (i < n && j < n)
                add_segment(m, a, b, b + 1, a + 1);
        }
    return m;
}

/* Moves nodes by random vectors and projects them onto the body. Nodes of a graph move in its plane and stay on its
 * border. */
static void place_nodes(struct smooth_mesh *m, double most, uint64_t seed)
{
    gsl_rng *stream = stream_new();
    for (size_t i = 0; i < m->nodes; i++) {
        double x[3], f[6];
        memcpy(x, m->xyz[i], sizeof x);
        stream_key(stream, seed, (uint64_t)m->kind, i, 0);
        if (m->kind == SMOOTH_SPHERE)
            smooth_project(m->kind, m->xyz[i], x, m->exact[i]);
        for (int k = 0; k < 3; k++) {
            const double move = most * (2 * gsl_rng_uniform(stream) - 1);
            const int border = m->kind >= SMOOTH_SADDLE && fabs(x[k]) >= 1;
            x[k] += border ? 0 : move;
        }
        if (m->kind >= SMOOTH_SADDLE) {
            graph(m->kind, x[0], x[1], f);
            x[2] = f[0];
        }
        smooth_project(m->kind, x, m->xyz[i], m->exact[i]);
    }
    gsl_rng_free(stream);
}

struct smooth_mesh *smooth_mesh_new(enum smooth_kind kind, int n, double jitter, uint64_t seed)
{
    struct smooth_mesh *m = kind == SMOOTH_SPHERE ? sphere(n) : kind == SMOOTH_TORUS ? torus(n) : square(kind, n);
    const double width = kind == SMOOTH_SPHERE ? M_PI_2 / n : kind == SMOOTH_TORUS ? 2 * M_PI * TUBE / n : 2.0 / n;
    place_nodes(m, jitter * width, seed);
    footpoint_node_normals(m->nodes, m->xyz[0], m->segments, m->seg[0], m->mean[0]);
    return m;
}

void smooth_mesh_free(struct smooth_mesh *m)
{
    if (m)
        arena_free(&m->memory);
    free(m);
}

void smooth_segment(const struct smooth_mesh *m, size_t i, double (*const normal)[3], double x[4][3], double n[4][3])
{
    for (int c = 0; c < 4; c++) {
        memcpy(x[c], m->xyz[m->seg[i][c]], 3 * sizeof(double));
        memcpy(n[c], normal[m->seg[i][c]], 3 * sizeof(double));
    }
}
