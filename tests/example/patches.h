/* Contact with a smoothed surface, the part to copy: Gregory patches over the segments, recomputed in each step, as a
 * deforming surface requires; foot points on them by Newton's iteration from footpoint's foot points on the facets.
 * Units: plates.h. */
#ifndef PATCHES_H
#define PATCHES_H

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function" /* impact.c does not use all functions */
#include "penalty.h"
#pragma GCC diagnostic pop

#include "../../runtime/geometry/footpoint-gregory-geometry.h"
#include "../../runtime/geometry/footpoint-node-normals.h"

enum { NEWTON_STEPS = 2 };

/* The surface's nearest point r to a slave node, its segment `seg` and the normal there; seg = -1: no contact. */
struct touch {
    int seg;
    double gap;
    vec r, n;
};

struct patches {
    double *normal;                  /* at the model's first nodes, to which the segments belong */
    struct footpoint_gregory *patch; /* indexed by segment */
};

static void facets_touch(const struct model *m, struct world *w, struct touch *touch)
{
    search_footpoint(m, w);
    choose_segments(m, w);
    for (int i = 0; i < m->slaves; i++) {
        struct touch *const t = &touch[i];
        const int p = w->nearest[i];
        double phi[4];
        vec d;
        t->seg = p < 0 ? -1 : w->pair_seg[p];
        if (p < 0)
            continue;
        foot(m, w, p, w->xi[p], w->eta[p], phi, d, t->n);
        t->gap = dot(d, t->n);
        for (int k = 0; k < 3; k++)
            t->r[k] = w->x[m->slave[i]][k] - d[k];
    }
}

/* ---- patches ---- */

static void refuse(int status)
{
    if (status != FOOTPOINT_OK) {
        fprintf(stderr, "slide: status %d from a patch\n", status);
        exit(1);
    }
}

/* Computes normals at nodes like footpoint_node_normals, but from c1 x c2 divided by |c1|^2 |c2|^2: exact for a sphere
 * on any mesh (Max, "Weights for computing vertex normals from facet normals", J. Graphics Tools 4, 1999). */
static void even_normals(const struct model *m, const struct world *w, int nodes, double *normal)
{
    memset(normal, 0, (size_t)nodes * sizeof(vec));
    for (int e = 0; e < m->segs; e++)
        for (int c = 0; c < 4; c++) {
            const int *const node = m->seg[e];
            double *const n = normal + 3 * node[c];
            vec a, b;
            for (int k = 0; k < 3; k++) {
                a[k] = w->x[node[(c + 1) % 4]][k] - w->x[node[c]][k];
                b[k] = w->x[node[(c + 3) % 4]][k] - w->x[node[c]][k];
            }
            const double weight = 1.0 / (dot(a, a) * dot(b, b));
            for (int k = 0; k < 3; k++)
                n[k] += weight * (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
        }
    for (int i = 0; i < nodes; i++) {
        double *const n = normal + 3 * i, length = sqrt(dot(n, n));
        for (int k = 0; k < 3; k++)
            n[k] /= length;
    }
}

static void make_patches(const struct model *m, const struct world *w, int nodes, int even, struct patches *p)
{
    if (even)
        even_normals(m, w, nodes, p->normal);
    else
        refuse(footpoint_node_normals((size_t)nodes, w->x[0], (size_t)m->segs, m->seg[0], p->normal));
    for (int e = 0; e < m->segs; e++) {
        vec x[4], n[4];
        for (int k = 0; k < 4; k++) {
            memcpy(x[k], w->x[m->seg[e][k]], sizeof(vec));
            memcpy(n[k], p->normal + 3 * m->seg[e][k], sizeof(vec));
        }
        refuse(footpoint_gregory_points((const vec *)x, (const vec *)n, &p->patch[e]));
    }
}

static double clamp(double x)
{
    return fmax(-1.0, fmin(1.0, x));
}

/* Runs Newton's iteration on r_xi . (S - r) = r_eta . (S - r) = 0 within the patch; returns jet and d = S - r at its
 * end. */
static void step_on_patch(const struct footpoint_gregory *patch, const vec S, double xi, double eta,
                          struct footpoint_jet *jet, vec d)
{
    for (int n = 0;; n++) {
        footpoint_gregory_jet(patch, xi, eta, jet);
        for (int i = 0; i < 3; i++)
            d[i] = S[i] - patch->net.origin[i] - jet->r[i];
        if (n == NEWTON_STEPS)
            return;
        const double a = dot(jet->r_xi, jet->r_xi) - dot(jet->r_xixi, d);
        const double b = dot(jet->r_xi, jet->r_eta) - dot(jet->r_xieta, d);
        const double c = dot(jet->r_eta, jet->r_eta) - dot(jet->r_etaeta, d);
        const double u = dot(jet->r_xi, d), v = dot(jet->r_eta, d), det = a * c - b * b;
        xi = clamp(xi + (c * u - b * v) / det);
        eta = clamp(eta + (a * v - b * u) / det);
    }
}

/* Assigns each slave node to the patch with the nearest point. A neighbour finds foot points that leave a patch. */
static void patches_touch(const struct model *m, struct world *w, const struct patches *p, struct touch *touch)
{
    search_footpoint(m, w);
    for (int i = 0; i < m->slaves; i++) {
        touch[i].seg = -1;
        w->distance[i] = DEPTH;
    }
    for (int k = 0; k < w->pairs; k++) {
        const int slave = w->pair_slave[k], seg = w->pair_seg[k];
        const double *const S = w->x[m->slave[slave]];
        struct touch *const t = &touch[slave];
        struct footpoint_jet jet;
        vec d;
        step_on_patch(&p->patch[seg], S, clamp(w->xi[k]), clamp(w->eta[k]), &jet, d);
        const double distance = sqrt(dot(d, d));
        if (distance >= w->distance[slave])
            continue;
        w->distance[slave] = distance;
        t->seg = seg;
        refuse(footpoint_jet_normal(p->patch[seg].net.origin, &jet, S, t->n, &t->gap));
        for (int i = 0; i < 3; i++)
            t->r[i] = S[i] - d[i];
    }
}

#endif
