/* Fronts of trees by price; see pareto.h. */
#include "pareto.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static struct operation_count operations_of(const struct tree *t)
{
    struct counter *c = counter_new(t->length);
    const struct operation_count o = count_operations(c, t, NULL);
    counter_free(c);
    return o;
}

double tree_price(const struct prices *p, const struct tree *t)
{
    const struct operation_count o = operations_of(t);
    return operations_price(&o, p);
}

double pareto_error(const struct pareto *s, double cost)
{
    double error = INFINITY;
    for (size_t i = 0; i < s->n && s->member[i].cost <= cost; i++)
        error = s->member[i].error;
    return error;
}

bool pareto_offer(struct pareto *s, const struct tree *t, double error)
{
    struct pareto_member new = {.operations = operations_of(t), .error = error};
    new.cost = operations_price(&new.operations, &s->prices);
    if (!(error < pareto_error(s, new.cost)))
        return false;
    size_t first = 0, after;
    while (first < s->n && s->member[first].cost < new.cost)
        first++;
    for (after = first; after < s->n && s->member[after].error >= error; after++)
        free(s->member[after].tree.gene);
    grow_array(&s->member, s->n, &s->room, sizeof *s->member);
    memmove(s->member + first + 1, s->member + after, (s->n - after) * sizeof *s->member);
    s->n = s->n - (after - first) + 1;
    new.tree.gene = new_array(t->length, sizeof *new.tree.gene);
    tree_copy(t, &new.tree);
    s->member[first] = new;
    return true;
}

void pareto_free(struct pareto *s)
{
    for (size_t i = 0; i < s->n; i++)
        free(s->member[i].tree.gene);
    free(s->member);
    *s = (struct pareto){.prices = s->prices};
}
