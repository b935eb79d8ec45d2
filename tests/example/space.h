/* Shared by the meshes of the examples: vectors, memory for them, and the inverse of a Jacobian. */
#ifndef SPACE_H
#define SPACE_H

#include <stdio.h>
#include <stdlib.h>

typedef double vec[3];

static void *room_for(void *old, size_t n, size_t size)
{
    void *const p = realloc(old, n * size + 1);
    if (!p) {
        fputs("out of memory\n", stderr);
        exit(3);
    }
    return p;
}

/* Inverts J and returns its determinant. */
static double invert(double J[3][3], double inverse[3][3])
{
    double det = 0.0;
    for (int i = 0; i < 3; i++)
        for (int j = 0; j < 3; j++) {
            const int p = (j + 1) % 3, q = (j + 2) % 3, r = (i + 1) % 3, s = (i + 2) % 3;
            inverse[i][j] = J[p][r] * J[q][s] - J[p][s] * J[q][r];
        }
    for (int j = 0; j < 3; j++)
        det += J[0][j] * inverse[j][0];
    for (int i = 0; i < 9; i++)
        inverse[i / 3][i % 3] /= det;
    return det;
}

#endif
