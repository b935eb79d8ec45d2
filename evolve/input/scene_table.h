/* Tables of all keys of a scene: type, limits, default, example value and meaning. scene_keys.h reads by them,
 * scene_print.h prints an example. */
#ifndef FOOTPOINT_SCENE_TABLE_H
#define FOOTPOINT_SCENE_TABLE_H

#include "../../codegen/genome/segment_kind.h"

#include <stdbool.h>
#include <stddef.h>

enum key_type {
    KEY_NUMBER, /* double */
    KEY_COUNT,  /* size_t, a whole number */
    KEY_INT,    /* int, a whole number */
    KEY_ANGLE,  /* double in radians: "45 deg" or "0.8 rad"; limits are in degrees */
    KEY_POINT,  /* double[2]: [a, b] */
    KEY_GRID,   /* struct grid_range: [largest, step] */
    KEY_RANGE,  /* double[2]: [lower, upper] */
    KEY_WORD,   /* an enum that counts `word` */
    KEY_CHOICE, /* const char *: one of `word` */
    KEY_TEXT,   /* char *, owned */
    KEY_OWN,    /* read by separate code */
    KEY_GROUP   /* the keys of `group` */
};

struct scene_key {
    const char *name;
    enum key_type type;
    size_t at; /* offset of the value in the group's struct */
    bool required;
    double low, high;
    double standard;         /* default */
    double strange;          /* few meshes exceed it; 0: no limit */
    const char *const *word; /* ends with NULL */
    const char *usual;       /* an example as text; for an optional key the default, if it can be written as a text */
    const char *help;
    bool (*suits)(const struct segment_kind *kind); /* kinds of segment that have the key; NULL: all */
    bool shared;                                    /* of tiers: may be in the scene, for all of them */
    const struct scene_group *group;
};

/** The keys of a group. */
struct scene_group {
    const char *name;
    const struct scene_key *key;
    size_t keys;
};
extern const struct scene_group scene_group, shapes_group, mesh_group, lattice_group, tier_group;

/** Returns the key with this name, or NULL. */
const struct scene_key *group_find(const struct scene_group *g, const char *name);

/** Returns true if segments of this kind have the key; always true if kind is NULL. */
static inline bool key_suits(const struct scene_key *k, const struct segment_kind *kind)
{
    return !kind || !k->suits || k->suits(kind);
}

#endif
