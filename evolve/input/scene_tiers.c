/* Reads the functions of a header that a scene asks for; see scene_parts.h. */
#include "scene_parts.h"

#include "../../codegen/base/text.h"

#include <stdlib.h>
#include <string.h>

static bool read_terminals(const struct scene_reader *r, const config_setting_t *s, struct tier *t)
{
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s) || config_setting_length(s) == 0)
        return key_fail(r, s, "'terminals' must be names, [\"p\", \"q\"]");
    t->terminal = new_array((size_t)config_setting_length(s), sizeof *t->terminal);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *e = config_setting_get_elem(s, (unsigned)i);
        if (!key_string(r, e, "terminals", &t->terminal[t->terminals]))
            return false;
        const char *name = t->terminal[t->terminals++];
        if (!key_identifier(name))
            return key_fail(r, e, "terminal '%s' is not a name", name);
        for (size_t k = 0; k + 1 < t->terminals; k++)
            if (strcmp(t->terminal[k], name) == 0)
                return key_fail(r, e, "terminal '%s' stands twice", name);
    }
    return true;
}

/* Reads a tier's reference point.  Tiers that expand about the same point share their values. */
static bool read_tier_reference(const struct scene_reader *r, const config_setting_t *s, const struct scene *scene,
                                struct tier *t)
{
    if (!key_two(r, s, "reference", -1, 1, t->reference))
        return false;
    int known = 0, same = 0;
    for (const struct tier *u = scene->tier; u < t; u++) {
        known = u->at > known ? u->at : known;
        if (u->at && u->reference[0] == t->reference[0] && u->reference[1] == t->reference[1])
            same = u->at;
    }
    t->at = same ? same : known + 1;
    return true;
}

static void add_suffix(char **name, const char *suffix)
{
    char *longer = new_format("%s%s", *name, suffix);
    free(*name);
    *name = longer;
}

/* Renames the values of its frame that the tier names, as a frame about the tier's own point calls them. */
static void suffix_names(struct tier *t)
{
    char suffix[16];
    tier_suffix(t, suffix);
    for (size_t i = 0; i < t->terminals; i++)
        add_suffix(&t->terminal[i], suffix);
    for (size_t i = 0; i < 2 * t->starts; i++)
        add_suffix(&t->start[i / 2][i % 2], suffix);
    for (size_t i = 0; i < t->functions; i++)
        if (gene_of_name(t->function[i]) < 0)
            add_suffix(&t->function[i], suffix);
    if (t->last)
        add_suffix(&t->last, suffix);
}

/* Reads "polynomial", "rational", or a list of operators and of functions of the frame. */
static bool read_functions(const struct scene_reader *r, const config_setting_t *s, struct tier *t)
{
    static const char *const word[] = {"polynomial", "rational", NULL};
    int which, sums = 0;
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s)) {
        const bool good = key_word(r, s, "functions", word, &which);
        t->rational = good && which == 1;
        return good;
    }
    t->function = new_array((size_t)config_setting_length(s), sizeof *t->function);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *e = config_setting_get_elem(s, (unsigned)i);
        const char *name = config_setting_get_string(e);
        const bool known = name && gene_of_name(name) >= 0;
        if (!name || !(known || key_identifier(name)))
            return key_fail(r, e, "'functions' holds something that is neither an operator nor a name");
        for (size_t k = 0; k < t->functions; k++)
            if (strcmp(t->function[k], name) == 0)
                return key_fail(r, e, "function '%s' stands twice", name);
        t->function[t->functions++] = new_text(name, strlen(name));
        t->calls = t->calls || !known;
        sums += strcmp(name, "+") == 0 || strcmp(name, "*") == 0;
    }
    return sums == 2 || key_fail(r, s, "'functions' must hold \"+\" and \"*\", which terms are added with");
}

/* Reads the function in which a tier's programs end. */
static bool read_last(const struct scene_reader *r, const config_setting_t *s, struct tier *t)
{
    return key_string(r, s, "last", &t->last) &&
           (t->program || key_fail(r, s, "tier '%s': 'last' is for programs, of more operations than 1", t->name));
}

static bool read_frame(const struct scene_reader *r, const config_setting_t *s, struct tier *t)
{
    t->frame_line = (int)config_setting_source_line(s);
    t->frame_column = key_column(r, s);
    return key_string(r, s, "frame", &t->frame) &&
           (key_identifier(t->frame) || key_fail(r, s, "frame '%s' is not a name", t->frame));
}

bool scene_check_tiers(const struct scene_reader *r, config_setting_t *root)
{
    config_setting_t *list = config_setting_get_member(root, "tiers");
    if (list && (!config_setting_is_list(list) || config_setting_length(list) == 0))
        return key_fail(r, list, "'tiers' must be a list of groups, ( { name = ...; }, ... )");
    for (int i = 0; list && i < config_setting_length(list); i++) {
        config_setting_t *g = config_setting_get_elem(list, (unsigned)i);
        char what[32];
        snprintf(what, sizeof what, "tier %d", i + 1);
        if (!config_setting_is_group(g))
            return key_fail(r, g, "a tier must be a group, { name = ...; }");
        if (!keys_check(r, g, what, &tier_group, NULL, root, NULL))
            return false;
    }
    return true;
}

