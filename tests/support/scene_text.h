/* Scenes for tests: shipped scenes, and texts that are written to a file and read. */
#ifndef FOOTPOINT_SCENE_TEXT_H
#define FOOTPOINT_SCENE_TEXT_H

#include "../../evolve/eval/frame.h"
#include "../../evolve/input/mesh.h"
#include "../../evolve/samples/default_tiers.h"
#include "../../evolve/samples/samples.h"
#include "../../evolve/surface/foot_bilinear.h"
#include <gsl/gsl_math.h>
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

static char path[] = "/tmp/footpoint-XXXXXX.scene";

static inline int make_path(void **state)
{
    const int f = mkstemps(path, 6);
    (void)state;
    return f < 0 ? -1 : close(f);
}

static inline int remove_path(void **state)
{
    (void)state;
    return unlink(path);
}

static inline struct scene *read_from_text(const char *text, struct diag *d)
{
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    assert_int_equal(fclose(f), 0);
    return scene_read("", path, d);
}

#define HEAD                                                                                                           \
    "segment = \"quad4\";\n"                                                                                           \
    "order = \"any\";\n"                                                                                               \
    "reference = [0.0, 0.0];\n"                                                                                        \
    "norm = \"p99\";\n"                                                                                                \
    "precision = \"double\";\n"                                                                                        \
    "seed = 5;\n"                                                                                                      \
    "training = 60;\n"                                                                                                 \
    "heldout = 40;\n"
#define SHAPES                                                                                                         \
    "shapes: { aspect = 5; skew = \"45 deg\"; taper = 0.3; warp = \"15 deg\"; gap = 0.2; overhang = 0.1; };\n"
#define LATTICE "lattice: { xy = [1.0, 0.25]; z = [0.3, 0.1]; xi = [-1.0, 0.0]; eta = [-1.0, 0.0]; };\n"
#define MESH "mesh: { file = \"MESH\"; distance = 0.5; };\n"
#define TAIL                                                                                                           \
    "frame = \"parallelogram\";\n"                                                                                     \
    "tiers = (\n"                                                                                                      \
    "    { name = \"fast\"; terminals = [\"p\", \"q\"]; max_length = 50; functions = \"rational\"; },\n"               \
    "    { name = \"slow\"; frame = \"other\"; terminals = [\"xS\"]; max_length = 100; functions = \"polynomial\"; "   \
    "}\n"                                                                                                              \
    ");\n"

static char *replaced(const char *text, const char *find, const char *put)
{
    const char *at = strstr(text, find);
    const size_t room = strlen(text) + strlen(put) + 1;
    char *out = new_array(room, 1);
    assert_non_null(at);
    snprintf(out, room, "%.*s%s%s", (int)(at - text), text, put, at + strlen(find));
    return out;
}

static inline struct scene *shipped(const char *name)
{
    struct diag d;
    struct scene *s = scene_read("", name, &d);
    if (!s)
        fail_msg("%s", d.text);
    return s;
}

#endif
