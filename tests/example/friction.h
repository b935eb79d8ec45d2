/* Contact with friction in an implicit code, the part to copy: for each slave node a face, a foot point without
 * iteration, and the contact element's force and consistent tangent, for any kind of face. Units: blocks.h. */
#ifndef FRICTION_H
#define FRICTION_H

#include "blocks.h"

static const double PENALTY = 4000.0, TANGENTIAL = 2000.0; /* N/mm */
enum { MOST_COORDINATES = 3 * MOST_FACE + 3 };

/* State of a slave node. Between steps: its face, the place (xi, eta) on the face that it would take without friction's
 * force, and its distance from there along the face. At present: its foot point, from which the next search starts, the
 * gap, the pressing force, and whether it slides. */
struct touch {
    int face;
    double stick[2];
    vec stretch;
    double loc[2], gap, pressure;
    int slides;
};

/* The contact element's input from a foot point. */
struct foot {
    double loc[2], gap, phi[MOST_FACE];
    vec r_xi, r_eta, normal;
    double d_gap[MOST_COORDINATES], d_normal[3 * MOST_COORDINATES];
    double hessian[MOST_COORDINATES * (MOST_COORDINATES + 1) / 2];
};

static void check(int status)
{
    if (status != FOOTPOINT_OK) {
        fprintf(stderr, "press: %s\n", footpoint_strerror(status));
        exit(1);
    }
}

/* Gathers the nodes of a slave node's face and, last, the slave node, and their coordinates. */
static void gather(const struct model *m, const vec *x, const struct touch *t, int slave, int *node, double *y)
{
    const int nodes = footpoint_face_nodes(m->kind);
    memcpy(node, m->face + nodes * t->face, (size_t)nodes * sizeof *node);
    node[nodes] = slave;
    for (int a = 0; a <= nodes; a++)
        memcpy(y + 3 * a, x[node[a]], sizeof(vec));
}

static void place(enum footpoint_face kind, const double *y, struct foot *at)
{
    check(footpoint_face_place(kind, y, at->loc, at->phi, at->r_xi, at->r_eta, at->normal, &at->gap));
}

static double along(const vec a, const vec b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Chooses each slave node's nearest face before a step; the node keeps it during the step. The place that it would take
 * without friction's force keeps its distance from the foot point, whichever the face. */
static void choose_faces(const struct model *m, const vec *x, struct touch *touch)
{
    for (int i = 0; i < m->slaves; i++) {
        struct touch *const t = &touch[i];
        struct foot foot;
        double y[MOST_COORDINATES], distance;
        size_t chosen;
        int node[MOST_FACE + 1], region;
        check(footpoint_face_select(m->kind, x[0], (size_t)m->faces, m->face, x[m->slave[i]], &chosen, t->loc,
                                    &distance, &region));
        t->face = (int)chosen;
        gather(m, x, t, m->slave[i], node, y);
        check(footpoint_track(m->kind, y, t->loc, &t->gap));
        memcpy(foot.loc, t->loc, sizeof foot.loc);
        place(m->kind, y, &foot);
        const double aa = along(foot.r_xi, foot.r_xi), ab = along(foot.r_xi, foot.r_eta);
        const double bb = along(foot.r_eta, foot.r_eta), area = aa * bb - ab * ab;
        const double u = along(foot.r_xi, t->stretch), v = along(foot.r_eta, t->stretch);
        t->stick[0] = foot.loc[0] - (bb * u - ab * v) / area;
        t->stick[1] = foot.loc[1] - (aa * v - ab * u) / area;
    }
}

/* A local search, from the last answer in loc or without it. */
typedef int local_search(enum footpoint_face, const double *y, double loc[2], double *gap);

/* Finds the foot points of all slave nodes. */
static void find_feet(const struct model *m, const vec *x, local_search search, struct touch *touch)
{
    for (int i = 0; i < m->slaves; i++) {
        double y[MOST_COORDINATES];
        int node[MOST_FACE + 1];
        gather(m, x, &touch[i], m->slave[i], node, y);
        check(search(m->kind, y, touch[i].loc, &touch[i].gap));
    }
}

/* Adds the contact forces on the nodes at the foot points and their tangent -df/dx, and the sum over slave nodes to
 * `force`. */
static void add_contact(const struct model *m, const vec *x, double friction, struct touch *touch, vec *f, double *K,
                        vec force)
{
    const int nodes = footpoint_face_nodes(m->kind), n = 3 * nodes + 3;
    memset(force, 0, sizeof(vec));
    for (int i = 0; i < m->slaves; i++) {
        struct touch *const t = &touch[i];
        double y[MOST_COORDINATES], pull[MOST_COORDINATES], drag[MOST_COORDINATES] = {0}, slip[2];
        static double packed[MOST_COORDINATES * (MOST_COORDINATES + 1) / 2], full[MOST_COORDINATES * MOST_COORDINATES];
        struct foot foot, stick;
        int node[MOST_FACE + 1];
        t->pressure = 0.0;
        t->slides = 0;
        memset(t->stretch, 0, sizeof t->stretch);
        if (t->gap >= 0.0)
            continue;
        gather(m, x, t, m->slave[i], node, y);
        memcpy(foot.loc, t->loc, sizeof foot.loc);
        place(m->kind, y, &foot);
        check(footpoint_face_hessian(m->kind, y, foot.loc, NULL, NULL, NULL, foot.d_gap, foot.d_normal, foot.hessian));
        check(footpoint_element_normal(nodes, foot.gap, foot.d_gap, foot.hessian, PENALTY, 0.0, &t->pressure, pull,
                                       packed));
        memset(full, 0, sizeof full);
        if (friction > 0.0) {
            memcpy(stick.loc, t->stick, sizeof stick.loc);
            place(m->kind, y, &stick);
            check(footpoint_element_friction(nodes, y, stick.phi, foot.r_xi, foot.r_eta, foot.normal, foot.d_gap,
                                             foot.d_normal, t->pressure, PENALTY, friction, TANGENTIAL, slip, drag,
                                             full));
            t->slides = slip[0] != 0.0 || slip[1] != 0.0;
        }
        for (int r = 0; r < n; r++)
            f[node[r / 3]][r % 3] += pull[r] + drag[r];
        for (int k = 0; k < 3; k++) {
            force[k] += pull[3 * nodes + k] + drag[3 * nodes + k];
            t->stretch[k] = -drag[3 * nodes + k] / TANGENTIAL;
        }
        for (int a = 0; a <= nodes; a++)
            for (int b = 0; b <= nodes; b++) {
                double tangent[3][3];
                for (int j = 0; j < 9; j++) {
                    const int r = 3 * a + j / 3, c = 3 * b + j % 3;
                    tangent[j / 3][j % 3] = packed[r < c ? c * (c + 1) / 2 + r : r * (r + 1) / 2 + c] + full[n * r + c];
                }
                add_tangent(m, K, node[a], node[b], tangent);
            }
    }
}

#endif
