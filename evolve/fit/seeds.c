/* Fronts of trees; see seeds.h. */
#include "seeds.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct operations operations_of(const struct tree *t)
{
    struct counter *c = counter_new(t->length);
    const struct operations o = operations_count(c, t, NULL);
    counter_free(c);
    return o;
}

double price_of(const struct prices *p, const struct tree *t)
{
    const struct operations o = operations_of(t);
    return operations_price(&o, p);
}

double seeds_error(const struct seeds *s, double cost)
{
    double error = INFINITY;
    for (size_t i = 0; i < s->n && s->seed[i].cost <= cost; i++)
        error = s->seed[i].error;
    return error;
}

bool seeds_offer(struct seeds *s, const struct tree *t, double error)
{
    struct seed new = {.operations = operations_of(t), .error = error};
    new.cost = operations_price(&new.operations, &s->prices);
    if (!(error < seeds_error(s, new.cost)))
        return false;
    size_t first = 0, after;
    while (first < s->n && s->seed[first].cost < new.cost)
        first++;
    for (after = first; after < s->n && s->seed[after].error >= error; after++)
        free(s->seed[after].tree.gene);
    grow_array(&s->seed, s->n, &s->room, sizeof *s->seed);
    memmove(s->seed + first + 1, s->seed + after, (s->n - after) * sizeof *s->seed);
    s->n = s->n - (after - first) + 1;
    new.tree.gene = new_array(t->length, sizeof *new.tree.gene);
    tree_copy(t, &new.tree);
    s->seed[first] = new;
    return true;
}

void seeds_free(struct seeds *s)
{
    for (size_t i = 0; i < s->n; i++)
        free(s->seed[i].tree.gene);
    free(s->seed);
    *s = (struct seeds){.prices = s->prices};
}