static bool read_starts(const struct scene_reader *r, const config_setting_t *s, struct tier *t)
{
    if (!config_setting_is_list(s) || config_setting_length(s) == 0)
        return key_fail(r, s, "'starts' must be pairs of names, ([\"p\", \"q\"], ...)");
    t->start = new_array((size_t)config_setting_length(s), sizeof *t->start);
    for (int i = 0; i < config_setting_length(s); i++) {
        const config_setting_t *pair = config_setting_get_elem(s, (unsigned)i);
        if (!config_setting_is_array(pair) || config_setting_length(pair) != 2)
            return key_fail(r, pair, "'starts' must be pairs of names, ([\"p\", \"q\"], ...)");
        t->starts++;
        for (unsigned k = 0; k < 2; k++)
            if (!key_string(r, config_setting_get_elem(pair, k), "starts", &t->start[i][k]))
                return false;
    }
    return true;
}

static bool read_name(const struct scene_reader *r, const config_setting_t *s, const struct scene *scene,
                      struct tier *t)
{
    if (!key_string(r, s, "name", &t->name))
        return false;
    if (!key_identifier(t->name))
        return key_fail(r, s, "tier name '%s' is not a C identifier", t->name);
    for (const struct tier *u = scene->tier; u < t; u++)
        if (strcmp(u->name, t->name) == 0)
            return key_fail(r, s, "tier '%s' stands twice", t->name);
    return true;
}

/* Reads a key of KEY_OWN. */
static bool read_own(const struct scene_reader *r, const config_setting_t *s, const char *key,
                     const struct scene *scene, struct tier *t)
{
    if (strcmp(key, "name") == 0)
        return read_name(r, s, scene, t);
    if (strcmp(key, "frame") == 0)
        return read_frame(r, s, t);
    if (strcmp(key, "terminals") == 0)
        return read_terminals(r, s, t);
    if (strcmp(key, "functions") == 0)
        return read_functions(r, s, t);
    if (strcmp(key, "reference") == 0)
        return read_tier_reference(r, s, scene, t);
    return strcmp(key, "starts") == 0 ? read_starts(r, s, t) : read_last(r, s, t);
}

/* Returns true for keys that tiers with a gene each ignore, because they are for programs. */
static bool of_programs(const char *key)
{
    return strcmp(key, "starts") == 0 || strcmp(key, "last") == 0;
}

static bool read_tier(const struct scene_reader *r, config_setting_t *g, const config_setting_t *root,
                      struct scene *scene)
{
    struct tier *t = &scene->tier[scene->tiers++];
    t->line = (int)config_setting_source_line(g);
    for (const struct scene_key *k = tier_group.key; k < tier_group.key + tier_group.keys; k++) {
        const config_setting_t *s = config_setting_get_member(g, k->name);
        if (!s && k->shared && (t->program || !of_programs(k->name)))
            s = config_setting_get_member(root, k->name);
        if (s && !(k->type == KEY_OWN ? read_own(r, s, k->name, scene, t) : key_read(r, s, k, t)))
            return false;
        t->program = t->calls || t->max_length > 1;
    }
    t->starts_at_large = !config_setting_get_member(g, "starts") && config_setting_get_member(g, "terminals");
    suffix_names(t);
    return true;
}

bool scene_read_tiers(const struct scene_reader *r, config_setting_t *root, struct scene *scene)
{
    config_setting_t *list = config_setting_get_member(root, "tiers");
    const config_setting_t *frame = config_setting_get_member(root, "frame");
    if (!list && frame)
        return key_fail(r, frame, "'frame' without 'tiers'; a scene names both or leaves both to its segments");
    if (!list)
        return true;
    scene->tier = new_array((size_t)config_setting_length(list), sizeof *scene->tier);
    for (int i = 0; i < config_setting_length(list); i++)
        if (!read_tier(r, config_setting_get_elem(list, (unsigned)i), root, scene))
            return false;
    return true;
}

void scene_set_lengths(struct scene *s, size_t max_length)
{
    for (struct tier *t = s->tier; t < s->tier + s->tiers; t++) {
        t->max_length = max_length;
        t->program = t->calls || max_length > 1;
    }
}

bool scene_check_last(const struct scene *s, struct diag *d)
{
    for (const struct tier *t = s->tier; t < s->tier + s->tiers; t++)
        if (t->last && !t->program)
            return diag_at(d, s->path, t->line, 0, "tier '%s': 'last' is for programs, of more operations than 1",
                           t->name);
    return true;
}

bool scene_take_trees(struct scene *s, struct diag *d)
{
    for (struct tier *t = s->tier; t < s->tier + s->tiers; t++) {
        if (t->calls)
            return diag_at(d, s->path, t->line, 0, "tier '%s' is of programs, which the paper's breeding has not",
                           t->name);
        t->program = false;
    }
    return scene_check_last(s, d);
}
