/* The table of kinds; see surface.h. */
#include "surface.h"

#include "../../runtime/geometry/footpoint-quad8-geometry.h"
#include "../../runtime/geometry/footpoint-quad9-geometry.h"
#include "../../runtime/geometry/footpoint-tri3-geometry.h"
#include "../../runtime/geometry/footpoint-tri6-geometry.h"
#include "../common/vec3.h"

#include <math.h>
#include <string.h>

enum { MOST_NODES = SEGMENT_VECTORS };

static void point_quad4(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3])
{
    (void)f;
    for (int k = 0; k < 3; k++) {
        const double c0 = (x[0][k] + x[1][k] + x[2][k] + x[3][k]) / 4;
        const double c1 = (-x[0][k] + x[1][k] + x[2][k] - x[3][k]) / 4;
        const double c2 = (-x[0][k] - x[1][k] + x[2][k] + x[3][k]) / 4;
        const double c3 = (x[0][k] - x[1][k] + x[2][k] - x[3][k]) / 4;
        r[0][k] = c0 + c1 * xi + c2 * eta + c3 * xi * eta;
        r[1][k] = c1 + c3 * eta;
        r[2][k] = c2 + c3 * xi;
    }
}

static void point_of_shape(const struct surface *f, double (*x)[3], double xi, double eta, double r[3][3])
{
    double phi[6 * MOST_NODES];
    f->shape(xi, eta, phi);
    for (int k = 0; k < 3; k++) {
        r[0][k] = x[0][k];
        r[1][k] = r[2][k] = 0;
        for (size_t i = 1; i < f->nodes; i++)
            for (size_t row = 0; row < 3; row++)
                r[row][k] += phi[row * f->nodes + i] * (x[i][k] - x[0][k]);
    }
}

/* A kind whose r is a weighted sum of nodes. */
#define WEIGHTED(kind, count, triangle_)                                                                               \
    {                                                                                                                  \
        .name = #kind, .nodes = count, .triangle = triangle_, .shape = footpoint_##kind##_shape,                       \
        .point = point_of_shape, .foot = surface_foot_quadratic                                                        \
    }

static const struct surface surfaces[] = {
    {.name = "quad4", .nodes = 4, .point = point_quad4, .foot = surface_foot_bilinear},
    WEIGHTED(tri3, 3, true),
    WEIGHTED(tri6, 6, true),
    WEIGHTED(quad8, 8, false),
    WEIGHTED(quad9, 9, false),
    {.name = "gregory", .nodes = 4, .patch = PATCH_GREGORY, .point = surface_point_patch, .foot = surface_foot_patch},
    {.name = "bezier", .nodes = 4, .patch = PATCH_BEZIER, .point = surface_point_patch, .foot = surface_foot_patch}};

const struct surface *surface_find(const struct segment_kind *k)
{
    for (size_t i = 0; i < sizeof surfaces / sizeof *surfaces; i++)
        if (strcmp(surfaces[i].name, k->name) == 0)
            return &surfaces[i];
    return NULL;
}

bool surface_normal(const struct surface *f, double (*x)[3], double xi, double eta, double r[3], double n[3])
{
    double at[3][3];
    f->point(f, x, xi, eta, at);
    memcpy(r, at[0], sizeof at[0]);
    vector_cross(at[1], at[2], n);
    const double length = vector_length(n);
    for (int k = 0; k < 3 && length > 0; k++)
        n[k] /= length;
    return length > 0;
}
