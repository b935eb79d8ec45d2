/* Faces in single precision for tests. */
#ifndef FOOTPOINT_TESTS_SINGLE_CASES_H
#define FOOTPOINT_TESTS_SINGLE_CASES_H

#include "../generated/curved_cases.h"

#include <stdint.h>

/** Names the groups of curved_cases.h, ordinary faces far from the origin, faces of any size, faces with a far slave
 *  node, and coordinates of mixed scales. */
enum single_family {
    SINGLE_OFFSET = CURVED_GROUPS,
    SINGLE_TINY,
    SINGLE_HUGE,
    SINGLE_FAR,
    SINGLE_MIXED,
    SINGLE_FAMILIES
};
extern const char *const single_families[SINGLE_FAMILIES];

/** Draws a face of f->kind whose coordinates are floats. */
void single_draw(uint64_t *stream, enum single_family family, struct curved_case *f);

/** Returns x as a float; infinite if it is too large. */
float single_round(double x);

#endif
