/* A scene of patches over meshes of smooth bodies, for tests. */
#ifndef FOOTPOINT_SMOOTH_BODIES_H
#define FOOTPOINT_SMOOTH_BODIES_H

#include "../../evolve/samples/samples.h"

/** Returns a scene of n samples a part, with |gap| up to a fifth of the shortest edge. It owns nothing. */
static inline struct scene smooth_bodies(const char *kind, size_t seed, size_t n)
{
    return (struct scene){.segment = segment_find(kind),
                          .precision = "double",
                          .training = n,
                          .heldout = n,
                          .seed = seed,
                          .run = 1,
                          .source = SOURCE_RANDOM,
                          .shapes = {.gap = 0.2}};
}

#endif
