/* Keys of a scene; see scene_keys.h. */
#include "scene_keys.h"

#include "../../codegen/genome/text.h"

#include <errno.h>
#include <gsl/gsl_math.h>
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

void keys_lack(const struct scene_reader *r, const config_setting_t *group, const char *what,
               const struct scene_key *key)
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
    snprintf(l->text + at, sizeof l->text - at, "%s '%s' (such as %s)", same ? "," : "", key->name, key->usual);
}

bool keys_complete(const struct scene_reader *r)
{
    return r->lacking->groups == 0 || diag_at(r->d, r->path, (int)r->lacking->line, 0, "%s", r->lacking->text);
}

bool keys_check(const struct scene_reader *r, config_setting_t *group, const char *what,
                const struct scene_key *required, const char *const *optional)
{
    for (int i = 0; i < config_setting_length(group); i++) {
        const config_setting_t *s = config_setting_get_elem(group, (unsigned)i);
        const char *key = config_setting_name(s);
        bool known = false;
        for (const struct scene_key *k = required; k->name; k++)
            known = known || strcmp(k->name, key) == 0;
        for (const char *const *k = optional; *k; k++)
            known = known || strcmp(*k, key) == 0;
        if (!known)
            return key_fail(r, s, "unknown key '%s' in %s", key, what);
    }
    for (const struct scene_key *k = required; k->name; k++)
        if (!config_setting_get_member(group, k->name))
            keys_lack(r, group, what, k);
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

bool key_number(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
                const char *usual, double *value)
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
    if (!(*value >= lo && *value <= hi))
        return key_fail(r, s, "'%s' must be in %g..%g%s%s%s", key, lo, hi, usual ? "; " : "", usual ? usual : "",
                        usual ? " is usual" : "");
    return true;
}

bool key_count(const struct scene_reader *r, const config_setting_t *s, const char *key, long long lo, long long hi,
               long long *value)
{
    const int type = config_setting_type(s);
    *value = config_setting_get_int64(s);
    if (type != CONFIG_TYPE_INT && type != CONFIG_TYPE_INT64)
        return key_fail(r, s, "'%s' must be a whole number", key);
    if (*value < lo || *value > hi)
        return key_fail(r, s, "'%s' must be in %lld..%lld", key, lo, hi);
    return true;
}

bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
             double value[2])
{
    if (!config_setting_is_aggregate(s) || config_setting_is_group(s) || config_setting_length(s) != 2)
        return key_fail(r, s, "'%s' must be two numbers, [a, b]", key);
    return key_number(r, config_setting_get_elem(s, 0), key, lo, hi, NULL, &value[0]) &&
           key_number(r, config_setting_get_elem(s, 1), key, lo, hi, NULL, &value[1]);
}

/* An angle with its unit, "45 deg" or "0.5 rad", in 0..limit degrees. */
bool key_angle(const struct scene_reader *r, const config_setting_t *s, const char *key, double limit,
               const char *usual, double *radians)
{
    const char *text = config_setting_get_string(s);
    char *end;
    if (!text)
        return key_fail(r, s, "'%s' must be an angle with its unit, \"45 deg\" or \"0.8 rad\"", key);
    *radians = strtod(text, &end);
    if (end == text)
        return key_fail(r, s, "'%s' must be an angle with its unit, \"45 deg\" or \"0.8 rad\"", key);
    end += strspn(end, " ");
    if (*end == '\0')
        return key_fail(r, s, "'%s' lacks its unit, deg or rad", key);
    if (strcmp(end, "deg") == 0)
        *radians *= M_PI / 180;
    else if (strcmp(end, "rad") != 0)
        return key_fail(r, s, "'%s' has the unknown unit '%s'; deg or rad", key, end);
    if (!(*radians >= 0 && *radians <= limit * M_PI / 180 * (1 + GSL_DBL_EPSILON)))
        return key_fail(r, s, "'%s' must be in 0..%g deg; %s is usual", key, limit, usual);
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

/* One of `n` words. */
bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word, int n,
              int *which)
{
    const char *t = config_setting_get_string(s);
    char list[200] = "";
    for (*which = 0; t && *which < n; ++*which)
        if (strcmp(t, word[*which]) == 0)
            return true;
    for (int i = 0; i < n; i++)
        snprintf(list + strlen(list), sizeof list - strlen(list), "%s\"%s\"", i ? " or " : "", word[i]);
    return key_fail(r, s, "'%s' must be %s", key, list);
}

bool key_identifier(const char *t)
{
    static const char letters[] = "0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ_";
    return strspn(t, "0123456789") == 0 && *t != '\0' && t[strspn(t, letters)] == '\0';
}
