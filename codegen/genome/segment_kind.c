/* The kinds of segments; see segment_kind.h.  A kind more is a row of the table, a row of that in evolve/surface/surface.c and its
 * geometry in runtime/.
 *
 * `surface` is C text that sets u = r_xi, v = r_eta and d = S - r from xi, eta and the vectors x[0], x[1], ..., S last,
 * all of length unit; @R stands for double or float, @F for the suffix of its numbers.  Where r is a sum of nodes times
 * shape functions, WEIGHTED wraps what sets these, p, and their derivatives, pu by xi and pv by eta: they add up to 1,
 * 0 and 0, so that differences of nodes will do. */
#include "segment_kind.h"

#include <stdio.h>
#include <string.h>

#define WEIGHTED(nodes, text)                                                                                          \
    "    @R p[" #nodes "], pu[" #nodes "], pv[" #nodes "];\n"                                                          \
    "    int k, j;\n" text "    for (j = 0; j < 3; j++) {\n"                                                           \
    "        u[j] = v[j] = 0.0@F;\n"                                                                                   \
    "        d[j] = x[" #nodes "][j] - x[0][j];\n"                                                                     \
    "        for (k = 1; k < " #nodes "; k++) {\n"                                                                     \
    "            u[j] += pu[k] * (x[k][j] - x[0][j]);\n"                                                               \
    "            v[j] += pv[k] * (x[k][j] - x[0][j]);\n"                                                               \
    "            d[j] -= p[k] * (x[k][j] - x[0][j]);\n"                                                                \
    "        }\n"                                                                                                      \
    "    }\n"

static const char tri3[] = WEIGHTED(3, "    p[1] = xi;\n"
                                       "    p[2] = eta;\n"
                                       "    pu[1] = pv[2] = 1.0@F;\n"
                                       "    pu[2] = pv[1] = 0.0@F;\n");

static const char tri6[] = WEIGHTED(6, "    const @R w = 1.0@F - xi - eta;\n"
                                       "    p[1] = xi * (2.0@F * xi - 1.0@F);\n"
                                       "    p[2] = eta * (2.0@F * eta - 1.0@F);\n"
                                       "    p[3] = 4.0@F * w * xi;\n"
                                       "    p[4] = 4.0@F * xi * eta;\n"
                                       "    p[5] = 4.0@F * eta * w;\n"
                                       "    pu[1] = 4.0@F * xi - 1.0@F;\n"
                                       "    pu[2] = pv[1] = 0.0@F;\n"
                                       "    pv[2] = 4.0@F * eta - 1.0@F;\n"
                                       "    pu[3] = 4.0@F * (w - xi);\n"
                                       "    pv[3] = -4.0@F * xi;\n"
                                       "    pu[4] = 4.0@F * eta;\n"
                                       "    pv[4] = 4.0@F * xi;\n"
                                       "    pu[5] = -4.0@F * eta;\n"
                                       "    pv[5] = 4.0@F * (w - eta);\n");

/* Corners (a,b), mid-side nodes at a = 0 and at b = 0. */
static const char quad8[] =
    WEIGHTED(8, "    for (k = 1; k < 4; k++) {\n"
                "        const @R a = k < 3 ? 1.0@F : -1.0@F, b = k > 1 ? 1.0@F : -1.0@F;\n"
                "        p[k] = 0.25@F * (1.0@F + a * xi) * (1.0@F + b * eta) * (a * xi + b * eta - 1.0@F);\n"
                "        pu[k] = 0.25@F * a * (1.0@F + b * eta) * (2.0@F * a * xi + b * eta);\n"
                "        pv[k] = 0.25@F * b * (1.0@F + a * xi) * (a * xi + 2.0@F * b * eta);\n"
                "    }\n"
                "    for (k = 4; k < 8; k += 2) {\n"
                "        const @R b = k > 4 ? 1.0@F : -1.0@F, a = -b;\n"
                "        p[k] = 0.5@F * (1.0@F - xi * xi) * (1.0@F + b * eta);\n"
                "        pu[k] = -xi * (1.0@F + b * eta);\n"
                "        pv[k] = 0.5@F * b * (1.0@F - xi * xi);\n"
                "        p[k + 1] = 0.5@F * (1.0@F - eta * eta) * (1.0@F + a * xi);\n"
                "        pu[k + 1] = 0.5@F * a * (1.0@F - eta * eta);\n"
                "        pv[k + 1] = -eta * (1.0@F + a * xi);\n"
                "    }\n");

/* Products of the parabolas that are 1 at -1, 0, 1, and of their derivatives. */
static const char quad9[] =
    WEIGHTED(9, "    static const int column[9] = {0, 2, 2, 0, 1, 2, 1, 0, 1}, row[9] = {0, 0, 2, 2, 0, 1, 2, 1, 1};\n"
                "    const @R f[3] = {0.5@F * xi * (xi - 1.0@F), 1.0@F - xi * xi, 0.5@F * xi * (xi + 1.0@F)};\n"
                "    const @R g[3] = {0.5@F * eta * (eta - 1.0@F), 1.0@F - eta * eta, 0.5@F * eta * (eta + 1.0@F)};\n"
                "    const @R df[3] = {xi - 0.5@F, -2.0@F * xi, xi + 0.5@F};\n"
                "    const @R dg[3] = {eta - 0.5@F, -2.0@F * eta, eta + 0.5@F};\n"
                "    for (k = 1; k < 9; k++) {\n"
                "        p[k] = f[column[k]] * g[row[k]];\n"
                "        pu[k] = df[column[k]] * g[row[k]];\n"
                "        pv[k] = f[column[k]] * dg[row[k]];\n"
                "    }\n");

