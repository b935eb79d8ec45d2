/* The search over a segment in C: its helpers and the functions of a genome. */
#ifndef FOOTPOINT_HEADER_SEARCH_H
#define FOOTPOINT_HEADER_SEARCH_H

#include "unit.h"

/** What all searches of a header share: tests of the nodes, gap, nearest corner. */
void search_print_helpers(const struct segment_kind *k, enum precision precision, FILE *out);

/** False if every zero of a denominator makes xi or eta infinite or NaN, which NAME notices by itself. */
bool search_hides_poles(const struct function *f);

/** NAME_at, NAME and NAME_n; in float, where there were samples, NAME_sure. */
void search_print(const struct unit *u, const struct function *f, FILE *out);

#endif
