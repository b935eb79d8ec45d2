/* Reads a scene: a libconfig text (scenes/, README.md for its meaning).  Every key, type, unit and range is checked,
 * and each complaint names its line. */
#include "mesh.h"
#include "samplers.h"

#include <errno.h>
#include <gsl/gsl_math.h>
#include <libconfig.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* What a complaint needs, and the first complaint. */
struct reader {
    const char *path;
    struct diag *d;
};

static bool fail(const struct reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

static bool fail(const struct reader *r, const config_setting_t *s, const char *format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    diag_at(r->d, r->path, (int)config_setting_source_line(s), 0, "%s", text);
    return false;
}

/* All keys of a group are among `known`, and those before the NULL-separated rest are there. */
static bool check_keys(const struct reader *r, config_setting_t *group, const char *what, const char *const *required,
                       const char *const *optional)
{
    for (int i = 0; i < config_setting_length(group); i++) {
        const config_setting_t *s = config_setting_get_elem(group, (unsigned)i);
        const char *key = config_setting_name(s);
        bool known = false;
        for (const char *const *k = required; *k; k++)
            known = known || strcmp(*k, key) == 0;
        for (const char *const *k = optional; *k; k++)
            known = known || strcmp(*k, key) == 0;
        if (!known)
            return fail(r, s, "unknown key '%s' in %s", key, what);
    }
    for (const char *const *k = required; *k; k++)
        if (!config_setting_get_member(group, *k))
            return fail(r, group, "%s lacks '%s'", what, *k);
    return true;
}

static bool read_number(const struct reader *r, const config_setting_t *s, const char *key, double lo, double hi,
                        double *value)
{
    switch (config_setting_type(s)) {
    case CONFIG_TYPE_INT:
    case CONFIG_TYPE_INT64:
        *value = (double)config_setting_get_int64(s);
        break;
    case CONFIG_TYPE_FLOAT:
        *value = config_setting_get_float(s);
        break;
    default:
        return fail(r, s, "'%s' must be a number", key);
    }
    if (!(*value >= lo && *value <= hi))
        return fail(r, s, "'%s' must be in %g..%g", key, lo, hi);
    return true;
}

static bool read_count(const struct reader *r, const config_setting_t *s, const char *key, long long lo, long long hi,
                       long long *value)
{
    const int type = config_setting_type(s);
    *value = config_setting_get_int64(s);
    if (type != CONFIG_TYPE_INT && type != CONFIG_TYPE_INT64)
        return fail(r, s, "'%s' must be a whole number", key);
    if (*value < lo || *value > hi)
        return fail(r, s, "'%s' must be in %lld..%lld", key, lo, hi);
    return true;
}

static bool read_two(const struct reader *r, const config_setting_t *s, const char *key, double lo, double hi,
                     double value[2])
{
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s) || config_setting_length(s) != 2)
        return fail(r, s, "'%s' must be two numbers, [a, b]", key);
    return read_number(r, config_setting_get_elem(s, 0), key, lo, hi, &value[0]) &&
           read_number(r, config_setting_get_elem(s, 1), key, lo, hi, &value[1]);
}

/* An angle with its unit, "45 deg" or "0.5 rad", in 0..limit degrees. */
static bool read_angle(const struct reader *r, const config_setting_t *s, const char *key, double limit,
                       double *radians)
{
    const char *text = config_setting_get_string(s);
    char *end;
    if (!text)
        return fail(r, s, "'%s' must be an angle with its unit, \"45 deg\" or \"0.8 rad\"", key);
    *radians = strtod(text, &end);
    if (end == text)
        return fail(r, s, "'%s' must be an angle with its unit, \"45 deg\" or \"0.8 rad\"", key);
    end += strspn(end, " ");
    if (*end == '\0')
        return fail(r, s, "'%s' lacks its unit, deg or rad", key);
    if (strcmp(end, "deg") == 0)
        *radians *= M_PI / 180;
    else if (strcmp(end, "rad") != 0)
        return fail(r, s, "'%s' has the unknown unit '%s'; deg or rad", key, end);
    if (!(*radians >= 0 && *radians <= limit * M_PI / 180 * (1 + GSL_DBL_EPSILON)))
        return fail(r, s, "'%s' must be in 0..%g deg", key, limit);
    return true;
}

