/* Reader of contact meshes (evolve/mesh.h): the sample models, every face of every element type, spellings of the
 * format, one case for each diagnostic, and mutated files, which must end in a sound mesh or in a diagnostic. */
#include "../evolve/mesh.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/footpoint-mesh-XXXXXX";

static const char *in_folder(const char *name)
{
    static char path[sizeof folder + 64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static void write_file(const char *name, const char *text, size_t size)
{
    FILE *f = fopen(in_folder(name), "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

static struct mesh *read_model(const char *path)
{
    struct diag d = {0};
    struct mesh *m = mesh_read(path, &d);
    if (!m)
        fail_msg("%s", d.text);
    return m;
}

static struct mesh *read_written(const char *text)
{
    write_file("model.inp", text, strlen(text));
    return read_model(in_folder("model.inp"));
}

/* Whatever was read: indices in range, slaves ascending and each once, faces of a known size, coordinates finite. */
static void check_sound(const struct mesh *m)
{
    assert_true(m->pairs > 0);
    for (size_t i = 0; i < m->nodes; i++) {
        assert_true(i == 0 || m->label[i - 1] < m->label[i]);
        assert_true(isfinite(m->xyz[i][0]) && isfinite(m->xyz[i][1]) && isfinite(m->xyz[i][2]));
    }
    for (size_t i = 0; i < m->pairs; i++) {
        const struct mesh_pair *p = &m->pair[i];
        assert_true(p->slaves > 0 && p->masters > 0);
        assert_true(strlen(p->slave_name) > 0 && strlen(p->master_name) > 0);
        for (size_t k = 0; k < p->slaves; k++) {
            assert_true(p->slave[k] >= 0 && (size_t)p->slave[k] < m->nodes);
            assert_true(k == 0 || p->slave[k - 1] < p->slave[k]);
        }
        for (size_t k = 0; k < p->masters; k++) {
            const int n = p->master[k].nodes;
            assert_true(n == 3 || n == 4 || n == 6 || n == 8);
            for (int j = 0; j < n; j++)
                assert_true(p->master[k].node[j] >= 0 && (size_t)p->master[k].node[j] < m->nodes);
        }
    }
}

/* Area vector of a face's corners and their mean. */
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

/* Largest distance of a mid-side node from the middle of its side. */
static double midside_error(const struct mesh *m, const struct mesh_face *f)
{
    const int corners = f->nodes / 2;
    double error = 0;
    for (int i = 0; i < corners; i++)
        for (int k = 0; k < 3; k++)
            error = fmax(error, fabs(m->xyz[f->node[corners + i]][k] -
                                     (m->xyz[f->node[i]][k] + m->xyz[f->node[(i + 1) % corners]][k]) / 2));
    return error;
}

/* ---- the sample models ---- */

static void sample_models(void **state)
{
    static const struct {
        const char *path;
        size_t nodes, pairs, slaves, masters;
        int face_nodes;
        const char *slave_name, *master_name;
    } models[] = {
        {"tests/meshes/punch.inp", 1914, 1, 841, 1012, 4, "PUNCH_FACE", "SHEET_TOP"},
        {"tests/meshes/blocks.inp", 1998, 1, 441, 196, 4, "Slave", "Master"},
        {"tests/meshes/tetra4.inp", 9, 1, 4, 1, 3, "bottom", "top"},
        {"tests/meshes/tetra10.inp", 12, 1, 2, 1, 6, "POINTS", "FACE"},
        {"tests/meshes/hexa20.inp", 23, 1, 3, 2, 8, "TIPS", "TOPANDSIDE"},
        {"tests/meshes/shell3.inp", 8, 2, 4, 2, 3, "TENT_INSIDE", "PLATE_TOP"},
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
        assert_string_equal(p->slave_name, models[i].slave_name);
        assert_string_equal(p->master_name, models[i].master_name);
        for (size_t k = 0; k < p->masters; k++) {
            assert_int_equal(p->master[k].nodes, models[i].face_nodes);
            if (models[i].face_nodes > 4)
                assert_true(midside_error(m, &p->master[k]) < 1e-12);
        }
        mesh_free(m);
    }
}

/* The upper sides of both big models: faces look up, are convex, share no two equal ones; slaves lie above them. */
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
    int edge[12][2];     /* of the mid-side nodes, in their order */
    int face_corners[6]; /* S1.. */
    int face[6][4];      /* as the manuals list them, inwards and outwards mixed */
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

/* Model of one element with nodes 1.. at their places and node 99 as slave. */
static struct mesh *read_element(const char *type, const struct shape *s, int nodes, const char *label)
{
    char text[4096];
    int n = snprintf(text, sizeof text, "*NODE\n99, 9, 9, 9\n");
    for (int i = 0; i < nodes; i++) {
        double x[3];
        for (int k = 0; k < 3; k++)
            x[k] =
                i < s->corners
                    ? s->corner[i][k]
                    : (s->corner[s->edge[i - s->corners][0] - 1][k] + s->corner[s->edge[i - s->corners][1] - 1][k]) / 2;
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
    assert_int_equal(f->nodes, nodes > s->corners ? 2 * corners : corners);
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
    if (s->faces == 2) /* a shell: against or along its own normal, which looks up here */
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
        {"C3D4", &tetrahedron, 4},   {"C3D10", &tetrahedron, 10},  {"C3D10M", &tetrahedron, 10},
        {"C3D6", &wedge, 6},         {"C3D15", &wedge, 15},        {"C3D8", &hexahedron, 8},
        {"c3d8r", &hexahedron, 8},   {"C3D8I", &hexahedron, 8},    {"C3D8RH", &hexahedron, 8},
        {"C3D20", &hexahedron, 20},  {"C3D20R", &hexahedron, 20},  {"S3", &triangle, 3},
        {"S3R", &triangle, 3},       {"S6", &triangle, 6},         {"STRI65", &triangle, 6},
        {"S4", &quadrilateral, 4},   {"S4R", &quadrilateral, 4},   {"S8R", &quadrilateral, 8},
        {"S8R5", &quadrilateral, 8}, {"M3D4R", &quadrilateral, 4}, {"R3D4", &quadrilateral, 4},
        {"R3D3", &triangle, 3},
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

/* ---- spellings ---- */

static const char everything[] = "\xEF\xBB\xBF** comment\r\n"
                                 "*HEADING\r\n"
                                 "  any text, even 1, 2, 3\r\n"
                                 " * node , NSET = \"Low Nodes\" , SYSTEM=R\r\n"
                                 "  +30 , 0 , 0 , 0 \r\n"
                                 "\r\n"
                                 "10, 1.5D+0, 0., -2d-1, 0., 0., 1.\r\n"
                                 "20,,1.E0\r\n"
                                 "*Node\r\n"
                                 "2000000000, 1, 1\r\n"
                                 "7, 0.5, 0.5, 1\r\n"
                                 "8, 0.5, 0.25, 1\r\n"
                                 "9, 0.25, 0.5, 1\r\n"
                                 "*SURFACE, NAME=\"master face\",\r\n"
                                 "** a comment between\r\n"
                                 "  TYPE=element\r\n"
                                 "outer, SPOS\r\n"
                                 "2\r\n"
                                 "*ELSET, ELSET=inner\r\n"
                                 "outer, 2, 1, 2,\r\n"
                                 "*ELSET, ELSET=OUTER\r\n"
                                 "INNER\r\n"
                                 "*ELEMENT, ELSET=Sheet,\r\n"
                                 "TYPE=s3\r\n"
                                 "1, 30,\r\n"
                                 "** a comment between\r\n"
                                 "10,\r\n"
                                 "2000000000\r\n"
                                 "2, 30, 2000000000, 20,\r\n"
                                 "3, 7, 8, 9\r\n"
                                 "*MATERIAL, NAME=nodes\r\n"
                                 "*ELASTIC, TYPE=ISO\r\n"
                                 "210000, 0.3, oops\r\n"
                                 "*NSET, NSET=Some, GENERATE\r\n"
                                 "5, 9, 2\r\n"
                                 "*NSET, NSET=more\r\n"
                                 "some, 8, 8\r\n"
                                 "*SURFACE, TYPE=NODE, NAME=tips\r\n"
                                 "MORE, 1.0\r\n"
                                 "8\r\n"
                                 "low nodes\r\n"
                                 "*SURFACE INTERACTION, NAME=x\r\n"
                                 "*STEP\r\n"
                                 "*CONTACT PAIR, INTERACTION=x, TYPE=SURFACE TO SURFACE\r\n"
                                 "Tips, MASTER FACE, , \r\n"
                                 "*NODE PRINT, NSET=Some\r\n"
                                 "U\r\n"
                                 "*END STEP";

static void spellings(void **state)
{
    static const int slaves[] = {7, 8, 9, 10, 20, 30}, faces[2][3] = {{30, 10, 2000000000}, {30, 2000000000, 20}};
    (void)state;
    struct mesh *m = read_written(everything);
    const struct mesh_pair *p = &m->pair[0];
    check_sound(m);
    assert_int_equal(m->nodes, 7);
    assert_int_equal(p->slaves, 6);
    for (int i = 0; i < 6; i++)
        assert_int_equal(m->label[p->slave[i]], slaves[i]);
    assert_int_equal(p->masters, 2);
    for (int i = 0; i < 2; i++)
        for (int k = 0; k < 3; k++)
            assert_int_equal(m->label[p->master[i].node[k]], faces[i][k]);
    const double *ten = m->xyz[p->slave[3]], *twenty = m->xyz[p->slave[4]];
    assert_true(ten[0] == 1.5 && ten[1] == 0 && ten[2] == -0.2);
    assert_true(twenty[0] == 0 && twenty[1] == 1 && twenty[2] == 0);
    mesh_free(m);
}

/* Files beside the including one, nested, in the midst of data, and by INPUT= of a keyword. */
static void included_files(void **state)
{
    static const char nodes[] = "1, 0, 0, 0\n*INCLUDE, INPUT=more.inp\n3, 0, 1, 0\n", more[] = "2, 1, 0, 0",
                      elements[] = "1, 1, 2, 3\n";
    (void)state;
    write_file("nodes.inp", nodes, strlen(nodes));
    write_file("more.inp", more, strlen(more));
    write_file("elements.inp", elements, strlen(elements));
    struct mesh *m = read_written("*NODE, NSET=N\n*INCLUDE, INPUT=\"nodes.inp\"\n4, 0, 0, 1\n"
                                  "*ELEMENT, TYPE=S3, ELSET=E, INPUT=elements.inp\n"
                                  "*SURFACE, NAME=M\nE, SPOS\n*SURFACE, NAME=S, TYPE=NODE\nN\n*CONTACT PAIR\nS, M\n");
    check_sound(m);
    assert_int_equal(m->nodes, 4);
    assert_int_equal(m->pair[0].slaves, 4);
    mesh_free(m);
}

/* Numbers far apart and in descending order. */
static void sparse_numbers(void **state)
{
    const int n = 20000;
    (void)state;
    FILE *f = fopen(in_folder("model.inp"), "w");
    assert_non_null(f);
    fprintf(f, "*NODE, NSET=ALL\n");
    for (int i = n; i > 0; i--)
        fprintf(f, "%d, %d, %d, 0\n", 100003 * i, i % 100, i / 100);
    fprintf(f, "*ELEMENT, TYPE=S3, ELSET=E\n");
    for (int i = n; i > 2; i--)
        fprintf(f, "%d, %d, %d, %d\n", 99991 * i, 100003 * i, 100003 * (i - 1), 100003 * (i - 2));
    fprintf(f, "*SURFACE, NAME=S\nE, SNEG\nE, SNEG\n*CONTACT PAIR\nS, S\n");
    assert_int_equal(fclose(f), 0);
    struct mesh *m = read_model(in_folder("model.inp"));
    check_sound(m);
    assert_int_equal(m->nodes, n);
    assert_int_equal(m->pair[0].slaves, n);
    assert_int_equal(m->pair[0].masters, n - 2);
    assert_int_equal(m->label[m->pair[0].master[0].node[0]], 3 * 100003);
    mesh_free(m);
}

/* ---- diagnostics ---- */

#define NODES "*NODE, NSET=N\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
#define MODEL NODES "*ELEMENT, TYPE=C3D4, ELSET=E\n1, 1, 2, 3, 4\n*SURFACE, NAME=M\nE, S1\n"
#define SLAVE "*SURFACE, NAME=S, TYPE=NODE\nN\n"
#define PAIR "*CONTACT PAIR\nS, M\n"

static const struct {
    const char *text, *expected; /* the diagnostic after the folder's name */
} bad_models[] = {
    {"", "model.inp: error: no contact pair: *CONTACT PAIR expected"},
    {MODEL SLAVE, "model.inp: error: no contact pair: *CONTACT PAIR expected"},
    {"hello, world\n", "model.inp:1: error: data before the first keyword: not an input file"},
    {"\n** nothing\n1, 2, 3\n*NODE\n", "model.inp:3: error: data before the first keyword: not an input file"},

    {"*NODE\n1, 0, 0, zero\n", "model.inp:2: error: 'zero' is not a number"},
    {"*NODE\n1, 0x10, 0, 0\n", "model.inp:2: error: '0x10' is not a number"},
    {"*NODE\n1, 1 2, 0, 0\n", "model.inp:2: error: '1 2' is not a number"},
    {"*NODE\n1, 1e, 0, 0\n", "model.inp:2: error: '1e' is not a number"},
    {"*NODE\n1, 0.00000000000000000000000000000000000000000000000000000000000000000001, 0, 0\n",
     "model.inp:2: error: '0.00000000000000000000000000000000000000...' is not a number"},
    {"*NODE\n1, 0, inf, 0\n", "model.inp:2: error: coordinate 'inf' of node 1 is not finite"},
    {"*NODE\n1, 0, NaN, 0\n", "model.inp:2: error: coordinate 'NaN' of node 1 is not finite"},
    {"*NODE\n1, 0, 0, -1D999\n", "model.inp:2: error: coordinate '-1D999' of node 1 is not finite"},
    {"*NODE\none, 0, 0, 0\n", "model.inp:2: error: 'one' is not a whole number from 1 to 2147483647"},
    {"*NODE\n0, 0, 0, 0\n", "model.inp:2: error: '0' is not a whole number from 1 to 2147483647"},
    {"*NODE\n-7, 0, 0, 0\n", "model.inp:2: error: '-7' is not a whole number from 1 to 2147483647"},
    {"*NODE\n1.5, 0, 0, 0\n", "model.inp:2: error: '1.5' is not a whole number from 1 to 2147483647"},
    {"*NODE\n2147483648, 0, 0, 0\n", "model.inp:2: error: '2147483648' is not a whole number from 1 to 2147483647"},
    {"*NODE\n, 0, 0, 0\n", "model.inp:2: error: '' is not a whole number from 1 to 2147483647"},
    {"*NODE\n1, 0, 0, 0\n2, 0, 0, 0\n2, 1, 0, 0\n1, 1, 0, 0\n*NODE\n", "model.inp:4: error: node 2 is defined twice"},
    {"*NODE, SYSTEM=C\n1, 0, 0, 0\n",
     "model.inp:1: error: *NODE, SYSTEM=C is not supported: rectangular coordinates only"},
    {"*NODE, NSET=\n1, 0, 0, 0\n", "model.inp:1: error: name expected"},

    {NODES "*ELEMENT\n1, 1, 2, 3, 4\n", "model.inp:6: error: *ELEMENT has no TYPE="},
    {NODES "*ELEMENT, TYPE=B31\n1, 1, 2\n", "model.inp:6: error: element type 'B31' is not supported"},
    {NODES "*ELEMENT, TYPE=C3D80\n1, 1, 2\n", "model.inp:6: error: element type 'C3D80' is not supported"},
    {NODES "*ELEMENT, TYPE=\n1, 1, 2\n", "model.inp:6: error: element type '' is not supported"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3\n2, 1, 2, 3, 4\n",
     "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2,\n3,\n*NSET, NSET=X\n",
     "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, ", "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4, 5\n",
     "model.inp:7: error: element 1 has more than the 4 nodes of type C3D4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2,\n3, x\n",
     "model.inp:8: error: 'x' is not a whole number from 1 to 2147483647"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 40\n", "model.inp:7: error: node 40 of element 1 is not defined"},
    {NODES "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n1, 1, 3, 4\n", "model.inp:8: error: element 1 is defined twice"},

    {"*NSET, GENERATE\n1, 2\n", "model.inp:1: error: *NSET has no NSET="},
    {"*ELSET, NSET=A\n1, 2\n", "model.inp:1: error: *ELSET has no ELSET="},
    {"*NSET, NSET=A, ELSET=B\n", "model.inp:1: error: *NSET, ELSET= is not supported: list the nodes"},
    {"*NSET, NSET=A, GENERATE\n1\n", "model.inp:2: error: GENERATE needs a first and a last number"},
    {"*NSET, NSET=A, GENERATE\n1, 2, 0\n", "model.inp:2: error: '0' is not a whole number from 1 to 2147483647"},
    {"*NSET, NSET=A, GENERATE\n1, 2, 1, 1\n",
     "model.inp:2: error: GENERATE takes first, last and step; '1' is one too many"},
    {"*NSET, NSET=A, GENERATE\n9, 2\n", "model.inp:2: error: GENERATE runs from 9 down to 2"},
    {"*NSET, NSET=A\n1, 99999999999\n", "model.inp:2: error: '99999999999' is not a whole number from 1 to 2147483647"},

    {"*SURFACE\nE, S1\n", "model.inp:1: error: *SURFACE has no NAME="},
    {"*SURFACE, NAME=M, TYPE=CYLINDER\n", "model.inp:1: error: surface type 'CYLINDER' is not supported"},
    {"*SURFACE, NAME=M, COMBINE=UNION\n", "model.inp:1: error: *SURFACE, COMBINE= is not supported: list the faces"},
    {"*SURFACE, NAME=M\nE, S1\n*SURFACE, TYPE=NODE, NAME=m\n", "model.inp:3: error: surface 'm' is defined twice"},
    {"*SURFACE, NAME=M\nE, S7\n", "model.inp:2: error: face label 'S7' is none of S1 to S6, SPOS and SNEG"},
    {"*SURFACE, NAME=M\n, S1\n", "model.inp:2: error: name expected"},
    {MODEL SLAVE "*SURFACE, NAME=B\nE\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element 1 of type C3D4 is solid and needs a face label, S1 to S4"},
    {MODEL SLAVE "*SURFACE, NAME=B\n1, S5\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element 1 of type C3D4 has no face S5"},
    {MODEL SLAVE "*SURFACE, NAME=B\n1, SPOS\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element 1 of type C3D4 has no face SPOS"},
    {NODES SLAVE "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n*SURFACE, NAME=M\n1, S3\n" PAIR,
     "model.inp:11: error: element 1 of type S3 has no face S3"},
    {MODEL SLAVE "*SURFACE, NAME=B\n2, S1\n*CONTACT PAIR\nS, B\n", "model.inp:13: error: element 2 is not defined"},
    {MODEL SLAVE "*SURFACE, NAME=B\nN, S1\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element set 'N' is not defined"},
    {MODEL SLAVE "*ELSET, ELSET=C\nE, D\n*SURFACE, NAME=B\nC, S1\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element set 'D' is not defined"},
    {MODEL SLAVE "*SURFACE, NAME=B\n*CONTACT PAIR\nS, B\n", "model.inp:12: error: surface 'B' is empty"},
    {MODEL "*SURFACE, NAME=S, TYPE=NODE\nE\n" PAIR, "model.inp:11: error: node set 'E' is not defined"},
    {MODEL "*SURFACE, NAME=S, TYPE=NODE\n1\n17\n" PAIR, "model.inp:12: error: node 17 is not defined"},
    {MODEL "*NSET, NSET=A, GENERATE\n10, 20\n*SURFACE, NAME=S, TYPE=NODE\nA\n" PAIR,
     "model.inp:11: error: no node from 10 to 20 is defined"},
    {MODEL "*NSET, NSET=A\nA\n*SURFACE, NAME=S, TYPE=NODE\nA\n" PAIR, "model.inp:12: error: surface 'S' is empty"},

    {MODEL SLAVE "*CONTACT PAIR\n", "model.inp:12: error: *CONTACT PAIR names no surfaces"},
    {MODEL SLAVE "*CONTACT PAIR\n*STEP\n", "model.inp:12: error: *CONTACT PAIR names no surfaces"},
    {MODEL SLAVE "*CONTACT PAIR\nS\n", "model.inp:13: error: contact pair needs a slave and a master surface"},
    {MODEL SLAVE "*CONTACT PAIR\n, M\n", "model.inp:13: error: contact pair needs a slave and a master surface"},
    {MODEL SLAVE "*CONTACT PAIR\nT, M\n", "model.inp:13: error: surface 'T' is not defined"},
    {MODEL SLAVE "*CONTACT PAIR\nS, E\n", "model.inp:13: error: surface 'E' is not defined"},
    {MODEL SLAVE "*CONTACT PAIR\nM, S\n",
     "model.inp:13: error: master surface 'S' is made of nodes; it must be made of element faces"},

    {"*HEADING\n*INCLUDE\n", "model.inp:2: error: *INCLUDE has no INPUT="},
    {"*INCLUDE, INPUT=\n", "model.inp:1: error: included file has no name"},
    {"*INCLUDE, INPUT=missing.inp\n", "model.inp:1: error: cannot read included file 'missing.inp'"},
    {"*INCLUDE, INPUT=/\n", "model.inp:1: error: cannot read included file '/'"},
    {"*INCLUDE, INPUT=model.inp\n", "model.inp:1: error: including 'model.inp' again makes a cycle"},
    {"*HEADING\n*INCLUDE, INPUT=part.inp\n", "part.inp:2: error: including './model.inp' again makes a cycle"},
    {"*NODE\n1, 0, 0, 0\n*INCLUDE, INPUT=word.inp\n", "word.inp:1: error: 'word' is not a number"},

    {"*HEADING\n*PART, NAME=P\n", "model.inp:2: error: *PART is not supported: an assembly of parts; write the model "
                                  "flat, without *PART and *INSTANCE"},
    {"*instance, NAME=P\n", "model.inp:1: error: *INSTANCE is not supported: an assembly of parts; write the model "
                            "flat, without *PART and *INSTANCE"},
    {"*Assembly\n", "model.inp:1: error: *ASSEMBLY is not supported: an assembly of parts; write the model flat, "
                    "without *PART and *INSTANCE"},
    {"*NGEN\n1, 9\n",
     "model.inp:1: error: *NGEN is not supported: it makes or moves nodes; list them in global coordinates"},
    {"*SYSTEM\n1, 2, 3\n",
     "model.inp:1: error: *SYSTEM is not supported: it makes or moves nodes; list them in global coordinates"},
    {"*NODE\n\001\377\n", "model.inp:2: error: '?\?' is not a whole number from 1 to 2147483647"},
};

static void check_refused(const char *path, const char *expected)
{
    struct diag d = {0};
    char full[800];
    struct mesh *m = mesh_read(path, &d);
    snprintf(full, sizeof full, "%s/%s", folder, expected);
    if (m)
        fail_msg("accepted, instead of: %s", full);
    assert_string_equal(d.text, full);
    assert_int_equal(d.code, EXIT_INPUT);
}

static void diagnostics(void **state)
{
    static const char part[] = "*HEADING\n*INCLUDE, INPUT=./model.inp\n", word[] = "2, 0, word\n";
    (void)state;
    write_file("part.inp", part, strlen(part));
    write_file("word.inp", word, strlen(word));
    for (size_t i = 0; i < sizeof bad_models / sizeof *bad_models; i++) {
        write_file("model.inp", bad_models[i].text, strlen(bad_models[i].text));
        check_refused(in_folder("model.inp"), bad_models[i].expected);
    }
    static const char nul[] = "*NODE\n1, 0, 0, 0\n2, \0, 0\n";
    write_file("model.inp", nul, sizeof nul - 1);
    check_refused(in_folder("model.inp"), "model.inp:3: error: not a text file: NUL byte");

    struct diag d = {0};
    assert_null(mesh_read("tests/meshes/none.inp", &d));
    assert_string_equal(d.text, "tests/meshes/none.inp: error: cannot open: No such file or directory");
    assert_int_equal(d.code, EXIT_SYSTEM);
    mesh_free(NULL);
}

/* A file whose two lines include the next one, and so on, doubles at each level. */
static void many_includes(void **state)
{
    (void)state;
    for (int i = 0; i < 20; i++) {
        char name[32], text[128];
        snprintf(name, sizeof name, "level%d.inp", i);
        snprintf(text, sizeof text, "*INCLUDE, INPUT=level%d.inp\n*INCLUDE, INPUT=level%d.inp\n", i + 1, i + 1);
        write_file(name, text, strlen(text));
    }
    write_file("level20.inp", "** end\n", 7);
    check_refused(in_folder("level0.inp"), "level19.inp:2: error: more than 10000 files included");
}

/* Hostile sizes: one very long line, very many fields, sets nested and tangled by the thousand. */
static void hostile_sizes(void **state)
{
    const size_t size = 2000000;
    const int sets = 20000;
    char *text = malloc(size);
    struct diag d = {0};
    (void)state;
    assert_non_null(text);
    memset(text, 'x', size);
    memcpy(text, "*NODE\n", 6);
    write_file("model.inp", text, size);
    check_refused(in_folder("model.inp"),
                  "model.inp:2: error: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' is not a whole number from 1 to "
                  "2147483647");
    memset(text, ',', size);
    memcpy(text, "*A", 2);
    write_file("model.inp", text, size);
    assert_null(mesh_read(in_folder("model.inp"), &d));
    memset(text, '*', size);
    write_file("model.inp", text, size);
    assert_null(mesh_read(in_folder("model.inp"), &d));
    free(text);

    FILE *f = fopen(in_folder("model.inp"), "w");
    assert_non_null(f);
    fprintf(f, MODEL SLAVE);
    for (int i = 0; i < sets; i++)
        fprintf(f, "*NSET, NSET=A%d\nA%d, A%d, A0\n", i, i + 1, i);
    fprintf(f, "*NSET, NSET=A%d\n2\n*SURFACE, NAME=T, TYPE=NODE\nA0\n*CONTACT PAIR\nT, M\n", sets);
    assert_int_equal(fclose(f), 0);
    struct mesh *m = read_model(in_folder("model.inp"));
    assert_int_equal(m->pair[0].slaves, 1);
    assert_int_equal(m->label[m->pair[0].slave[0]], 2);
    mesh_free(m);
}

/* ---- mutations ---- */

static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* One to four changes: a byte, a bit, a span removed, doubled or moved, a word put in, the end cut off. */
static size_t mutate(char *text, size_t n, size_t room, uint64_t *random)
{
    static const char *const words[] = {"*",
                                        ",",
                                        "\n",
                                        "**",
                                        "=",
                                        "*NODE\n",
                                        "1e999",
                                        "-1",
                                        "0",
                                        "2147483647",
                                        "GENERATE",
                                        "\n*SURFACE",
                                        "nan",
                                        "\"",
                                        "\r\n",
                                        ",,",
                                        "\0",
                                        "S9",
                                        "*INCLUDE, INPUT=model.inp\n",
                                        ", 1,\n",
                                        "ELSET="};
    for (uint64_t changes = 1 + draw(random) % 4; changes > 0 && n > 0; changes--) {
        const size_t at = draw(random) % n, most = n - at < 40 ? n - at : 40, span = 1 + draw(random) % most;
        const char *word = words[draw(random) % (sizeof words / sizeof *words)];
        const size_t length = word[0] ? strlen(word) : 1;
        switch (draw(random) % 7) {
        case 0:
            text[at] = (char)draw(random);
            break;
        case 1:
            text[at] = (char)(text[at] ^ (1 << draw(random) % 8));
            break;
        case 2:
            memmove(text + at, text + at + span, n - at - span);
            n -= span;
            break;
        case 3:
            if (n + span <= room) {
                memmove(text + at + span, text + at, n - at);
                n += span;
            }
            break;
        case 4:
            if (n + length <= room) {
                memmove(text + at + length, text + at, n - at);
                memcpy(text + at, word, length);
                n += length;
            }
            break;
        case 5:
            memmove(text + draw(random) % (n - span + 1), text + at, span);
            break;
        default:
            if (draw(random) % 4 == 0)
                n = at;
        }
    }
    return n;
}

static void mutations(void **state)
{
    static const struct {
        const char *path; /* NULL: the text of all spellings */
        int rounds;
    } samples[] = {
        {NULL, 1500},
        {"tests/meshes/tetra4.inp", 500},
        {"tests/meshes/tetra10.inp", 500},
        {"tests/meshes/hexa20.inp", 500},
        {"tests/meshes/shell3.inp", 1000},
        {"tests/meshes/punch.inp", 12},
        {"tests/meshes/blocks-nodes.inp", 4},
    };
    uint64_t random = 2008;
    int read = 0, refused = 0;
    (void)state;
    for (size_t i = 0; i < sizeof samples / sizeof *samples; i++) {
        struct diag d = {0};
        size_t size = strlen(everything);
        char *text = samples[i].path ? read_text(samples[i].path, &size, &d) : new_text(everything, size);
        char *mutant = new_array(size + 1000, 1);
        assert_non_null(text);
        for (int round = 0; round < samples[i].rounds; round++) {
            memcpy(mutant, text, size);
            write_file("model.inp", mutant, mutate(mutant, size, size + 1000, &random));
            d.text[0] = '\0';
            struct mesh *m = mesh_read(in_folder("model.inp"), &d);
            if (m)
                check_sound(m);
            else
                assert_true(strstr(d.text, "error: ") && !strchr(d.text, '\n'));
            m ? read++ : refused++;
            mesh_free(m);
        }
        free(mutant);
        free(text);
    }
    print_message("# %d mutants read, %d refused\n", read, refused);
    assert_true(read > 100 && refused > 100);
}

static int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static int remove_folder(void **state)
{
    static const char *const names[] = {"model.inp", "nodes.inp", "more.inp", "elements.inp", "part.inp", "word.inp"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        unlink(in_folder(names[i]));
    for (int i = 0; i <= 20; i++) {
        char name[32];
        snprintf(name, sizeof name, "level%d.inp", i);
        unlink(in_folder(name));
    }
    return rmdir(folder);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sample_models), cmocka_unit_test(big_models),     cmocka_unit_test(every_face),
        cmocka_unit_test(spellings),     cmocka_unit_test(included_files), cmocka_unit_test(sparse_numbers),
        cmocka_unit_test(diagnostics),   cmocka_unit_test(many_includes),  cmocka_unit_test(hostile_sizes),
        cmocka_unit_test(mutations),
    };
    return cmocka_run_group_tests_name("mesh", tests, make_folder, remove_folder);
}
