/* Every key that a scene may have, once: its type, limits and default, a usual value and what it means.  scene_keys.h reads
 * by these tables, scene_print.h prints an example of them. */
#ifndef FOOTPOINT_SCENE_TABLE_H
#define FOOTPOINT_SCENE_TABLE_H

#include "../../codegen/genome/segment_kind.h"

#include <stdbool.h>
#include <stddef.h>

enum key_type {
    KEY_NUMBER, /* double */
    KEY_COUNT,  /* size_t, a whole number */
    KEY_INT,    /* int, the same */
    KEY_ANGLE,  /* double in radians: "45 deg" or "0.8 rad"; limits are in degrees */
    KEY_POINT,  /* double[2]: [a, b] */
    KEY_GRID,   /* struct grid_range: [largest, step] */
    KEY_RANGE,  /* double[2]: [lower, upper] */
    KEY_WORD,   /* an enum that counts `word` */
    KEY_CHOICE, /* const char *: one of `word` */
    KEY_TEXT,   /* char *, owned */
    KEY_OWN,    /* read by code of its own */
    KEY_GROUP   /* the keys of `group` */
};

struct scene_key {
    const char *name;
    enum key_type type;
    size_t at; /* offset of the value in the group's struct */
    bool required;
    double low, high;
    double standard;         /* the value if the key is left out */
    double strange;          /* few meshes go beyond; 0: no matter */
    const char *const *word; /* ends with NULL */
    const char *usual; /* a value as text; of a key that may be left out the default, if there is one text for it */
    const char *help;
    bool (*suits)(const struct segment_kind *kind); /* NULL: segments of any kind have it */
    bool shared;                                    /* of tiers: may stand in the scene, for all of them */
    const struct scene_group *group;
};

/** The keys of one group. */
struct scene_group {
    const char *name;
    const struct scene_key *key;
    size_t keys;
};
extern const struct scene_group scene_group, shapes_group, mesh_group, lattice_group, tier_group;

/** The key of that name, or NULL. */
const struct scene_key *group_find(const struct scene_group *g, const char *name);

/** Whether segments of that kind have the key; any key of a kind NULL. */
static inline bool key_suits(const struct scene_key *k, const struct segment_kind *kind)
{
    return !kind || !k->suits || k->suits(kind);
}

#endif
