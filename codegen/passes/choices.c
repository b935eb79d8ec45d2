/* Choices and their record; see choices.h. */
#include "choices.h"

#include <stdlib.h>

uint64_t policy_key(enum choice_kind kind, uint64_t mark)
{
    return random_of(mark + (uint64_t)kind);
}

static int compare_choices(const void *a, const void *b)
{
    const struct choice *x = a, *y = b;
    return (x->key > y->key) - (x->key < y->key);
}

const struct choice *policy_find(const struct policy *p, uint64_t key)
{
    const struct choice c = {key, 0};
    return p->choices ? bsearch(&c, p->choice, p->choices, sizeof c, compare_choices) : NULL;
}

double policy_random(const struct policy *p, uint64_t mark)
{
    return random_fraction(random_of(mark ^ random_of(p->seed)));
}

bool policy_flag(const struct policy *p, struct record *r, enum choice_kind kind, uint64_t mark, uint64_t group)
{
    const uint64_t key = policy_key(kind, mark);
    const struct choice *c = policy_find(p, key);
    record_decision(r, key);
    record_alternative(r, 1);
    return c ? c->what : policy_random(p, group) < (kind == CHOICE_DISSOLVE ? p->dissolve : p->combine);
}

void policy_choose(struct policy *p, struct choice c)
{
    struct choice *known = p->choices ? bsearch(&c, p->choice, p->choices, sizeof c, compare_choices) : NULL;
    if (known) {
        *known = c;
        return;
    }
    grow_array(&p->choice, p->choices, &p->choice_room, sizeof *p->choice);
    size_t i = p->choices++;
    for (; i > 0 && p->choice[i - 1].key > c.key; i--)
        p->choice[i] = p->choice[i - 1];
    p->choice[i] = c;
}

void policy_copy(struct policy *to, const struct policy *from)
{
    struct policy copy = *from;
    copy.choice = to->choice;
    copy.choice_room = to->choice_room;
    copy.choices = 0;
    while (copy.choices < from->choices) {
        grow_array(&copy.choice, copy.choices, &copy.choice_room, sizeof *copy.choice);
        copy.choice[copy.choices] = from->choice[copy.choices];
        copy.choices++;
    }
    *to = copy;
}

void policy_clear(struct policy *p)
{
    free(p->choice);
    *p = (struct policy){0};
}

void record_decision(struct record *r, uint64_t key)
{
    if (!r)
        return;
    APPEND(r->decision, r->decisions, r->decision_room) = (struct decision){key, r->alternatives, 0};
}

void record_alternative(struct record *r, uint64_t what)
{
    if (!r)
        return;
    APPEND(r->alternative, r->alternatives, r->alternative_room) = what;
    r->decision[r->decisions - 1].alternatives++;
}

void record_clear(struct record *r)
{
    free(r->decision);
    free(r->alternative);
    *r = (struct record){0};
}