static bool read_string(const struct reader *r, const config_setting_t *s, const char *key, char **text)
{
    const char *t = config_setting_get_string(s);
    if (!t || *t == '\0')
        return fail(r, s, "'%s' must be a text in quotes", key);
    *text = new_text(t, strlen(t));
    return true;
}

/* One of `n` words. */
static bool read_word(const struct reader *r, const config_setting_t *s, const char *key, const char *const *word,
                      int n, int *which)
{
    const char *t = config_setting_get_string(s);
    char list[200] = "";
    for (*which = 0; t && *which < n; ++*which)
        if (strcmp(t, word[*which]) == 0)
            return true;
    for (int i = 0; i < n; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s\"%s\"", i ? " or " : "", word[i]);
    return fail(r, s, "'%s' must be %s", key, list);
}

static bool is_identifier(const char *t)
{
    static const char letters[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_", digits[] = "0123456789";
    if (!strchr(letters, *t) || *t == '\0')
        return false;
    for (t++; *t; t++)
        if (!strchr(letters, *t) && !strchr(digits, *t))
            return false;
    return true;
}

/* Of segments with normals: how these are drawn. */
static bool read_normals(const struct reader *r, const config_setting_t *g, struct lattice *l)
{
    long long sets;
    if (!read_count(r, config_setting_get_member(g, "normal_sets"), "normal_sets", 1, 1000, &sets) ||
        !read_number(r, config_setting_get_member(g, "tilt"), "tilt", 0, 1, &l->tilt))
        return false;
    l->normal_sets = (int)sets;
    return true;
}

static bool read_lattice(const struct reader *r, config_setting_t *g, const struct segment_kind *kind,
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
    if (!check_keys(r, g, "lattice", required, optional))
        return false;
    for (int i = 0; i < 2; i++) {
        const config_setting_t *s = config_setting_get_member(g, grid[i].key);
        double pair[2];
        if (!read_two(r, s, grid[i].key, 0, 100, pair))
            return false;
        if (pair[1] < 1e-3)
            return fail(r, s, "'%s' is [largest, step]; the step must be at least 0.001", grid[i].key);
        *grid[i].limit = pair[0];
        *grid[i].step = pair[1];
    }
    for (int i = 0; i < 2; i++) {
        const config_setting_t *s = config_setting_get_member(g, box[i].key);
        if (!read_two(r, s, box[i].key, -10, 10, box[i].range))
            return false;
        if (!(box[i].range[0] < box[i].range[1]))
            return fail(r, s, "'%s' is [lower, upper]; the lower must be below the upper", box[i].key);
    }
    const config_setting_t *s = config_setting_get_member(g, "newton");
    long long steps = 0;
    if (s && !read_count(r, s, "newton", 1, 1000, &steps))
        return false;
    l->newton = (int)steps;
    return !normals || read_normals(r, g, l);
}

/* Triangles have no taper and no warp of their own; curve and shift are of mid-side nodes.  Segments with normals come
 * from meshes of smooth bodies (smooth.h), and end at their edges. */
static bool read_shapes(const struct reader *r, config_setting_t *g, const struct segment_kind *kind, struct shapes *s)
{
    const bool middles = strlen(kind->nodes) > kind->corners, warps = !kind->triangle;
    const char *required[10] = {"aspect", "skew", "gap", "overhang"}, *const optional[] = {NULL};
    size_t n = 4;
    if (*kind->normals) {
        static const char *const gap[] = {"gap", NULL};
        return check_keys(r, g, "shapes", gap, optional) &&
               read_number(r, config_setting_get_member(g, "gap"), "gap", 0, 100, &s->gap);
    }
    if (warps) {
        required[n++] = "taper";
        required[n++] = "warp";
    }
    if (middles) {
        required[n++] = "curve";
        required[n++] = "shift";
    }
    return check_keys(r, g, "shapes", required, optional) &&
           read_number(r, config_setting_get_member(g, "aspect"), "aspect", 1, 1000, &s->aspect) &&
           read_angle(r, config_setting_get_member(g, "skew"), "skew", 85, &s->skew) &&
           (!warps || (read_number(r, config_setting_get_member(g, "taper"), "taper", 0, 0.95, &s->taper) &&
                       read_angle(r, config_setting_get_member(g, "warp"), "warp", 90, &s->warp))) &&
           (!middles || (read_number(r, config_setting_get_member(g, "curve"), "curve", 0, 0.2, &s->curve) &&
                         read_number(r, config_setting_get_member(g, "shift"), "shift", 0, 0.2, &s->shift))) &&
           read_number(r, config_setting_get_member(g, "gap"), "gap", 0, 100, &s->gap) &&
           read_number(r, config_setting_get_member(g, "overhang"), "overhang", 0, 1, &s->overhang);
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

/* What the mesh contributes to the scene's digest: its nodes and contact pairs, whatever files they stand in. */
static bool read_mesh_content(const char *path, char **data, size_t *size, struct diag *d)
{
    struct mesh *m = mesh_read(path, d);
    if (!m)
        return false;
    append(data, size, m->xyz, m->nodes * sizeof *m->xyz);
    for (size_t i = 0; i < m->pairs; i++) {
        append(data, size, m->pair[i].slave, m->pair[i].slaves * sizeof *m->pair[i].slave);
        append(data, size, m->pair[i].master, m->pair[i].masters * sizeof *m->pair[i].master);
    }
    mesh_free(m);
    return true;
}

/* The mesh file's path is relative to the scene's folder. */
static bool read_mesh(const struct reader *r, config_setting_t *g, struct mesh_pairs *m, char **data, size_t *size)
{
    static const char *const required[] = {"file", "distance", NULL}, *const optional[] = {NULL};
    const config_setting_t *s;
    const char *slash = strrchr(r->path, '/');
    char path[1024], *file = NULL;
    if (!check_keys(r, g, "mesh", required, optional) ||
        !read_number(r, config_setting_get_member(g, "distance"), "distance", 1e-300, 1e300, &m->distance))
        return false;
    s = config_setting_get_member(g, "file");
    if (!read_string(r, s, "file", &file))
        return false;
    if (file[0] == '/' || !slash)
        snprintf(path, sizeof path, "%s", file);
    else
        snprintf(path, sizeof path, "%.*s/%s", (int)(slash - r->path), r->path, file);
    free(file);
    m->file = new_text(path, strlen(path));
    if (access(path, R_OK) != 0)
        return fail(r, s, "cannot read mesh file '%s'", path);
    return read_mesh_content(path, data, size, r->d);
}

static bool read_terminals(const struct reader *r, const config_setting_t *s, struct tier *t)
{
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s) || config_setting_length(s) == 0)
        return fail(r, s, "'terminals' must be names, [\"p\", \"q\"]");
    t->terminal = new_array((size_t)config_setting_length(s), sizeof *t->terminal);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *e = config_setting_get_elem(s, (unsigned)i);
        if (!read_string(r, e, "terminals", &t->terminal[t->terminals]))
            return false;
        const char *name = t->terminal[t->terminals++];
        if (!is_identifier(name))
            return fail(r, e, "terminal '%s' is not a name", name);
        for (size_t k = 0; k + 1 < t->terminals; k++)
            if (strcmp(t->terminal[k], name) == 0)
                return fail(r, e, "terminal '%s' stands twice", name);
    }
    return true;
}

