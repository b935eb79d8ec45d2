/* Reads keys of a libconfig text.  Each function is true if the key's value is of the right type and in its range; if
 * not, the complaint names its line. */
#ifndef FOOTPOINT_SCENE_KEYS_H
#define FOOTPOINT_SCENE_KEYS_H

#include "../../codegen/genome/genome.h"

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
    const char *root, *path, *text;
    struct diag *d;
    struct scene_lacking *lacking;
    char **warnings; /* owned by the scene: lines, or NULL */
    SHA2_CTX *sum;   /* of the scene's text and, after it, of the mesh content */
};

/** A key and the text of a usual value. */
struct scene_key {
    const char *name, *usual;
};

/** Always false. */
bool key_fail(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** Note "file:line: warning: ..." for the scene. */
void key_warn(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** All keys of a group are among `required` and `optional`, both ended by NULL.  Required ones that are not there are
 *  gathered. */
bool keys_check(const struct scene_reader *r, config_setting_t *group, const char *what,
                const struct scene_key *required, const char *const *optional);
/** One more that is not there. */
void keys_lack(const struct scene_reader *r, const config_setting_t *group, const char *what,
               const struct scene_key *key);
/** Nothing lacks. */
bool keys_complete(const struct scene_reader *r);

/** Where a text stands that is the value of a key: its quote, from 1; 0: not found. */
int key_column(const struct scene_reader *r, const config_setting_t *s);

/** Numbers from lo to hi; a pair of them.  usual: a value that a complaint about the range tells, or NULL. */
bool key_number(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
                const char *usual, double *value);
bool key_count(const struct scene_reader *r, const config_setting_t *s, const char *key, long long lo, long long hi,
               long long *value);
bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
             double value[2]);

/** "45 deg" or "0.8 rad", up to `limit` degrees; in radians. */
bool key_angle(const struct scene_reader *r, const config_setting_t *s, const char *key, double limit,
               const char *usual, double *radians);

/** *text is the caller's to free. */
bool key_string(const struct scene_reader *r, const config_setting_t *s, const char *key, char **text);

/** One of n words; *which is its number. */
bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word, int n,
              int *which);

/** Whether t is a C identifier. */
bool key_identifier(const char *t);

#endif
