/* Contact meshes as users write them: parts and instances, surfaces without face labels, combined surfaces, named sets,
 * edges of shells; ties and general contact. The decks are in tests/meshes/decks. */
#include "../support/mesh_model.h"

enum { PAIRS = 2 };

static const struct {
    const char *name;
    size_t nodes, pairs, slaves[PAIRS], masters[PAIRS];
    const char *notes[2]; /* notes after the file's name, in order */
} decks[] = {
    {"exposed", 20, 1, {4}, {10}, {NULL}},
    {"combined", 20, 1, {4}, {2}, {NULL}},
    {"lent", 20, 1, {9}, {2}, {NULL}},
    {"missing",
     20,
     1,
     {2},
     {2},
     {":36: note: skipped 2 set entries without a defined element; the first is 4",
      ":38: note: skipped 1 set entry without a defined node; the first is 99"}},
    {"edges", 20, 1, {4}, {2}, {":28: note: surface 'M': edges of shells are skipped"}},
    {"tie", 20, 1, {4}, {2}, {NULL}},
    {"inclusions", 20, 2, {4, 6}, {2, 1}, {":35: note: contact of all exterior faces is skipped; name both surfaces"}},
    {"types", 20, 1, {4}, {6}, {NULL}},
    {"self", 20, 2, {6, 6}, {2, 2}, {NULL}},
    {"assembly", 25, 2, {11, 6}, {2, 2}, {NULL}},
    {"carriage", 20, 1, {4}, {2}, {NULL}},
    {"plane", 16, 2, {3, 5}, {2, 5}, {NULL}},
};

static struct mesh *read_deck(const char *name, char path[64])
{
    snprintf(path, 64, "tests/meshes/decks/%s.inp", name);
    return read_model(path);
}

static void decks_are_read(void **state)
{
    char path[64];
    (void)state;
    for (size_t i = 0; i < sizeof decks / sizeof *decks; i++) {
        struct mesh *m = read_deck(decks[i].name, path);
        assert_int_equal(m->nodes, decks[i].nodes);
        assert_int_equal(m->pairs, decks[i].pairs);
        for (size_t k = 0; k < m->pairs; k++) {
            assert_int_equal(m->pair[k].slaves, decks[i].slaves[k]);
            assert_int_equal(m->pair[k].masters, decks[i].masters[k]);
        }
        for (size_t k = 0; k < 2 && decks[i].notes[k]; k++) {
            char note[200];
            snprintf(note, sizeof note, "%s%s\n", path, decks[i].notes[k]);
            assert_non_null(m->notes);
            assert_non_null(strstr(m->notes, note));
        }
        assert_true(decks[i].notes[0] || !m->notes);
        mesh_free(m);
    }
}

static void check_node(const struct mesh *m, size_t at, int label, double x, double y, double z)
{
    assert_int_equal(m->label[at], label);
    assert_true(fabs(m->xyz[at][0] - x) + fabs(m->xyz[at][1] - y) + fabs(m->xyz[at][2] - z) < 1e-14);
}

/* The model's own node comes first, then the first instance's nodes as in the part, then moved and turned nodes. */
static void instances_are_placed(void **state)
{
    char path[64];
    (void)state;
    struct mesh *m = read_deck("assembly", path);
    check_node(m, 0, 1, 9, 9, 9);
    check_node(m, 1, 1, 0, 0, 0);
    check_node(m, 12, 16, 4, 1, 1);
    check_node(m, 13, 1, 4, -4, 1.5);
    check_node(m, 24, 16, 3, 0, 2.5);
    for (size_t k = 0; k < m->pair[1].masters; k++)
        for (int i = 0; i < 4; i++)
            assert_true(m->pair[1].master[k].node[i] >= 7 && m->pair[1].master[k].node[i] <= 12);
    for (size_t k = 0; k < m->pair[1].slaves; k++)
        assert_true(m->pair[1].slave[k] >= 13 && m->pair[1].slave[k] < 19);
    mesh_free(m);
}

/* Edges of plane elements have their bodies to the left and middle nodes last. */
static void plane_elements_have_edges(void **state)
{
    char path[64], faces[100];
    (void)state;
    struct mesh *m = read_deck("plane", path);
    const struct mesh_face *const top = m->pair[0].master;
    const int quadratic[2][3] = {{3, 4, 7}, {9, 3, 11}};
    for (int k = 0; k < 2; k++) {
        assert_true(top[k].edge && top[k].nodes == 3);
        for (int i = 0; i < 3; i++)
            assert_int_equal(m->label[top[k].node[i]], quadratic[k][i]);
    }
    for (size_t k = 0; k < m->pair[1].masters; k++) {
        const struct mesh_face *const f = &m->pair[1].master[k];
        const double *const a = m->xyz[f->node[0]], *const b = m->xyz[f->node[1]];
        assert_true(f->edge && f->nodes == 2);
        assert_true((b[0] - a[0]) * (3.4 - a[1]) - (b[1] - a[1]) * (0.9 - a[0]) > 0);
    }
    assert_null(mesh_segment(m, faces, sizeof faces));
    assert_string_equal(faces, "5 of edge2, 2 of edge3");
    assert_true(mesh_is_plane(m) && mesh_shortest_edge(m) == 1);
    mesh_free(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(decks_are_read),
        cmocka_unit_test(instances_are_placed),
        cmocka_unit_test(plane_elements_have_edges),
    };
    return cmocka_run_group_tests_name("mesh decks", tests, make_folder, remove_folder);
}
