/* Reads a scene: a libconfig text (documented in evolve/README.md). Checks every key, type, unit and range; each error
 * names its line. */
#include "scene_parts.h"

#include <ctype.h>
#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* Reads the segment, which may be missing (NULL) if a mesh determines it. */
static bool read_segment(const struct scene_reader *r, const config_setting_t *s, const struct segment_kind **segment)
{
    char *name = NULL;
    if (!s)
        return true;
    if (!key_string(r, s, "segment", &name))
        return false;
    *segment = segment_find(name);
    const bool found = *segment != NULL;
    if (!found)
        key_fail(r, s, "unknown segment '%s'", name);
    free(name);
    return found;
}

/* Checks that every key is known and that all required keys are present. */
static bool check_keys(const struct scene_reader *r, config_setting_t *root, struct scene *scene,
                       config_setting_t **source)
{
    if (!keys_check(r, root, "scene", &scene_group, NULL, NULL, &tier_group) ||
        !read_segment(r, config_setting_get_member(root, "segment"), &scene->segment) ||
        !scene_find_source(r, root, scene, source))
        return false;
    if (!scene->segment && *source && scene->source != SOURCE_MESH)
        keys_lack(r, root, "scene", "segment", group_find(&scene_group, "segment")->usual);
    return scene_check_source(r, *source, scene) && scene_check_tiers(r, root) && keys_complete(r);
}

/* Rejects settings that segments of the scene's kind do not have. */
static bool suits_segment(const struct scene_reader *r, const config_setting_t *root, const struct scene *scene)
{
    const struct segment_kind *kind = scene->segment;
    if (scene->order != CORNERS_ANY && !kind->turns)
        return key_fail(r, config_setting_get_member(root, "order"), "'order' must be \"any\" for segment '%s'",
                        kind->name);
    return strcmp(scene->precision, "double") == 0 || !*kind->normals ||
           key_fail(r, config_setting_get_member(root, "precision"), "'precision' must be \"double\" for segment '%s'",
                    kind->name);
}

static bool read_scene(const struct scene_reader *r, config_setting_t *root, struct scene *scene)
{
    config_setting_t *source = NULL;
    if (!check_keys(r, root, scene, &source))
        return false;
    const bool mesh = scene->source == SOURCE_MESH; /* a mesh determines the segments */
    return (!mesh || scene_read_source(r, source, scene)) && keys_read(r, root, &scene_group, NULL, scene) &&
           suits_segment(r, root, scene) && (mesh || scene_read_source(r, source, scene)) &&
           scene_read_tiers(r, root, scene);
}

/* Returns the line of an @include directive, or 0. The digest covers one text, so a scene must not include others. */
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

/* Returns the text after a comment or string that begins at `at`, or NULL if neither begins there. */
static const char *behind_other_text(const char *at)
{
    const char *end;
    if (*at == '"') {
        for (end = at + 1; *end && *end != '"'; end++)
            end += *end == '\\' && end[1];
        return *end ? end + 1 : end;
    }
    if (*at == '/' && at[1] == '*')
        return (end = strstr(at + 2, "*/")) ? end + 2 : at + strlen(at);
    return *at == '#' || (*at == '/' && at[1] == '/') ? at + strcspn(at, "\n") : NULL;
}

/* Returns the line of a whole number that needs the suffix L, or 0. Without it, libconfig 1.5 takes the last 32
 * bits. */
static int wrapped_line(const char *text)
{
    int line = 1;
    for (const char *at = text, *end; *at; at = end) {
        if ((end = behind_other_text(at))) {
            for (; at < end; at++)
                line += *at == '\n';
        } else if (isdigit((unsigned char)*at) || (*at == '.' && isdigit((unsigned char)at[1]))) {
            end = at + strspn(at, "0123456789abcdefABCDEFxX._+-LgG");
            char *stop;
            errno = 0;
            const unsigned long long value = strtoull(at, &stop, strncasecmp(at, "0x", 2) == 0 ? 16 : 10);
            if (stop == end && (errno == ERANGE || value > INT_MAX))
                return line;
        } else {
            line += *at == '\n';
            end = at + 1;
            while (isalpha((unsigned char)*at) && (isalnum((unsigned char)*end) || *end == '_'))
                end++;
        }
    }
    return 0;
}

