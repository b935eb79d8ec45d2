/* Where a scene's samples come from: a lattice, random shapes, or a mesh; see scene_parts.h. */
#include "scene_parts.h"

#include "mesh.h"

#include <gsl/gsl_math.h>
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Of segments with normals: how these are drawn. */
static bool read_normals(const struct scene_reader *r, const config_setting_t *g, struct lattice *l)
{
    long long sets;
    if (!key_count(r, config_setting_get_member(g, "normal_sets"), "normal_sets", 1, 1000, &sets) ||
        !key_number(r, config_setting_get_member(g, "tilt"), "tilt", 0, 1, NULL, &l->tilt))
        return false;
    l->normal_sets = (int)sets;
    return true;
}

static bool check_lattice(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind)
{
    static const struct scene_key grid[] = {
        {"xy", "[1.0, 0.25]"}, {"z", "[0.3, 0.1]"}, {"xi", "[-1.0, 0.0]"}, {"eta", "[-1.0, 0.0]"}, {NULL, NULL}};
    static const struct scene_key normals[] = {
        {"xy", "[1.0, 0.25]"}, {"z", "[0.3, 0.1]"}, {"xi", "[-1.0, 0.0]"}, {"eta", "[-1.0, 0.0]"},
        {"normal_sets", "10"}, {"tilt", "0.3"},     {NULL, NULL}};
    static const char *const optional[] = {"newton", "random", NULL};
    if (!kind->bilinear && !*kind->normals)
        return key_fail(r, g, "a 'lattice' is of segments quad4, gregory and bezier");
    return keys_check(r, g, "lattice", *kind->normals ? normals : grid, optional);
}

static bool read_lattice(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind,
                         struct lattice *l)
{
    const struct {
        const char *key;
        double *limit, *step;
    } grid[] = {{"xy", &l->xy_max, &l->xy_step}, {"z", &l->z_max, &l->z_step}};
    const struct {
        const char *key;
        double *range;
    } box[] = {{"xi", l->xi}, {"eta", l->eta}};
    for (int i = 0; i < 2; i++) {
        const config_setting_t *s = config_setting_get_member(g, grid[i].key);
        double pair[2];
        if (!key_two(r, s, grid[i].key, 0, 100, pair))
            return false;
        if (pair[1] < 1e-3)
            return key_fail(r, s, "'%s' is [largest, step]; the step must be at least 0.001", grid[i].key);
        *grid[i].limit = pair[0];
        *grid[i].step = pair[1];
    }
    for (int i = 0; i < 2; i++) {
        const config_setting_t *s = config_setting_get_member(g, box[i].key);
        if (!key_two(r, s, box[i].key, -10, 10, box[i].range))
            return false;
        if (!(box[i].range[0] < box[i].range[1]))
            return key_fail(r, s, "'%s' is [lower, upper]; the lower must be below the upper", box[i].key);
    }
    const config_setting_t *s = config_setting_get_member(g, "newton");
    const config_setting_t *besides = config_setting_get_member(g, "random");
    long long steps = 0, random = 0;
    if ((s && !key_count(r, s, "newton", 1, 1000, &steps)) ||
        (besides && !key_count(r, besides, "random", 1, 100000000, &random)))
        return false;
    l->newton = (int)steps;
    l->random = (size_t)random;
    return !*kind->normals || read_normals(r, g, l);
}

/* Limits of shapes: of numbers, or angles in degrees.  Beyond `strange` few meshes go. */
static const struct limit {
    const char *key, *usual;
    bool angle;
    double lo, hi, strange;
    size_t at; /* of its value in struct shapes */
} limits[] = {{"aspect", "5.0", false, 1, 1000, 100, offsetof(struct shapes, aspect)},
              {"skew", "\"45 deg\"", true, 0, 85, 75, offsetof(struct shapes, skew)},
              {"taper", "0.3", false, 0, 0.95, 0.8, offsetof(struct shapes, taper)},
              {"warp", "\"15 deg\"", true, 0, 90, 45, offsetof(struct shapes, warp)},
              {"curve", "0.05", false, 0, 0.2, 0.15, offsetof(struct shapes, curve)},
              {"shift", "0.03", false, 0, 0.2, 0.1, offsetof(struct shapes, shift)},
              {"gap", "0.2", false, 0, 100, 2, offsetof(struct shapes, gap)},
              {"overhang", "0.1", false, 0, 1, 0.5, offsetof(struct shapes, overhang)}};

enum { LIMITS = sizeof limits / sizeof *limits };

/* Triangles have no taper and no warp of their own; curve and shift are of mid-side nodes.  Segments with normals come
 * from meshes of smooth bodies (body_samples.h), and end at their edges. */
static bool has_limit(const struct segment_kind *kind, const char *key)
{
    const bool bends = strcmp(key, "taper") == 0 || strcmp(key, "warp") == 0;
    const bool curves = strcmp(key, "curve") == 0 || strcmp(key, "shift") == 0;
    if (*kind->normals)
        return strcmp(key, "gap") == 0;
    return !(bends && kind->triangle) && !(curves && strlen(kind->nodes) == kind->corners);
}

static bool check_shapes(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind)
{
    static const char *const optional[] = {NULL};
    struct scene_key required[LIMITS + 1] = {{NULL, NULL}};
    size_t n = 0;
    for (size_t i = 0; i < LIMITS; i++)
        if (has_limit(kind, limits[i].key))
            required[n++] = (struct scene_key){limits[i].key, limits[i].usual};
    return keys_check(r, g, "shapes", required, optional);
}

