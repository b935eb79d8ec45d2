/* Reader of contact meshes (evolve/input/mesh.h): the sample models, and every face of every element type. */
#include "../support/mesh_model.h"

/* Computes the area vector of a face's corners and their mean. */
static void face_normal(const struct mesh *m, const struct mesh_face *f, double normal[3], double centre[3])
{
    const int corners = f->nodes > 4 ? f->nodes / 2 : f->nodes;
    memset(normal, 0, 3 * sizeof *normal);
    memset(centre, 0, 3 * sizeof *centre);
    for (int i = 0; i < corners; i++) {
        const double *a = m->xyz[f->node[i]], *b = m->xyz[f->node[(i + 1) % corners]];
        for (int k = 0; k < 3; k++) {
            normal[k] += (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]) / 2;
            centre[k] += a[k] / corners;
        }
    }
}

/* Returns the largest distance of a mid-side node from the middle of its side, and of the middle node from the mean of
 * the corners. */
static double midside_error(const struct mesh *m, const struct mesh_face *f)
{
    const int corners = f->nodes / 2;
    double error = 0;
    for (int i = 0; i < corners; i++)
        for (int k = 0; k < 3; k++)
            error = fmax(error, fabs(m->xyz[f->node[corners + i]][k] -
                                     (m->xyz[f->node[i]][k] + m->xyz[f->node[(i + 1) % corners]][k]) / 2));
    for (int k = 0; f->nodes == 9 && k < 3; k++) {
        double middle = 0;
        for (int i = 0; i < corners; i++)
            middle += m->xyz[f->node[i]][k] / corners;
        error = fmax(error, fabs(m->xyz[f->node[8]][k] - middle));
    }
    return error;
}

/* ---- the sample models ---- */

static void sample_models(void **state)
{
    static const struct {
        const char *path;
        size_t nodes, pairs, slaves, masters;
        int face_nodes;
    } models[] = {
        {"tests/meshes/punch.inp", 1914, 1, 841, 1012, 4}, {"tests/meshes/blocks.inp", 1998, 1, 441, 196, 4},
        {"tests/meshes/tetra4.inp", 9, 1, 4, 1, 3},        {"tests/meshes/tetra10.inp", 12, 1, 2, 1, 6},
        {"tests/meshes/hexa20.inp", 23, 1, 3, 2, 8},       {"tests/meshes/hexa27.inp", 30, 1, 3, 2, 9},
        {"tests/meshes/shell3.inp", 8, 2, 4, 2, 3},
    };
    (void)state;
    for (size_t i = 0; i < sizeof models / sizeof *models; i++) {
        struct mesh *m = read_model(models[i].path);
        const struct mesh_pair *p = &m->pair[0];
        check_sound(m);
        assert_int_equal(m->nodes, models[i].nodes);
        assert_int_equal(m->pairs, models[i].pairs);
        assert_int_equal(p->slaves, models[i].slaves);
        assert_int_equal(p->masters, models[i].masters);
        for (size_t k = 0; k < p->masters; k++) {
            assert_int_equal(p->master[k].nodes, models[i].face_nodes);
            if (models[i].face_nodes > 4)
                assert_true(midside_error(m, &p->master[k]) < 1e-12);
        }
        mesh_free(m);
    }
}

/* The upper sides of both big models: faces look up, are convex and all different; slaves lie above them. */
static void big_models(void **state)
{
    static const char *const paths[] = {"tests/meshes/punch.inp", "tests/meshes/blocks.inp"};
    (void)state;
    for (int i = 0; i < 2; i++) {
        struct mesh *m = read_model(paths[i]);
        const struct mesh_pair *p = &m->pair[0];
        double area = 0;
        for (size_t k = 0; k < p->masters; k++) {
            const struct mesh_face *f = &p->master[k];
            double normal[3], centre[3];
            face_normal(m, f, normal, centre);
            assert_true(normal[2] > 0);
            area += normal[2];
            for (int j = 0; j < 4; j++) {
                const double *a = m->xyz[f->node[j]], *b = m->xyz[f->node[(j + 1) % 4]],
                             *c = m->xyz[f->node[(j + 2) % 4]];
                assert_true((b[0] - a[0]) * (c[1] - b[1]) - (b[1] - a[1]) * (c[0] - b[0]) > 0);
            }
        }
        if (i == 0) /* the sheet is covered once: 120 x 80 */
            assert_true(fabs(area - 9600) < 1e-2);
        mesh_free(m);
    }
}

