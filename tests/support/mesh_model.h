/* Helpers of the tests of the mesh reader: a folder for written models, and properties of every mesh that is read. */
#ifndef FOOTPOINT_MESH_MODEL_H
#define FOOTPOINT_MESH_MODEL_H

#include "../../evolve/input/mesh.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char folder[] = "/tmp/footpoint-mesh-XXXXXX";

static inline const char *in_folder(const char *name)
{
    static char path[sizeof folder + 64];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

static inline void write_file(const char *name, const char *text, size_t size)
{
    FILE *f = fopen(in_folder(name), "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(text, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

static inline struct mesh *read_model(const char *path)
{
    struct diag d = {0};
    struct mesh *m = mesh_read(path, &d);
    if (!m)
        fail_msg("%s", d.text);
    return m;
}

static inline struct mesh *read_written(const char *text)
{
    write_file("model.inp", text, strlen(text));
    return read_model(in_folder("model.inp"));
}

/* Checks a mesh: indices in range, slaves ascending and unique, faces of a known size, coordinates finite. */
static inline void check_sound(const struct mesh *m)
{
    assert_true(m->pairs > 0);
    for (size_t i = 0; i < m->nodes; i++) {
        assert_true(i == 0 || m->label[i - 1] < m->label[i]);
        assert_true(isfinite(m->xyz[i][0]) && isfinite(m->xyz[i][1]) && isfinite(m->xyz[i][2]));
    }
    for (size_t i = 0; i < m->pairs; i++) {
        const struct mesh_pair *p = &m->pair[i];
        assert_true(p->slaves > 0 && p->masters > 0);
        for (size_t k = 0; k < p->slaves; k++) {
            assert_true(p->slave[k] >= 0 && (size_t)p->slave[k] < m->nodes);
            assert_true(k == 0 || p->slave[k - 1] < p->slave[k]);
        }
        for (size_t k = 0; k < p->masters; k++) {
            const int n = p->master[k].nodes;
            assert_true(n == 3 || n == 4 || n == 6 || n == 8 || n == 9);
            for (int j = 0; j < n; j++)
                assert_true(p->master[k].node[j] >= 0 && (size_t)p->master[k].node[j] < m->nodes);
        }
    }
}

static inline int make_folder(void **state)
{
    (void)state;
    return mkdtemp(folder) ? 0 : -1;
}

static inline int remove_folder(void **state)
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

#endif
