/* The table of rivals; see rivals_closed.h. */
#include "rivals_closed.h"

#define ITERATION(name, start, gauss_newton, newton, clamped) {#name, rival_##name},
#define CLOSED_FORM(name) {#name, rival_##name},
const struct rival rivals[] = {RIVAL_ITERATIONS(ITERATION) RIVAL_CLOSED_FORMS(CLOSED_FORM)};
const int rival_count = sizeof rivals / sizeof *rivals;