/* ---- every face of every type ---- */

struct shape {
    int corners, edges, faces;
    double corner[8][3];
    int edge[12][2];     /* of the mid-side nodes, in order */
    int face_corners[6]; /* S1.. */
    int face[6][4];      /* as the manuals list them, some inwards, some outwards */
};

static const struct shape tetrahedron = {
    4,
    6,
    4,
    {{0, 0, 0}, {2, 0.1, 0.2}, {0.3, 2, 0.1}, {0.2, 0.1, 2}},
    {{1, 2}, {2, 3}, {3, 1}, {1, 4}, {2, 4}, {3, 4}},
    {3, 3, 3, 3},
    {{1, 2, 3}, {1, 4, 2}, {2, 4, 3}, {3, 4, 1}},
};

static const struct shape wedge = {
    6,
    9,
    5,
    {{0, 0, 0}, {2, 0.1, 0.2}, {0.3, 2, 0.1}, {0.2, 0.1, 2}, {2.1, 0, 2.2}, {0.2, 2.1, 2}},
    {{1, 2}, {2, 3}, {3, 1}, {4, 5}, {5, 6}, {6, 4}, {1, 4}, {2, 5}, {3, 6}},
    {3, 3, 4, 4, 4},
    {{1, 2, 3}, {4, 6, 5}, {1, 4, 5, 2}, {2, 5, 6, 3}, {3, 6, 4, 1}},
};

static const struct shape hexahedron = {
    8,
    12,
    6,
    {{0, 0, 0}, {2, 0.1, 0.2}, {2.2, 2, 0.1}, {0.2, 1.9, 0}, {0.1, 0, 2}, {2.1, 0, 2.2}, {2, 2.1, 2}, {0, 2, 1.8}},
    {{1, 2}, {2, 3}, {3, 4}, {4, 1}, {5, 6}, {6, 7}, {7, 8}, {8, 5}, {1, 5}, {2, 6}, {3, 7}, {4, 8}},
    {4, 4, 4, 4, 4, 4},
    {{1, 2, 3, 4}, {5, 8, 7, 6}, {1, 5, 6, 2}, {2, 6, 7, 3}, {3, 7, 8, 4}, {4, 8, 5, 1}},
};

/* A shell's sides: S1 (SNEG) and S2 (SPOS). */
static const struct shape triangle = {
    3, 3, 2, {{0, 0, 0}, {2, 0.1, 0.2}, {0.3, 2, 0.1}}, {{1, 2}, {2, 3}, {3, 1}}, {3, 3}, {{1, 3, 2}, {1, 2, 3}},
};

static const struct shape quadrilateral = {
    4,
    4,
    2,
    {{0, 0, 0}, {2, 0.1, 0.2}, {2.2, 2, 0.1}, {0.2, 1.9, 0.3}},
    {{1, 2}, {2, 3}, {3, 4}, {4, 1}},
    {4, 4},
    {{1, 4, 3, 2}, {1, 2, 3, 4}},
};

static void mean(const struct shape *s, const int *corner, int n, double x[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = 0;
        for (int i = 0; i < n; i++)
            x[k] += s->corner[corner[i] - 1][k] / n;
    }
}

/* Places node i, from 0: corners, middles of edges, then the middle of a solid and of its faces, or of a shell. */
static void place(const struct shape *s, int i, double x[3])
{
    static const int all[] = {1, 2, 3, 4, 5, 6, 7, 8};
    const int middle = i - s->corners - s->edges;
    if (i < s->corners)
        memcpy(x, s->corner[i], 3 * sizeof *x);
    else if (middle < 0)
        mean(s, s->edge[i - s->corners], 2, x);
    else if (middle == 0)
        mean(s, all, s->corners, x);
    else
        mean(s, s->face[middle - 1], s->face_corners[middle - 1], x);
}

