/* The choices that the passes leave open, and how a search overrules them.  A choice is named by the value that it is
 * about, so that it holds wherever that value turns up, whatever else was chosen. */
#ifndef FOOTPOINT_CHOICES_H
#define FOOTPOINT_CHOICES_H

#include "../base/base.h"
#include "../base/random.h"

#include <stdint.h>

/** What is chosen. */
enum choice_kind {
    CHOICE_FACTOR,   /* which factor a sub-sum gives up first: its mark, 0 for none */
    CHOICE_DISSOLVE, /* 1: a sum is multiplied out where it is used */
    CHOICE_COMBINE   /* 1: an inverse is brought to a common denominator where it is used */
};

struct choice {
    uint64_t key;
    uint64_t what;
};

struct policy {
    uint64_t seed;
    double preference;        /* random weight of each factor, in terms that hold it */
    double dissolve, combine; /* share of the flags that are set where no choice says otherwise */
    bool join;                /* independent inverses share one division */
    bool early;               /* common parts of sums are looked for before factors are taken out, too */
    bool plain;               /* nothing is factored where no choice says so */
    bool differences;         /* differences of two inputs stay whole: they are exact, or nearly */
    struct choice *choice;    /* owned; sorted by key */
    size_t choices, choice_room;
};

/** A choice that a run met, and what it could have been. */
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
/** The choice of that key, or NULL. */
const struct choice *policy_find(const struct policy *p, uint64_t key);
/** A yes-no choice about the value of that mark; recorded.  Where no choice says otherwise, values of the same group
 *  are treated alike. */
bool policy_flag(const struct policy *p, struct record *r, enum choice_kind kind, uint64_t mark, uint64_t group);
/** Random number in [0,1) that belongs to a mark. */
double policy_random(const struct policy *p, uint64_t mark);

void policy_choose(struct policy *p, struct choice c);
void policy_copy(struct policy *to, const struct policy *from);
void policy_clear(struct policy *p);

/** r may be NULL: nothing is recorded. */
void record_decision(struct record *r, uint64_t key);
/** Of the last decision. */
void record_alternative(struct record *r, uint64_t what);
void record_clear(struct record *r);

#endif
