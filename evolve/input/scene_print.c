/* Prints the tables of keys as a scene; see scene_print.h. */
#include "scene_print.h"

#include "scene_table.h"

#include <string.h>

enum { HELP_COLUMN = 32 };

static void print_limits(const struct scene_key *k, FILE *f)
{
    if (k->word)
        for (size_t i = 0; k->word[i]; i++)
            fprintf(f, "%s\"%s\"", i == 0 ? " (" : ", ", k->word[i]);
    else if (k->high > 0 && k->high < 1e18)
        fprintf(f, " (%.9g..%.9g%s", k->low, k->high, k->type == KEY_ANGLE ? " deg" : "");
    else
        return;
    fputc(')', f);
}

/* Prints "name = value;  // help (limits)", as a comment if the key or its whole group is optional. */
static void print_key(const struct scene_key *k, const char *value, const char *indent, bool comment, FILE *f)
{
    const int column = fprintf(f, "%s%s%s = %s;", comment ? "// " : "", indent, k->name, value);
    fprintf(f, "%*s// %s", column < HELP_COLUMN ? HELP_COLUMN - column : 1, "", k->help);
    print_limits(k, f);
    fputc('\n', f);
}

static void print_group(const struct scene_key *group, const struct segment_kind *kind, bool comment, FILE *f)
{
    const char *const slashes = comment ? "// " : "";
    const struct scene_group *g = group->group;
    fprintf(f, "// %s%s\n%s%s: {\n", comment ? "or " : "", group->help, slashes, group->name);
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (key_suits(k, kind))
            print_key(k, k->usual, "    ", comment || !k->required, f);
    fprintf(f, "%s};\n", slashes);
}

static void print_tiers(const struct segment_kind *kind, FILE *f)
{
    const struct scene_group *g = &tier_group;
    fprintf(f, "\n// The functions of the header. Without tiers, the scene takes those of scene %s.\n", kind->name);
    fputs("// Keys that all tiers share may precede them:\n", f);
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (k->shared)
            print_key(k, k->usual, "", true, f);
    fputs("// tiers = ({\n", f);
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (!k->shared)
            print_key(k, k->usual, "    ", true, f);
    fputs("// });\n", f);
}

void scene_print(const struct segment_kind *kind, FILE *f)
{
    const struct scene_group *g = &scene_group;
    char segment[32];
    snprintf(segment, sizeof segment, "\"%s\"", kind->name);
    fputs("// Keys in comments are optional.\n", f);
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (strcmp(k->name, "segment") == 0)
            print_key(k, segment, "", false, f);
        else if (!k->group && key_suits(k, kind))
            print_key(k, k->usual, "", !k->required, f);
    fputs("\n// The source of samples, one of these:\n", f);
    for (const struct scene_key *k = g->key; k < g->key + g->keys; k++)
        if (k->type == KEY_GROUP && key_suits(k, kind))
            print_group(k, kind, k->group != &shapes_group, f);
    print_tiers(kind, f);
}