/* A Bezier patch, runtime/geometry/bezier.c, as a sum over its corners c: of the handles a[c][0] along xi and a[c][1] along eta,
 * whose sum leads to the inner point. */
static const char bezier[] =
    "    @R a[4][2][3];\n"
    "    int c, m, j;\n"
    "    for (c = 0; c < 4; c++)\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const @R *const y = x[m ? 3 - c : c ^ 1], *const n = x[4 + c];\n"
    "            const @R along = (y[0] - x[c][0]) * n[0] + (y[1] - x[c][1]) * n[1] + (y[2] - x[c][2]) * n[2];\n"
    "            for (j = 0; j < 3; j++)\n"
    "                a[c][m][j] = (y[j] - x[c][j] - along * n[j]) / 3.0@F;\n"
    "        }\n"
    "    for (j = 0; j < 3; j++) {\n"
    "        u[j] = v[j] = 0.0@F;\n"
    "        d[j] = x[8][j] - x[0][j];\n"
    "    }\n"
    "    for (c = 0; c < 4; c++) {\n"
    "        const @R z[2] = {c == 1 || c == 2 ? 0.5@F : -0.5@F, c > 1 ? 0.5@F : -0.5@F};\n"
    "        @R g[2], h[2], gd[2], hd[2];\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const @R p = 0.5@F + z[m] * (m ? eta : xi), r = 1.0@F - p;\n"
    "            g[m] = 3.0@F * p * p * r;\n"
    "            h[m] = p * p * p + g[m];\n"
    "            gd[m] = 3.0@F * z[m] * p * (2.0@F * r - p);\n"
    "            hd[m] = 6.0@F * z[m] * p * r;\n"
    "        }\n"
    "        for (j = 0; j < 3; j++) {\n"
    "            const @R y = x[c][j] - x[0][j];\n"
    "            d[j] -= y * h[0] * h[1] + a[c][0][j] * g[0] * h[1] + a[c][1][j] * h[0] * g[1];\n"
    "            u[j] += y * hd[0] * h[1] + a[c][0][j] * gd[0] * h[1] + a[c][1][j] * hd[0] * g[1];\n"
    "            v[j] += y * h[0] * hd[1] + a[c][0][j] * g[0] * hd[1] + a[c][1][j] * h[0] * gd[1];\n"
    "        }\n"
    "    }\n";

/* A Gregory patch, runtime/geometry/gregory.c, as a sum over its corners c: of the handles a[c][0] along xi and a[c][1] along
 * eta and the inner points q, which the two edges make each for itself.  w weighs these; f and g are the Bernstein
 * polynomials of a corner and of its handle, h their sum, and fd, gd, hd what they rise by towards larger xi, eta. */
