/* Node normals; see footpoint-node-normals.h. */
#include "footpoint-node-normals.h"

#include "vector.h"

int footpoint_node_normals(size_t nodes, const double *xyz, size_t segments, const int *seg, double *normal)
{
    for (size_t i = 0; i < 4 * segments; i++)
        if (seg[i] < 0 || (size_t)seg[i] >= nodes)
            return FOOTPOINT_ERR_ARGUMENT;
    for (size_t i = 0; i < 3 * nodes; i++)
        normal[i] = 0.0;
    for (size_t i = 0; i < segments; i++)
        for (size_t c = 0; c < 4; c++) {
            const double *x = &xyz[3 * (size_t)seg[4 * i + c]];
            double *n = &normal[3 * (size_t)seg[4 * i + c]], c1[3], c2[3], area[3];
            vector_sub(&xyz[3 * (size_t)seg[4 * i + (c + 1) % 4]], x, c1);
            vector_sub(&xyz[3 * (size_t)seg[4 * i + (c + 3) % 4]], x, c2);
            vector_cross(c1, c2, area);
            for (int k = 0; k < 3; k++)
                n[k] += area[k];
        }
    for (size_t i = 0; i < nodes; i++) {
        double *n = &normal[3 * i];
        const double square = vector_dot(n, n), length = sqrt(square);
        for (int k = 0; k < 3; k++)
            n[k] = number_normal(square) ? n[k] / length : 0.0;
    }
    return FOOTPOINT_OK;
}
