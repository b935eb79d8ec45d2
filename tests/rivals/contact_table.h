/* Decisions of the pinball test against the exact answer. */
#ifndef FOOTPOINT_CONTACT_TABLE_H
#define FOOTPOINT_CONTACT_TABLE_H

#include "../../evolve/samples/samples.h"
#include "../support/error_stats.h"

/** Exact contact: the foot point lies on the segment and the gap is negative. Gaps within rounding of 0 are
 * omitted. */
struct contact_decisions {
    size_t n, contacts;       /* samples counted, and those in exact contact */
    size_t missed, invented;  /* contacts not found; contacts found without an exact contact */
    struct error_stats depth; /* |depth - exact depth| over the contacts found, relative to the root of the area */
};
struct contact_decisions contact_decide(const struct sample_set *set);

/** Prints a row of CSV for each held-out part of the scene, below contact_table_head; nothing for segments other than
 *  quad4. */
extern const char contact_table_head[];
bool contact_table(const struct scene *scene, struct diag *d);

#endif