void tier_suffix(const struct tier *t, char text[16])
{
    snprintf(text, 16, t->at ? "_at%d" : "", t->at);
}

/* Tiers that expand about the same point share their values. */
static bool read_tier_reference(const struct reader *r, const config_setting_t *s, const struct scene *scene,
                                struct tier *t)
{
    char suffix[16];
    if (!read_two(r, s, "reference", -1, 1, t->reference))
        return false;
    int known = 0, same = 0;
    for (const struct tier *u = scene->tier; u < t; u++) {
        known = u->at > known ? u->at : known;
        if (u->at && u->reference[0] == t->reference[0] && u->reference[1] == t->reference[1])
            same = u->at;
    }
    t->at = same ? same : known + 1;
    tier_suffix(t, suffix);
    for (size_t i = 0; i < t->terminals; i++) {
        char name[300];
        snprintf(name, sizeof name, "%.250s%s", t->terminal[i], suffix);
        free(t->terminal[i]);
        t->terminal[i] = new_text(name, strlen(name));
    }
    return true;
}

static bool is_operator(const char *name, int arity)
{
    for (int gene = 0; gene < GENE_OPERATORS; gene++)
        if (gene_arity(gene) == arity && strcmp(gene_name(gene), name) == 0)
            return true;
    return false;
}

