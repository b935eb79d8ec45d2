/* Converts a schedule to a straight-line program, with operations in the order of their statements, and counts them. */
#ifndef FOOTPOINT_LOWER_H
#define FOOTPOINT_LOWER_H

#include "../genome/genome.h"
#include "../program/program.h"
#include "schedule.h"

struct lowered {
    struct program *program; /* owned */
    struct operations ops;
    long negations;    /* leading minus signs, which take time but do not count as operations */
    bool out_of_range; /* a constant factor, or a part of its quotient, is not a normal double */
};

/** Lowers the schedule; never fails. The caller frees l->program. */
void lower(const struct genome_file *f, const struct schedule *s, struct lowered *l);

#endif
