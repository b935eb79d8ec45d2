/* Smooth bodies with exact geometry, and meshes of four-node segments with nodes on them. */
#ifndef FOOTPOINT_BODIES_H
#define FOOTPOINT_BODIES_H

#include "../../codegen/base/base.h"

#include <stdint.h>

enum smooth_kind {
    SMOOTH_SPHERE, /* radius 1; 6 n n segments, three of which meet at each corner of a cube */
    SMOOTH_TORUS,  /* radii 1 and 0.4; 2n n segments */
    SMOOTH_SADDLE, /* z = 0.4 (x^2 - y^2), -1 <= x,y <= 1; n n segments */
    SMOOTH_SHEET,  /* pressed by a round die: z = -0.35/(1 + (x^2 + y^2)^2/0.5^4), -1 <= x,y <= 1; n n segments */
    SMOOTH_KINDS
};

extern const char *const smooth_name[SMOOTH_KINDS];

struct smooth_mesh {
    enum smooth_kind kind;
    size_t nodes, segments;
    struct arena memory; /* owned; it owns: */
    double (*xyz)[3];    /* nodes x 3, on the body */
    double (*exact)[3];  /* nodes x 3, the body's unit normals, outwards or upwards */
    double (*mean)[3];   /* nodes x 3, the mesh's normals (44) */
    int (*seg)[4];       /* segments x 4 nodes A, B, C, D, counter-clockwise from outside */
};

/** Computes the body's closest point to a nearby point, foot[3], and the unit normal[3] there. Returns the signed
 *  distance, > 0 outside. */
double smooth_project(enum smooth_kind kind, const double x[3], double foot[3], double normal[3]);

/** Returns a mesh with n >= 3 segments along a side (see smooth_kind). Nodes move at random within the body, border
 *  nodes along the border, by up to `jitter` (below 0.3) times a segment's usual width. */
struct smooth_mesh *smooth_mesh_new(enum smooth_kind kind, int n, double jitter, uint64_t seed);
void smooth_mesh_free(struct smooth_mesh *m);

/** Copies the corners and the normals (mean or exact) of segment i. */
void smooth_segment(const struct smooth_mesh *m, size_t i, double (*const normal)[3], double x[4][3], double n[4][3]);

#endif
