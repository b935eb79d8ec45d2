/* The statements of one function in C, and their operation counts. */
#ifndef FOOTPOINT_EMIT_H
#define FOOTPOINT_EMIT_H

#include "../genome/genome.h"
#include "schedule.h"

struct emission {
    char *text; /* owned: indented lines, the last ones set *out_... (segment: *xi, *eta) */
    struct operations ops;
    long negations;    /* leading minus signs, which are no operations but take time */
    bool out_of_range; /* a constant factor is no normal double, or its quotient's parts are none */
};

/** Never fails; free e->text. */
void emit_statements(const struct genome_file *f, const struct schedule *s, struct emission *e);

#endif
