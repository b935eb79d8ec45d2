/* Decisions of the pinball test against the exact answer. */
#ifndef FOOTPOINT_CONTACT_TABLE_H
#define FOOTPOINT_CONTACT_TABLE_H

#include "../../evolve/samples/samples.h"
#include "../support/error_stats.h"

/** Exact: in contact where the foot point lies on the segment and the gap is negative.  A gap within rounding of 0 is
 *  either, and left out. */
struct contact_decisions {
    size_t n, contacts;       /* samples that are decided, and those exactly in contact */
    size_t missed, invented;  /* contacts not found, and found where there is none */
    struct error_stats depth; /* |depth - exact depth| over the contacts found, relative to the root of the area */
};
struct contact_decisions contact_decide(const struct sample_set *set);

/** A row of CSV for each held-out part of the scene, contact_table_head before; none for segments other than quad4. */
extern const char contact_table_head[];
bool contact_table(const struct scene *scene, struct diag *d);

#endif