/* "polynomial", "rational", or a list of operators and of functions of the frame. */
static bool read_functions(const struct reader *r, const config_setting_t *s, struct tier *t)
{
    static const char *const word[] = {"polynomial", "rational"};
    int which, sums = 0;
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s)) {
        const bool good = read_word(r, s, "functions", word, 2, &which);
        t->rational = good && which == 1;
        return good;
    }
    t->function = new_array((size_t)config_setting_length(s), sizeof *t->function);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *e = config_setting_get_elem(s, (unsigned)i);
        const char *name = config_setting_get_string(e);
        const bool known = name && (is_operator(name, 1) || is_operator(name, 2));
        if (!name || !(known || is_identifier(name)))
            return fail(r, e, "'functions' holds something that is neither an operator nor a name");
        for (size_t k = 0; k < t->functions; k++)
            if (strcmp(t->function[k], name) == 0)
                return fail(r, e, "function '%s' stands twice", name);
        t->function[t->functions++] = new_text(name, strlen(name));
        t->twin = t->twin || !known;
        sums += strcmp(name, "+") == 0 || strcmp(name, "*") == 0;
    }
    return sums == 2 || fail(r, s, "'functions' must hold \"+\" and \"*\", which terms are added with");
}

/* The function that a tier's trees must end in, one of its list. */
static bool read_last(const struct reader *r, const config_setting_t *s, struct tier *t)
{
    bool known = false;
    if (!read_string(r, s, "last", &t->last))
        return false;
    for (size_t i = 0; i < t->functions; i++)
        known = known || strcmp(t->function[i], t->last) == 0;
    return (known && t->twin) || fail(r, s, "tier '%s': '%s' is none of its functions of the frame", t->name, t->last);
}

