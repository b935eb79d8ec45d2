/* Fuzzes the reader of contact meshes: any bytes must give a sound mesh or a diagnostic of one line.  Built with clang
 * -fsanitize=fuzzer by tests/long/fuzz_mesh.sh.  The bytes are the file "0" of the current folder, so that they may include it. */
#include "../../evolve/input/mesh.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool good, const char *what)
{
    if (good)
        return;
    fprintf(stderr, "%s\n", what);
    abort();
}

static void check_face(const struct mesh *m, const struct mesh_face *f)
{
    require(f->edge ? f->nodes == 2 || f->nodes == 3 : segment_of_face((size_t)f->nodes) != NULL, "a face of no kind");
    for (int i = 0; i < f->nodes; i++)
        require(f->node[i] >= 0 && (size_t)f->node[i] < m->nodes, "a face without a node");
}

static void check_mesh(const struct mesh *m)
{
    require(m->pairs > 0, "no pair");
    for (size_t i = 0; i < m->nodes; i++)
        require(isfinite(m->xyz[i][0]) && isfinite(m->xyz[i][1]) && isfinite(m->xyz[i][2]), "a node nowhere");
    for (size_t i = 0; i < m->pairs; i++) {
        const struct mesh_pair *p = &m->pair[i];
        require(p->slaves > 0 && p->masters > 0, "an empty pair");
        for (size_t k = 0; k < p->slaves; k++)
            require(p->slave[k] >= 0 && (size_t)p->slave[k] < m->nodes, "a slave that is no node");
        for (size_t k = 0; k < p->masters; k++)
            check_face(m, &p->master[k]);
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct diag d = {0};
    FILE *const file = fopen("0", "wb");
    require(file && fwrite(data, 1, size, file) == size && fclose(file) == 0, "no file");
    struct mesh *m = mesh_read("0", &d);
    if (m)
        check_mesh(m);
    else
        require(strstr(d.text, "error: ") && !strchr(d.text, '\n'), "no diagnostic of one line");
    mesh_free(m);
    return 0;
}
