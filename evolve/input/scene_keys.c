/* Keys of a scene; see scene_keys.h. */
#include "scene_keys.h"

#include "../../codegen/base/text.h"

#include <errno.h>
#include <gsl/gsl_math.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

bool key_fail(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    diag_at(r->d, r->path, (int)config_setting_source_line(s), 0, "%s", text);
    return false;
}

void key_warn(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
{
    char text[300];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    char *all = new_format("%s%.300s:%u: warning: %s\n", *r->warnings ? *r->warnings : "", r->path,
                           config_setting_source_line(s), text);
    free(*r->warnings);
    *r->warnings = all;
}

void keys_lack(const struct scene_reader *r, const config_setting_t *group, const char *what, const char *name,
               const char *usual)
{
    struct scene_lacking *l = r->lacking;
    const size_t n = strlen(l->text), line = config_setting_source_line(group);
    const bool same = l->groups > 0 && l->group == group;
    if (l->groups == 0)
        l->line = line;
    if (!same)
        snprintf(l->text + n, sizeof l->text - n, "%s%s lacks", l->groups++ ? "; " : "", what);
    l->group = group;
    const size_t at = strlen(l->text);
    snprintf(l->text + at, sizeof l->text - at, "%s '%s' (such as %s)", same ? "," : "", name, usual);
}

bool keys_complete(const struct scene_reader *r)
{
    return r->lacking->groups == 0 || diag_at(r->d, r->path, (int)r->lacking->line, 0, "%s", r->lacking->text);
}

static bool known_key(const char *name, const struct scene_group *g, const struct segment_kind *kind,
                      const struct scene_group *besides)
{
    const struct scene_key *own = group_find(g, name), *shared = besides ? group_find(besides, name) : NULL;
    return (own && key_suits(own, kind)) || (shared && shared->shared);
}

bool keys_check(const struct scene_reader *r, config_setting_t *setting, const char *what, const struct scene_group *g,
                const struct segment_kind *kind, const config_setting_t *above, const struct scene_group *besides)
{
    for (int i = 0; i < config_setting_length(setting); i++) {
        const config_setting_t *s = config_setting_get_elem(setting, (unsigned)i);
        if (!known_key(config_setting_name(s), g, kind, besides))
            return key_fail(r, s, "unknown key '%s' in %s", config_setting_name(s), what);
    }
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (k->required && key_suits(k, kind) && !config_setting_get_member(setting, k->name) &&
            !(k->shared && above && config_setting_get_member(above, k->name)))
            keys_lack(r, setting, what, k->name, k->usual);
    return true;
}

int key_column(const struct scene_reader *r, const config_setting_t *s)
{
    const char *line = r->text, *value = config_setting_get_string(s);
    for (unsigned n = config_setting_source_line(s); n > 1 && line; n--)
        line = (line = strchr(line, '\n')) ? line + 1 : NULL;
    const size_t length = value ? strlen(value) : 0;
    const char *key = line ? strstr(line, config_setting_name(s)) : NULL;
    for (const char *at = key; at && length && *at && *at != '\n'; at++)
        if (*at == '"' && strncmp(at + 1, value, length) == 0 && at[1 + length] == '"')
            return (int)(at - line) + 1;
    return 0;
}

static bool read_number(const struct scene_reader *r, const config_setting_t *s, const char *key, double low,
                        double high, const char *usual, double *value)
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
        return key_fail(r, s, "'%s' must be a number", key);
    }
    if (!(*value >= low && *value <= high))
        return key_fail(r, s, "'%s' must be in %g..%g%s%s%s", key, low, high, usual ? "; " : "", usual ? usual : "",
                        usual ? " is usual" : "");
    return true;
}

static bool read_whole(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k,
                       long long *value)
{
    const int type = config_setting_type(s);
    const long long low = (long long)k->low, high = k->high >= 0x1p63 ? LLONG_MAX : (long long)k->high;
    *value = config_setting_get_int64(s);
    if (type != CONFIG_TYPE_INT && type != CONFIG_TYPE_INT64)
        return key_fail(r, s, "'%s' must be a whole number", k->name);
    if (*value < low || *value > high)
        return key_fail(r, s, "'%s' must be in %lld..%lld", k->name, low, high);
    return true;
}

bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double low, double high,
             double value[2])
{
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s) || config_setting_length(s) != 2)
        return key_fail(r, s, "'%s' must be two numbers, [a, b]", key);
    return read_number(r, config_setting_get_elem(s, 0), key, low, high, NULL, &value[0]) &&
           read_number(r, config_setting_get_elem(s, 1), key, low, high, NULL, &value[1]);
}

