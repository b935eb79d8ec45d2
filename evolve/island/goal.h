/* The goal of an island, and the individuals that it breeds. */
#ifndef FOOTPOINT_GOAL_H
#define FOOTPOINT_GOAL_H

#include "../eval/objective.h"
#include "../fit/fits.h"
#include "plan.h"

/** The goal of an island. */
struct goal {
    bool program;                 /* breeds programs; otherwise trees */
    size_t column;                /* for trees: column of the target */
    int last;                     /* for programs: function that they end in, or -1 */
    size_t max_length;            /* in genes */
    const struct gene_set *genes; /* not owned */
    uint64_t ring, place;         /* key of its random streams: ring, and place in the ring */
    const struct fitting *fit;    /* not owned; for programs */
    size_t limit;                 /* largest cost of the front's members; 0: the plan's limit */
    struct tails tails;           /* for programs: their largest permitted errors */
};

struct individual {
    struct genes genes; /* not owned: in the island's pool; constants are decimal numbers */
    double fitness;     /* minimised by selection; the paper's 1/fitness */
    double error;       /* INFINITY if not finite, or if evaluation stopped early */
    double cost;        /* by the plan's model, including the frame's values that it needs */
    uint64_t hash;      /* of its operations */
};

#endif
