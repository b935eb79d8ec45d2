/* Where a scene's samples come from: a lattice, random shapes, or a mesh; see scene_parts.h. */
#include "scene_parts.h"

#include "mesh.h"
#include "samplers.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* Of segments with normals: how these are drawn. */
static bool read_normals(const struct scene_reader *r, const config_setting_t *g, struct lattice *l)
{
    long long sets;
    if (!key_count(r, config_setting_get_member(g, "normal_sets"), "normal_sets", 1, 1000, &sets) ||
        !key_number(r, config_setting_get_member(g, "tilt"), "tilt", 0, 1, &l->tilt))
        return false;
    l->normal_sets = (int)sets;
    return true;
}

static bool read_lattice(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind,
                         struct lattice *l)
{
    const bool normals = *kind->normals != '\0';
    const char *const required[] = {"xy", "z", "xi", "eta", normals ? "normal_sets" : NULL, "tilt", NULL};
    static const char *const optional[] = {"newton", NULL};
    const struct {
        const char *key;
        double *limit, *step;
    } grid[] = {{"xy", &l->xy_max, &l->xy_step}, {"z", &l->z_max, &l->z_step}};
    const struct {
        const char *key;
        double *range;
    } box[] = {{"xi", l->xi}, {"eta", l->eta}};
    if (!keys_check(r, g, "lattice", required, optional))
        return false;
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
    long long steps = 0;
    if (s && !key_count(r, s, "newton", 1, 1000, &steps))
        return false;
    l->newton = (int)steps;
    return !normals || read_normals(r, g, l);
}

/* Triangles have no taper and no warp of their own; curve and shift are of mid-side nodes.  Segments with normals come
 * from meshes of smooth bodies (smooth.h), and end at their edges. */
static bool read_shapes(const struct scene_reader *r, config_setting_t *g, const struct segment_kind *kind,
                        struct shapes *s)
{
    const bool middles = strlen(kind->nodes) > kind->corners, warps = !kind->triangle;
    const char *required[10] = {"aspect", "skew", "gap", "overhang"}, *const optional[] = {NULL};
    size_t n = 4;
    if (*kind->normals) {
        static const char *const gap[] = {"gap", NULL};
        return keys_check(r, g, "shapes", gap, optional) &&
               key_number(r, config_setting_get_member(g, "gap"), "gap", 0, 100, &s->gap);
    }
    if (warps) {
        required[n++] = "taper";
        required[n++] = "warp";
    }
    if (middles) {
        required[n++] = "curve";
        required[n++] = "shift";
    }
    return keys_check(r, g, "shapes", required, optional) &&
           key_number(r, config_setting_get_member(g, "aspect"), "aspect", 1, 1000, &s->aspect) &&
           key_angle(r, config_setting_get_member(g, "skew"), "skew", 85, &s->skew) &&
           (!warps || (key_number(r, config_setting_get_member(g, "taper"), "taper", 0, 0.95, &s->taper) &&
                       key_angle(r, config_setting_get_member(g, "warp"), "warp", 90, &s->warp))) &&
           (!middles || (key_number(r, config_setting_get_member(g, "curve"), "curve", 0, 0.2, &s->curve) &&
                         key_number(r, config_setting_get_member(g, "shift"), "shift", 0, 0.2, &s->shift))) &&
           key_number(r, config_setting_get_member(g, "gap"), "gap", 0, 100, &s->gap) &&
           key_number(r, config_setting_get_member(g, "overhang"), "overhang", 0, 1, &s->overhang);
}

static void append(char **data, size_t *size, const void *more, size_t n)
{
    char *all = new_array(*size + n, 1);
    if (*size)
        memcpy(all, *data, *size);
    if (n)
        memcpy(all + *size, more, n);
    free(*data);
    *data = all;
    *size += n;
}

static void append_faces(char **data, size_t *size, const struct mesh_face *face, size_t faces)
{
    int *node = new_array(faces * (sizeof face->node / sizeof *face->node), sizeof *node);
    size_t n = 0;
    for (size_t i = 0; i < faces; i++)
        for (int k = 0; k < face[i].nodes; k++)
            node[n++] = face[i].node[k];
    append(data, size, node, n * sizeof *node);
    free(node);
}

/* What the mesh contributes to the scene's digest: its nodes and contact pairs, whatever files they stand in. */
static void append_mesh(char **data, size_t *size, const struct mesh *m)
{
    append(data, size, m->xyz, m->nodes * sizeof *m->xyz);
    for (size_t i = 0; i < m->pairs; i++) {
        append(data, size, m->pair[i].slave, m->pair[i].slaves * sizeof *m->pair[i].slave);
        append_faces(data, size, m->pair[i].master, m->pair[i].masters);
    }
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
bool scene_read_mesh(const struct scene_reader *r, config_setting_t *g, struct scene *scene, char **data, size_t *size)
{
    static const char *const required[] = {"file", "distance", NULL}, *const optional[] = {NULL};
    struct mesh_pairs *m = &scene->mesh;
    const config_setting_t *s;
    const char *slash = strrchr(r->path, '/');
    char path[1024], *file = NULL;
    if (scene->segment && *scene->segment->normals)
        return key_fail(r, g, "segments '%s' come from 'lattice' or 'shapes', not from a mesh file",
                        scene->segment->name);
    if (!keys_check(r, g, "mesh", required, optional) ||
        !key_number(r, config_setting_get_member(g, "distance"), "distance", 1e-300, 1e300, &m->distance))
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
    append_mesh(data, size, read);
    const bool chosen = choose_segment(r, g, read, scene);
    mesh_free(read);
    return chosen;
}

config_setting_t *scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene)
{
    static const char *const source[] = {"lattice", "shapes", "mesh"};
    config_setting_t *found = NULL;
    for (int i = 0; i < 3; i++) {
        config_setting_t *s = config_setting_get_member(root, source[i]);
        if (s && found) {
            key_fail(r, s, "both '%s' and '%s'; a scene has one of lattice, shapes and mesh",
                     config_setting_name(found), source[i]);
            return NULL;
        }
        if (s && !config_setting_is_group(s)) {
            key_fail(r, s, "'%s' must be a group, { ... }", source[i]);
            return NULL;
        }
        if (s) {
            found = s;
            scene->source = (enum scene_source)i;
        }
    }
    if (!found)
        diag_at(r->d, r->path, 0, 0, "none of lattice, shapes and mesh; a scene has one of them");
    return found;
}

bool scene_read_source(const struct scene_reader *r, config_setting_t *group, struct scene *scene)
{
    if (scene->source == SOURCE_RANDOM)
        return read_shapes(r, group, scene->segment, &scene->shapes);
    if (scene->segment->surface && !*scene->segment->normals)
        return key_fail(r, group, "a 'lattice' is of segments quad4, gregory and bezier");
    return read_lattice(r, group, scene->segment, &scene->lattice);
}
