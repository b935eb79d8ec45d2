/* Topologies: who sends migrants to whom. In each migration, every island of a ring receives from one island and sends
 * to one. */
#ifndef FOOTPOINT_TOPOLOGY_H
#define FOOTPOINT_TOPOLOGY_H

#include <stddef.h>
#include <stdint.h>

enum topology {
    TOPOLOGY_RING,   /* to the next place, as in the paper */
    TOPOLOGY_TORUS,  /* a grid, as square as the number of places allows, along rows and columns in turn */
    TOPOLOGY_RANDOM, /* along a circle through all places, drawn anew for each migration */
    TOPOLOGY_NONE    /* no migration */
};

/** A migration of a ring. */
struct migration {
    enum topology topology;
    uint64_t seed, ring; /* key of the random draw */
    size_t places;       /* at least 1 */
    size_t number;       /* of the migration: 1, 2, ... */
};

/** Returns the place from which `place` receives, or `place` itself if it receives nothing. */
size_t topology_source(const struct migration *m, size_t place);
/** Returns the place to which `place` sends: the inverse permutation. */
size_t topology_target(const struct migration *m, size_t place);

#endif