static const char gregory[] =
    "    @R a[4][2][3], t[4][2][3], k[4][2], l[4][2], q[4][2][3];\n"
    "    int c, m, j;\n"
    "    for (c = 0; c < 4; c++)\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const @R *const y = x[m ? 3 - c : c ^ 1], *const n = x[4 + c];\n"
    "            const @R along = (y[0] - x[c][0]) * n[0] + (y[1] - x[c][1]) * n[1] + (y[2] - x[c][2]) * n[2];\n"
    "            for (j = 0; j < 3; j++)\n"
    "                a[c][m][j] = (y[j] - x[c][j] - along * n[j]) / 3.0@F;\n"
    "            for (j = 0; j < 3; j++)\n"
    "                t[c][m][j] = n[(j + 1) % 3] * a[c][m][(j + 2) % 3] - n[(j + 2) % 3] * a[c][m][(j + 1) % 3];\n"
    "        }\n"
    "    for (c = 0; c < 4; c++)\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const @R *const b = a[c][m], *const o = a[c][1 - m];\n"
    "            const @R size = b[0] * b[0] + b[1] * b[1] + b[2] * b[2];\n"
    "            k[c][m] = (t[c][m][0] * o[0] + t[c][m][1] * o[1] + t[c][m][2] * o[2]) / size;\n"
    "            l[c][m] = (b[0] * o[0] + b[1] * o[1] + b[2] * o[2]) / size;\n"
    "        }\n"
    "    for (c = 0; c < 4; c++)\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const int e = m ? 3 - c : c ^ 1;\n"
    "            for (j = 0; j < 3; j++) {\n"
    "                const @R middle = (x[e][j] - x[c][j]) + (a[e][m][j] - a[c][m][j]);\n"
    "                q[c][m][j] = a[c][m][j] + ((k[c][m] - k[e][m]) * t[c][m][j] - k[c][m] * t[e][m][j] +\n"
    "                                           2.0@F * l[c][m] * middle - l[e][m] * a[c][m][j]) / 3.0@F;\n"
    "            }\n"
    "        }\n"
    "    for (j = 0; j < 3; j++) {\n"
    "        u[j] = v[j] = 0.0@F;\n"
    "        d[j] = x[8][j] - x[0][j];\n"
    "    }\n"
    "    for (c = 0; c < 4; c++) {\n"
    "        const @R z[2] = {c == 1 || c == 2 ? 0.5@F : -0.5@F, c > 1 ? 0.5@F : -0.5@F};\n"
    "        @R f[2], g[2], h[2], fd[2], gd[2], hd[2], s[2], w, wd[2];\n"
    "        for (m = 0; m < 2; m++) {\n"
    "            const @R p = 0.5@F + z[m] * (m ? eta : xi), r = 1.0@F - p;\n"
    "            s[m] = r;\n"
    "            f[m] = p * p * p;\n"
    "            g[m] = 3.0@F * p * p * r;\n"
    "            h[m] = f[m] + g[m];\n"
    "            fd[m] = 3.0@F * z[m] * p * p;\n"
    "            gd[m] = 3.0@F * z[m] * p * (2.0@F * r - p);\n"
    "            hd[m] = 6.0@F * z[m] * p * r;\n"
    "        }\n"
    "        w = (s[0] > 0.0@F ? s[0] : 0.0@F) + (s[1] > 0.0@F ? s[1] : 0.0@F);\n"
    "        wd[0] = wd[1] = 0.0@F;\n"
    "        if (s[0] > 0.0@F && s[1] > 0.0@F) {\n"
    "            wd[0] = z[0] * s[1] / (w * w);\n"
    "            wd[1] = -z[1] * s[0] / (w * w);\n"
    "        }\n"
    "        w = w > 0.0@F ? (s[1] > 0.0@F ? s[1] / w : 0.0@F) : 0.5@F;\n"
    "        for (j = 0; j < 3; j++) {\n"
    "            const @R y = x[c][j] - x[0][j], o = q[c][1][j] - q[c][0][j], i = q[c][0][j] + w * o;\n"
    "            d[j] -= y * h[0] * h[1] + a[c][0][j] * g[0] * f[1] + a[c][1][j] * f[0] * g[1] + i * g[0] * g[1];\n"
    "            u[j] += y * hd[0] * h[1] + a[c][0][j] * gd[0] * f[1] + a[c][1][j] * fd[0] * g[1] +\n"
    "                    (i * gd[0] + o * wd[0] * g[0]) * g[1];\n"
    "            v[j] += y * h[0] * hd[1] + a[c][0][j] * g[0] * fd[1] + a[c][1][j] * f[0] * gd[1] +\n"
    "                    (i * gd[1] + o * wd[1] * g[1]) * g[0];\n"
    "        }\n"
    "    }\n";

static const struct segment_kind kinds[] = {
    {.name = "quad4", .nodes = "ABCD", .normals = "", .corners = 4, .turns = true},
    {.name = "tri3", .nodes = "ABC", .normals = "", .corners = 3, .triangle = true, .surface = tri3},
    {.name = "tri6", .nodes = "ABCDEF", .normals = "", .corners = 3, .triangle = true, .surface = tri6},
    {.name = "quad8", .nodes = "ABCDEFGH", .normals = "", .corners = 4, .surface = quad8},
    {.name = "quad9", .nodes = "ABCDEFGHI", .normals = "", .corners = 4, .surface = quad9},
    {.name = "bezier", .nodes = "ABCD", .normals = "ABCD", .corners = 4, .surface = bezier},
    {.name = "gregory", .nodes = "ABCD", .normals = "ABCD", .corners = 4, .surface = gregory},
};

const struct segment_kind *segment_find(const char *name)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (strcmp(kinds[i].name, name) == 0)
            return &kinds[i];
    return NULL;
}

const struct segment_kind *segment_of_face(size_t nodes)
{
    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (!*kinds[i].normals && strlen(kinds[i].nodes) == nodes)
            return &kinds[i];
    return NULL;
}

size_t segment_vectors(const struct segment_kind *k)
{
    return strlen(k->nodes) + strlen(k->normals);
}

size_t segment_inputs(const struct segment_kind *k)
{
    return 3 * (segment_vectors(k) + 1);
}

void segment_vector_name(const struct segment_kind *k, size_t vector, char name[4])
{
    const size_t nodes = strlen(k->nodes);
    if (vector < nodes)
        snprintf(name, 4, "x%c", k->nodes[vector]);
    else if (vector < segment_vectors(k))
        snprintf(name, 4, "n%c", k->normals[vector - nodes]);
    else
        snprintf(name, 4, "xS");
}

void segment_input_name(const struct segment_kind *k, size_t input, char name[5])
{
    char vector[4];
    segment_vector_name(k, input / 3, vector);
    snprintf(name, 5, "%c%s", "xyz"[input % 3], vector[0] == 'x' ? vector + 1 : vector);
}
