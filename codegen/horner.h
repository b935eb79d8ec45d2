/* Common factors taken out of sums. */
#ifndef FOOTPOINT_HORNER_H
#define FOOTPOINT_HORNER_H

#include "dag.h"

#include <stdint.h>

/** Which factor each sub-sum gives up first.  By default the one that most of its terms hold; `preference` adds a
 *  random liking of each factor, in terms; `choice` overrules both, by the sub-sum's value. */
struct horner_policy {
    uint64_t seed;
    double preference;
    struct horner_choice *choice; /* owned; sorted by key */
    size_t choices, choice_room;
};

struct horner_choice {
    uint64_t key;    /* of the sub-sum */
    uint64_t factor; /* of the factor to take out; 0: none */
};

/** A choice that a run made, and what it could have chosen instead. */
struct horner_decision {
    uint64_t key, chosen;
    size_t first, alternatives; /* in `alternative` */
};

struct horner_record {
    struct horner_decision *decision; /* owned */
    size_t decisions, decision_room;
    uint64_t *alternative; /* owned */
    size_t alternatives, alternative_room;
};

void horner_choose(struct horner_policy *p, struct horner_choice c);
void horner_policy_copy(struct horner_policy *to, const struct horner_policy *from);
void horner_policy_clear(struct horner_policy *p);
void horner_record_clear(struct horner_record *r);

/** A new graph of the same outputs with fewer multiplications. Free with dag_free.  `record`, if not NULL, is emptied
 *  and filled. */
struct dag *horner_factor(const struct dag *g, const struct horner_policy *policy, struct horner_record *record);

#endif