static bool read_tier(const struct reader *r, config_setting_t *g, const config_setting_t *frame, struct scene *scene)
{
    static const char *const required[] = {"name", "terminals", "max_length", "functions", NULL};
    static const char *const optional[] = {"frame", "budget", "reference", "last", NULL};
    struct tier *t = &scene->tier[scene->tiers++];
    const config_setting_t *own;
    long long length;
    t->line = (int)config_setting_source_line(g);
    if (!config_setting_is_group(g))
        return fail(r, g, "a tier must be a group, { name = ...; }");
    if (!check_keys(r, g, "tier", required, optional) ||
        !read_string(r, config_setting_get_member(g, "name"), "name", &t->name))
        return false;
    if (!is_identifier(t->name))
        return fail(r, config_setting_get_member(g, "name"), "tier name '%s' is not a C identifier", t->name);
    for (const struct tier *u = scene->tier; u < t; u++)
        if (strcmp(u->name, t->name) == 0)
            return fail(r, config_setting_get_member(g, "name"), "tier '%s' stands twice", t->name);
    own = config_setting_get_member(g, "frame");
    if (!own && !frame)
        return fail(r, g, "tier '%s' lacks 'frame', and the scene has none", t->name);
    if (!read_string(r, own ? own : frame, "frame", &t->frame))
        return false;
    if (!is_identifier(t->frame))
        return fail(r, own ? own : frame, "frame '%s' is not a name", t->frame);
    if (!read_terminals(r, config_setting_get_member(g, "terminals"), t) ||
        !read_count(r, config_setting_get_member(g, "max_length"), "max_length", 1, 100000, &length) ||
        !read_functions(r, config_setting_get_member(g, "functions"), t))
        return false;
    t->max_length = (size_t)length;
    own = config_setting_get_member(g, "reference");
    if (own && !read_tier_reference(r, own, scene, t))
        return false;
    if (own && t->twin)
        return fail(r, own, "tier '%s': functions of a frame are about the scene's reference point", t->name);
    own = config_setting_get_member(g, "last");
    if (own && !read_last(r, own, t))
        return false;
    const config_setting_t *budget = config_setting_get_member(g, "budget");
    return !budget || read_number(r, budget, "budget", 1, 1e6, &t->budget);
}

static bool read_tiers(const struct reader *r, config_setting_t *root, struct scene *scene)
{
    config_setting_t *list = config_setting_get_member(root, "tiers");
    const config_setting_t *frame = config_setting_get_member(root, "frame");
    if (!list && frame)
        return fail(r, frame, "'frame' without 'tiers'; a scene names both or leaves both to its segments");
    if (!list && scene->segment->surface)
        return fail(r, root, "scene lacks 'tiers', which follow for segments quad4 alone");
    if (!list)
        return true;
    if (!config_setting_is_list(list) || config_setting_length(list) == 0)
        return fail(r, list, "'tiers' must be a list of groups, ( { name = ...; }, ... )");
    scene->tier = new_array((size_t)config_setting_length(list), sizeof *scene->tier);
    for (int i = 0; i < config_setting_length(list); i++)
        if (!read_tier(r, config_setting_get_elem(list, (unsigned)i), frame, scene))
            return false;
    return true;
}

static bool read_segment(const struct reader *r, const config_setting_t *s, const struct segment_kind **segment)
{
    static const char *const planned[] = {"bezier"};
    char *name = NULL;
    if (!read_string(r, s, "segment", &name))
        return false;
    *segment = segment_find(name);
    bool found = *segment != NULL;
    for (size_t i = 0; !found && i < sizeof planned / sizeof *planned; i++)
        if (strcmp(name, planned[i]) == 0) {
            free(name);
            return fail(r, s, "segment '%s' is not yet supported", planned[i]);
        }
    if (!found)
        fail(r, s, "unknown segment '%s'", name);
    free(name);
    return found;
}

