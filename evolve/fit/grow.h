/* Trees grown from a start by the additions that lower the error the most for their price. */
#ifndef FOOTPOINT_GROW_H
#define FOOTPOINT_GROW_H

#include "fit_constants.h"
#include "pareto.h"

struct grow_plan {
    const int *symbol; /* genes that may be added; not owned */
    size_t symbols;
    struct prices prices; /* add > 0 */
    double max_cost;      /* by that price */
    size_t max_length;    /* genes */
    size_t rows;          /* about so many of the table's samples are grown on; the last fit takes all */
    int tries;            /* additions that are fitted before the best of them is made */
    size_t starts;        /* quotients: so many of the most promising starts are grown to the end */
    bool clamped;         /* what is grown is kept between low and high, near which the constants begin */
    double low, high;
};
/** The plan that the project uses, for these symbols: multiplications and divisions count, as in the paper, and
 *  additions a little. */
struct grow_plan grow_plan_new(const int *symbol, size_t symbols, double max_cost, size_t max_length);

/** Grow a tree and offer all stages, fitted in the objective's norm to all samples, to the front.  Deterministic. */
void grow(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *start,
          struct pareto *front);

/** Grow polynomials: a constant and, unless NULL, `base`, a tree that is a good value already, and what helps. */
void grow_polynomials(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *base,
                      struct pareto *front);
/** The same beginning with a quotient more, constant / (constant + symbol), for each symbol. */
void grow_quotients(const struct grow_plan *plan, struct objective *objective, size_t target, const struct tree *base,
                    struct pareto *front);

#endif