static char *scene_name(const char *path)
{
    const char *slash = strrchr(path, '/'), *base = slash ? slash + 1 : path;
    const size_t length = strlen(base), suffix = strlen(".scene");
    const bool named = length > suffix && strcmp(base + length - suffix, ".scene") == 0;
    return new_text(base, named ? length - suffix : length);
}

/* Gives tiers without a frame the frame of their kind's scene. */
static bool take_frame(const char *root, struct scene *scene, struct diag *d)
{
    struct scene *usual = NULL;
    bool good = true;
    for (struct tier *t = scene->tier; good && t < scene->tier + scene->tiers; t++) {
        if (t->frame)
            continue;
        good = usual || (usual = scene_of_kind(root, scene, d));
        if (good)
            t->frame = new_text(usual->tier[0].frame, strlen(usual->tier[0].frame));
    }
    scene_free(usual);
    return good;
}

struct scene *scene_read(const char *root, const char *name_or_path, struct diag *d)
{
    char *path = scene_path(root, name_or_path);
    size_t size = 0;
    char *text = read_text(path, &size, d);
    struct scene *scene = NULL;
    struct scene_lacking lacking = {.groups = 0};
    config_t config;
    SHA2_CTX sum;
    if (!text) {
        free(path);
        return NULL;
    }
    scene = new_array(1, sizeof *scene);
    scene->run = 1;
    scene->path = path;
    scene->name = scene_name(path);
    const struct scene_reader r = {path, text, d, &lacking, &scene->warnings, &sum};
    SHA256Init(&sum);
    SHA256Update(&sum, (const uint8_t *)text, size);
    config_init(&config);
    bool good = strlen(text) == size;
    const int line = include_line(text), wrapped = wrapped_line(text);
    if (!good)
        diag_at(d, path, 0, 0, "the text contains a NUL character");
    else if (line)
        good = diag_at(d, path, line, 0, "a scene must not include other files");
    else if (wrapped)
        good = diag_at(d, path, wrapped, 0, "a whole number above %d must end in L", INT_MAX);
    else if (!config_read_string(&config, text))
        good = diag_at(d, path, config_error_line(&config), 0, "%s", config_error_text(&config));
    else
        good = read_scene(&r, config_root_setting(&config), scene) && take_frame(root, scene, d);
    if (good && scene->tiers > 0 && isnan(scene->reference[0]))
        scene_choose_reference(scene, false);
    if (good)
        SHA256End(&sum, scene->sha256);
    else {
        scene_free(scene);
        scene = NULL;
    }
    config_destroy(&config);
    free(text);
    return scene;
}

struct scene *scene_of_kind(const char *root, const struct scene *s, struct diag *d)
{
    const char *const kind = s->segment->name;
    char *path = scene_path(root, kind);
    struct scene *usual = NULL;
    if (strcmp(path, s->path) == 0)
        diag_at(d, path, 0, 0, "frame and tiers are missing; other scenes of segment %s take them from here", kind);
    else if (segment_find(s->name) && segment_find(s->name) != s->segment)
        diag_at(d, s->path, 0, 0, "scene %s supplies tiers for its kind; its segment must not be %s", s->name, kind);
    else
        usual = scene_read(root, kind, d);
    if (usual && usual->tiers == 0) {
        diag_at(d, path, 0, 0, "no tiers; scene '%s' of segment %s takes them from here", s->name, kind);
        scene_free(usual);
        usual = NULL;
    }
    free(path);
    return usual;
}