static bool read_shapes(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind,
                        struct shapes *shapes)
{
    const double degree = M_PI / 180;
    for (const struct limit *l = limits; l < limits + LIMITS; l++) {
        const config_setting_t *s = config_setting_get_member(g, l->key);
        double *value = (double *)((char *)shapes + l->at);
        if (!has_limit(kind, l->key))
            continue;
        if (!(l->angle ? key_angle(r, s, l->key, l->hi, l->usual, value)
                       : key_number(r, s, l->key, l->lo, l->hi, l->usual, value)))
            return false;
        if (*value > l->strange * (l->angle ? degree : 1))
            key_warn(r, s, "'%s' is %g%s; %s is usual", l->key, l->angle ? *value / degree : *value,
                     l->angle ? " deg" : "", l->usual);
    }
    return true;
}

static void add(SHA2_CTX *sum, const void *data, size_t bytes)
{
    if (bytes)
        SHA256Update(sum, data, bytes);
}

/* What the mesh contributes to the scene's digest: its nodes, contact pairs and the elements that join slave nodes to
 * masters, whatever files they stand in. */
static void add_mesh(SHA2_CTX *sum, const struct mesh *m)
{
    add(sum, m->xyz, m->nodes * sizeof *m->xyz);
    for (size_t i = 0; i < m->pairs; i++) {
        const struct mesh_pair *p = &m->pair[i];
        add(sum, p->slave, p->slaves * sizeof *p->slave);
        for (size_t k = 0; k < p->masters; k++)
            add(sum, p->master[k].node, (size_t)p->master[k].nodes * sizeof *p->master[k].node);
    }
    for (size_t i = 0; i < m->elements; i++)
        add(sum, m->element[i].node, (size_t)m->element[i].nodes * sizeof *m->element[i].node);
}

/* The scene's kind of segment is the one that it names, or what all master faces are. */
static bool choose_segment(const struct scene_reader *r, const config_setting_t *group, struct mesh *m,
                           struct scene *scene)
{
    char faces[200];
    const struct segment_kind *kind = mesh_segment(m, faces, sizeof faces);
    if (scene->segment)
        return mesh_keep_faces(m, scene->segment) > 0 ||
               key_fail(r, group, "no master face is of segment '%s'; there are %s", scene->segment->name, faces);
    scene->segment = kind;
    return kind ||
           key_fail(r, group, "master faces of several kinds: %s; choose one of them, segment = \"...\";", faces);
}

/* The mesh file's path is relative to the scene's folder. */
bool scene_read_mesh(const struct scene_reader *r, config_setting_t *g, struct scene *scene)
{
    struct mesh_pairs *m = &scene->mesh;
    const config_setting_t *s;
    const char *slash = strrchr(r->path, '/');
    char path[1024], *file = NULL;
    if (scene->segment && *scene->segment->normals)
        return key_fail(r, g, "segments '%s' come from 'lattice' or 'shapes', not from a mesh file",
                        scene->segment->name);
    if (!key_number(r, config_setting_get_member(g, "distance"), "distance", 1e-300, 1e300, NULL, &m->distance))
        return false;
    s = config_setting_get_member(g, "file");
    if (!key_string(r, s, "file", &file))
        return false;
    if (file[0] == '/' || !slash)
        snprintf(path, sizeof path, "%s", file);
    else
        snprintf(path, sizeof path, "%.*s/%s", (int)(slash - r->path), r->path, file);
    free(file);
    m->file = new_text(path, strlen(path));
    if (access(path, R_OK) != 0)
        return key_fail(r, s, "cannot read mesh file '%s'", path);
    struct mesh *read = mesh_read(path, r->d);
    if (!read)
        return false;
    add_mesh(r->sum, read);
    m->read = read->file;
    m->reads = read->files;
    read->file = NULL;
    read->files = 0;
    const bool chosen = choose_segment(r, g, read, scene);
    mesh_free(read);
    return chosen;
}

bool scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **group)
{
    static const char *const source[] = {"lattice", "shapes", "mesh"};
    static const struct scene_key any = {"mesh", "mesh: { file = \"contact.inp\"; distance = 0.5; }, or 'shapes'"};
    for (int i = 0; i < 3; i++) {
        config_setting_t *s = config_setting_get_member(root, source[i]);
        if (!s)
            continue;
        if (*group)
            return key_fail(r, s, "both '%s' and '%s'; a scene has one of lattice, shapes and mesh",
                            config_setting_name(*group), source[i]);
        if (!config_setting_is_group(s))
            return key_fail(r, s, "'%s' must be a group, { ... }", source[i]);
        *group = s;
        scene->source = (enum scene_source)i;
    }
    if (!*group)
        keys_lack(r, root, "scene", &any);
    return true;
}

bool scene_check_source(const struct scene_reader *r, config_setting_t *group, const struct scene *scene)
{
    static const struct scene_key mesh[] = {{"file", "\"contact.inp\""}, {"distance", "0.5"}, {NULL, NULL}};
    static const char *const optional[] = {NULL};
    if (group && scene->source == SOURCE_MESH)
        return keys_check(r, group, "mesh", mesh, optional);
    if (!group || !scene->segment)
        return true;
    return scene->source == SOURCE_RANDOM ? check_shapes(r, group, scene->segment)
                                          : check_lattice(r, group, scene->segment);
}

bool scene_read_source(const struct scene_reader *r, config_setting_t *group, struct scene *scene)
{
    return scene->source == SOURCE_RANDOM ? read_shapes(r, group, scene->segment, &scene->shapes)
                                          : read_lattice(r, group, scene->segment, &scene->lattice);
}
