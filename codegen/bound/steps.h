/* Steps: how much values that requires hold near a local coordinate change with those before them.  What one of Newton's
 * steps leads to hardly depends on where it began; enclosures of its derivatives do not show that, as they know nothing of
 * the foot point. */
#ifndef FOOTPOINT_STEPS_H
#define FOOTPOINT_STEPS_H

#include "../program/program.h"

/** |d to / d from| < most, where operation `from` varies by itself, and what else is held near a local coordinate does not. */
struct step_limit {
    int to, from;
    double most;
};

struct step_limits {
    struct program
        *program; /* owned: of the region's inputs; outputs: K - |dv/dw|, > 0 where the limits hold; or NULL */
    struct step_limit *limit; /* owned: of the program whose errors are bounded */
    size_t limits, limit_room;
};

/** What the requires of file f that end in "step K" say of the operations of p from `first` on.
 *  @param[in] require  by require of the file: its operation
 *  @param[in] twin     by operation: an earlier one that it is a multiple of, or -1
 *  @param[in] pinned   by operation: a require holds it near a local coordinate */
struct step_limits step_limits_new(const struct genome_file *f, const struct program *p, size_t first,
                                   const int *require, const int *twin, const bool *pinned);
void step_limits_free(struct step_limits *s);

/** Above |d to / d from|; infinite where nothing is said. */
double step_limits_most(const struct step_limits *s, int to, int from);

#endif
