/* Samples on patches, their inputs, and growing sets of them; see patch.h. */
#include "patch.h"

#include "../../codegen/genome/base.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

const char *const patch_input_name[PATCH_INPUTS] = {"xC",  "yC",  "zC",  "xD",  "yD",  "xS",  "yS",  "zS",
                                                    "nxA", "nyA", "nxB", "nyB", "nxC", "nyC", "nxD", "nyD"};

int patch_sample_points(const struct patch_sample *s, struct footpoint_gregory *patch)
{
    const double(*const x)[3] = (const double(*)[3])s->x, (*const n)[3] = (const double(*)[3])s->n;
    if (s->kind == PATCH_GREGORY)
        return footpoint_gregory_points(x, n, patch);
    struct footpoint_bezier net;
    const int status = footpoint_bezier_points(x, n, &net);
    if (status != FOOTPOINT_OK)
        return status;
    patch->net = net;
    for (int i = 0; i < 2; i++)
        for (int j = 0; j < 2; j++)
            memcpy(patch->twin[i][j], net.p[1 + i][1 + j], sizeof net.p[0][0]);
    return FOOTPOINT_OK;
}

static double dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void cross(const double a[3], const double b[3], double c[3])
{
    c[0] = a[1] * b[2] - a[2] * b[1];
    c[1] = a[2] * b[0] - a[0] * b[2];
    c[2] = a[0] * b[1] - a[1] * b[0];
}

/* Components of p - from along unit axes, in units of `length`. */
static void turn(double axis[3][3], const double p[3], const double from[3], double length, double out[3])
{
    const double v[3] = {(p[0] - from[0]) / length, (p[1] - from[1]) / length, (p[2] - from[2]) / length};
    for (int k = 0; k < 3; k++)
        out[k] = dot(axis[k], v);
}

void patch_inputs(const struct patch_sample *s, double input[PATCH_INPUTS])
{
    static const double origin[3];
    double axis[3][3], ad[3], c[3], d[3], xs[3];
    for (int k = 0; k < 3; k++) {
        axis[0][k] = s->x[1][k] - s->x[0][k];
        ad[k] = s->x[3][k] - s->x[0][k];
    }
    const double length = sqrt(dot(axis[0], axis[0]));
    cross(axis[0], ad, axis[2]);
    const double area = sqrt(dot(axis[2], axis[2]));
    for (int k = 0; k < 3; k++) {
        axis[0][k] /= length;
        axis[2][k] /= area;
    }
    cross(axis[2], axis[0], axis[1]);
    turn(axis, s->x[2], s->x[0], length, c);
    turn(axis, s->x[3], s->x[0], length, d);
    turn(axis, s->xs, s->x[0], length, xs);
    const double coordinates[8] = {c[0], c[1], c[2], d[0], d[1], xs[0], xs[1], xs[2]};
    for (int k = 0; k < 8; k++)
        input[k] = coordinates[k];
    for (int i = 0; i < 4; i++) {
        double n[3];
        turn(axis, s->n[i], origin, 1, n);
        input[8 + 2 * i] = n[0] / n[2];
        input[9 + 2 * i] = n[1] / n[2];
    }
}

void patch_set_add(struct patch_set *set, const struct patch_sample *s)
{
    grow_array(&set->s, set->n, &set->room, sizeof *set->s);
    set->s[set->n++] = *s;
}

void patch_set_free(struct patch_set *set)
{
    free(set->s);
    *set = (struct patch_set){0};
}