/* Reads an angle with its unit, in radians. */
static bool read_angle(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k,
                       double *radians)
{
    const char *text = config_setting_get_string(s), *const key = k->name;
    char *end = NULL;
    *radians = text ? strtod(text, &end) : 0;
    if (!text || end == text)
        return key_fail(r, s, "'%s' must be an angle with its unit, \"45 deg\" or \"0.8 rad\"", key);
    end += strspn(end, " ");
    if (*end == '\0')
        return key_fail(r, s, "'%s' needs a unit, deg or rad", key);
    if (strcmp(end, "deg") == 0)
        *radians *= M_PI / 180;
    else if (strcmp(end, "rad") != 0)
        return key_fail(r, s, "'%s' has the unknown unit '%s'; it must be deg or rad", key, end);
    if (!(*radians >= 0 && *radians <= k->high * M_PI / 180 * (1 + GSL_DBL_EPSILON)))
        return key_fail(r, s, "'%s' must be in 0..%g deg; %s is usual", key, k->high, k->usual);
    return true;
}

bool key_string(const struct scene_reader *r, const config_setting_t *s, const char *key, char **text)
{
    const char *t = config_setting_get_string(s);
    if (!t || *t == '\0')
        return key_fail(r, s, "'%s' must be a text in quotes", key);
    *text = new_text(t, strlen(t));
    return true;
}

bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word,
              int *which)
{
    const char *t = config_setting_get_string(s);
    char list[200] = "";
    for (*which = 0; t && word[*which]; ++*which)
        if (strcmp(t, word[*which]) == 0)
            return true;
    for (int i = 0; word[i]; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s\"%s\"", i ? " or " : "", word[i]);
    return key_fail(r, s, "'%s' must be %s", key, list);
}

/* Reads two numbers, the first or second of which has a lower limit. */
static bool read_pair(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k,
                      double value[2])
{
    if (!key_two(r, s, k->name, k->low, k->high, value))
        return false;
    if (k->type == KEY_GRID && value[1] < 1e-3)
        return key_fail(r, s, "'%s' is [largest, step]; the step must be at least 0.001", k->name);
    if (k->type == KEY_RANGE && !(value[0] < value[1]))
        return key_fail(r, s, "'%s' is [lower, upper]; the lower must be below the upper", k->name);
    return true;
}

static bool read_value(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k, void *to)
{
    const double unit = k->type == KEY_ANGLE ? M_PI / 180 : 1;
    long long whole = 0;
    int which = 0;
    bool good = true;
    switch (k->type) {
    case KEY_NUMBER:
        good = read_number(r, s, k->name, k->low, k->high, k->strange > 0 ? k->usual : NULL, to);
        break;
    case KEY_ANGLE:
        good = read_angle(r, s, k, to);
        break;
    case KEY_COUNT:
        good = read_whole(r, s, k, &whole);
        *(size_t *)to = (size_t)whole;
        break;
    case KEY_INT:
        good = read_whole(r, s, k, &whole);
        *(int *)to = (int)whole;
        break;
    case KEY_POINT:
    case KEY_GRID:
    case KEY_RANGE:
        return read_pair(r, s, k, to);
    case KEY_WORD:
        return key_word(r, s, k->name, k->word, to);
    case KEY_CHOICE:
        good = key_word(r, s, k->name, k->word, &which);
        *(const char **)to = k->word[which];
        break;
    case KEY_TEXT:
        return key_string(r, s, k->name, to);
    case KEY_OWN:
    case KEY_GROUP:
        break;
    }
    if (good && k->strange > 0 && *(double *)to > k->strange * unit)
        key_warn(r, s, "'%s' is %g%s; %s is usual", k->name, *(double *)to / unit, k->type == KEY_ANGLE ? " deg" : "",
                 k->usual);
    return good;
}

static void set_standard(const struct scene_key *k, void *to)
{
    if (k->type == KEY_NUMBER)
        *(double *)to = k->standard;
    else if (k->type == KEY_COUNT)
        *(size_t *)to = (size_t)k->standard;
    else if (k->type == KEY_INT || k->type == KEY_WORD)
        *(int *)to = (int)k->standard;
    else if (k->type == KEY_CHOICE)
        *(const char **)to = k->word[0];
    else if (k->type == KEY_POINT)
        ((double *)to)[0] = ((double *)to)[1] = k->standard;
}

bool key_read(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k, void *values)
{
    void *to = (char *)values + k->at;
    if (s)
        return read_value(r, s, k, to);
    set_standard(k, to);
    return true;
}

bool keys_read(const struct scene_reader *r, const config_setting_t *setting, const struct scene_group *g,
               const struct segment_kind *kind, void *values)
{
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (key_suits(k, kind) && !key_read(r, config_setting_get_member(setting, k->name), k, values))
            return false;
    return true;
}

bool key_identifier(const char *t)
{
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    return strspn(t, "0123456789") == 0 && *t != '\0' && t[strspn(t, letters)] == '\0';
}
