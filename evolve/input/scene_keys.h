/* Reads a libconfig text by tables of keys (scene_table.h).  Each function is true if the key's value is of the right type
 * and in its range; if not, the complaint names its line. */
#ifndef FOOTPOINT_SCENE_KEYS_H
#define FOOTPOINT_SCENE_KEYS_H

#include "../../codegen/genome/genome.h"
#include "scene_table.h"

#include <libconfig.h>
#include <sha256.h>
#include <stdint.h>

/** Keys that a scene lacks, gathered so that they are named at once. */
struct scene_lacking {
    char text[420];
    size_t groups, line;           /* line of the first group that lacks one */
    const config_setting_t *group; /* not owned; the last one */
};

/* What a complaint needs, and the first complaint. */
struct scene_reader {
    const char *path, *text;
    struct diag *d;
    struct scene_lacking *lacking;
    char **warnings; /* owned by the scene: lines, or NULL */
    SHA2_CTX *sum;   /* of the scene's text and, after it, of the mesh content */
};

/** Always false. */
bool key_fail(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Notes "file:line: warning: ..." for the scene. */
void key_warn(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Checks that all keys of a setting are the group's, of segments of that kind, or of `besides` shared ones; gathers
 *  those that are required and not there, neither here nor, of shared keys, in `above`.  what: how complaints call it.
 *  @param[in] kind     NULL: any
 *  @param[in] above    the setting that shared keys may stand in; NULL: none
 *  @param[in] besides  a group whose shared keys may stand here; NULL: none */
bool keys_check(const struct scene_reader *r, config_setting_t *setting, const char *what, const struct scene_group *g,
                const struct segment_kind *kind, const config_setting_t *above, const struct scene_group *besides);
/** One more that is not there. */
void keys_lack(const struct scene_reader *r, const config_setting_t *group, const char *what, const char *name,
               const char *usual);
/** Nothing lacks. */
bool keys_complete(const struct scene_reader *r);

/** Reads a key's value to where the table says, or its default where s is NULL.  Keys with readers of their own are left
 *  alone. */
bool key_read(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k, void *values);
/** Reads all keys of a group that segments of that kind have. */
bool keys_read(const struct scene_reader *r, const config_setting_t *setting, const struct scene_group *g,
               const struct segment_kind *kind, void *values);

/** Where a text stands that is the value of a key: its quote, from 1; 0: not found. */
int key_column(const struct scene_reader *r, const config_setting_t *s);
/** Two numbers from low to high. */
bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double low, double high,
             double value[2]);
/** *text is the caller's to free. */
bool key_string(const struct scene_reader *r, const config_setting_t *s, const char *key, char **text);
/** One of some words, which end with NULL; *which is its number. */
bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word,
              int *which);
/** Whether t is a C identifier. */
bool key_identifier(const char *t);

#endif
