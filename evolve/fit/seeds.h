/* A front of trees for one output: none is as good as a cheaper one. */
#ifndef FOOTPOINT_SEEDS_H
#define FOOTPOINT_SEEDS_H

#include "../eval/operation_count.h"

double price_of(const struct prices *p, const struct tree *t);

struct seed {
    struct tree tree; /* genes owned */
    struct operations operations;
    double cost, error; /* error: as the finder measured it */
};
/** Ascending by cost, descending by error. */
struct seeds {
    struct prices prices;
    struct seed *seed; /* owned */
    size_t n, room;
};
/** Keep a copy if no seed of at most its cost has at most its error; drop what it replaces. */
bool seeds_offer(struct seeds *s, const struct tree *t, double error);
/** The error to beat at a cost: the least one at no more than that, or INFINITY. */
double seeds_error(const struct seeds *s, double cost);
void seeds_free(struct seeds *s);

#endif
