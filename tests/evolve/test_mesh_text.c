/* The text of contact meshes: spellings of the format, included files, and mutated files, which must end in a valid
 * mesh or in a diagnostic. */
#include "../support/mesh_model.h"

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

/* Included files lie beside the including file, nest, interrupt data, and follow INPUT= of a keyword. */
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

/* Numbers may be far apart and in descending order. */
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

/* ---- mutations ---- */

static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15u;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/* Applies one to four changes: a byte, a bit, a span removed, doubled or moved, a word inserted, the end cut off. */
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

/* Parts of the model that no master face needs may be of any kind: elements of any type, with any number of nodes on
 * any number of lines; unread surfaces and sets; faces and nodes under one name, in several pieces. */
static const char around[] = "*NODE\n"
                             "1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 1, 1\n6, 1, 1, 2\n"
                             "*ELEMENT, TYPE=B32R, ELSET=BEAM\n"
                             "10, 4, 5,\n"
                             "6\n"
                             "*ELEMENT, TYPE=MASS, ELSET=POINT\n"
                             "11, 6\n"
                             "*ELEMENT, TYPE=CONN3D2\n"
                             "12, , 4\n"
                             "13, 2, frame-1.3,\n"
                             "*ELEMENT, TYPE=CAXA8\n"
                             "21, 1, 2, 3, 4, 5, 6, 1001, 1002\n"
                             "22, 1, 2, 3, 4,\n"
                             "5, 6, 1, 2,\n"
                             "*NODAL THICKNESS\n"
                             "1, 0.1\n"
                             "*USER ELEMENT, TYPE=U1, NODES=2\n"
                             "*ELEMENT, TYPE=u1\n"
                             "31, 1, 2\n"
                             "*ELEMENT, TYPE=S3\n"
                             "1, 1, 2, 3\n"
                             "2, 1, 2, 4\n"
                             "*NSET, NSET=MADE, ELSET=BEAM\n"
                             "*SURFACE, NAME=DRUM, TYPE=REVOLUTION\n"
                             "START, 1., 2.\n"
                             "*SURFACE, NAME=BOTH, COMBINE=UNION\n"
                             "A, B\n"
                             "*SURFACE, NAME=ONE\n"
                             "1, SPOS\n"
                             "*SURFACE, NAME=one, TYPE=NODE\n"
                             "4\n"
                             "*SURFACE, NAME=ONE\n"
                             "2, SNEG\n"
                             "*SURFACE, NAME=ONE, TYPE=NODE\n"
                             "6\n"
                             "*SURFACE, NAME=THIN\n"
                             "BEAM, S2\n"
                             "2\n"
                             "*CONTACT PAIR\n"
                             "ONE, ONE\n"
                             "THIN, ONE\n";

static void irrelevant_input_is_skipped(void **state)
{
    static const int slaves[2][6] = {{4, 6}, {1, 2, 4, 5, 6}};
    (void)state;
    struct mesh *m = read_written(around);
    check_sound(m);
    assert_int_equal(m->pairs, 2);
    for (size_t i = 0; i < 2; i++) {
        assert_int_equal(m->pair[i].masters, 2);
        assert_int_equal(m->pair[i].slaves, i ? 5 : 2);
        for (size_t k = 0; k < m->pair[i].slaves; k++)
            assert_int_equal(m->label[m->pair[i].slave[k]], slaves[i][k]);
    }
    mesh_free(m);
}

/* The master faces determine the kind of segment; of several kinds, one may be kept. */
static void kinds_of_faces(void **state)
{
    static const char solids[] = "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n5, 1, 0, 1\n6, 0, 1, 1\n"
                                 "*ELEMENT, TYPE=C3D6\n1, 1, 2, 3, 4, 5, 6\n*SURFACE, NAME=M\n1, S1\n1, S3\n1, S4\n"
                                 "*SURFACE, NAME=S, TYPE=NODE\n4\n*CONTACT PAIR\nS, M\n";
    char text[64];
    (void)state;
    struct mesh *m = read_written(solids);
    assert_null(mesh_segment(m, text, sizeof text));
    assert_string_equal(text, "1 of tri3, 2 of quad4");
    assert_int_equal(mesh_keep_faces(m, segment_find("quad8")), 0);
    mesh_free(m);
    m = read_written(solids);
    assert_int_equal(mesh_keep_faces(m, segment_find("quad4")), 2);
    check_sound(m);
    assert_ptr_equal(mesh_segment(m, text, sizeof text), segment_find("quad4"));
    assert_string_equal(text, "2 of quad4");
    mesh_free(m);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(spellings),      cmocka_unit_test(included_files),
        cmocka_unit_test(sparse_numbers), cmocka_unit_test(irrelevant_input_is_skipped),
        cmocka_unit_test(kinds_of_faces), cmocka_unit_test(mutations),
    };
    return cmocka_run_group_tests_name("mesh text", tests, make_folder, remove_folder);
}
