/* Default plans; see plan.h. */
#include "plan.h"

struct plan plan_default(void)
{
    return (struct plan){.seed = 1,
                         .breeding = BREED_FRONT,
                         .selection = SELECT_TOURNAMENT,
                         .population = 200,
                         .migrants = 20,
                         .prices = {.add = 1, .div = 8, .path = 0},
                         .times = {.add = 1, .div = 7, .path = 4},
                         .parsimony = 0.005,
                         .front_limit = 512,
                         .front_parents = 0.3,
                         .crowd = 10,
                         .tune = 0.1,
                         .polish_every = 10};
}

double plan_fitness(const struct plan *plan, double error, double cost)
{
    return error * (1 + plan->parsimony * cost);
}
