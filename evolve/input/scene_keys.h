/* Reads a libconfig text by tables of keys (scene_table.h). Each function returns true if the key's value has the right
 * type and is in range; otherwise the diagnostic names its line. */
#ifndef FOOTPOINT_SCENE_KEYS_H
#define FOOTPOINT_SCENE_KEYS_H

#include "../../codegen/genome/genome.h"
#include "scene_table.h"

#include <libconfig.h>
#include <sha256.h>
#include <stdint.h>

/** Missing keys, collected so that a single message names all. */
struct scene_lacking {
    char text[420];
    size_t groups, line;           /* line of the first group that lacks a key */
    const config_setting_t *group; /* not owned; the last group that lacks a key */
};

/* State of the reader, and the first error. */
struct scene_reader {
    const char *path, *text;
    struct diag *d;
    struct scene_lacking *lacking;
    char **warnings; /* owned by the scene: lines, or NULL */
    SHA2_CTX *sum;   /* of the scene's text, then of the mesh's content */
};

/** Reports an error; always returns false. */
bool key_fail(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Adds "file:line: warning: ..." to the scene's warnings. */
void key_warn(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Checks that all keys of a setting belong to the group, suit the kind of segment, or are shared keys of `besides`.
 *  Collects required keys that are missing both here and, for shared keys, in `above`. what: the setting's name in
 *  messages.
 *  @param[in] kind     NULL: any
 *  @param[in] above    setting that may contain shared keys, or NULL
 *  @param[in] besides  group whose shared keys may be here, or NULL */
bool keys_check(const struct scene_reader *r, config_setting_t *setting, const char *what, const struct scene_group *g,
                const struct segment_kind *kind, const config_setting_t *above, const struct scene_group *besides);
/** Adds a missing key. */
void keys_lack(const struct scene_reader *r, const config_setting_t *group, const char *what, const char *name,
               const char *usual);
/** Returns true if no key is missing. */
bool keys_complete(const struct scene_reader *r);

/** Reads a key's value, or its default if s is NULL, into the place that the table gives. Keys with their own reader
 *  are skipped. */
bool key_read(const struct scene_reader *r, const config_setting_t *s, const struct scene_key *k, void *values);
/** Reads all keys of a group that suit the kind of segment. */
bool keys_read(const struct scene_reader *r, const config_setting_t *setting, const struct scene_group *g,
               const struct segment_kind *kind, void *values);

/** Returns the column of the opening quote of a text value, from 1, or 0 if it is not found. */
int key_column(const struct scene_reader *r, const config_setting_t *s);
/** Reads two numbers between low and high. */
bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double low, double high,
             double value[2]);
/** Reads a text; *text is owned by the caller. */
bool key_string(const struct scene_reader *r, const config_setting_t *s, const char *key, char **text);
/** Reads one of several words; the list must end with NULL. *which becomes its index. */
bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word,
              int *which);
/** Returns true if t is a C identifier. */
bool key_identifier(const char *t);

#endif
