/* footpoint_face_select over closed meshes of each kind: face, distance and side are those that footpoint_face_robust
 * finds among all faces. The mesh is a cube of N x N faces per side (triangles: twice as many), projected onto a sphere
 * with dents. Slave nodes lie on normals of the faces, up to an edge or about 100 edges away, so their side is known.
 * FOOTPOINT_NOT_UNIQUE is accepted only if quadruple precision finds two points as near on the face. FOOTPOINT_LONG=1: a
 * million. */
#include "../../runtime/footpoint_face.h"
#include "../support/long_cases.h"
#include "../support/quad_precision.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

enum { N = 4, FACES = 2 * 6 * N * N, MOST = 9, SHORT = 1000, LONG = 1000000 };

struct mesh {
    enum footpoint_face kind;
    int nodes, faces, seg[MOST * FACES];
    double xyz[3 * MOST * FACES];
};

static double uniform(uint64_t *stream)
{
    *stream = *stream * 6364136223846793005u + 1442695040888963407u;
    return (double)(*stream >> 11) * 0x1p-53;
}

/* Maps a point of the cube's surface to the body, with edges of about 1; equal points keep equal bits. */
static void blow_up(const double p[3], double x[3])
{
    const double length = sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]), u = p[0] / length, v = p[1] / length;
    const double radius = 0.63 * N * (1.0 + 0.04 * sin(3.0 * u + 1.0) * cos(4.0 * v));
    for (int i = 0; i < 3; i++)
        x[i] = radius * p[i] / length;
}

/* Computes point (a, b) of side s of the cube, both from 0 to 2 N, a x b outwards. */
static void place(int s, int a, int b, double p[3])
{
    const double u = (double)a / N - 1.0, v = (double)b / N - 1.0;
    p[s % 3] = s < 3 ? 1.0 : -1.0;
    p[(s + 1) % 3] = s < 3 ? u : v;
    p[(s + 2) % 3] = s < 3 ? v : u;
}

static void add_face(struct mesh *m, int s, const int (*at)[2])
{
    for (int k = 0; k < m->nodes; k++) {
        double p[3];
        place(s, at[k][0], at[k][1], p);
        m->seg[m->nodes * m->faces + k] = m->nodes * m->faces + k;
        blow_up(p, m->xyz + 3 * (m->nodes * m->faces + k));
    }
    m->faces++;
}

static void make_mesh(struct mesh *m, enum footpoint_face kind)
{
    static const int square[9][2] = {{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 0}, {2, 1}, {1, 2}, {0, 1}, {1, 1}};
    static const int triangle[2][6][2] = {{{0, 0}, {2, 0}, {2, 2}, {1, 0}, {2, 1}, {1, 1}},
                                          {{0, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 1}}};
    const int halves = kind <= FOOTPOINT_TRI6 ? 2 : 1;
    m->kind = kind;
    m->nodes = footpoint_face_nodes(kind);
    m->faces = 0;
    for (int i = 0; i < 6 * N * N * halves; i++) {
        const int cell = i / halves, s = cell / (N * N), a = 2 * (cell % N), b = 2 * (cell / N % N);
        const int(*const from)[2] = halves == 2 ? triangle[i % 2] : square;
        int at[MOST][2];
        for (int k = 0; k < m->nodes; k++) {
            at[k][0] = a + from[k][0];
            at[k][1] = b + from[k][1];
        }
        add_face(m, s, (const int(*)[2])at);
    }
}

static void gather(const struct mesh *m, int face, const double xS[3], double *x)
{
    memcpy(x, m->xyz + 3 * m->nodes * face, sizeof *x * 3 * (size_t)m->nodes);
    memcpy(x + 3 * m->nodes, xS, 3 * sizeof *x);
}

/* Draws a slave node on the normal of a face, sometimes at a corner or an edge; returns its side. */
static int draw(const struct mesh *m, uint64_t *stream, int far, double xS[3])
{
    const int face = (int)(uniform(stream) * m->faces), snapped = uniform(stream) < 0.3;
    const double height = far ? 60.0 + 80.0 * uniform(stream) : uniform(stream) - 0.4;
    double x[3 * (MOST + 1)], phi[MOST], normal[3], loc[2] = {uniform(stream), uniform(stream)}, none[2][3], gap;
    if (snapped)
        loc[0] = floor(2.0 * loc[0]);
    if (m->kind <= FOOTPOINT_TRI6)
        loc[1] *= 1.0 - loc[0];
    else
        for (int k = 0; k < 2; k++)
            loc[k] = 2.0 * loc[k] - 1.0;
    gather(m, face, xS, x);
    assert_int_equal(footpoint_face_place(m->kind, x, loc, phi, none[0], none[1], normal, &gap), FOOTPOINT_OK);
    for (int i = 0; i < 3; i++) {
        xS[i] = height * normal[i];
        for (int k = 0; k < m->nodes; k++)
            xS[i] += phi[k] * x[3 * k + i];
    }
    return fabs(height) < 1e-6 ? 0 : height < 0.0 ? -1 : 1;
}

/* Returns the least distance of all faces; distance[] is indexed by face. */
static double search_all(const struct mesh *m, const double xS[3], double *distance)
{
    double least = HUGE_VAL;
    for (int face = 0; face < m->faces; face++) {
        double x[3 * (MOST + 1)], loc[2];
        int region;
        gather(m, face, xS, x);
        assert_true(footpoint_face_robust(m->kind, x, loc, &distance[face], &region) >= FOOTPOINT_OK);
        distance[face] = fabs(distance[face]);
        least = fmin(least, distance[face]);
    }
    return least;
}

