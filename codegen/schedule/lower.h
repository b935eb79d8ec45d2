/* A schedule becomes a straight-line program: operations in the order of their statements, counted as they are. */
#ifndef FOOTPOINT_LOWER_H
#define FOOTPOINT_LOWER_H

#include "../genome/genome.h"
#include "../program/program.h"
#include "schedule.h"

struct lowered {
    struct program *program; /* owned */
    struct operations ops;
    long negations;    /* leading minus signs, which are no operations but take time */
    bool out_of_range; /* a constant factor is no normal double, or its quotient's parts are none */
};

/** Never fails; program_free(l->program). */
void lower(const struct genome_file *f, const struct schedule *s, struct lowered *l);

#endif
