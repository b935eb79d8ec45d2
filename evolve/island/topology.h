/* Who sends migrants to whom.  In each migration every island of a ring receives from one other and sends to one. */
#ifndef FOOTPOINT_TOPOLOGY_H
#define FOOTPOINT_TOPOLOGY_H

#include <stddef.h>
#include <stdint.h>

enum topology {
    TOPOLOGY_RING,   /* to the next place, the paper's */
    TOPOLOGY_TORUS,  /* a grid as square as the places divide: along its rows and its columns in turn */
    TOPOLOGY_RANDOM, /* along a circle through all places, drawn anew for each migration */
    TOPOLOGY_NONE    /* islands stay alone */
};

/** One migration of one ring. */
struct migration {
    enum topology topology;
    uint64_t seed, ring; /* key of what is drawn at random */
    size_t places;       /* at least 1 */
    size_t number;       /* of the migration: 1, 2, ... */
};

/** The place from which `place` receives: itself where nothing comes. */
size_t topology_source(const struct migration *m, size_t place);
/** The place to which `place` sends: the inverse. */
size_t topology_target(const struct migration *m, size_t place);

#endif
