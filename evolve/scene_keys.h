/* Reads keys of a libconfig text.  Each function is true if the key's value is of the right type and in its range; if
 * not, the complaint names its line. */
#ifndef FOOTPOINT_SCENE_KEYS_H
#define FOOTPOINT_SCENE_KEYS_H

#include "../codegen/genome.h"

#include <libconfig.h>

/* What a complaint needs, and the first complaint. */
struct scene_reader {
    const char *path;
    struct diag *d;
};

/** Always false. */
bool key_fail(const struct scene_reader *r, const config_setting_t *s, const char *format, ...)
    __attribute__((format(printf, 3, 4)));

/** All keys of a group are among `required` and `optional`, both NULL-terminated, and the required ones are there. */
bool keys_check(const struct scene_reader *r, config_setting_t *group, const char *what, const char *const *required,
                const char *const *optional);

/** Numbers from lo to hi; a pair of them. */
bool key_number(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
                double *value);
bool key_count(const struct scene_reader *r, const config_setting_t *s, const char *key, long long lo, long long hi,
               long long *value);
bool key_two(const struct scene_reader *r, const config_setting_t *s, const char *key, double lo, double hi,
             double value[2]);

/** "45 deg" or "0.8 rad", up to `limit` degrees; in radians. */
bool key_angle(const struct scene_reader *r, const config_setting_t *s, const char *key, double limit, double *radians);

/** *text is the caller's to free. */
bool key_string(const struct scene_reader *r, const config_setting_t *s, const char *key, char **text);

/** One of n words; *which is its number. */
bool key_word(const struct scene_reader *r, const config_setting_t *s, const char *key, const char *const *word, int n,
              int *which);

/** Whether t is a C identifier. */
bool key_identifier(const char *t);

#endif