/* Exactly one of lattice, shapes and mesh. */
static bool read_source(const struct reader *r, config_setting_t *root, struct scene *scene, char **mesh, size_t *size)
{
    static const char *const source[] = {"lattice", "shapes", "mesh"};
    config_setting_t *found = NULL;
    for (int i = 0; i < 3; i++) {
        config_setting_t *s = config_setting_get_member(root, source[i]);
        if (s && found)
            return fail(r, s, "both '%s' and '%s'; a scene has one of lattice, shapes and mesh",
                        config_setting_name(found), source[i]);
        if (s && !config_setting_is_group(s))
            return fail(r, s, "'%s' must be a group, { ... }", source[i]);
        if (s) {
            found = s;
            scene->source = (enum scene_source)i;
        }
    }
    if (!found)
        return diag_at(r->d, r->path, 0, 0, "none of lattice, shapes and mesh; a scene has one of them");
    if (scene->source == SOURCE_MESH && *scene->segment->normals)
        return fail(r, found, "segments '%s' come from 'lattice' or 'shapes', not from a mesh file",
                    scene->segment->name);
    switch (scene->source) {
    case SOURCE_LATTICE:
        if (scene->segment->surface && !*scene->segment->normals)
            return fail(r, found, "a 'lattice' is of segments quad4 and gregory");
        return read_lattice(r, found, scene->segment, &scene->lattice);
    case SOURCE_RANDOM:
        return read_shapes(r, found, scene->segment, &scene->shapes);
    case SOURCE_MESH:
        break;
    }
    return read_mesh(r, found, &scene->mesh, mesh, size);
}

static bool read_reference(const struct reader *r, const config_setting_t *root, double reference[2])
{
    const config_setting_t *s = config_setting_get_member(root, "reference");
    reference[0] = reference[1] = NAN;
    if (!s && config_setting_get_member(root, "tiers"))
        return fail(r, root, "scene lacks 'reference'");
    return !s || read_two(r, s, "reference", -1, 1, reference);
}

static bool read_scene(const struct reader *r, config_setting_t *root, struct scene *scene, char **mesh, size_t *size)
{
    static const char *const required[] = {"segment", "order",    "norm",    "precision",
                                           "seed",    "training", "heldout", NULL};
    static const char *const optional[] = {"reference", "frame", "tiers", "lattice", "shapes", "mesh", NULL};
    static const char *const order[] = {"any", "nearest", "nearest-shorter"};
    static const char *const norm[] = {"mean", "p99", "max"}, *const precision[] = {"double"};
    long long training, heldout, seed;
    int which;
    if (!check_keys(r, root, "scene", required, optional) ||
        !read_segment(r, config_setting_get_member(root, "segment"), &scene->segment) ||
        !read_word(r, config_setting_get_member(root, "order"), "order", order, 3, &which))
        return false;
    scene->order = (enum corner_order)which;
    if (scene->order != CORNERS_ANY && !scene->segment->turns)
        return fail(r, config_setting_get_member(root, "order"), "'order' must be \"any\" for segment '%s'",
                    scene->segment->name);
    if (!read_reference(r, root, scene->reference) ||
        !read_word(r, config_setting_get_member(root, "norm"), "norm", norm, 3, &which))
        return false;
    scene->norm = (enum scene_norm)which;
    if (!read_word(r, config_setting_get_member(root, "precision"), "precision", precision, 1, &which))
        return false;
    scene->precision = new_text(precision[which], strlen(precision[which]));
    if (!read_count(r, config_setting_get_member(root, "seed"), "seed", 0, LLONG_MAX, &seed) ||
        !read_count(r, config_setting_get_member(root, "training"), "training", 1, 100000000, &training) ||
        !read_count(r, config_setting_get_member(root, "heldout"), "heldout", 1, 100000000, &heldout))
        return false;
    scene->seed = (uint64_t)seed;
    scene->training = (size_t)training;
    scene->heldout = (size_t)heldout;
    return read_source(r, root, scene, mesh, size) && read_tiers(r, root, scene);
}

/* Line of an @include directive, or 0.  The digest covers one text, so that a scene has no others. */
static int include_line(const char *text)
{
    for (int line = 1;; line++) {
        text += strspn(text, " \t");
        if (strncmp(text, "@include", strlen("@include")) == 0)
            return line;
        text = strchr(text, '\n');
        if (!text++)
            return 0;
    }
}

/* SHA-256 of the scene text and, after it, of the mesh content. */
static void digest(struct scene *scene, const char *text, size_t size, const char *mesh, size_t mesh_size)
{
    char *both = new_array(size + mesh_size, 1);
    memcpy(both, text, size);
    if (mesh)
        memcpy(both + size, mesh, mesh_size);
    sha256_hex(both, size + mesh_size, scene->sha256);
    free(both);
}

