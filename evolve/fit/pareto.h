/* The Pareto front of trees by error and price: none is as good as a cheaper one. */
#ifndef FOOTPOINT_PARETO_H
#define FOOTPOINT_PARETO_H

#include "../eval/operation_count.h"

double tree_price(const struct prices *p, const struct tree *t);

struct pareto_member {
    struct tree tree; /* genes owned */
    struct operation_count operations;
    double cost, error; /* error: as the finder measured it */
};
/** Ascending by cost, descending by error. */
struct pareto {
    struct prices prices;
    struct pareto_member *member; /* owned */
    size_t n, room;
};
/** Keep a copy if no member of at most its cost has at most its error; drop what it replaces. */
bool pareto_offer(struct pareto *s, const struct tree *t, double error);
/** The error to beat at a cost: the least one at no more than that, or INFINITY. */
double pareto_error(const struct pareto *s, double cost);
void pareto_free(struct pareto *s);

#endif
