/* The choices that the passes leave open, and how a search overrides them. A choice is identified by the value that it
 * concerns, so that it applies wherever that value occurs, whatever else was chosen. */
#ifndef FOOTPOINT_CHOICES_H
#define FOOTPOINT_CHOICES_H

#include "../base/base.h"
#include "../base/random.h"

#include <stdint.h>

/** Kinds of choices. */
enum choice_kind {
    CHOICE_FACTOR,   /* which factor a sub-sum extracts first: its mark, 0 for none */
    CHOICE_DISSOLVE, /* 1: a sum is multiplied out where it is used */
    CHOICE_COMBINE   /* 1: an inverse is brought to a common denominator where it is used */
};

struct choice {
    uint64_t key;
    uint64_t what;
};

struct policy {
    uint64_t seed;
    double preference;        /* random weight of each factor, in terms that contain it */
    double dissolve, combine; /* fraction of flags that are set by default */
    bool join;                /* independent inverses share one division */
    bool early;               /* common parts of sums are also sought before factors are extracted */
    bool plain;               /* nothing is factored by default */
    bool differences;         /* differences of two inputs stay whole: they are exact, or nearly */
    struct choice *choice;    /* owned; sorted by key */
    size_t choices, choice_room;
};

/** A choice that a run met, and its alternatives. */
struct decision {
    uint64_t key;
    size_t first, alternatives; /* in `alternative` */
};

struct record {
    struct decision *decision; /* owned */
    size_t decisions, decision_room;
    uint64_t *alternative; /* owned */
    size_t alternatives, alternative_room;
};

uint64_t policy_key(enum choice_kind kind, uint64_t mark);
/** Returns the choice with this key, or NULL. */
const struct choice *policy_find(const struct policy *p, uint64_t key);
/** Decides and records a yes-no choice about a value, identified by its mark. By default, values of the same group are
 *  treated alike. */
bool policy_flag(const struct policy *p, struct record *r, enum choice_kind kind, uint64_t mark, uint64_t group);
/** Returns a random number in [0,1) determined by a mark. */
double policy_random(const struct policy *p, uint64_t mark);

void policy_choose(struct policy *p, struct choice c);
void policy_copy(struct policy *to, const struct policy *from);
void policy_clear(struct policy *p);

/** Records a decision; r may be NULL. */
void record_decision(struct record *r, uint64_t key);
/** Records an alternative of the last decision. */
void record_alternative(struct record *r, uint64_t what);
void record_clear(struct record *r);

#endif
