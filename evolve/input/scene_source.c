/* Reads the source of a scene's samples: a lattice, random shapes, or a mesh; see scene_parts.h. */
#include "scene_parts.h"

#include "../../codegen/base/text.h"
#include "mesh.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static void add(SHA2_CTX *sum, const void *data, size_t bytes)
{
    if (bytes)
        SHA256Update(sum, data, bytes);
}

/* Adds the mesh to the scene's digest: nodes, contact pairs and the elements that join slave nodes to master faces,
 * whichever files contain them. */
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

/* Sets the scene's kind of segment: the kind that it names, or the kind of all master faces. */
static bool choose_segment(const struct scene_reader *r, const config_setting_t *group, struct mesh *m,
                           struct scene *scene)
{
    char faces[200];
    const struct segment_kind *kind = mesh_segment(m, faces, sizeof faces);
    if (scene->segment)
        return mesh_keep_faces(m, scene->segment) > 0 ||
               key_fail(r, group, "no master face has segment '%s'; there are %s", scene->segment->name, faces);
    scene->segment = kind;
    if (!kind && mesh_is_plane(m))
        return key_fail(r, group,
                        "master faces are edges of plane elements, %s; their headers need no scene: "
                        "footpoint-codegen --edge",
                        faces);
    return kind ||
           key_fail(r, group, "master faces are of several kinds: %s; choose one with segment = \"...\";", faces);
}

/* Returns a path relative to the scene's folder; the caller frees it. */
static char *beside_scene(const struct scene_reader *r, const char *file)
{
    const char *slash = strrchr(r->path, '/');
    if (file[0] == '/' || !slash)
        return new_text(file, strlen(file));
    return new_format("%.*s/%s", (int)(slash - r->path), r->path, file);
}

/* Sets the largest gap: the scene's, or a fraction of the shortest edge of the mesh. */
static bool choose_distance(const struct scene_reader *r, const config_setting_t *g, const struct mesh *m,
                            struct mesh_pairs *pairs)
{
    static const double usual = 0.2, most = 0.5;
    const double edge = mesh_shortest_edge(m);
    if (pairs->distance == 0)
        pairs->distance = usual * edge;
    else if (pairs->distance > most * edge)
        key_warn(r, config_setting_get_member(g, "distance"),
                 "'distance' of %g is more than %g times the shortest master edge, %.3g; it is the penetration plus "
                 "the motion of a step, and functions for larger gaps are less accurate in contact",
                 pairs->distance, most, edge);
    return pairs->distance < INFINITY || key_fail(r, g, "all master faces have edges of length 0");
}

static bool read_mesh(const struct scene_reader *r, config_setting_t *g, struct scene *scene)
{
    struct mesh_pairs *m = &scene->mesh;
    if (scene->segment && *scene->segment->normals)
        return key_fail(r, g, "segment '%s' needs 'lattice' or 'shapes'; a mesh file has no such faces",
                        scene->segment->name);
    if (!keys_read(r, g, &mesh_group, NULL, m))
        return false;
    char *path = beside_scene(r, m->file);
    free(m->file);
    m->file = path;
    if (access(path, R_OK) != 0)
        return key_fail(r, config_setting_get_member(g, "file"), "cannot read mesh file '%s'", path);
    struct mesh *read = mesh_read(path, r->d);
    if (!read)
        return false;
    add_mesh(r->sum, read);
    m->read = read->file;
    m->reads = read->files;
    if (read->notes) {
        char *all = new_format("%s%s", *r->warnings ? *r->warnings : "", read->notes);
        free(*r->warnings);
        *r->warnings = all;
    }
    read->file = NULL;
    read->files = 0;
    const bool chosen = choose_segment(r, g, read, scene) && choose_distance(r, g, read, m);
    mesh_free(read);
    return chosen;
}

static const struct scene_group *const source[] = {
    [SOURCE_LATTICE] = &lattice_group, [SOURCE_RANDOM] = &shapes_group, [SOURCE_MESH] = &mesh_group};

bool scene_find_source(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **setting)
{
    for (int i = 0; i < 3; i++) {
        config_setting_t *s = config_setting_get_member(root, source[i]->name);
        if (!s)
            continue;
        if (*setting)
            return key_fail(r, s,
                            "both '%s' and '%s' are given; a scene must have exactly one of lattice, shapes "
                            "and mesh",
                            config_setting_name(*setting), source[i]->name);
        if (!config_setting_is_group(s))
            return key_fail(r, s, "'%s' must be a group, { ... }", source[i]->name);
        *setting = s;
        scene->source = (enum scene_source)i;
    }
    if (!*setting)
        keys_lack(r, root, "scene", "mesh", "mesh: { file = \"contact.inp\"; distance = 0.5; }, or 'shapes'");
    return true;
}

bool scene_check_source(const struct scene_reader *r, config_setting_t *setting, const struct scene *scene)
{
    const struct scene_group *g = source[scene->source];
    const bool mesh = scene->source == SOURCE_MESH;
    if (!setting || (!mesh && !scene->segment))
        return true;
    if (scene->source == SOURCE_LATTICE && !key_suits(group_find(&scene_group, "lattice"), scene->segment))
        return key_fail(r, setting, "a 'lattice' must have segment quad4, gregory or bezier");
    return keys_check(r, setting, g->name, g, mesh ? NULL : scene->segment, NULL, NULL);
}

bool scene_read_source(const struct scene_reader *r, config_setting_t *setting, struct scene *scene)
{
    if (scene->source == SOURCE_MESH)
        return read_mesh(r, setting, scene);
    if (scene->source == SOURCE_RANDOM)
        return keys_read(r, setting, &shapes_group, scene->segment, &scene->shapes);
    return keys_read(r, setting, &lattice_group, scene->segment, &scene->lattice);
}