/* Returns the squared distance at z of the four-node face y, whose fifth point is the slave node; d: the difference. */
static quadruple square_at(const struct exact_face *f, const quadruple *y, const quadruple z[2], quadruple d[3])
{
    quadruple normal[3];
    exact_point(f, y, z[0], z[1], d, normal);
    for (int i = 0; i < 3; i++)
        d[i] -= y[12 + i];
    return exact_dot(d, d);
}

/* Returns the derivative at z by z[i], in which the square is of degree 2, and half its second derivative. */
static quadruple slope_at(const struct exact_face *f, const quadruple *y, const quadruple z[2], int i, quadruple *bend)
{
    quadruple d[3], to[2] = {z[0], z[1]}, square[3];
    for (int k = -1; k <= 1; k++) {
        to[i] = z[i] + k;
        square[k + 1] = square_at(f, y, to, d);
    }
    *bend = (square[0] + square[2]) / 2 - square[1];
    return (square[2] - square[0]) / 2;
}

/* Finds the nearest point of edge z[i] = side. Returns true if the face rises from there, to first order. */
static bool is_least(const struct exact_face *f, const quadruple *y, int i, int side, quadruple d[3], double *distance)
{
    quadruple z[2] = {i ? 0 : side, i ? side : 0}, bend;
    const quadruple slope = slope_at(f, y, z, !i, &bend), t = -slope / (2 * bend);
    z[!i] = t < -1 ? -1 : t > 1 ? 1 : t;
    *distance = sqrt((double)square_at(f, y, z, d));
    return -side * slope_at(f, y, z, i, &bend) >= 0;
}

/* Returns true if the nearest points of two edges, from which a four-node face rises, differ and are both as near as
 * `least` to the 1e-10 of an edge that footpoint_robust promises. */
static bool has_tie(const struct mesh *m, size_t face, const double xS[3], double least)
{
    const struct exact_face f = exact_face_of(4);
    double x[3 * (MOST + 1)], distance;
    quadruple y[15], d[4][3];
    int tied = 0;
    gather(m, (int)face, xS, x);
    for (int i = 0; i < 15; i++)
        y[i] = x[i];
    for (int k = 0; k < 4; k++)
        if (is_least(&f, y, k % 2, k < 2 ? -1 : 1, d[tied], &distance) && fabs(distance - least) <= 1e-10)
            tied++;
    for (int k = 1; k < tied; k++)
        for (int i = 0; i < 3; i++)
            if (fabs((double)(d[k][i] - d[0][i])) > 1e-9)
                return true;
    return false;
}

static void check(const struct mesh *m, uint64_t *stream, int far)
{
    double xS[3] = {0.0, 0.0, 0.0}, all[FACES], loc[2], distance;
    size_t chosen;
    int region;
    const int side = draw(m, stream, far, xS);
    const double least = search_all(m, xS, all), within = 1e-9 * fmax(1.0, least);
    const int status =
        footpoint_face_select(m->kind, m->xyz, (size_t)m->faces, m->seg, xS, &chosen, loc, &distance, &region);
    if (status != FOOTPOINT_NOT_UNIQUE || m->kind != FOOTPOINT_QUAD4 || !has_tie(m, chosen, xS, fabs(distance)))
        assert_int_equal(status, FOOTPOINT_OK);
    if (!(fabs(fabs(distance) - least) <= within) || !(all[chosen] - least <= within) || side * distance < 0.0)
        fail_msg("kind %d, slave node %a %a %a: face %zu, distance %.17g, not %.17g, side %d", m->kind, xS[0], xS[1],
                 xS[2], chosen, distance, least, side);
}

static void nearest_faces_are_those_of_brute_force(void **state)
{
    static struct mesh m;
    const int count = (int)long_cases(SHORT, LONG);
    uint64_t stream = 9;
    (void)state;
    for (enum footpoint_face kind = FOOTPOINT_TRI3; kind < FOOTPOINT_FACES; kind++) {
        make_mesh(&m, kind);
        for (int n = 0; n < count / FOOTPOINT_FACES; n++)
            check(&m, &stream, n % 2);
    }
}

/* Nearest points of both edges at a corner lie 1e-5 from it, and their distances of 85 edges differ by 1.3e-12. */
static void two_points_as_near_are_not_unique(void **state)
{
    static struct mesh m;
    const double xS[3] = {0x1.177bc8d3792dbp+4, 0x1.497fbe947a8aap+6, -0x1.598a2e84036d6p+4};
    double loc[2], distance;
    size_t chosen;
    int region;
    (void)state;
    make_mesh(&m, FOOTPOINT_QUAD4);
    assert_int_equal(footpoint_face_select(m.kind, m.xyz, (size_t)m.faces, m.seg, xS, &chosen, loc, &distance, &region),
                     FOOTPOINT_NOT_UNIQUE);
    assert_true(has_tie(&m, chosen, xS, distance));
    assert_false(has_tie(&m, chosen, m.xyz + 12 * chosen, 0.0));
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nearest_faces_are_those_of_brute_force),
                                       cmocka_unit_test(two_points_as_near_are_not_unique)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
