/* Averaged normals; see footpoint-averaged-normal.h. */
#include "footpoint-averaged-normal.h"

#include "footpoint-quad8-geometry.h"
#include "footpoint-quad9-geometry.h"
#include "footpoint-tri3-geometry.h"
#include "footpoint-tri6-geometry.h"
#include "isoparametric.h"
#include "vector.h"

enum { MOST = 9 };

/* Tangents at a node of a face, and derivatives of shape functions, which these grow with. */
struct tangents {
    double xi[3], eta[3], normal[3], phi[FOOTPOINT_ROWS * MOST];
};

static int nodes_of(enum footpoint_face face)
{
    static const int nodes[] = {3, 6, 4, 8, 9, 0, 2, 3};
    return (unsigned)face < sizeof nodes / sizeof *nodes ? nodes[face] : 0;
}

/* Derivatives of shape functions at node k of a face, in rows as isoparametric.h has them. */
static void shapes_at(enum footpoint_face face, int k, double *phi)
{
    static const double square[MOST][2] = {{-1, -1}, {1, -1}, {1, 1},  {-1, 1}, {0, -1},
                                           {1, 0},   {0, 1},  {-1, 0}, {0, 0}};
    static const double triangle[6][2] = {{0, 0}, {1, 0}, {0, 1}, {0.5, 0}, {0.5, 0.5}, {0, 0.5}};
    const double *const at = square[k], *const in = triangle[k % 6], t = k < 2 ? 2.0 * k - 1.0 : 0.0;
    if (face == FOOTPOINT_TRI3)
        footpoint_tri3_shape(in[0], in[1], phi);
    if (face == FOOTPOINT_TRI6)
        footpoint_tri6_shape(in[0], in[1], phi);
    if (face == FOOTPOINT_QUAD8)
        footpoint_quad8_shape(at[0], at[1], phi);
    if (face == FOOTPOINT_QUAD9)
        footpoint_quad9_shape(at[0], at[1], phi);
    for (int i = 0; face == FOOTPOINT_QUAD4 && i < 4; i++) {
        phi[4 + i] = 0.25 * square[i][0] * (1.0 + square[i][1] * at[1]);
        phi[8 + i] = 0.25 * square[i][1] * (1.0 + square[i][0] * at[0]);
    }
    for (int i = 0; face == FOOTPOINT_EDGE2 && i < 2; i++)
        phi[2 + i] = i - 0.5;
    for (int i = 0; face == FOOTPOINT_EDGE3 && i < 3; i++)
        phi[3 + i] = i < 2 ? t + i - 0.5 : -2.0 * t;
}

static int tangents_at(enum footpoint_face face, const double *xyz, const int *seg, int node, struct tangents *t)
{
    const int nodes = nodes_of(face);
    const double *x[MOST];
    int k = nodes;
    for (int i = nodes; i-- > 0;) {
        x[i] = xyz + 3 * (size_t)seg[i];
        k = seg[i] == node ? i : k;
    }
    for (int i = 0; i < FOOTPOINT_ROWS * MOST; i++)
        t->phi[i] = 0.0;
    if (k == nodes)
        return FOOTPOINT_ERR_ARGUMENT;
    shapes_at(face, k, t->phi);
    isoparametric_sum(x, nodes, t->phi + FOOTPOINT_ROW_XI * nodes, t->xi);
    isoparametric_sum(x, nodes, t->phi + FOOTPOINT_ROW_ETA * nodes, t->eta);
    if (face == FOOTPOINT_EDGE2 || face == FOOTPOINT_EDGE3) {
        t->eta[0] = t->eta[1] = t->xi[2] = 0.0;
        t->eta[2] = 1.0;
    }
    vector_cross(t->xi, t->eta, t->normal);
    return vector_finite(t->normal) ? FOOTPOINT_OK : FOOTPOINT_ERR_NOT_FINITE;
}

int footpoint_averaged_normal(enum footpoint_face face, const double *xyz, size_t faces, const int *seg, int node,
                              double normal[3])
{
    const int nodes = nodes_of(face);
    double sum[3] = {0.0, 0.0, 0.0};
    for (size_t f = 0; f < faces; f++) {
        struct tangents t;
        const int status = tangents_at(face, xyz, seg + (size_t)nodes * f, node, &t);
        if (status != FOOTPOINT_OK)
            return status;
        for (int i = 0; i < 3; i++)
            sum[i] += t.normal[i];
    }
    if (!nodes)
        return FOOTPOINT_ERR_ARGUMENT;
    if (!vector_finite(sum))
        return FOOTPOINT_ERR_NOT_FINITE;
    if (sum[0] == 0.0 && sum[1] == 0.0 && sum[2] == 0.0)
        return FOOTPOINT_ERR_DEGENERATE;
    for (int i = 0; i < 3; i++)
        normal[i] = sum[i];
    return FOOTPOINT_OK;
}

/* g . d(a x b) = (b x g) . da + (g x a) . db */
int footpoint_averaged_normal_gradient(enum footpoint_face face, const double *xyz, size_t faces, const int *seg,
                                       int node, const double by_normal[3], double *by)
{
    const int nodes = nodes_of(face), is_edge = face == FOOTPOINT_EDGE2 || face == FOOTPOINT_EDGE3;
    double unused[3];
    const int status = footpoint_averaged_normal(face, xyz, faces, seg, node, unused);
    if (status != FOOTPOINT_OK && status != FOOTPOINT_ERR_DEGENERATE)
        return status;
    for (size_t f = 0; f < faces; f++, by += 3 * nodes) {
        struct tangents t;
        double xi[3], eta[3];
        (void)tangents_at(face, xyz, seg + (size_t)nodes * f, node, &t);
        vector_cross(t.eta, by_normal, xi);
        vector_cross(by_normal, t.xi, eta);
        for (int k = 0; k < nodes; k++)
            for (int i = 0; i < 3; i++)
                by[3 * k + i] = is_edge && i == 2 ? 0.0 : t.phi[nodes + k] * xi[i] + t.phi[2 * nodes + k] * eta[i];
    }
    return FOOTPOINT_OK;
}