static char *scene_path(const char *root, const char *name)
{
    const size_t length = strlen(name), suffix = strlen(".scene");
    char path[1024];
    if (strchr(name, '/') || (length > suffix && strcmp(name + length - suffix, ".scene") == 0))
        return new_text(name, length);
    snprintf(path, sizeof path, "%s%sevolve/scenes/%s.scene", root, *root ? "/" : "", name);
    return new_text(path, strlen(path));
}

static char *scene_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    const size_t length = strlen(base), suffix = strlen(".scene");
    const bool named = length > suffix && strcmp(base + length - suffix, ".scene") == 0;
    return new_text(base, named ? length - suffix : length);
}

struct scene *scene_read(const char *root, const char *name_or_path, struct diag *d)
{
    char *path = scene_path(root, name_or_path), *mesh = NULL;
    const struct reader r = {path, d};
    size_t size = 0, mesh_size = 0;
    char *text = read_text(path, &size, d);
    struct scene *scene = NULL;
    config_t config;
    if (!text) {
        free(path);
        return NULL;
    }
    scene = new_array(1, sizeof *scene);
    scene->path = path;
    scene->name = scene_name(path);
    config_init(&config);
    bool good = strlen(text) == size;
    const int line = include_line(text);
    if (!good)
        diag_at(d, path, 0, 0, "a NUL character in the text");
    else if (line)
        good = diag_at(d, path, line, 0, "a scene includes no other file");
    else if (!config_read_string(&config, text))
        good = diag_at(d, path, config_error_line(&config), 0, "%s", config_error_text(&config));
    else
        good = read_scene(&r, config_root_setting(&config), scene, &mesh, &mesh_size);
    if (good)
        digest(scene, text, size, mesh, mesh_size);
    else {
        scene_free(scene);
        scene = NULL;
    }
    config_destroy(&config);
    free(mesh);
    free(text);
    return scene;
}

void scene_free(struct scene *s)
{
    if (!s)
        return;
    for (size_t i = 0; i < s->tiers; i++) {
        for (size_t k = 0; k < s->tier[i].terminals; k++)
            free(s->tier[i].terminal[k]);
        free(s->tier[i].terminal);
        for (size_t k = 0; k < s->tier[i].functions; k++)
            free(s->tier[i].function[k]);
        free(s->tier[i].function);
        free(s->tier[i].frame);
        free(s->tier[i].last);
        free(s->tier[i].name);
    }
    free(s->tier);
    free(s->mesh.file);
    free(s->precision);
    free(s->path);
    free(s->name);
    free(s);
}

void scene_box(const struct scene *s, double lo[2], double hi[2])
{
    const double overhang = s->source == SOURCE_RANDOM ? s->shapes.overhang : MESH_OVERHANG;
    const double reach = s->segment->triangle ? 1 + overhang : 1 + 2 * overhang;
    const bool lattice = s->source == SOURCE_LATTICE;
    lo[0] = lattice ? s->lattice.xi[0] : s->segment->triangle ? -overhang : -reach;
    hi[0] = lattice ? s->lattice.xi[1] : reach;
    lo[1] = lattice ? s->lattice.eta[0] : lo[0];
    hi[1] = lattice ? s->lattice.eta[1] : reach;
}

bool scene_samples(const struct scene *s, enum sample_part part, struct sample_set *set, struct diag *d)
{
    if (*s->segment->normals)
        return patches_samples(s, part, set, d);
    switch (s->source) {
    case SOURCE_LATTICE:
        return lattice_samples(s, part, set, d);
    case SOURCE_RANDOM:
        return shapes_samples(s, part, set, d);
    case SOURCE_MESH:
        break;
    }
    return mesh_samples(s, part, set, d);
}