/* Reads a model of one element with nodes 1.. at their places and node 99 as slave. */
static struct mesh *read_element(const char *type, const struct shape *s, int nodes, const char *label)
{
    char text[4096];
    int n = snprintf(text, sizeof text, "*NODE\n99, 9, 9, 9\n");
    for (int i = 0; i < nodes; i++) {
        double x[3];
        place(s, i, x);
        n += snprintf(text + n, sizeof text - (size_t)n, "%d, %.17g, %.17g, %.17g\n", i + 1, x[0], x[1], x[2]);
    }
    n += snprintf(text + n, sizeof text - (size_t)n, "*ELEMENT, TYPE=%s\n5", type);
    for (int i = 0; i < nodes; i++)
        n += snprintf(text + n, sizeof text - (size_t)n, "%s%d", i % 7 == 6 ? ",\n" : ",", i + 1);
    snprintf(text + n, sizeof text - (size_t)n,
             "\n*SURFACE, NAME=M\n5, %s\n*SURFACE, NAME=S, TYPE=NODE\n99\n*CONTACT PAIR\nS, M\n", label);
    return read_written(text);
}

static void check_face(const char *type, const struct shape *s, int nodes, int face, const char *label)
{
    struct mesh *m = read_element(type, s, nodes, label);
    const struct mesh_face *f = &m->pair[0].master[0];
    const int corners = s->face_corners[face];
    double normal[3], centre[3], outwards = 0;
    check_sound(m);
    assert_int_equal(m->pair[0].masters, 1);
    assert_int_equal(f->nodes, (nodes > s->corners ? 2 * corners : corners) + (nodes > s->corners + s->edges));
    for (int i = 0; i < corners; i++) {
        int times = 0;
        for (int k = 0; k < corners; k++)
            times += m->label[f->node[k]] == s->face[face][i];
        assert_int_equal(times, 1);
    }
    face_normal(m, f, normal, centre);
    for (int k = 0; k < 3; k++) {
        double middle = 0;
        for (int i = 0; i < s->corners; i++)
            middle += s->corner[i][k] / s->corners;
        outwards += normal[k] * (centre[k] - middle);
    }
    if (s->faces == 2) /* a shell: against or along its normal, which looks up here */
        outwards = face == 0 ? -normal[2] : normal[2];
    if (!(outwards > 0.1))
        fail_msg("%s %s does not look outwards: %a", type, label, outwards);
    if (f->nodes > 4 && midside_error(m, f) > 1e-15)
        fail_msg("%s %s: mid-side nodes off by %a", type, label, midside_error(m, f));
    mesh_free(m);
}

static void every_face(void **state)
{
    static const struct {
        const char *type;
        const struct shape *shape;
        int nodes;
    } types[] = {
        {"C3D4", &tetrahedron, 4},    {"C3D10", &tetrahedron, 10},  {"C3D10M", &tetrahedron, 10},
        {"C3D6", &wedge, 6},          {"C3D15", &wedge, 15},        {"C3D8", &hexahedron, 8},
        {"c3d8r", &hexahedron, 8},    {"C3D8I", &hexahedron, 8},    {"C3D8RH", &hexahedron, 8},
        {"C3D20", &hexahedron, 20},   {"C3D20R", &hexahedron, 20},  {"S3", &triangle, 3},
        {"S3R", &triangle, 3},        {"S6", &triangle, 6},         {"STRI65", &triangle, 6},
        {"S4", &quadrilateral, 4},    {"S4R", &quadrilateral, 4},   {"S8R", &quadrilateral, 8},
        {"S8R5", &quadrilateral, 8},  {"M3D4R", &quadrilateral, 4}, {"R3D4", &quadrilateral, 4},
        {"R3D3", &triangle, 3},       {"C3D27", &hexahedron, 27},   {"C3D27R", &hexahedron, 27},
        {"M3D9R", &quadrilateral, 9}, {"S9R5", &quadrilateral, 9},
    };
    static const char *const labels[] = {"S1", "s2", "S3", "S4", "S5", "S6"};
    (void)state;
    for (size_t i = 0; i < sizeof types / sizeof *types; i++)
        for (int face = 0; face < types[i].shape->faces; face++) {
            check_face(types[i].type, types[i].shape, types[i].nodes, face, labels[face]);
            if (types[i].shape->faces == 2)
                check_face(types[i].type, types[i].shape, types[i].nodes, face, face == 0 ? "SNEG" : "spos");
        }
    check_face("S4", &quadrilateral, 4, 1, ""); /* a shell without a label: its positive side */
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sample_models),
        cmocka_unit_test(big_models),
        cmocka_unit_test(every_face),
    };
    return cmocka_run_group_tests_name("mesh", tests, make_folder, remove_folder);
}
