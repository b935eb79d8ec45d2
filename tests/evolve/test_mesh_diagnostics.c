/* Refused contact meshes: one case for each diagnostic, and hostile sizes. */
#include "../support/mesh_model.h"

#define NODES "*NODE, NSET=N\n1, 0, 0, 0\n2, 1, 0, 0\n3, 0, 1, 0\n4, 0, 0, 1\n"
#define MODEL NODES "*ELEMENT, TYPE=C3D4, ELSET=E\n1, 1, 2, 3, 4\n*SURFACE, NAME=M\nE, S1\n"
#define SLAVE "*SURFACE, NAME=S, TYPE=NODE\nN\n"
#define PAIR "*CONTACT PAIR\nS, M\n"
#define KNOWN " without known faces; it must be a solid, shell or membrane"
#define NO_PAIR                                                                                                        \
    "model.inp: error: no contact pair; a model must contain *CONTACT PAIR, *CONTACT INCLUSIONS of named surfaces, "   \
    "or *TIE"
#define PART "*PART, NAME=P\n" NODES "*END PART\n"

static const struct {
    const char *text, *expected; /* expected: the diagnostic after the folder's name */
} bad_models[] = {
    {"", NO_PAIR},
    {MODEL SLAVE, NO_PAIR},
    {"hello, world\n", NO_PAIR},
    {MODEL SLAVE "*CONTACT INCLUSIONS, ALL EXTERIOR\n", NO_PAIR},
    {MODEL SLAVE "*TIE, NAME=T, CYCLIC SYMMETRY\nS, M\n", NO_PAIR},

    {"*NODE\n1, 0, 0, zero\n", "model.inp:2: error: 'zero' must be a number"},
    {"*NODE\n1, 0x10, 0, 0\n", "model.inp:2: error: '0x10' must be a number"},
    {"*NODE\n1, 1 2, 0, 0\n", "model.inp:2: error: '1 2' must be a number"},
    {"*NODE\n1, 1e, 0, 0\n", "model.inp:2: error: '1e' must be a number"},
    {"*NODE\n1, 0.00000000000000000000000000000000000000000000000000000000000000000001, 0, 0\n",
     "model.inp:2: error: '0.00000000000000000000000000000000000000...' must be a number"},
    {"*NODE\n1, 0, inf, 0\n", "model.inp:2: error: coordinate 'inf' of node 1 must be finite"},
    {"*NODE\n1, 0, NaN, 0\n", "model.inp:2: error: coordinate 'NaN' of node 1 must be finite"},
    {"*NODE\n1, 0, 0, -1D999\n", "model.inp:2: error: coordinate '-1D999' of node 1 must be finite"},
    {"*NODE\none, 0, 0, 0\n", "model.inp:2: error: 'one' must be a whole number from 1 to 2147483647"},
    {"*NODE\n0, 0, 0, 0\n", "model.inp:2: error: '0' must be a whole number from 1 to 2147483647"},
    {"*NODE\n-7, 0, 0, 0\n", "model.inp:2: error: '-7' must be a whole number from 1 to 2147483647"},
    {"*NODE\n1.5, 0, 0, 0\n", "model.inp:2: error: '1.5' must be a whole number from 1 to 2147483647"},
    {"*NODE\n2147483648, 0, 0, 0\n", "model.inp:2: error: '2147483648' must be a whole number from 1 to 2147483647"},
    {"*NODE\n, 0, 0, 0\n", "model.inp:2: error: '' must be a whole number from 1 to 2147483647"},
    {"*NODE\n1, 0, 0, 0\n2, 0, 0, 0\n2, 1, 0, 0\n1, 1, 0, 0\n*NODE\n", "model.inp:4: error: node 2 is defined twice"},
    {"*NODE, SYSTEM=C\n1, 0, 0, 0\n",
     "model.inp:1: error: *NODE, SYSTEM=C is not supported; coordinates must be rectangular"},
    {"*NODE, NSET=\n1, 0, 0, 0\n", "model.inp:1: error: name expected"},

    {NODES "*ELEMENT\n1, 1, 2, 3, 4\n", "model.inp:6: error: *ELEMENT needs TYPE="},
    {NODES "*ELEMENT, TYPE=\n1, 1, 2\n", "model.inp:6: error: *ELEMENT needs TYPE="},
    {NODES "*ELEMENT, TYPE=CAX8\none, 1, 2\n", "model.inp:7: error: 'one' must be a whole number from 1 to 2147483647"},
    {NODES SLAVE "*ELEMENT, TYPE=C3D80\n1, 1, 2\n*SURFACE, NAME=M\n1, S1\n" PAIR,
     "model.inp:11: error: element 1 of a master surface has type C3D80" KNOWN},
    {MODEL SLAVE "*ELEMENT, TYPE=CAXA8R, ELSET=P\n7, 1, 2,\n3, 4, 1, 2, 3, 4\n*SURFACE, NAME=B\n1, S1\nP, S2\n"
                 "*CONTACT PAIR\nS, B\n",
     "model.inp:17: error: element 7 of a master surface has type CAXA8R" KNOWN},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3\n2, 1, 2, 3, 4\n",
     "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2,\n3,\n*NSET, NSET=X\n",
     "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, ", "model.inp:7: error: element 1 has 3 nodes, but type C3D4 has 4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 4, 5\n",
     "model.inp:7: error: element 1 has more than the 4 nodes of type C3D4"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2,\n3, x\n",
     "model.inp:8: error: 'x' must be a whole number from 1 to 2147483647"},
    {NODES "*ELEMENT, TYPE=C3D4\n1, 1, 2, 3, 40\n", "model.inp:7: error: node 40 of element 1 is not defined"},
    {NODES "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n1, 1, 3, 4\n", "model.inp:8: error: element 1 is defined twice"},

    {"*NSET, GENERATE\n1, 2\n", "model.inp:1: error: *NSET needs NSET="},
    {"*ELSET, NSET=A\n1, 2\n", "model.inp:1: error: *ELSET needs ELSET="},
    {MODEL "*NSET, NSET=A, ELSET=N\n*SURFACE, NAME=S, TYPE=NODE\nA\n" PAIR,
     "model.inp:12: error: element set 'N' is not defined"},
    {"*NSET, NSET=A, INSTANCE=I\n", "model.inp:1: error: instance 'I' is not defined"},
    {"*NSET, NSET=A, GENERATE\n1\n", "model.inp:2: error: GENERATE needs a first and a last number"},
    {"*NSET, NSET=A, GENERATE\n1, 2, 0\n", "model.inp:2: error: '0' must be a whole number from 1 to 2147483647"},
    {"*NSET, NSET=A, GENERATE\n1, 2, 1, 1\n", "model.inp:2: error: GENERATE takes first, last and step; '1' is extra"},
    {"*NSET, NSET=A, GENERATE\n9, 2\n",
     "model.inp:2: error: GENERATE runs from 9 down to 2; the first number must not exceed the last"},
    {"*NSET, NSET=A\n1, 99999999999\n",
     "model.inp:2: error: '99999999999' must be a whole number from 1 to 2147483647"},

    {"*SURFACE\nE, S1\n", "model.inp:1: error: *SURFACE needs NAME="},
    {MODEL SLAVE "*SURFACE, NAME=B, TYPE=CYLINDER\nSTART, 0, 0\n*CONTACT PAIR\nS, B\n",
     "model.inp:12: error: surface type must be ELEMENT or NODE"},
    {MODEL SLAVE "*SURFACE, NAME=B, TYPE=CUTTING SURFACE, COMBINE=UNION\n*CONTACT PAIR\nS, B\n",
     "model.inp:12: error: surface type must be ELEMENT or NODE"},
    {"*SURFACE, NAME=B, COMBINE=XOR\n", "model.inp:1: error: COMBINE=XOR must be UNION, INTERSECTION or DIFFERENCE"},
    {MODEL SLAVE "*SURFACE, NAME=B, COMBINE=UNION\nM, C\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: surface 'C' is not defined"},
    {MODEL SLAVE "*SURFACE, NAME=B, COMBINE=UNION\nM, S\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: surface 'S' is made of nodes; it must be made of element faces"},
    {MODEL SLAVE "*SURFACE, NAME=B, COMBINE=UNION\nM, C\n*SURFACE, NAME=C, COMBINE=UNION\nM, B\n*CONTACT PAIR\nS, "
                 "B\n",
     "model.inp:15: error: surface 'B' must not be combined of itself"},
    {MODEL SLAVE "*SURFACE, NAME=M, COMBINE=UNION\nM, M\n",
     "model.inp:12: error: surface 'M' is defined both with COMBINE= and without"},
    {"*SURFACE, NAME=M\nE, S7\n", "model.inp:2: error: face label 'S7' must be S1 to S6, SPOS or SNEG"},
    {"*SURFACE, NAME=M\n, S1\n", "model.inp:2: error: name expected"},
    {MODEL SLAVE "*SURFACE, NAME=B\n1, S5\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element 1 of type C3D4 has no face S5"},
    {MODEL SLAVE "*SURFACE, NAME=B\n1, SPOS\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element 1 of type C3D4 has no face SPOS"},
    {NODES SLAVE "*ELEMENT, TYPE=S3\n1, 1, 2, 3\n*SURFACE, NAME=M\n1, S3\n" PAIR,
     "model.inp:10: error: surface 'M' is empty"},
    {MODEL SLAVE "*SURFACE, NAME=B\n2, S1\n*CONTACT PAIR\nS, B\n", "model.inp:13: error: element 2 is not defined"},
    {MODEL SLAVE "*SURFACE, NAME=B\nN, S1\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element set 'N' is not defined"},
    {MODEL SLAVE "*ELSET, ELSET=C\nE, D\n*SURFACE, NAME=B\nC, S1\n*CONTACT PAIR\nS, B\n",
     "model.inp:13: error: element set 'D' is not defined"},
    {MODEL SLAVE "*SURFACE, NAME=B\n*CONTACT PAIR\nS, B\n", "model.inp:12: error: surface 'B' is empty"},
    {MODEL "*SURFACE, NAME=S, TYPE=NODE\nE\n" PAIR, "model.inp:11: error: node set 'E' is not defined"},
    {MODEL "*SURFACE, NAME=S, TYPE=NODE\n1\n17\n" PAIR, "model.inp:12: error: node 17 is not defined"},
    {MODEL "*NSET, NSET=A, GENERATE\n10, 20\n*SURFACE, NAME=S, TYPE=NODE\nA\n" PAIR,
     "model.inp:12: error: surface 'S' is empty"},
    {MODEL "*NSET, NSET=A\nA\n*SURFACE, NAME=S, TYPE=NODE\nA\n" PAIR, "model.inp:12: error: surface 'S' is empty"},

    {MODEL SLAVE "*CONTACT PAIR\n", "model.inp:12: error: *CONTACT PAIR names no surfaces"},
    {MODEL SLAVE "*CONTACT PAIR\n*STEP\n", "model.inp:12: error: *CONTACT PAIR names no surfaces"},
    {MODEL SLAVE "*CONTACT PAIR\nS\n",
     "model.inp:13: error: master surface 'S' is made of nodes; it must be made of element faces"},
    {MODEL SLAVE "*CONTACT PAIR\n, M\n",
     "model.inp:13: error: contact pair needs a slave and a master surface, or one surface for self contact"},
    {MODEL SLAVE "*CONTACT PAIR\nT, M\n", "model.inp:13: error: surface 'T' is not defined"},
    {MODEL SLAVE "*CONTACT PAIR\nS, E\n", "model.inp:13: error: surface 'E' is not defined"},
    {MODEL SLAVE "*CONTACT PAIR\nM, S\n",
     "model.inp:13: error: master surface 'S' is made of nodes; it must be made of element faces"},

    {"*HEADING\n*INCLUDE\n", "model.inp:2: error: *INCLUDE needs INPUT="},
    {"*INCLUDE, INPUT=\n", "model.inp:1: error: included file has no name"},
    {"*INCLUDE, INPUT=missing.inp\n", "model.inp:1: error: cannot read included file 'missing.inp'"},
    {"*INCLUDE, INPUT=/\n", "model.inp:1: error: cannot read included file '/'"},
    {"*INCLUDE, INPUT=model.inp\n",
     "model.inp:1: error: file 'model.inp' must not include itself, directly or through others"},
    {"*HEADING\n*INCLUDE, INPUT=part.inp\n",
     "part.inp:2: error: file './model.inp' must not include itself, directly or through others"},
    {"*NODE\n1, 0, 0, 0\n*INCLUDE, INPUT=word.inp\n", "word.inp:1: error: 'word' must be a number"},

    {"*HEADING\n*PART, NAME=P\n*NODE\n1, x\n", "model.inp:2: error: *PART needs *END PART"},
    {"*PART\n", "model.inp:1: error: *PART needs NAME="},
    {"*END PART\n", "model.inp:1: error: *END PART without *PART"},
    {"*END INSTANCE\n", "model.inp:1: error: *END INSTANCE without *INSTANCE"},
    {"*instance, NAME=P\n", "model.inp:1: error: *INSTANCE needs NAME= and PART="},
    {"*instance, NAME=P, PART=P\n", "model.inp:1: error: part 'P' must be defined before its instance"},
    {PART PART, "model.inp:8: error: part 'P' is defined twice"},
    {PART "*INSTANCE, NAME=, PART=P\n", "model.inp:8: error: instance has no name"},
    {PART "*INSTANCE, NAME=I, PART=P\n1, 2\n", "model.inp:8: error: *INSTANCE needs *END INSTANCE"},
    {PART "*INSTANCE, NAME=I, PART=P\n*INSTANCE, NAME=J, PART=P\n",
     "model.inp:9: error: *INSTANCE must not be inside an instance"},
    {PART "*INSTANCE, NAME=I, PART=P\n*END INSTANCE\n*INSTANCE, NAME=I, PART=P\n",
     "model.inp:10: error: instance 'I' is defined twice"},
    {PART "*INSTANCE, NAME=I, PART=P\n0, 0, up\n", "model.inp:9: error: 'up' must be a number"},
    {PART "*INSTANCE, NAME=I, PART=P\n1e308\n0, 0, 0, 0, 0, 1, 45\n*NODE\n9, 1e308\n*END INSTANCE\n",
     "model.inp:12: error: node 9 of instance 'I' is not finite after placement"},
    {"*PART, NAME=P\n*INSTANCE, NAME=I, PART=P\n*END PART\n*INSTANCE, NAME=I, PART=P\n",
     "model.inp:2: error: *INSTANCE must not be inside an instance"},
    {"*NGEN\n1, 9\n",
     "model.inp:1: error: *NGEN is not supported: it makes or moves nodes; list them in global coordinates"},
    {"*SYSTEM\n1, 2, 3\n",
     "model.inp:1: error: *SYSTEM is not supported: it makes or moves nodes; list them in global coordinates"},
    {"*NODE\n\001\377\n", "model.inp:2: error: '?\?' must be a whole number from 1 to 2147483647"},
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
    check_refused(in_folder("model.inp"), "model.inp:3: error: not a text file: it contains a NUL byte");

    struct diag d = {0};
    assert_null(mesh_read("tests/meshes/none.inp", &d));
    assert_string_equal(d.text, "tests/meshes/none.inp: error: cannot open: No such file or directory");
    assert_int_equal(d.code, EXIT_SYSTEM);
    mesh_free(NULL);
}

/* Files whose two lines include the next file double at each level. */
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
    check_refused(in_folder("level0.inp"), "level19.inp:2: error: at most 10000 files may be included");
}

/* Hostile sizes: a very long line, very many fields, thousands of nested and tangled sets. */
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
    check_refused(in_folder("model.inp"), "model.inp:2: error: 'xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx...' must be a "
                                          "whole number from 1 to 2147483647");
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(diagnostics),
        cmocka_unit_test(many_includes),
        cmocka_unit_test(hostile_sizes),
    };
    return cmocka_run_group_tests_name("mesh diagnostics", tests, make_folder, remove_folder);
}
