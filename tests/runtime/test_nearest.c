/* footpoint_face_select over closed meshes of each kind: face, distance and side are those that footpoint_face_robust
 * finds among all faces. The mesh is a cube of N x N faces per side (triangles: twice as many), projected onto a sphere
 * with dents. Slave nodes lie on normals of the faces, up to an edge or about 100 edges away, so their side is known.
 * FOOTPOINT_LONG=1: a million. */
#include "../../runtime/footpoint_face.h"
#include "../support/long_cases.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
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

static void check(const struct mesh *m, uint64_t *stream, int far)
{
    double xS[3] = {0.0, 0.0, 0.0}, all[FACES], loc[2], distance;
    size_t chosen;
    int region;
    const int side = draw(m, stream, far, xS);
    const double least = search_all(m, xS, all), within = 1e-9 * fmax(1.0, least);
    const int status =
        footpoint_face_select(m->kind, m->xyz, (size_t)m->faces, m->seg, xS, &chosen, loc, &distance, &region);
    assert_true(status == FOOTPOINT_OK || status == FOOTPOINT_NOT_UNIQUE); /* two points of a face may be as near */
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(nearest_faces_are_those_of_brute_force)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
